#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/commands.h"
#include "cli/stop_signal.h"
#include "io/scene/curve_csv.h"
#include "io/scene/scene_file.h"
#include "nacre/accuracy/exact_colour.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/lut/bake.h"
#include "nacre/shade/spectra.h"
#include "pipeline/picked_colours.h"

namespace nacre {
namespace {

struct SpectrumOptions {
    std::string scene;
    std::vector<std::string> materials;
    std::vector<double> angles_deg;
    std::string points;
    bool xyz = false;
};

// One row that is asked for. The texts are the user's own, so that rows can be joined with what he has.
struct Point {
    const Material* material = nullptr;
    std::string angle_text;
    double angle_deg = 0.0;
    std::string wavelength_text;
    double wavelength_nm = 0.0;
};

constexpr double longest_wavelength_nm = 1e6;

// A table of text and numbers that is printed as CSV (17 digits, so that a double comes back) or as JSON.
class Report {
public:
    Report(Console& console, std::vector<std::string> texts, std::vector<std::string> numbers)
        : console_(console), text_names_(std::move(texts)), number_names_(std::move(numbers)) {
        std::vector<std::string> all = text_names_;
        all.insert(all.end(), number_names_.begin(), number_names_.end());
        std::string line;
        for (const std::string& name : all) line += (line.empty() ? "" : ",") + name;
        if (!console_.json()) console_.result(line);
    }

    void row(const std::vector<std::string>& texts, const std::vector<double>& numbers) {
        throw_if_stopped();
        if (console_.json()) {
            nlohmann::ordered_json object;
            object[text_names_.front()] = texts.front();
            for (std::size_t i = 1; i < texts.size(); ++i) object[text_names_[i]] = std::stod(texts[i]);
            for (std::size_t i = 0; i < numbers.size(); ++i) object[number_names_[i]] = numbers[i];
            json_.push_back(std::move(object));
            return;
        }
        std::string line;
        for (const std::string& text : texts) line += (line.empty() ? "" : ",") + text;
        for (const double number : numbers) {
            char digits[40];
            std::snprintf(digits, sizeof digits, ",%.17g", number);
            line += digits;
        }
        console_.result(line);
    }

    void finish() {
        if (console_.json()) console_.result_json(json_);
    }

private:
    Console& console_;
    std::vector<std::string> text_names_;
    std::vector<std::string> number_names_;
    nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
};

class SpectrumRun {
public:
    SpectrumRun(const SpectrumOptions& options, Console& console)
        : options_(options),
          console_(console),
          plan_(plan_scene(read_scene_file(options.scene), scene_files_with_colours(options.scene, ""),
                           {{}, true, false})) {}

    int run() {
        const std::vector<Point> points = options_.points.empty() ? points_of_options() : points_of_file();
        if (options_.xyz) {
            print_xyz(points);
        } else if (options_.points.empty()) {
            print_spectra(points);
        } else {
            print_points(points);
        }
        return exit_done;
    }

private:
    const Material& material(const std::string& name, const std::string& where) const {
        std::vector<std::string> known;
        for (const Material& candidate : plan_.materials) {
            if (candidate.name == name) return candidate;
            known.push_back(candidate.name);
        }
        throw Error(where + ": unknown material " + in_quotes(name) + "; known: " + known_like(name, known));
    }

    static void check_angle(double angle_deg, const Mechanism& mechanism, const std::string& where) {
        const double most_deg = quantity_of(mechanism) == Quantity::cos_scatter ? 180.0 : 90.0;
        if (angle_deg >= 0.0 && angle_deg <= most_deg) return;
        throw Error(where + ": angle " + number_text(angle_deg) + " is out of range; allowed [0, " +
                    number_text(most_deg) + "] degrees");
    }

    // What one angle means: of gratings that of the eye, with light along the normal; of scattering that by which light
    // is turned.
    static Geometry geometry(const Point& point) {
        switch (quantity_of(point.material->mechanism)) {
            case Quantity::grating_u:
                return Geometry::from_grating_u(std::sin(point.angle_deg * std::numbers::pi / 180.0));
            case Quantity::cos_scatter:
                return Geometry::from_cos_scatter(std::cos(point.angle_deg * std::numbers::pi / 180.0));
            case Quantity::incidence:
                break;
        }
        return Incidence::from_degrees(point.angle_deg);
    }

    static void check_known(const Point& point, const std::string& where) {
        const auto unknown = unknown_at(point.material->mechanism, point.wavelength_nm);
        if (!unknown) return;
        throw Error(where + ": wavelength " + point.wavelength_text + " nm lies outside what is known of " +
                    (unknown->name.empty() ? "an index" : in_quotes(unknown->name)) + " in material " +
                    in_quotes(point.material->name) + "; allowed [" + number_text(unknown->first_nm) + ", " +
                    number_text(unknown->last_nm) + "] nm");
    }

    std::vector<Point> points_of_options() const {
        std::vector<std::string> names = options_.materials;
        if (names.empty()) {
            for (const Material& candidate : plan_.materials) names.push_back(candidate.name);
        }
        std::vector<double> angles_deg = options_.angles_deg;
        if (angles_deg.empty()) angles_deg = {0.0};
        std::vector<Point> points;
        for (const std::string& name : names) {
            for (const double angle_deg : angles_deg) {
                const Material& asked = material(name, "--material");
                check_angle(angle_deg, asked.mechanism, "--angle");
                points.push_back({&asked, number_text(angle_deg), angle_deg, {}, 0.0});
            }
        }
        return points;
    }

