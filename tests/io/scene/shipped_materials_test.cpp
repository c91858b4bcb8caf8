#include "io/scene/shipped_materials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "io/scene/material_file.h"
#include "nacre/base/error.h"
#include "support/folders.h"

namespace nacre {
namespace {

const std::filesystem::path materials_folder = std::filesystem::path(NACRE_TEST_DATA_DIR) / "../../configs/materials";

// Wavelengths of the default light.
constexpr double first_nm = 360.0, last_nm = 830.0;

/// The rows of the README's table: cells without blanks around them.
std::vector<std::vector<std::string>> readme_rows() {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(test::file_bytes(materials_folder / "README.md"));
    for (std::string line; std::getline(text, line);) {
        if (!line.starts_with("| `")) continue;
        std::vector<std::string> cells;
        std::istringstream stream(line.substr(1));
        for (std::string cell; std::getline(stream, cell, '|');) {
            const std::size_t begin = cell.find_first_not_of(' ');
            if (begin == std::string::npos) continue;
            cells.push_back(cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
        }
        rows.push_back(cells);
    }
    return rows;
}

std::string message_for(const std::string& name, const std::string& folder) {
    try {
        find_material(name, folder, "s.toml:3:1");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ShippedMaterials, AreTheFilesOfTheirFolder) {
    std::vector<std::string> stems;
    for (const auto& entry : std::filesystem::directory_iterator(materials_folder)) {
        if (entry.path().extension() == ".yml") stems.push_back(entry.path().stem().string());
    }
    std::sort(stems.begin(), stems.end());
    EXPECT_EQ(shipped_material_names(), stems);
    for (const std::string& stem : stems) {
        IndexCurve file = read_material_file((materials_folder / (stem + ".yml")).string());
        file.name = stem;
        file.is_shipped = true;
        ASSERT_NE(shipped_material(stem), nullptr);
        EXPECT_EQ(*shipped_material(stem), file) << "another file is compiled in as " << stem;
    }
    EXPECT_EQ(shipped_material("unobtainium"), nullptr);
    EXPECT_EQ(shipped_material(""), nullptr);
}

TEST(ShippedMaterials, CoverTheDefaultLightWithPlausibleIndices) {
    for (const std::string& name : shipped_material_names()) {
        const auto material = shipped_material(name);
        EXPECT_EQ(material->name, name);
        EXPECT_LE(material->first_nm, first_nm) << name;
        EXPECT_GE(material->last_nm, last_nm) << name;
        EXPECT_FALSE(material->holds_outside) << name;
        for (double nm = first_nm; nm <= last_nm; nm += 0.5) {
            const RefractiveIndex index = material->at(nm);
            EXPECT_TRUE(index.real() > 0.01 && index.real() < 7.0) << name << " " << nm;  // silver .. silicon
            EXPECT_TRUE(index.imag() >= 0.0 && index.imag() < 10.0) << name << " " << nm;
        }
    }
}

TEST(ShippedMaterials, AreWhatTheirReadmeSays) {
    const auto rows = readme_rows();
    std::vector<std::string> names;
    for (const auto& cells : rows) {
        ASSERT_EQ(cells.size(), 8u) << cells.front();
        names.push_back(cells[0].substr(1, cells[0].size() - 2));
        const auto material = shipped_material(names.back());
        ASSERT_NE(material, nullptr) << names.back();
        const RefractiveIndex index = material->at(550);
        const double last_digit = cells[2].size() > 6 ? 1e-5 : 1e-4;
        EXPECT_NEAR(index.real(), std::stod(cells[2]), 0.5001 * last_digit) << names.back();
        EXPECT_NEAR(index.imag(), std::stod(cells[3]), 0.005 * index.imag()) << names.back();  // three digits
        std::istringstream range(cells[4]);
        double first = 0.0, last = 0.0;
        std::string to;
        range >> first >> to >> last;
        EXPECT_NEAR(material->first_nm, first, 1e-9) << names.back();
        EXPECT_NEAR(material->last_nm, last, 1e-9) << names.back();
    }
    EXPECT_EQ(names, shipped_material_names());
}

TEST(ShippedMaterials, HaveTheIndicesOfTheirPapers) {
    const auto n = [](const char* name, double nm) { return shipped_material(name)->at(nm).real(); };
    // Leertouwer, Wilts & Stavenga 2011, abstract; three decimals.
    const std::map<double, std::pair<double, double>> chitin_and_keratin{
        {400, {1.572, 1.569}}, {500, {1.552, 1.556}}, {600, {1.541, 1.548}}};
    for (const auto& [nm, pair] : chitin_and_keratin) {
        EXPECT_NEAR(n("chitin", nm), pair.first, 6e-4) << nm;
        EXPECT_NEAR(n("keratin", nm), pair.second, 6e-4) << nm;
    }
    EXPECT_EQ(shipped_material("cuticle")->at(440), RefractiveIndex(1.56, 0.06));  // Vukusic et al. 1999, abstract
    // ISO 8036-1: n_e = 1.5180 and v_e = (n_e - 1) / (n_F' - n_C') = 44.
    EXPECT_NEAR(n("oil", 546.074), 1.5180, 1e-6);
    EXPECT_NEAR((n("oil", 546.074) - 1.0) / (n("oil", 479.9914) - n("oil", 643.8469)), 44.0, 1e-3);
    // The table of melanin against k = 0.56 exp(-wavelength / 270 nm).
    for (double nm = first_nm; nm <= last_nm; nm += 0.5) {
        const double k = 0.56 * std::exp(-nm / 270.0);
        EXPECT_NEAR(shipped_material("melanin")->at(nm).imag(), k, 5e-5 * k) << nm;
    }
    EXPECT_NEAR(n("melanin", 500), 1.648 + 23700.0 / 250000.0, 1e-12);
    // Textbooks: silica, water, sapphire, calcite at the d line.
    EXPECT_NEAR(n("sio2", 587.56), 1.45846, 5e-6);
    EXPECT_NEAR(n("water", 589.3), 1.3334, 2e-4);
    EXPECT_NEAR(n("al2o3", 587.56), 1.76817, 5e-6);
    EXPECT_NEAR(n("calcite", 587.56), 1.6585, 1e-4);
}

TEST(ShippedMaterials, AreListedWithHalfALineOfWords) {
    const std::vector<ListedName> list = shipped_material_list();
    const std::vector<std::string> names = shipped_material_names();
    ASSERT_EQ(list.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(list[i].name, names[i]);
        EXPECT_FALSE(list[i].description.empty()) << names[i];
    }
    EXPECT_EQ(list.front().description, "silver");
}

TEST(FindMaterial, TakesAFileByItsEndingAndAMaterialByItsName) {
    const test::TemporaryFolder folder;
    folder.file("sub/mine.csv", "400,1.5\n700,1.4\n");
    const auto file = find_material("sub/mine.csv", folder.path().string(), "s.toml:3:1");
    EXPECT_EQ(file->name, "mine.csv");
    EXPECT_EQ(file->at(400).real(), 1.5);
    EXPECT_EQ(*find_material((folder.path() / "sub/mine.csv").string(), "elsewhere", "s.toml:3:1"), *file);
    EXPECT_EQ(*find_material("water", folder.path().string(), "s.toml:3:1"), *shipped_material("water"));
}

TEST(FindMaterial, NamesWhatItCannotFind) {
    EXPECT_EQ(message_for("watr", ""),
              "s.toml:3:1: unknown material \"watr\"; nearest: water, air; `nacre list materials` prints all; a .yml "
              "or .csv file is also allowed");
    EXPECT_EQ(message_for("TiO2", ""),
              "s.toml:3:1: unknown material \"TiO2\"; nearest: tio2, sio2; `nacre list materials` prints all; a .yml "
              "or .csv file is also allowed");
    EXPECT_EQ(message_for("unobtainium", ""),
              "s.toml:3:1: unknown material \"unobtainium\"; known: ag, air, al, al2o3, aragonite, ...; `nacre list "
              "materials` prints all; a .yml or .csv file is also allowed");
    EXPECT_EQ(message_for("Titanium Dioxide", ""),
              "s.toml:3:1: unknown material \"Titanium Dioxide\"; did you mean tio2?");
    EXPECT_EQ(message_for("gold", ""), "s.toml:3:1: unknown material \"gold\"; did you mean au?");
    EXPECT_EQ(message_for("mine.yml", "/nowhere"),
              "s.toml:3:1: /nowhere/mine.yml: cannot be opened: No such file or directory");
    const test::TemporaryFolder folder;
    const std::string path = folder.file("bad.yml", "DATA: 1\n");
    EXPECT_EQ(message_for("bad.yml", folder.path().string()),
              path +
                  ":1: DATA must be a list of one block or more; a material is YAML with DATA, as refractiveindex.info "
                  "has it");
}

}  // namespace
}  // namespace nacre
