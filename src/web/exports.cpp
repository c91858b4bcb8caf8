// What the module of WebAssembly exports: one call, and the numbers that its answer may have beside the JSON.
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/scene/shipped_materials.h"
#include "nacre/base/error.h"
#include "nacre/lut/snippet.h"
#include "pipeline/json.h"
#include "pipeline/version.h"
#include "web/session.h"

// Told how far a search is; defined by the page, see page/module.ts.
EM_JS(void, nacre_tell, (int done), {
    if (Module.step) Module.step(done);
});

namespace nacre {
namespace {

using Arguments = nlohmann::json;

struct State {
    Session session;
    std::string answer;
    std::string bytes;
};

State& state() {
    static State one;
    return one;
}

template <typename Number>
void keep(const std::vector<Number>& numbers) {
    state().bytes.assign(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

Lobe lobe_of(const Arguments& pick) {
    return {pick.at("peakNm"), pick.at("widthNm"), pick.at("height"), pick.at("floor"), pick.at("flatness")};
}

Json listed(const std::vector<ListedName>& names) {
    Json list = Json::array();
    for (const ListedName& one : names) list.push_back({{"name", one.name}, {"about", one.description}});
    return list;
}

using Call = Json (*)(Session& session, const Arguments& in);

// The calls of page/api.ts, by name.
const std::map<std::string_view, Call>& calls() {
    static const std::map<std::string_view, Call> table{
        {"version", [](Session&, const Arguments&) { return Json(std::string(nacre_version())); }},
        {"open", [](Session& session, const Arguments& in) { return session.open(in.at(0)); }},
        {"bake",
         [](Session& session, const Arguments& in) {
             Session::Answer answer = session.bake(in.at(0), in.at(1));
             keep(answer.numbers);
             return std::move(answer.json);
         }},
        {"cost", [](Session& session, const Arguments& in) { return session.cost(in.at(0), in.at(1)); }},
        {"exr",
         [](Session& session, const Arguments& in) {
             state().bytes = session.exr(in.at(0));
             return Json();
         }},
        {"xyz",
         [](Session& session, const Arguments& in) {
             keep(session.xyz(in.at(0)));
             return Json();
         }},
        {"manifest", [](Session& session, const Arguments& in) { return Json(session.manifest(in.at(0))); }},
        {"snippet",
         [](Session&, const Arguments& in) {
             return Json(std::string(snippet(in.at(0) == "hlsl" ? ShaderLanguage::hlsl : ShaderLanguage::glsl)));
         }},
        {"paletteField",
         [](Session& session, const Arguments& in) {
             keep(session.palette_field(lobe_of(in.at(0)), in.at(1), in.at(2), in.at(3)));
             return Json();
         }},
        {"findStructure",
         [](Session& session, const Arguments& in) {
             return session.find_structure(in.at(0), in.at(1), [](int done) { nacre_tell(done); });
         }},
        {"shippedMaterials", [](Session&, const Arguments&) { return listed(shipped_material_list()); }},
    };
    return table;
}

Json answer_to(const std::string& name, const std::string& arguments) {
    try {
        return {{"result", calls().at(name)(state().session, Arguments::parse(arguments))}};
    } catch (const std::exception& error) {
        return {{"error", error.what()}};
    }
}

}  // namespace
}  // namespace nacre

extern "C" {

/// Calls `name` with a JSON array of arguments. The answer is JSON, { "result": ... } or { "error": "..." }, and stays
/// until the next call.
EMSCRIPTEN_KEEPALIVE const char* nacre_call(const char* name, const char* arguments) {
    nacre::state().bytes.clear();
    nacre::state().answer = nacre::answer_to(name, arguments).text();
    return nacre::state().answer.c_str();
}

/// The numbers or the file beside the last answer.
EMSCRIPTEN_KEEPALIVE const char* nacre_bytes() {
    return nacre::state().bytes.data();
}
EMSCRIPTEN_KEEPALIVE std::size_t nacre_byte_count() {
    return nacre::state().bytes.size();
}

/// Puts a file into the module's file system, for scenes that name it. @return whether that worked
EMSCRIPTEN_KEEPALIVE bool nacre_put_file(const char* path, const char* bytes, std::size_t count) {
    nacre::state().session.files_changed();
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path, "wb"), &std::fclose);
    return file && std::fwrite(bytes, 1, count, file.get()) == count;
}
}
