#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/text_table.h"
#include "io/ocio/ocio_spaces.h"
#include "pipeline/json.h"
#include "pipeline/name_lists.h"

namespace nacre {
namespace {

struct ListOptions {
    std::string list;
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

void print_names(const ListOptions& options, Console& console) {
    std::vector<std::vector<std::string>> rows;
    Json json = Json::array();
    for (const ListedName& one : listed_names(options.list, open_ocio_spaces, {options.ocio, "", "--ocio"})) {
        rows.push_back({one.name, one.description});
        json.push_back(Json{{"name", one.name}, {"description", one.description}});
    }
    for (const std::string& line : table_lines(rows)) console.summary(line);
    if (console.json()) console.result_json(Json{{"list", options.list}, {"names", json}});
}

std::vector<std::string> list_names() {
    std::vector<std::string> names;
    for (const ListTitle& title : list_titles()) names.push_back(title.name);
    return names;
}

}  // namespace

Command list_command() {
    const auto options = std::make_shared<ListOptions>();
    Command command{"list", "print the names that a scene may use", {}, {}};
    command.options = {
        {.names = "LIST",
         .target = &options->list,
         .help = "materials, spaces, displays, illuminants, mechanisms, axes, ...; without it, all lists",
         .allowed = list_names()},
        ocio_option(options->ocio)};
    command.footer =
        "\nThe colour spaces and the displays are those of the OpenColorIO config: --ocio, else $OCIO, else the "
        "config\n"
        "that nacre contains.\n\nExamples:\n  nacre list materials\n  nacre list spaces --ocio config.ocio\n";
    command.run = [options](Console& console) -> int {
        options->list.empty() ? print_titles(console) : print_names(*options, console);
        return exit_done;
    };
    return command;
}

}  // namespace nacre
