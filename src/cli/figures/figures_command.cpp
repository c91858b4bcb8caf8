#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/figures/paper_pictures.h"
#include "cli/stop_signal.h"
#include "io/disk/output_folder.h"
#include "io/image/font.h"
#include "io/image/gnuplot.h"
#include "io/image/swatch_png.h"
#include "io/ocio/colour_config.h"
#include "nacre/base/names.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch.h"

namespace nacre {
namespace {

// What the Color Interop Forum calls the encoding of an sRGB display.
constexpr std::string_view srgb_display_id = "srgb_rec709_display";

struct FiguresOptions {
    std::string folder = "figures";
    std::string ocio;
};

std::string swatch_png(const PlannedSwatch& swatch, const ColourTransform& to_display, bool is_srgb) {
    const PngSettings settings{find_font(), is_srgb};
    const auto bytes = encode_swatch_png(
        draw_swatch(swatch), [&](const Image<Xyz>& image) { return to_display.apply(image); }, settings);
    return {bytes.begin(), bytes.end()};
}

// Everything that a figure consists of, in memory.
NamedFiles figure_files(const PaperFigure& figure, const ColourTransform& to_display, bool is_srgb, Console& console) {
    NamedFiles files;
    for (const Series& series : figure.data) files[series.name + ".csv"] = csv_text(series);
    for (const PlannedSwatch& swatch : figure.swatches) {
        files[swatch.name + ".png"] = swatch_png(swatch, to_display, is_srgb);
    }
    if (figure.script.empty()) return files;
    const std::string script = figure.name + ".gp";
    files[script] = figure.script;
    files[figure_style_file] = figure_style_script();
    GnuplotResult plotted = run_gnuplot(files, script, figure.pictures());
    if (!plotted.warnings.empty()) console.warning("gnuplot: " + plotted.warnings);
    files.merge(plotted.files);
    return files;
}

int run_figures(const FiguresOptions& options, Console& console) {
    const ColourConfig config = ColourConfig::open({options.ocio, "", "--ocio"});
    const ColourTransform to_display = config.to_display("", "", config.description());
    const bool is_srgb = to_display.interop_id() == srgb_display_id;
    const std::vector<PaperFigure> figures = paper_figures(to_display, is_srgb);
    OutputFolder folder(options.folder);
    NamedFiles files{{"README.md", figures_readme(figures)}};
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const PaperFigure& figure : figures) {
        throw_if_stopped();
        files.merge(figure_files(figure, to_display, is_srgb, console));
        console.progress(json.size() + 1, figures.size());
        json.push_back({{"name", figure.name}, {"title", figure.title}, {"files", figure.files()}});
    }
    for (const auto& [name, bytes] : files) {
        if (!folder.holds(name, bytes)) folder.write(name, bytes);
    }
    throw_if_stopped();
    folder.commit();
    for (const PaperFigure& figure : figures) console.summary(figure.title + ": " + comma_separated(figure.files()));
    if (console.json()) console.result_json({{"figures", json}});
    return exit_done;
}

}  // namespace

Command add_figures_command(CLI::App& app) {
    const auto options = std::make_shared<FiguresOptions>();
    app.add_option("-o,--output", options->folder, "folder for the files; made if it is missing")
        ->capture_default_str();
    app.add_option("--ocio", options->ocio, "OpenColorIO config; wins over $OCIO");
    app.footer(
        "\nFigures 5, 7, 8, 9, 11, 12 and 14 of Park & Tsuruno 2014, from its equations and parameters: CSV, gnuplot "
        "script and\n"
        "PNG of each, and a README.md that says what they show. Beside them stacks_morpho and stacks_beetle, which "
        "judge\n"
        "the paper's palettes against exactly solved layers. Needs gnuplot (Debian package gnuplot-nox).\n\n"
        "Example:\n  nacre figures -o figures\n");
    return [options](Console& console) { return run_figures(*options, console); };
}

}  // namespace nacre
