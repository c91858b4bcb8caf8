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
};

constexpr Shipped shipped[] = {
    {"ag", material_ag},
    {"air", material_air},
    {"al", material_al},
    {"al2o3", material_al2o3},
    {"aragonite", material_aragonite},
    {"au", material_au},
    {"bk7", material_bk7},
    {"calcite", material_calcite},
    {"chitin", material_chitin},
    {"cr", material_cr},
    {"cu", material_cu},
    {"cuticle", material_cuticle},
    {"cytoplasm", material_cytoplasm},
    {"fe2o3", material_fe2o3},
    {"guanine", material_guanine},
    {"keratin", material_keratin},
    {"melanin", material_melanin},
    {"mgf2", material_mgf2},
    {"mica", material_mica},
    {"oil", material_oil},
    {"si", material_si},
    {"sio2", material_sio2},
    {"tio2", material_tio2},
    {"water", material_water},
};

bool names_a_file(const std::string& name) {
    return name.ends_with(".yml") || name.ends_with(".yaml") || name.ends_with(".csv");
}

}  // namespace

std::vector<std::string> shipped_material_names() {
    std::vector<std::string> names;
    for (const Shipped& material : shipped) names.emplace_back(material.name);
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
    throw Error(where + ": unknown material " + in_quotes(name) +
                "; known: " + known_like(name, shipped_material_names()) + ", or a .yml or .csv file");
}

}  // namespace nacre
