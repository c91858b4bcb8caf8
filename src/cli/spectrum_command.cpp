#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/scenes.h"
#include "cli/stop_signal.h"
#include "io/scene/curve_csv.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/shade/spectra.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/spectrum.h"

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

// A millimetre, far beyond the tables of all materials.
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
            Json object = Json::object();
            object[text_names_.front()] = texts.front();
            for (std::size_t i = 1; i < texts.size(); ++i) object[text_names_[i]] = std::stod(texts[i]);
            for (std::size_t i = 0; i < numbers.size(); ++i) object[number_names_[i]] = numbers[i];
            json_.push_back(object);
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
    Json json_ = Json::array();
};

// ---- which points are asked for

std::vector<Point> points_of_options(const Plan& plan, const SpectrumOptions& options) {
    std::vector<std::string> names = options.materials;
    if (names.empty()) {
        for (const Material& candidate : plan.materials) names.push_back(candidate.name);
    }
    std::vector<double> angles_deg = options.angles_deg;
    if (angles_deg.empty()) angles_deg = {0.0};
    std::vector<Point> points;
    for (const std::string& name : names) {
        for (const double angle_deg : angles_deg) {
            const Material& asked = material_named(plan, name, "--material");
            check_angle(angle_deg, asked.mechanism, "--angle");
            points.push_back({&asked, number_text(angle_deg), angle_deg, {}, 0.0});
        }
    }
    return points;
}

Point point_of_row(const Plan& plan, const SpectrumOptions& options, const CsvRow& row) {
    const std::string line = options.points + ":" + std::to_string(row.line) + ":";
    const std::string where = line + std::to_string(row.columns.front());
    if (row.fields.size() != (options.xyz ? 2U : 3U)) {
        throw Error(where + ": has " + std::to_string(row.fields.size()) + " columns; give " +
                    (options.xyz ? "material,angle_deg" : "material,angle_deg,wavelength_nm"));
    }
    Point point{
        &material_named(plan, row.fields[0], where), row.fields[1], csv_number(options.points, row, 1), {}, 0.0};
    check_angle(point.angle_deg, point.material->mechanism, line + std::to_string(row.columns[1]));
    if (options.xyz) return point;
    point.wavelength_text = row.fields[2];
    point.wavelength_nm = csv_number(options.points, row, 2);
    if (!(point.wavelength_nm > 0.0 && point.wavelength_nm <= longest_wavelength_nm)) {
        throw Error(where + ": wavelength " + row.fields[2] + " is out of range; allowed (0, " +
                    number_text(longest_wavelength_nm) + "] nm");
    }
    check_wavelength(*point.material, point.wavelength_nm, point.wavelength_text,
                     line + std::to_string(row.columns[2]));
    return point;
}

std::vector<Point> points_of_file(const Plan& plan, const SpectrumOptions& options) {
    std::vector<CsvRow> rows = read_csv(options.points);
    if (!rows.empty() && rows.front().fields.size() >= 2 && rows.front().fields[1] == "angle_deg")
        rows.erase(rows.begin());
    std::vector<Point> points;
    points.reserve(rows.size());
    for (const CsvRow& row : rows) points.push_back(point_of_row(plan, options, row));
    return points;
}

// ---- what is printed

void print_spectra(const std::vector<Point>& points, const Plan& plan, Console& console) {
    const std::vector<double> wavelengths_nm = every_nanometre(*plan.light);
    Report report(console, {"material", "angle_deg"}, {"wavelength_nm", "R_s", "R_p", "R"});
    for (const Point& point : points) {
        const Mechanism& mechanism = point.material->mechanism;
        const std::vector<Response> responses =
            responses_at(mechanism, geometry_at_angle(mechanism, point.angle_deg), wavelengths_nm);
        for (std::size_t i = 0; i < responses.size(); ++i) {
            const Response& r = responses[i];
            report.row({point.material->name, point.angle_text},
                       {wavelengths_nm[i], r.reflectance_s, r.reflectance_p, r.reflectance()});
        }
    }
    report.finish();
}

