// The rows that `nacre spectrum` prints numbers for: of options, or of a CSV file.
#include "cli/spectrum_points.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "cli/number_ranges.h"
#include "io/scene/csv_file.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/base/where.h"
#include "pipeline/spectrum.h"

namespace nacre {
namespace {

// A millimetre, far beyond the tables of all materials.
constexpr double longest_wavelength_nm = 1e6;

bool is_grating(const Material& material) {
    return quantity_of(material.mechanism) == Quantity::grating_u;
}

bool lets_through(const Material& material) {
    return is_layered(material.mechanism) && !material.mechanism.effects.base;
}

// @param where  for the message
const Material& asked_material(const Plan& plan, const SpectrumRequest& request, const std::string& name,
                               const std::string& where) {
    const Material& asked = material_named(plan, name, where);
    if (request.wants_transmittance && !lets_through(asked)) {
        throw Error(where + ": material " + in_quotes(name) +
                    " lets no light through; --transmittance takes films, stacks and crystals without a base");
    }
    return asked;
}

// ---- of options

std::vector<std::string> asked_materials(const Plan& plan, const SpectrumRequest& request) {
    if (!request.materials.empty()) return request.materials;
    std::vector<std::string> names;
    for (const Material& candidate : plan.materials) {
        if (request.wants_transmittance && !lets_through(candidate)) continue;
        if (request.grating_us.empty() || is_grating(candidate)) names.push_back(candidate.name);
    }
    if (names.empty() && request.wants_transmittance)
        throw Error("--transmittance: the scene has no film, stack or crystal without a base");
    if (names.empty()) throw Error("--grating-u: the scene has no grating; give --angle");
    return names;
}

SpectrumTable table_of_options(const Plan& plan, const SpectrumRequest& request) {
    const bool has_u = !request.grating_us.empty();
    std::vector<double> numbers =
        has_u ? numbers_in_ranges(request.grating_us, "--grating-u") : numbers_in_ranges(request.angles, "--angle");
    if (numbers.empty()) numbers = {0.0};
    const std::string option = "--material";
    SpectrumTable table{{"material", has_u ? "grating_u" : "angle_deg"}, {}, {}};
    for (const std::string& name : asked_materials(plan, request)) {
        const Material& asked = asked_material(plan, request, name, option);
        if (request.wants_colour) check_colour(name, asked.mechanism, *plan.light, asked.where.text());
        for (const double number : numbers) {
            if (!has_u) check_angle(number, asked.mechanism, "--angle");
            const Geometry geometry =
                has_u ? geometry_at_u(asked, number, "--grating-u") : geometry_at_angle(asked.mechanism, number);
            table.points.push_back({&asked, geometry, 0.0, {}, {name, number_text(number)}});
        }
    }
    return table;
}

// ---- of a file: rows of material, angle_deg, wavelength_nm, or what a heading says

constexpr const char* allowed_columns =
    "; a heading names material, angle_deg or grating_u, wavelength_nm unless colours are asked for, and any "
    "parameters of the materials";

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
    return text;
}

// Reads the rows of one file of points.
class PointsFile {
public:
    PointsFile(const Plan& plan, const SpectrumRequest& request) : plan_(plan), request_(request) {}

    SpectrumTable read() {
        std::vector<CsvRow> rows = read_csv(request_.points);
        const bool has_heading = !rows.empty() && is_heading(rows.front());
        table_.columns = {"material", "angle_deg"};
        if (!request_.wants_colour) table_.columns.emplace_back("wavelength_nm");
        if (has_heading) {
            read_heading(rows.front());
            rows.erase(rows.begin());
        }
        table_.points.reserve(rows.size());
        for (const CsvRow& row : rows) table_.points.push_back(point_of(row));
        return std::move(table_);
    }

private:
    static bool is_parameter(const std::string& column) {
        return column != "material" && column != "angle_deg" && column != "grating_u" && column != "wavelength_nm";
    }

    static bool is_heading(const CsvRow& row) {
        return std::any_of(row.fields.begin(), row.fields.end(),
                           [](const std::string& field) { return field == "angle_deg" || field == "grating_u"; });
    }

    Where where(const CsvRow& row, std::size_t column) const {
        return {request_.points, row.line, row.columns[column]};
    }

