#include "io/scene/shipped_materials.h"

#include <filesystem>
#include <utility>

#include "io/scene/material_file.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"

namespace nacre {

// The files of configs/materials, embedded by src/io/CMakeLists.txt.
extern const std::string_view material_ag;
extern const std::string_view material_air;
extern const std::string_view material_al;
extern const std::string_view material_al2o3;
extern const std::string_view material_aragonite;
extern const std::string_view material_au;
extern const std::string_view material_bk7;
extern const std::string_view material_calcite;
extern const std::string_view material_chitin;
extern const std::string_view material_cr;
extern const std::string_view material_cu;
extern const std::string_view material_cuticle;
extern const std::string_view material_cytoplasm;
extern const std::string_view material_fe2o3;
extern const std::string_view material_guanine;
extern const std::string_view material_keratin;
extern const std::string_view material_melanin;
extern const std::string_view material_mgf2;
extern const std::string_view material_mica;
extern const std::string_view material_oil;
extern const std::string_view material_si;
extern const std::string_view material_sio2;
extern const std::string_view material_tio2;
extern const std::string_view material_water;

namespace {

// A row refers to the other object, because objects of different files are initialised in an unknown order.
struct Shipped {
    std::string_view name;
    const std::string_view& yaml;
    std::string_view description;  // half a line; configs/materials/README.md says more
};

constexpr Shipped shipped[] = {
    {"ag", material_ag, "silver"},
    {"air", material_air, "standard air, 15 C"},
    {"al", material_al, "aluminium, evaporated, without oxide"},
    {"al2o3", material_al2o3, "sapphire, ordinary ray"},
    {"aragonite", material_aragonite, "aragonite along its c axis: tablets of nacre head-on"},
    {"au", material_au, "gold"},
    {"bk7", material_bk7, "optical glass N-BK7"},
    {"calcite", material_calcite, "calcite, ordinary ray"},
    {"chitin", material_chitin, "butterfly chitin"},
    {"cr", material_cr, "chromium"},
    {"cu", material_cu, "copper"},
    {"cuticle", material_cuticle, "cuticle of Morpho scales, with its pigment"},
    {"cytoplasm", material_cytoplasm, "watery cell fluid"},
    {"fe2o3", material_fe2o3, "hematite, extraordinary ray"},
    {"guanine", material_guanine, "guanine plates of fish, head-on"},
    {"keratin", material_keratin, "keratin of white feathers"},
    {"melanin", material_melanin, "melanin of insects and birds"},
    {"mgf2", material_mgf2, "magnesium fluoride, ordinary ray"},
    {"mica", material_mica, "muscovite flake, head-on"},
    {"oil", material_oil, "immersion oil"},
    {"si", material_si, "silicon, crystalline"},
    {"sio2", material_sio2, "fused silica"},
    {"tio2", material_tio2, "titania, a film by atomic layer deposition"},
    {"water", material_water, "water, 20 C"},
};

// What people call these materials; in lower case.
struct OtherName {
    std::string_view name;
    std::string_view material;
};
constexpr OtherName other_names[] = {
    {"alumina", "al2o3"},  {"aluminium", "al"},          {"aluminum", "al"}, {"chrome", "cr"},       {"chromium", "cr"},
    {"copper", "cu"},      {"fused silica", "sio2"},     {"glass", "bk7"},   {"gold", "au"},         {"h2o", "water"},
    {"hematite", "fe2o3"}, {"iron oxide", "fe2o3"},      {"n-bk7", "bk7"},   {"nacre", "aragonite"}, {"quartz", "sio2"},
    {"rust", "fe2o3"},     {"sapphire", "al2o3"},        {"silica", "sio2"}, {"silicon", "si"},      {"silver", "ag"},
    {"titania", "tio2"},   {"titanium dioxide", "tio2"}, {"vacuum", "air"},
};

std::string offered(const std::string& name) {
    std::string key = name;
    for (char& c : key) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '_' ? ' ' : c;
    for (const OtherName& other : other_names) {
        if (other.name == key) return "did you mean " + std::string(other.material) + "?";
    }
    const std::vector<std::string> known = shipped_material_names();
    return (nearest_names(name, known, 1).empty() ? "known: " : "nearest: ") + known_like(name, known) +
           "; `nacre list materials` prints all; a .yml or .csv file is also allowed";
}

bool names_a_file(const std::string& name) {
    return name.ends_with(".yml") || name.ends_with(".yaml") || name.ends_with(".csv");
}

}  // namespace

std::vector<std::string> shipped_material_names() {
    std::vector<std::string> names;
    for (const Shipped& material : shipped) names.emplace_back(material.name);
    return names;
}

std::vector<ListedName> shipped_material_list() {
    std::vector<ListedName> names;
    for (const Shipped& material : shipped)
        names.push_back({std::string(material.name), std::string(material.description)});
    return names;
}

std::shared_ptr<const IndexCurve> shipped_material(std::string_view name) {
    for (const Shipped& material : shipped) {
        if (material.name != name) continue;
        IndexCurve curve = parse_material_yaml(material.yaml, std::string(name) + ".yml");
        curve.name = name;
        curve.is_shipped = true;
        return std::make_shared<const IndexCurve>(std::move(curve));
    }
    return nullptr;
}

std::shared_ptr<const IndexCurve> find_material(const std::string& name, const std::string& folder,
                                                const std::string& where) {
    if (names_a_file(name)) {
        try {
            const std::filesystem::path path = std::filesystem::path(folder) / name;
            return std::make_shared<const IndexCurve>(read_material_file(path.string()));
        } catch (const IoError& error) {
            throw Error(where + ": " + error.what());
        }
    }
    if (auto material = shipped_material(name)) return material;
    throw Error(where + ": unknown material " + in_quotes(name) + "; " + offered(name));
}

}  // namespace nacre
