#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "io/disk/output_folder.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "pipeline/json.h"

namespace nacre {

extern const std::string_view first_toml;

namespace {

// What the scene calls its material, its LUT and itself.
constexpr std::string_view placeholder = "NAME";

std::string first_scene(const std::string& name) {
    std::string text(first_toml);
    for (std::size_t at = text.find(placeholder); at != std::string::npos;
         at = text.find(placeholder, at + name.size()))
        text.replace(at, placeholder.size(), name);
    return text;
}

// A name that TOML needs no quotes for.
void check_scene_name(const std::string& name) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    constexpr std::size_t longest = 80;  // with what is appended to it less than a name of a LUT may have
    if (name.empty() || name.size() > longest || name.front() == '-' ||
        !std::all_of(name.begin(), name.end(), is_allowed))
        throw Error("the name " + in_quotes(name) + " cannot be that of a material; give 1 to " +
                    std::to_string(longest) + " characters out of A-Z a-z 0-9 _ - that do not begin with -");
}

int run_init(const std::string& word, Console& console) {
    std::filesystem::path file(word);
    if (file.extension() != ".toml") file += ".toml";
    const std::string name = file.stem().string();
    check_scene_name(name);
    if (std::filesystem::exists(file)) {
        throw Error(file.string() +
                    ": exists already, and nacre does not overwrite a scene; give another name, as in " +
                    "nacre init " + name + "2");
    }
    OutputFolder folder(file.has_parent_path() ? file.parent_path().string() : ".");
    folder.write(file.filename().string(), first_scene(name));
    folder.commit();
    console.summary(file.string() + ": written; look at it with nacre swatch " + file.string() + " -o out");
    if (console.json()) console.result_json(Json{{"file", file.string()}});
    return exit_done;
}

}  // namespace

Command init_command() {
    const auto name = std::make_shared<std::string>("first");
    Command command{"init", "write a first scene to change", {}, {}};
    command.options = {{.names = "NAME",
                        .target = name.get(),
                        .help = "name of the scene and of its material; nacre writes NAME.toml. Default: first"}};
    command.footer =
        "\nThe scene has two picked colours, a LUT and a swatch, and comments that explain them. A file that exists "
        "is\n"
        "never overwritten.\n\nExample:\n  nacre init hero && nacre bake hero.toml -o out\n";
    command.run = [name](Console& console) { return run_init(*name, console); };
    return command;
}

}  // namespace nacre