void print_points(const std::vector<Point>& points, Console& console) {
    Report report(console, {"material", "angle_deg", "wavelength_nm"}, {"R_s", "R_p", "T_s", "T_p"});
    for (const Point& point : points) {
        const Mechanism& mechanism = point.material->mechanism;
        const Response response =
            response_at(mechanism, geometry_at_angle(mechanism, point.angle_deg), point.wavelength_nm);
        report.row(
            {point.material->name, point.angle_text, point.wavelength_text},
            {response.reflectance_s, response.reflectance_p, response.transmittance_s, response.transmittance_p});
    }
    report.finish();
}

void print_xyz(const std::vector<Point>& points, const Plan& plan, Console& console) {
    Report report(console, {"material", "angle_deg"}, {"X", "Y", "Z", "X_adapted", "Y_adapted", "Z_adapted"});
    for (const Point& point : points) {
        const auto [seen, adapted] = exact_colour_at(*point.material, point.angle_deg, *plan.light);
        report.row({point.material->name, point.angle_text}, {seen.x, seen.y, seen.z, adapted.x, adapted.y, adapted.z});
    }
    report.finish();
}

int run_spectrum(const SpectrumOptions& options, Console& console) {
    SceneRequest request = scene_request("", console);
    request.all_materials = true;
    request.on_warning = {};  // standard output is a table; warnings are those of `nacre plan`
    const Plan plan = plan_file(options.scene, request);
    const std::vector<Point> points =
        options.points.empty() ? points_of_options(plan, options) : points_of_file(plan, options);
    if (options.xyz) {
        print_xyz(points, plan, console);
    } else if (options.points.empty()) {
        print_spectra(points, plan, console);
    } else {
        print_points(points, console);
    }
    return exit_done;
}

}  // namespace

Command spectrum_command() {
    const auto options = std::make_shared<SpectrumOptions>();
    Command command{"spectrum", "print reflectance spectra, or XYZ, as CSV with 17 digits", {}, {}};
    command.options = {
        {.names = "SCENE", .target = &options->scene, .help = "scene file (TOML)", .is_required = true},
        {.names = "--material",
         .target = &options->materials,
         .help = "only these materials of the scene, as in --material a b or --material a,b; default: all",
         .value_name = "NAME",
         .is_list = true},
        {.names = "--angle",
         .target = &options->angles_deg,
         .help = "angles in degrees from the normal, 0 to 90; for scattering, the scattering angle, 0 to 180 (0 is "
                 "straight on): "
                 "--angle 0 20 40; default: 0",
         .value_name = "DEG",
         .is_list = true},
        {.names = "--points",
         .target = &options->points,
         .help = "CSV file with rows material,angle_deg,wavelength_nm (with --xyz: material,angle_deg); prints "
                 "R_s,R_p,T_s,T_p for each row",
         .value_name = "FILE",
         .excludes = {"--material", "--angle"}},
        {.names = "--xyz",
         .target = &options->xyz,
         .help = "print X, Y, Z under the scene's light, before and after adaptation to D65"}};
    command.footer =
        "\nThe numbers come from the exact model, not from a LUT. Films, stacks and crystals reflect and transmit "
        "light, and\n"
        "absorb what remains. Every other mechanism is opaque (T = 0), and of these only scattering distinguishes s "
        "from\n"
        "p. R_s, R_p and R are the reflectances of the two polarisations and of unpolarised light. For a grating, "
        "which\n"
        "is lit along its normal, R is the power per unit of sin(angle). For scattering, R is 1 if a layer sends all\n"
        "light evenly in all directions.\n\nExamples:\n"
        "  nacre spectrum configs/scenes/morpho.toml --material morpho --angle 0 20 40\n"
        "  nacre spectrum configs/scenes/soap_film.toml --material soap_film --points points.csv\n";
    command.run = [options](Console& console) { return run_spectrum(*options, console); };
    return command;
}

}  // namespace nacre