    std::vector<Point> points_of_file() const {
        const std::size_t columns = options_.xyz ? 2 : 3;
        const char* heading = options_.xyz ? "material,angle_deg" : "material,angle_deg,wavelength_nm";
        std::vector<CsvRow> rows = read_csv(options_.points);
        if (!rows.empty() && rows.front().fields.size() >= 2 && rows.front().fields[1] == "angle_deg")
            rows.erase(rows.begin());
        std::vector<Point> points;
        for (const CsvRow& row : rows) {
            const std::string where =
                options_.points + ":" + std::to_string(row.line) + ":" + std::to_string(row.columns.front());
            if (row.fields.size() != columns) {
                throw Error(where + ": has " + std::to_string(row.fields.size()) + " columns; give " + heading);
            }
            Point point{&material(row.fields[0], where), row.fields[1], csv_number(options_.points, row, 1), {}, 0.0};
            check_angle(point.angle_deg, point.material->mechanism,
                        options_.points + ":" + std::to_string(row.line) + ":" + std::to_string(row.columns[1]));
            if (!options_.xyz) {
                point.wavelength_text = row.fields[2];
                point.wavelength_nm = csv_number(options_.points, row, 2);
                if (!(point.wavelength_nm > 0.0 && point.wavelength_nm <= longest_wavelength_nm)) {
                    throw Error(where + ": wavelength " + row.fields[2] + " is out of range; allowed (0, " +
                                number_text(longest_wavelength_nm) + "] nm");
                }
                check_known(point,
                            options_.points + ":" + std::to_string(row.line) + ":" + std::to_string(row.columns[2]));
            }
            points.push_back(std::move(point));
        }
        return points;
    }

    void print_spectra(const std::vector<Point>& points) {
        const LightSettings& light = plan_.light->settings;
        const WavelengthGrid grid{static_cast<double>(light.first_nm), static_cast<double>(light.last_nm),
                                  light.last_nm - light.first_nm + 1};
        std::vector<double> wavelengths_nm;
        for (int node = 0; node < grid.count; ++node) wavelengths_nm.push_back(grid.wavelength_nm(node));
        Report report(console_, {"material", "angle_deg"}, {"wavelength_nm", "R_s", "R_p", "R"});
        for (const Point& point : points) {
            const std::vector<Response> responses =
                responses_at(point.material->mechanism, geometry(point), wavelengths_nm);
            for (std::size_t i = 0; i < responses.size(); ++i) {
                const Response& r = responses[i];
                report.row({point.material->name, point.angle_text},
                           {wavelengths_nm[i], r.reflectance_s, r.reflectance_p, r.reflectance()});
            }
        }
        report.finish();
    }

    void print_points(const std::vector<Point>& points) {
        Report report(console_, {"material", "angle_deg", "wavelength_nm"}, {"R_s", "R_p", "T_s", "T_p"});
        for (const Point& point : points) {
            const Response response = response_at(point.material->mechanism, geometry(point), point.wavelength_nm);
            report.row(
                {point.material->name, point.angle_text, point.wavelength_text},
                {response.reflectance_s, response.reflectance_p, response.transmittance_s, response.transmittance_p});
        }
        report.finish();
    }

    void print_xyz(const std::vector<Point>& points) {
        Report report(console_, {"material", "angle_deg"}, {"X", "Y", "Z", "X_adapted", "Y_adapted", "Z_adapted"});
        for (const Point& point : points) {
            const Xyz seen = reflectance_xyz(point.material->mechanism, geometry(point), *plan_.light);
            const Xyz adapted = adapt(plan_.light->adaptation, seen);
            report.row({point.material->name, point.angle_text},
                       {seen.x, seen.y, seen.z, adapted.x, adapted.y, adapted.z});
        }
        report.finish();
    }

    const SpectrumOptions& options_;
    Console& console_;
    Plan plan_;
};

}  // namespace

Command add_spectrum_command(CLI::App& app) {
    const auto options = std::make_shared<SpectrumOptions>();
    app.add_option("SCENE", options->scene, "scene file (TOML)")->required()->type_name("");
    app.add_option("--material", options->materials, "material of the scene; may be repeated; default: all")
        ->type_name("NAME")
        ->allow_extra_args(false);
    app.add_option("--angle", options->angles_deg,
                   "degrees from the normal, 0 to 90 (scattering: by which light is turned, 0 to 180); default: 0")
        ->type_name("DEG");
    app.add_option("--points", options->points,
                   "CSV of material,angle_deg,wavelength_nm: R_s,R_p,T_s,T_p per row; with --xyz of material,angle_deg")
        ->type_name("FILE")
        ->excludes("--material")
        ->excludes("--angle");
    app.add_flag("--xyz", options->xyz, "X, Y, Z under the scene's light instead, before and after adaptation to D65");
    app.footer(
        "\nThe exact model, no LUT in between. Films, stacks and crystals reflect and let through; what is missing to "
        "1 "
        "is\n"
        "absorbed. All else is opaque (T = 0), and but for scattering s and p are alike. Columns R_s, R_p, R are "
        "reflectances of the two\n"
        "polarisations and of unpolarised light. Of a grating, lit along its normal, R is power per unit of\n"
        "sin(angle); of scattering, 1 is a layer that sends all light evenly into all directions.\n\n"
        "Examples:\n"
        "  nacre spectrum configs/scenes/morpho.toml --material morpho --angle 0 20 40\n"
        "  nacre spectrum configs/scenes/soap_film.toml --material soap_film --points points.csv\n");
    return [options](Console& console) { return SpectrumRun(*options, console).run(); };
}

}  // namespace nacre
