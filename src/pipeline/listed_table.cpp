#include "pipeline/listed_table.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/sampled_curve.h"
#include "nacre/colour/cie_tables.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/observer.h"
#include "nacre/scene/catalogue.h"

namespace nacre {
namespace {

[[noreturn]] void refuse_name(const char* what, std::string_view name, const std::vector<std::string>& known) {
    throw Error("unknown " + std::string(what) + " " + in_quotes(name) + "; known: " + comma_separated(known));
}

ListedTable illuminant_table(std::string_view name) {
    const std::optional<SampledCurve> curve = illuminant_by_name(name);
    if (!curve) {
        const std::vector<std::string_view> names = illuminant_names();
        refuse_name("illuminant", name, {names.begin(), names.end()});
    }
    ListedTable table{{"wavelength_nm", "power"}, {}};
    for (std::size_t i = 0; i < curve->value.size(); ++i)
        table.rows.push_back({curve->wavelength_nm[i], curve->value[i]});
    return table;
}

ListedTable observer_table(std::string_view name) {
    const auto* const word = std::find_if(observer_words.begin(), observer_words.end(),
                                          [&](const Word<Observer>& one) { return one.name == name; });
    if (word == observer_words.end()) refuse_name("observer", name, names_of(observer_words));
    ListedTable table{{"wavelength_nm", "x_bar", "y_bar", "z_bar"}, {}};
    for (int nm = cie_table_first_nm; nm <= cie_table_last_nm; ++nm) {
        const auto& [x, y, z] = colour_matching(word->meaning, nm);
        table.rows.push_back({static_cast<double>(nm), x, y, z});
    }
    return table;
}

}  // namespace

ListedTable listed_table(std::string_view list, std::string_view name) {
    if (list == "illuminants") return illuminant_table(name);
    if (list == "observers") return observer_table(name);
    throw Error("the names of " + in_quotes(list) + " have no tables of numbers; illuminants and observers have");
}

}  // namespace nacre
