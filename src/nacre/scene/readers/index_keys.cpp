#include "nacre/scene/readers/index_keys.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "nacre/base/text.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/metal_reader.h"

namespace nacre {

Index read_required_index(const Table& table, std::string_view key, const IndexReader& reader) {
    const Value* value = table.find(key);
    if (value != nullptr) return reader.read(table, key, *value);
    table.note_missing(key, "give a number, { n, k }, or the name of a material");
    return Index(1.0);
}

Index read_clear_medium(const Table& table, std::string_view key, const IndexReader& reader,
                        std::string_view consequence) {
    Index medium = reader.read_or(table, key, Index(1.0));
    // A number is meant as it is; a table of a clear material may have a tiny k.
    const double limit = medium.is_constant() ? 0.0 : transparent_k;
    if (largest_k(medium, reader.first_nm, reader.last_nm) > limit) {
        table.note_at(key,
                      std::string(key) + " absorbs, so " + std::string(consequence) + "; give a medium with k = 0");
    }
    if (medium.is_constant() || medium.curve->is_lossless()) return medium;
    IndexCurve lossless = *medium.curve;
    lossless.k = 0.0;
    return Index(std::make_shared<const IndexCurve>(std::move(lossless)));
}

Index read_incident(const Table& table, const IndexReader& reader) {
    return read_clear_medium(table, "incident", reader, "no light reaches the layers through it");
}

double read_thickness(const Table& table, std::string_view key) {
    const Value* value = table.find(key);
    if (value != nullptr && refuse_range(table, key, *value)) return 0.0;
    const double thickness_nm = table.number(key, allowed_thickness);
    if (value != nullptr) warn_of_thin_layer(table, key, *value, thickness_nm);
    return thickness_nm;
}

// A layer of few atoms has no refractive index of its own; a number as small as this is more likely in micrometres.
void warn_of_thin_layer(const Table& table, std::string_view key, const Value& value, double thickness_nm) {
    if (!(thickness_nm > 0.0 && thickness_nm < 1.0)) return;
    table.warn(value.where, std::string(key) + " = " + value.text() +
                                " is less than 1 nm, a layer of a few atoms; if micrometres are meant, write " +
                                number_text(1000.0 * thickness_nm));
}

double read_spread(const Table& table) {
    return table.number_or("thickness_spread_nm", allowed_spread, 0.0);
}

void add_index_parameters(const std::string& prefix, const std::string& of_what, const Index& index,
                          const std::function<Index&(Mechanism&)>& find, std::vector<Parameter>& parameters) {
    if (!index.is_constant()) {
        if (index.curve->metal) parameters.push_back(f0_parameter(prefix, of_what, *index.curve->metal, find));
        return;
    }
    parameters.push_back({prefix + "n", "refractive index" + of_what, allowed_n,
                          [find](Mechanism& m, double value) { find(m).constant.real(value); }});
    parameters.push_back({prefix + "k", "absorption index" + of_what, allowed_k,
                          [find](Mechanism& m, double value) { find(m).constant.imag(value); }});
}

double largest_k(const Index& index, double first_nm, double last_nm) {
    if (index.is_constant()) return index.constant.imag();
    double largest = index.at(last_nm).imag();
    for (double nm = first_nm; nm < last_nm; nm += 1.0) largest = std::max(largest, index.at(nm).imag());
    return largest;
}

}  // namespace nacre
