#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/scenes.h"
#include "cli/spectrum_points.h"
#include "cli/stop_signal.h"
#include "nacre/base/image.h"
#include "nacre/base/text.h"
#include "nacre/lut/encoding.h"
#include "pipeline/baked_lut.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/spectrum.h"

namespace nacre {
namespace {

struct SpectrumOptions {
    std::string scene;
    SpectrumRequest request;
    double step_nm = 1.0;
    bool xyz = false;
    bool rgb = false;
    std::vector<std::string> edits;
    std::string ocio;
};

// Steps of [light] range_nm: from a picometre to all of it.
constexpr Allowed allowed_step{0.001, 470.0};

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
            for (std::size_t i = 0; i < texts.size(); ++i) object[text_names_[i]] = json_of(text_names_[i], texts[i]);
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
    // All columns but one hold numbers; an empty field is a parameter that stays as it is.
    static Json json_of(const std::string& column, const std::string& text) {
        if (column == "material") return text;
        return text.empty() ? Json() : Json(std::stod(text));
    }

    Console& console_;
    std::vector<std::string> text_names_;
    std::vector<std::string> number_names_;
    Json json_ = Json::array();
};

// ---- what is printed

std::vector<std::string> with_column(std::vector<std::string> columns, const char* one) {
    columns.emplace_back(one);
    return columns;
}

void print_spectra(const SpectrumTable& table, const std::vector<double>& wavelengths_nm, Console& console) {
    const bool is_through = !table.points.empty() && is_transmittance(table.points.front().material->mechanism);
    const std::string letter = is_through ? "T" : "R";
    Report report(console, with_column(table.columns, "wavelength_nm"), {letter + "_s", letter + "_p", letter});
    for (const SpectrumPoint& point : table.points) {
        const std::vector<Response> responses = responses_at(point.material->mechanism, point.geometry, wavelengths_nm);
        for (std::size_t i = 0; i < responses.size(); ++i) {
            std::vector<double> numbers;
            for (const Polarisation light : {Polarisation::s, Polarisation::p, Polarisation::mean})
                numbers.push_back(observed_of(responses[i], point.material->mechanism.effects.observed, light));
            report.row({point.texts[0], point.texts[1], number_text(wavelengths_nm[i])}, numbers);
        }
    }
    report.finish();
}

void print_points(const SpectrumTable& table, Console& console) {
    Report report(console, table.columns, {"R_s", "R_p", "T_s", "T_p"});
    Mechanism changed;
    for (const SpectrumPoint& point : table.points) {
        const Response r = response_at(mechanism_of(table, point, changed), point.geometry, point.wavelength_nm);
        report.row(point.texts, {r.reflectance_s, r.reflectance_p, r.transmittance_s, r.transmittance_p});
    }
    report.finish();
}

// @param row  what a colour becomes
template <typename Row>
void print_colours(const SpectrumTable& table, const Light& light, Report& report, const Row& row) {
    ExactColours colours(light);
    Mechanism changed;
    for (const SpectrumPoint& point : table.points) {
        throw_if_stopped();
        const Mechanism& mechanism = mechanism_of(table, point, changed);
        report.row(point.texts, row(exact_colour_at(mechanism, point.geometry, light, colours)));
    }
    report.finish();
}

void print_xyz(const SpectrumTable& table, const Light& light, Console& console) {
    Report report(console, table.columns, {"X", "Y", "Z", "X_adapted", "Y_adapted", "Z_adapted"});
    print_colours(table, light, report, [](const ExactColour& colour) {
        const auto& [seen, adapted] = colour;
        return std::vector<double>{seen.x, seen.y, seen.z, adapted.x, adapted.y, adapted.z};
    });
}

void print_rgb(const SpectrumTable& table, const LoadedScene& scene, Console& console) {
    const ColourSpace& space = scene.space_of(scene.plan.colour);
    const Encoding encoding = lut_encoding(space, scene.plan.colour.gamut);
    console.note(scene.path + ": R, G, B are of " + space.name() + ", OpenColorIO config " + scene.source.config);
    Report report(console, table.columns, {"R", "G", "B"});
    print_colours(table, *scene.plan.light, report, [&](const ExactColour& colour) {
        const Rgb rgb = encoding.to_rgb(Image<Xyz>(1, 1, colour.adapted)).at(0, 0);
        return std::vector<double>{rgb.r, rgb.g, rgb.b};
    });
}

int run_spectrum(const SpectrumOptions& options, Console& console) {
    SceneRequest request = scene_request(options.ocio, console);
    request.edits = scene_edits(options.edits);
    request.all_materials = true;
    request.any_thickness = true;  // only colours need fringes resolved, and their rows are checked
    request.want_swatches = false;
    request.on_warning = {};  // standard output is a table; warnings are those of `nacre plan`
    LoadedScene scene;
    if (options.rgb) {
        scene = load_scene(options.scene, request);
    } else {
        scene.plan = plan_file(options.scene, request);
    }
    const Light& light = *scene.plan.light;
    SpectrumRequest rows = options.request;
    rows.wants_colour = options.xyz || options.rgb;
    if (rows.wants_transmittance) {
        for (SceneMaterial& material : scene.plan.materials)
            material.mechanism.effects.observed = Observed::transmittance;
    }
    const SpectrumTable table = spectrum_table(scene.plan, rows);
    if (options.rgb) {
        print_rgb(table, scene, console);
    } else if (options.xyz) {
        print_xyz(table, light, console);
    } else if (rows.points.empty()) {
        print_spectra(table, wavelengths_of(light, options.step_nm), console);
    } else {
        print_points(table, console);
    }
    return exit_done;
}

// Which rows.
std::vector<Option> row_options(SpectrumOptions& options) {
    return {
        {.names = "SCENE", .target = &options.scene, .help = "scene file (TOML)", .is_required = true},
        {.names = "--material",
         .target = &options.request.materials,
         .help = "only these materials of the scene, as in --material a b or --material a,b; default: all",
         .value_name = "NAME",
         .is_list = true},
        {.names = "--angle",
         .target = &options.request.angles,
         .help = "angles in degrees from the normal, 0 to 90; for scattering, the scattering angle, 0 to 180 (0 is "
                 "straight on): --angle 0 20 40, or ranges FIRST:LAST:STEP: --angle 0:60:10 60:90:1; default: 0",
         .value_name = "DEG",
         .is_list = true},
        {.names = "--grating-u",
         .target = &options.request.grating_us,
         .help = "for gratings, instead of --angle: sin of the light's angle + sin of the eye's, -2 to 2, as numbers "
                 "and ranges: --grating-u 0:2:0.01; without --material, all gratings of the scene",
         .value_name = "U",
         .is_list = true,
         .excludes = {"--angle"}},
        {.names = "--step",
         .target = &options.step_nm,
         .help = "distance of the wavelengths of a spectrum in nm; default: 1",
         .value_name = "NM",
         .range = allowed_step},
        {.names = "--points",
         .target = &options.request.points,
         .help = "CSV file with rows material,angle_deg,wavelength_nm (with --xyz or --rgb: material,angle_deg); "
                 "prints R_s,R_p,T_s,T_p for each row. A heading may name the columns in any order, grating_u instead "
                 "of angle_deg, and parameters of the materials such as thickness_nm; an empty field is the scene's "
                 "own value",
         .value_name = "FILE",
         .excludes = {"--material", "--angle", "--grating-u", "--step"}}};
}

// What they hold.
std::vector<Option> output_options(SpectrumOptions& options) {
    return {{.names = "--xyz",
             .target = &options.xyz,
             .help = "print X, Y, Z under the scene's light, before and after adaptation to D65",
             .excludes = {"--step"}},
            {.names = "--rgb",
             .target = &options.rgb,
             .help = "print R, G, B as a LUT would hold them before rounding: in [colour] space of the scene, with its "
                     "gamut",
             .excludes = {"--xyz", "--step"}},
            {.names = "--transmittance",
             .target = &options.request.wants_transmittance,
             .help = "print the light that goes through: T_s, T_p and T, or its colour with --xyz or --rgb; without "
                     "--material, all films, stacks and crystals of the scene that have no base",
             .excludes = {"--grating-u"}},
            set_option(options.edits),
            ocio_option(options.ocio)};
}

}  // namespace

