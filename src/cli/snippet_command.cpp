#include "cli/commands.h"
#include "nacre/lut/snippet.h"

namespace nacre {

Command add_snippet_command(CLI::App& app) {
    const auto language = std::make_shared<std::string>();
    app.add_option("LANGUAGE", *language, "glsl (ES 3.00, 3.30 and later) or hlsl")
        ->required()
        ->check(CLI::IsMember({"glsl", "hlsl"}));
    app.footer("\nExample:\n  nacre snippet glsl > nacre.glsl\n");
    return [language](Console& console) {
        std::string text = snippet(*language == "glsl" ? ShaderLanguage::glsl : ShaderLanguage::hlsl);
        if (text.ends_with('\n')) text.pop_back();
        console.result(text);
        return static_cast<int>(exit_done);
    };
}

}  // namespace nacre