    bool has_column(const std::string& name) const {
        return std::find(table_.columns.begin(), table_.columns.end(), name) != table_.columns.end();
    }

    void read_heading(const CsvRow& row) {
        table_.columns.clear();
        for (std::size_t i = 0; i < row.fields.size(); ++i) {
            const std::string& name = row.fields[i];
            if (has_column(name)) throw Error(where(row, i).text() + ": column " + in_quotes(name) + " is given twice");
            if (name == "wavelength_nm" && request_.wants_colour) {
                throw Error(where(row, i).text() +
                            ": a colour has no wavelength; leave out the column wavelength_nm, or --xyz and --rgb");
            }
            table_.columns.push_back(name);
            if (is_parameter(name)) table_.parameters.push_back(name);
        }
        const std::string line = where(row, 0).text();
        if (!has_column("material")) throw Error(line + ": there is no column material" + allowed_columns);
        if (has_column("angle_deg") && has_column("grating_u"))
            throw Error(line + ": angle_deg and grating_u are one too many" + allowed_columns);
        if (!request_.wants_colour && !has_column("wavelength_nm"))
            throw Error(line + ": there is no column wavelength_nm" + allowed_columns);
    }

    SpectrumPoint point_of(const CsvRow& row) const {
        if (row.fields.size() != table_.columns.size()) {
            throw Error(where(row, 0).text() + ": has " + std::to_string(row.fields.size()) + " columns; give " +
                        joined(table_.columns));
        }
        const auto column = std::find(table_.columns.begin(), table_.columns.end(), "material");
        const auto place = static_cast<std::size_t>(column - table_.columns.begin());
        SpectrumPoint point;
        point.material = &asked_material(plan_, request_, row.fields[place], where(row, place).text());
        point.texts = row.fields;
        Mechanism mechanism;
        if (!table_.parameters.empty() || request_.wants_colour) mechanism = point.material->mechanism;
        for (std::size_t i = 0; i < row.fields.size(); ++i) read_field(row, i, point, mechanism);
        if (request_.wants_colour)
            check_colour(point.material->name, mechanism, *plan_.light, where(row, place).text());
        return point;
    }

    // @param mechanism  of the row: takes the parameters
    void read_field(const CsvRow& row, std::size_t i, SpectrumPoint& point, Mechanism& mechanism) const {
        const std::string& name = table_.columns[i];
        const Material& material = *point.material;
        if (name == "material") return;
        if (is_parameter(name) && row.fields[i].empty()) {
            point.parameters.emplace_back();
            return;
        }
        const double number = csv_number(request_.points, row, i);
        const std::string place = where(row, i).text();
        if (name == "angle_deg") {
            check_angle(number, material.mechanism, place);
            point.geometry = geometry_at_angle(material.mechanism, number);
        } else if (name == "grating_u") {
            point.geometry = geometry_at_u(material, number, place);
        } else if (name == "wavelength_nm") {
            if (!(number > 0.0 && number <= longest_wavelength_nm)) {
                throw Error(place + ": wavelength " + row.fields[i] + " is out of range; allowed (0, " +
                            number_text(longest_wavelength_nm) + "] nm");
            }
            check_wavelength(material, number, row.fields[i], place);
            point.wavelength_nm = number;
        } else {
            point.parameters.emplace_back(number);
            set_parameter(mechanism, name, number, where(row, i));
        }
    }

    const Plan& plan_;
    const SpectrumRequest& request_;
    SpectrumTable table_;
};

}  // namespace

SpectrumTable spectrum_table(const Plan& plan, const SpectrumRequest& request) {
    return request.points.empty() ? table_of_options(plan, request) : PointsFile(plan, request).read();
}

const Mechanism& mechanism_of(const SpectrumTable& table, const SpectrumPoint& point, Mechanism& changed) {
    const bool is_changed = std::any_of(point.parameters.begin(), point.parameters.end(),
                                        [](const std::optional<double>& value) { return value.has_value(); });
    if (!is_changed) return point.material->mechanism;
    changed = point.material->mechanism;
    for (std::size_t i = 0; i < point.parameters.size(); ++i) {
        if (point.parameters[i]) set_parameter(changed, table.parameters[i], *point.parameters[i], {});
    }
    return changed;
}

}  // namespace nacre