Command spectrum_command() {
    const auto options = std::make_shared<SpectrumOptions>();
    Command command{"spectrum", "print reflectance spectra, XYZ or RGB as CSV with 17 digits", {}, {}};
    command.options = row_options(*options);
    for (Option& option : output_options(*options)) command.options.push_back(std::move(option));
    command.footer =
        "\nThe numbers come from the exact model, not from a LUT. Films, stacks and crystals reflect and transmit "
        "light, and\n"
        "absorb what remains. Every other mechanism is opaque (T = 0), and of these only scattering distinguishes s "
        "from\n"
        "p. R_s, R_p and R are the reflectances of the two polarisations and of unpolarised light; with "
        "--transmittance,\n"
        "T_s, T_p and T are the fractions that pass into the substrate. For a grating R is the power per unit of u;\n"
        "--angle means light along the normal. For scattering, R is 1 if a layer sends all light evenly in all "
        "directions.\n\nExamples:\n"
        "  nacre spectrum configs/scenes/morpho.toml --material morpho --angle 0 20 40\n"
        "  nacre spectrum configs/scenes/soap_film.toml --material soap_film --angle 0:90:5 --rgb\n"
        "  nacre spectrum configs/scenes/soap_film.toml --points points.csv\n";
    command.run = [options](Console& console) { return run_spectrum(*options, console); };
    return command;
}

}  // namespace nacre
