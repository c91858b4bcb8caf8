// Prints what a session makes of the one-dimensional LUTs of scenes, as JSON: the module of WebAssembly is compared
// with it. A folder of a scene is where its tables are.
//
//   nacre_session_numbers SCENE.toml...
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "nacre/base/error.h"
#include "pipeline/json.h"
#include "web/session.h"

int main(int count, char** arguments) {
    using namespace nacre;
    Json all = Json::array();
    try {
        for (int i = 1; i < count; ++i) {
            const std::filesystem::path path = std::filesystem::absolute(arguments[i]);
            std::filesystem::current_path(path.parent_path());
            std::ifstream file(path);
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            Session session;
            session.open(text);
            for (const std::string& lut : session.luts()) {
                if (session.has_second_axis(lut)) continue;
                all.push_back({{"scene", path.stem().string()}, {"lut", lut}, {"xyz", session.xyz(lut)}});
            }
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    std::printf("%s\n", all.text().c_str());
}
