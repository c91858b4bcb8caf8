#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/figures/paper_pictures.h"
#include "cli/plot_style.h"
#include "cli/stop_signal.h"
#include "io/disk/output_folder.h"
#include "io/image/font.h"
#include "io/image/gnuplot.h"
#include "io/image/swatch_png.h"
#include "io/ocio/ocio_spaces.h"
#include "nacre/base/names.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch.h"
#include "pipeline/json.h"

namespace nacre {
namespace {

// What the Color Interop Forum calls the encoding of an sRGB display.
constexpr std::string_view srgb_display_id = "srgb_rec709_display";

struct FiguresOptions {
    std::string folder = "figures";
    std::string ocio;
};

std::string swatch_png(const PlannedSwatch& swatch, const ColourSpace& to_display, bool is_srgb) {
    const PngSettings settings{find_font(), is_srgb};
    const auto bytes = encode_swatch_png(
        draw_swatch(swatch), [&](const Image<Xyz>& image) { return to_display.to_rgb(image); }, settings);
    return {bytes.begin(), bytes.end()};
}

// Everything that a figure consists of, in memory.
NamedFiles figure_files(const PaperFigure& figure, const ColourSpace& to_display, bool is_srgb, Console& console) {
    NamedFiles files;
    for (const Series& series : figure.data) files[series.name + ".csv"] = csv_text(series);
    for (const PlannedSwatch& swatch : figure.swatches) {
        files[swatch.name + ".png"] = swatch_png(swatch, to_display, is_srgb);
    }
    if (figure.script.empty()) return files;
    const std::string script = figure.name + ".gp";
    files[script] = figure.script;
    files[plot_style_file] = plot_style_script();
    GnuplotResult plotted = run_gnuplot(files, script, figure.pictures());
    if (!plotted.warnings.empty()) console.warning("gnuplot: " + plotted.warnings);
    files.merge(plotted.files);
    return files;
}

int run_figures(const FiguresOptions& options, Console& console) {
    const auto colours = open_ocio_spaces({options.ocio, "", "--ocio"});
    const auto to_display = colours->display_view("", "", colours->description());
    const bool is_srgb = to_display->interop_id() == srgb_display_id;
    const std::vector<PaperFigure> figures = paper_figures(*to_display, is_srgb);
    OutputFolder folder(options.folder);
    NamedFiles files{{"README.md", figures_readme(figures)}};
    Json json = Json::array();
    for (const PaperFigure& figure : figures) {
        throw_if_stopped();
        files.merge(figure_files(figure, *to_display, is_srgb, console));
        console.progress(json.size() + 1, figures.size());
        json.push_back(Json{{"name", figure.name}, {"title", figure.title}, {"files", figure.files()}});
    }
    for (const auto& [name, bytes] : files) {
        if (!folder.holds(name, bytes)) folder.write(name, bytes);
    }
    throw_if_stopped();
    folder.commit();
    for (const PaperFigure& figure : figures) console.summary(figure.title + ": " + comma_separated(figure.files()));
    if (console.json()) console.result_json(Json{{"figures", json}});
    return exit_done;
}

}  // namespace

Command figures_command() {
    const auto options = std::make_shared<FiguresOptions>();
    Command command{"figures", "draw the figures of Park & Tsuruno 2014: data, gnuplot scripts and plots", {}, {}};
    command.options = {{.names = "-o,--output",
                        .target = &options->folder,
                        .help = "folder for the files; created if it is missing",
                        .value_name = "DIR",
                        .shows_default = true},
                       ocio_option(options->ocio)};
    command.footer =
        "\nDraws figures 5, 7, 8, 9, 11, 12 and 14 of Park & Tsuruno 2014 from its equations and parameters: CSV, "
        "gnuplot\n"
        "script and PNG of each, and a README.md that says what they show. stacks_morpho and stacks_beetle compare "
        "the\n"
        "paper's palettes with layers that are solved exactly. study counts the moves of an automatic user to "
        "given\n"
        "pictures. bands shows what the keys floor and flatness of a palette do. Needs gnuplot (Debian package "
        "gnuplot-nox).\n\n"
        "Example:\n  nacre figures -o figures\n";
    command.run = [options](Console& console) { return run_figures(*options, console); };
    return command;
}

}  // namespace nacre
