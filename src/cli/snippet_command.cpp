#include <memory>
#include <string>

#include "cli/commands.h"
#include "nacre/lut/snippet.h"

namespace nacre {

Command snippet_command() {
    const auto language = std::make_shared<std::string>();
    Command command{"snippet", "print the shader code that fetches from a LUT", {}, {}};
    command.options = {{.names = "LANGUAGE",
                        .target = language.get(),
                        .help = "glsl (ES 3.00, 3.30 and later) or hlsl",
                        .is_required = true,
                        .allowed = {"glsl", "hlsl"}}};
    command.footer = "\nExample:\n  nacre snippet glsl > nacre.glsl\n";
    command.run = [language](Console& console) -> int {
        std::string text = snippet(*language == "glsl" ? ShaderLanguage::glsl : ShaderLanguage::hlsl);
        if (text.ends_with('\n')) text.pop_back();
        console.result(text);
        return exit_done;
    };
    return command;
}

}  // namespace nacre
