#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/text_table.h"
#include "io/ocio/ocio_spaces.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "pipeline/json.h"
#include "pipeline/listed_table.h"
#include "pipeline/metal_table.h"
#include "pipeline/name_lists.h"

namespace nacre {
namespace {

struct ListOptions {
    std::vector<std::string> words;
    std::string ocio;
};

void print_titles(Console& console) {
    std::vector<std::vector<std::string>> rows;
    Json json = Json::array();
    for (const ListTitle& title : list_titles()) {
        rows.push_back({title.name, title.description, title.where});
        json.push_back(Json{{"list", title.name}, {"description", title.description}, {"where", title.where}});
    }
    for (const std::string& line : table_lines(rows)) console.summary(line);
    if (console.json()) console.result_json(Json{{"lists", json}});
}

void print_names(const std::string& list, const std::string& ocio, Console& console) {
    std::vector<std::vector<std::string>> rows;
    Json json = Json::array();
    for (const ListedName& one : listed_names(list, open_ocio_spaces, {ocio, "", "--ocio"})) {
        rows.push_back({one.name, one.description});
        json.push_back(Json{{"name", one.name}, {"description", one.description}});
    }
    for (const std::string& line : table_lines(rows)) console.summary(line);
    if (console.json()) console.result_json(Json{{"list", list}, {"names", json}});
}

// F0 and F82 as renderers take them. Four decimals are more than an eye tells apart.
void print_metals(Console& console) {
    const auto text = [](const std::array<double, 3>& rgb) {
        return fixed_text(rgb[0], 4) + " " + fixed_text(rgb[1], 4) + " " + fixed_text(rgb[2], 4);
    };
    std::vector<std::vector<std::string>> rows{{"metal", "space", "F0", "F82", "F82 tint", "dE00", "Schlick dE00"}};
    Json json = Json::array();
    for (const MetalInSpace& row : metal_table()) {
        rows.push_back({row.metal, row.space, text(row.f0), text(row.f82), text(row.tint),
                        significant_text(row.f82_de00, 2), significant_text(row.schlick_de00, 2)});
        json.push_back(Json{{"name", row.metal},
                            {"description", row.description},
                            {"space", row.space},
                            {"f0", row.f0},
                            {"f82", row.f82},
                            {"f82_tint", row.tint},
                            {"f82_de00", row.f82_de00},
                            {"schlick_de00", row.schlick_de00}});
    }
    for (const std::string& line : table_lines(rows)) console.summary(line);
    if (console.json()) console.result_json(Json{{"list", "metals"}, {"names", json}});
}

// The result itself, so --quiet prints it too.
void print_table(const std::string& list, const std::string& name, Console& console) {
    const ListedTable table = listed_table(list, name);
    if (console.json()) {
        Json rows = Json::array();
        for (const std::vector<double>& row : table.rows) rows.push_back(row);
        console.result_json(Json{{"list", list}, {"name", name}, {"columns", table.columns}, {"rows", rows}});
        return;
    }
    std::string heading;
    for (const std::string& column : table.columns) heading += (heading.empty() ? "" : ",") + column;
    console.result(heading);
    for (const std::vector<double>& row : table.rows) {
        std::string line;
        for (const double number : row) line += (line.empty() ? "" : ",") + number_text(number);
        console.result(line);
    }
}

void check_words(const std::vector<std::string>& words) {
    std::vector<std::string> known;
    for (const ListTitle& title : list_titles()) known.push_back(title.name);
    if (!words.empty() && std::find(known.begin(), known.end(), words[0]) == known.end())
        throw Error("LIST " + in_quotes(words[0]) + " is unknown; known: " + comma_separated(known) +
                    "; see nacre list --help");
    if (words.size() > 2) throw Error("unexpected argument " + in_quotes(words[2]) + "; see nacre list --help");
}

int run_list(const ListOptions& options, Console& console) {
    const std::vector<std::string>& words = options.words;
    check_words(words);
    if (words.empty()) {
        print_titles(console);
    } else if (words.size() == 1 && words[0] == "metals") {
        print_metals(console);
    } else if (words.size() == 1) {
        print_names(words[0], options.ocio, console);
    } else {
        print_table(words[0], words[1], console);
    }
    return exit_done;
}

}  // namespace

Command list_command() {
    const auto options = std::make_shared<ListOptions>();
    Command command{"list", "print the names that a scene may use, and the CIE tables", {}, {}};
    command.options = {{.names = "LIST",
                        .target = &options->words,
                        .help = "materials, metals, spaces, displays, illuminants, mechanisms, axes, ...; without it, "
                                "all lists. The name of "
                                "an illuminant or of an observer behind its list prints its table as CSV"},
                       ocio_option(options->ocio)};
    command.footer =
        "\nThe colour spaces and the displays are those of the OpenColorIO config: --ocio, else $OCIO, else the "
        "config\n"
        "that nacre contains. A table has the numbers of the CIE: the relative power of an illuminant, in the form "
        "that\n"
        "[light] reads, or the colour matching functions of an observer. metals has the colours of the shipped metals\n"
        "for a renderer: F0, F82 and the tint of the F82-tint model, and its largest error in CIEDE2000.\n\n"
        "Examples:\n  nacre list materials\n  nacre list metals\n"
        "  nacre list spaces --ocio config.ocio\n  nacre list illuminants FL11\n"
        "  nacre list observers cie1931_2deg\n";
    command.run = [options](Console& console) { return run_list(*options, console); };
    return command;
}

}  // namespace nacre
