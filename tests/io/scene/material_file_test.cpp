#include "io/scene/material_file.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "nacre/base/error.h"
#include "reference/csv.h"
#include "support/folders.h"

namespace nacre {
namespace {

const std::string formula_block =
    "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 1\n    coefficients: 1.5 0.01 -2\n";
const std::string table_head = "DATA:\n  - type: tabulated nk\n    data: |\n";

std::string reference_file(const std::string& name) {
    return std::string(NACRE_REFERENCE_DATA_DIR) + "/" + name;
}

template <typename Action>
std::string message_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

std::string yaml_message(const std::string& text) {
    return message_of([&] { parse_material_yaml(text, "some/x.yml"); });
}

std::string csv_message(const std::string& text) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("x.csv", text);
    const std::string message = message_of([&] { read_material_file(path); });
    return message.starts_with(path) ? message.substr(path.size()) : "elsewhere: " + message;
}

TEST(MaterialFile, ReadsEveryKindOfBlockAsAnotherReaderDoes) {
    const auto csv = reference::read_csv("rii_index.csv");
    ASSERT_EQ(csv.rows.size(), 16u);
    int compared = 0;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const std::string& name = csv.text(row, "file");
        const IndexCurve curve = read_material_file(reference_file("rii/" + name));
        EXPECT_EQ(curve.name, name);
        EXPECT_EQ(curve.first_nm, csv.number(row, "first_nm")) << name;
        EXPECT_EQ(curve.last_nm, csv.number(row, "last_nm")) << name;
        for (const auto& [column, nm] : {std::pair{"400", 400.0}, {"500", 500.0}, {"587.6", 587.6}, {"700", 700.0}}) {
            const auto n = csv.number(row, std::string("n_") + column);
            const auto k = csv.number(row, std::string("k_") + column);
            const RefractiveIndex index = n || k ? curve.at(nm) : RefractiveIndex();
            EXPECT_NEAR(index.real(), n.value_or(index.real()), 1e-7) << name << " " << nm;
            EXPECT_NEAR(index.imag(), k.value_or(curve.is_lossless() ? 0.0 : index.imag()), 1e-7 * index.imag())
                << name << " " << nm;
            compared += (n ? 1 : 0) + (k ? 1 : 0);
        }
    }
    EXPECT_EQ(compared, 75);
}

TEST(MaterialFile, KnowsEveryFormulaByItsNumber) {
    const std::vector<std::string> files{
        "formula1_sio2_malitson", "formula2_water_daimon",    "formula3_pmma_beadie",
        "formula4_mgo_stephens",  "formula5_hfo2_al-kuhaili", "formula6_air_ciddor",
        "formula7_si_edwards",    "formula8_agbr_schroter",   "formula9_urea-e_rosker"};
    for (std::size_t i = 0; i < files.size(); ++i) {
        const IndexCurve curve = read_material_file(reference_file("rii/" + files[i] + ".yml"));
        const auto* formula = std::get_if<IndexFormula>(&curve.n);
        ASSERT_NE(formula, nullptr) << files[i];
        EXPECT_EQ(formula->number, static_cast<int>(i + 1));
        EXPECT_TRUE(curve.is_lossless());
    }
    // Edwards and Ochoa 1980, by hand at 10 um: 3.41983 + 0.159906/99.972 - 0.123109/99.972^2 + 1.26878e-4
    // - 1.95104e-5.
    const IndexCurve silicon = read_material_file(reference_file("rii/formula7_si_edwards.yml"));
    EXPECT_NEAR(silicon.at(10000).real(), 3.421524558, 1e-8);
}

TEST(MaterialFile, TakesNFromTheFormulaAndKFromTheTableBesideIt) {
    const IndexCurve pvp = read_material_file(reference_file("rii/formula5_nk_pvp_konig.yml"));
    EXPECT_TRUE(std::holds_alternative<IndexFormula>(pvp.n));
    EXPECT_NEAR(pvp.at(500).real(), 1.5151 + 0.00279 * 4.0 + 5.0756e-4 * 16.0, 1e-14);
    EXPECT_EQ(pvp.at(500).imag(), 0.0026427);
    const std::string table = "  - type: tabulated nk\n    data: |\n        0.4 1.6 0.1\n        0.8 1.6 0.2\n";
    const IndexCurve after = parse_material_yaml(formula_block + table, "x.yml");
    const IndexCurve before = parse_material_yaml("DATA:\n" + table + formula_block.substr(6), "x.yml");
    EXPECT_EQ(after, before);
    EXPECT_NEAR(after.at(500).real(), 1.54, 1e-15);
    EXPECT_NEAR(after.at(500).imag(), 0.125, 1e-15);
}

TEST(MaterialFile, IsKnownWhereBothNAndKAre) {
    const IndexCurve curve = parse_material_yaml(
        "DATA:\n  - type: tabulated k\n    data: |\n      0.5 0.1\n      1.2 0.2\n"
        "  - type: tabulated n\n    data: |\n      0.45 1.5\n      0.6 1.6\n      1.005 1.7\n",
        "x.yml");
    EXPECT_EQ(curve.first_nm, 500.0);
    EXPECT_EQ(curve.last_nm, 1005.0);  // and not 1004.9999999999999, which 1.005 * 1000 is
    EXPECT_NEAR(curve.at(500).real(), 1.5 + 0.1 / 3.0, 1e-14);
    EXPECT_EQ(curve.at(500).imag(), 0.1);
}

TEST(MaterialFile, DoesNotCareHowAFileIsWritten) {
    const IndexCurve plain = parse_material_yaml(formula_block, "x.yml");
    EXPECT_EQ(plain.name, "x.yml");
    EXPECT_EQ(plain.first_nm, 300.0);
    const auto same = [&](const std::string& text) { EXPECT_EQ(parse_material_yaml(text, "x.yml"), plain) << text; };
    same("\xEF\xBB\xBF" + formula_block);
    same("DATA:\r\n  - type: formula 5\r\n    wavelength_range: 0.3 1\r\n    coefficients: 1.5 0.01 -2\r\n");
    same("DATA:\r  - type: formula 5\r    wavelength_range: 0.3 1\r    coefficients: 1.5 0.01 -2\r");
    same("DATA:\n\t- type: formula 5\n\t  wavelength_range:\t0.3\t1\t\n\t  coefficients: 1.5\t0.01 -2");
    same("DATA:\n- {type: formula   5, range: 300e-3 +1.0, coefficients: '1.5 1E-2 -2'}\n");
    same("REFERENCES: |\n    A. Author: <i>J. Opt.</i> <b>1</b> [link](https://x.y) & \"quotes\"\n" + formula_block +
         "CONDITIONS:\n    temperature: 293\nPROPERTIES:\n    thermal_dispersion:\n      - type: formula A\n"
         "        coefficients: 1 2 3\nCOMMENTS: |\n    *Markdown*\tand: - tabs\n");
    same("---\n" + formula_block + "...\n");
}

TEST(MaterialFile, SortsRowsAndCountsARepeatedOneOnce) {
    const IndexCurve curve = parse_material_yaml(
        table_head + "        0.7 1.5 0\n\n        0.4 1.6 0.2\n\t0.5\t1.55 0.1\n        0.4 1.6 0.2\n", "x.yml");
    const SampledCurve n{{400, 500, 700}, {1.6, 1.55, 1.5}};
    const SampledCurve k{{400, 500, 700}, {0.2, 0.1, 0}};
    EXPECT_EQ(std::get<SampledCurve>(curve.n), n);
    EXPECT_EQ(std::get<SampledCurve>(curve.k), k);
}

TEST(MaterialFile, SaysWhatIsWrongWithARowAndInWhichLine) {
    const auto row = [](const std::string& text) {
        return yaml_message(table_head + "        0.4 1.6 0.2\n        " + text + "\n");
    };
    EXPECT_EQ(
        row("0.4 1.6 0.3"),
        "some/x.yml:5: 400 nm is given twice, with n = 1.6, k = 0.3 and in line 4 with n = 1.6, k = 0.2; give it once");
    EXPECT_EQ(row("0.43 1.6 -0.01"),
              "some/x.yml:5: k = -0.01 at 430 nm is negative, which would be gain; allowed: 0 or more");
    EXPECT_EQ(row("0.43 0 0"), "some/x.yml:5: n = 0 at 430 nm is not above 0; allowed: above 0");
    EXPECT_EQ(row("0 1.5 0"), "some/x.yml:5: wavelength 0 nm is not above 0; allowed: above 0");
    EXPECT_EQ(row("0.43 1,5 0"), "some/x.yml:5: \"1,5\" is not a finite number");
    EXPECT_EQ(row("0.43 nan 0"), "some/x.yml:5: \"nan\" is not a finite number");
    EXPECT_EQ(row("0.43 1.5 1e999"), "some/x.yml:5: \"1e999\" is not a finite number");
    EXPECT_EQ(row("0.43 1.5"),
              "some/x.yml:5: has 2 columns; this table has 3, a wavelength in micrometres and n and k");
    EXPECT_EQ(yaml_message("DATA:\n - type: tabulated k\n   data: |\n    0.4 1 2\n"),
              "some/x.yml:4: has 3 columns; this table has 2, a wavelength in micrometres and k");
    EXPECT_EQ(yaml_message("\xEF\xBB\xBF"
                           "DATA:\r\n - type: tabulated n\r\n   data: |\r\n    0.4 1.5\r\n    0.5 0\r\n"),
              "some/x.yml:5: n = 0 at 500 nm is not above 0; allowed: above 0");
    // A table in one line of its own begins in that line.
    EXPECT_EQ(yaml_message("DATA:\n - type: tabulated n\n   data: 0.4 -1\n"),
              "some/x.yml:3: n = -1 at 400 nm is not above 0; allowed: above 0");
}

TEST(MaterialFile, SaysWhatIsWrongWithABlock) {
    const auto block = [](const std::string& text) { return yaml_message("DATA:\n  - " + text + "\n"); };
    EXPECT_EQ(block("type: formula 10"),
              "some/x.yml:2: unknown type \"formula 10\"; allowed: formula 1 to formula 9, tabulated n, tabulated k, "
              "tabulated nk");
    EXPECT_EQ(block("type: tabulated n2"),
              "some/x.yml:2: unknown type \"tabulated n2\"; allowed: formula 1 to formula 9, tabulated n, tabulated k, "
              "tabulated nk");
    EXPECT_EQ(block("data: 1"), "some/x.yml:2: a block of DATA has no type; it needs one");
    EXPECT_EQ(block("glass"), "some/x.yml:2: a block of DATA must have keys, type among them");
    EXPECT_EQ(block("type: tabulated n"), "some/x.yml:2: a block of DATA has no data; it needs one");
    EXPECT_EQ(block("type: tabulated n\n    data: [1, 2]"), "some/x.yml:3: data must be a text of words or numbers");
    EXPECT_EQ(block("type: tabulated n\n    data: 1 2\n    date: 3"),
              "some/x.yml:4: unknown key \"date\"; known: type, data, wavelength_range");
    EXPECT_EQ(block("type: formula 1\n    coefficients: 1"),
              "some/x.yml:2: a block of DATA has no wavelength_range; it needs one");
    const auto formula = [&](const std::string& number, const std::string& range, const std::string& coefficients) {
        return block("type: formula " + number + "\n    wavelength_range: " + range +
                     "\n    coefficients: " + coefficients);
    };
    EXPECT_EQ(formula("8", "0.3 1", "0.4 0.1 0.07 0 0"), "some/x.yml:4: formula 8 has 5 coefficients; allowed: 1 to 4");
    EXPECT_EQ(formula("8", "0.3 1", "''"), "some/x.yml:4: formula 8 has 0 coefficients; allowed: 1 to 4");
    EXPECT_EQ(formula("5", "0.3 1", "1.5 x"), "some/x.yml:4: \"x\" is not a finite number");
    EXPECT_EQ(formula("5", "0.3", "1.5"), "some/x.yml:3: wavelength_range must be two wavelengths in micrometres");
    EXPECT_EQ(formula("5", "1 0.3", "1.5"),
              "some/x.yml:3: wavelength_range \"1 0.3\"; allowed: two ascending wavelengths above 0");
    EXPECT_EQ(formula("5", "0 0.3", "1.5"),
              "some/x.yml:3: wavelength_range \"0 0.3\"; allowed: two ascending wavelengths above 0");
    EXPECT_EQ(
        formula("5", "0.3 1", "-1.5"),
        "some/x.yml:2: formula 5 gives n = -1.5 at 300 nm; allowed: above 0 and finite in all of wavelength_range");
    // A resonance at 0.5 um: n^2 is negative just below it.
    EXPECT_EQ(
        formula("1", "0.3 1", "0 0.01 0.5"),
        "some/x.yml:2: formula 1 gives n = the root of a negative number at 498 nm; allowed: above 0 and finite in "
        "all of wavelength_range");
    EXPECT_EQ(
        formula("6", "0.5 1", "0 1 4"),
        "some/x.yml:2: formula 6 gives n = inf at 500 nm; allowed: above 0 and finite in all of wavelength_range");
}

TEST(MaterialFile, SaysWhatIsWrongWithTheWhole) {
    const std::string k_block = "  - type: tabulated k\n    data: |\n        0.4 0.1\n        0.7 0.2\n";
    const std::string what = "; a material is YAML with DATA, as refractiveindex.info has it";
    EXPECT_EQ(yaml_message(""), "some/x.yml: has no DATA" + what);
    EXPECT_EQ(yaml_message("hello"), "some/x.yml: has no DATA" + what);
    EXPECT_EQ(yaml_message("<!DOCTYPE html><html></html>"), "some/x.yml: has no DATA" + what);
    EXPECT_EQ(yaml_message("data: 1\n"), "some/x.yml: has no DATA" + what);
    EXPECT_EQ(yaml_message("A: 1\nDATA:\n"), "some/x.yml:2: DATA must be a list of one block or more" + what);
    EXPECT_EQ(yaml_message("DATA: []\n"), "some/x.yml:1: DATA must be a list of one block or more" + what);
    EXPECT_EQ(yaml_message("DATA:\n" + k_block), "some/x.yml:2: gives k only; n is needed too");
    EXPECT_EQ(yaml_message(formula_block + formula_block.substr(6)), "some/x.yml:5: gives n twice; give it once");
    EXPECT_EQ(yaml_message(formula_block + k_block + k_block), "some/x.yml:9: gives k twice; give it once");
    EXPECT_EQ(yaml_message(formula_block + "  - type: tabulated k\n    data: |\n      1 0.1\n      2 0.2\n"),
              "some/x.yml:2: n is known from 300 to 1000 nm and k from 1000 to 2000 nm; they must overlap");
    EXPECT_EQ(yaml_message(formula_block + formula_block),
              "some/x.yml:5: the key \"DATA\" is given twice; give it once");
    EXPECT_EQ(yaml_message(formula_block + "---\nDATA: 1\n"), "some/x.yml:5: a second document begins; a file has one");
}

TEST(MaterialFile, EndsHostileTextWithOneLine) {
    const auto repeated = [](const std::string& text, int times) {
        std::string result;
        for (int i = 0; i < times; ++i) result += text;
        return result;
    };
    EXPECT_EQ(yaml_message("a: [1, 2\n"), "some/x.yml:2: is not YAML: end of sequence flow not found");
    EXPECT_EQ(yaml_message("DATA: |\n  a\n b: c: d\n"), "some/x.yml:3: is not YAML: end of map not found");
    EXPECT_EQ(yaml_message("a: &x [1]\nb: *x\n"), "some/x.yml:2: has an alias (*); write its value out");
    EXPECT_EQ(yaml_message("&x\n- *x\n"), "some/x.yml:2: has an alias (*); write its value out");
    EXPECT_EQ(yaml_message(repeated("- ", 100000)), "some/x.yml:1: more than 32 levels");
    EXPECT_EQ(yaml_message("a: " + repeated("[", 50) + repeated("]", 50)), "some/x.yml:1: more than 32 levels");
    EXPECT_EQ(yaml_message("a: " + repeated("[", 20) + repeated("]", 20)),
              "some/x.yml: has no DATA; a material is YAML with DATA, as refractiveindex.info has it");
    // yaml-cpp looks for the colon of a key no further than 1024 characters ahead.
    EXPECT_EQ(yaml_message("a: " + repeated("[", 100000)), "some/x.yml:1: a key is not a word; a key must be a word");
    EXPECT_EQ(yaml_message(repeated("- 1\n", 20000)), "some/x.yml:10000: more than 10000 values");
    EXPECT_EQ(yaml_message("[a]: 1\n"), "some/x.yml:1: a key is not a word; a key must be a word");
    EXPECT_EQ(yaml_message("a: 1\nb: \x01\n" + std::string(1, '\0')),
              "some/x.yml:3: has a zero byte; the file must be text in UTF-8");
    EXPECT_EQ(yaml_message(table_head + repeated("     4 2 1\n", 1000001)),
              "some/x.yml:1000004: more than 1000000 rows");
    EXPECT_EQ(
        yaml_message("DATA:\n - type: |\n    a\n    b\n"),
        "some/x.yml:2: unknown type \"a b \"; allowed: formula 1 to formula 9, tabulated n, tabulated k, tabulated nk");
    std::string junk;
    for (unsigned state = 1; junk.size() < 100000; state = state * 1664525u + 1013904223u)
        junk += static_cast<char>(1 + (state >> 24) % 255);
    for (std::size_t begin = 0; begin < junk.size(); begin += 97) {
        const std::string message = yaml_message(junk.substr(begin, 300));
        EXPECT_TRUE(message.starts_with("some/x.yml:")) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

TEST(MaterialFile, EveryTruncationOfAFileIsAMaterialOrOneLine) {
    const std::string text = test::file_bytes(reference_file("rii/formula5_nk_pvp_konig.yml"));
    for (std::size_t length = 0; length < text.size(); ++length) {
        const std::string message = yaml_message(text.substr(0, length));
        EXPECT_TRUE(message == "no error" || message.starts_with("some/x.yml:")) << message;
    }
}

TEST(MaterialFile, ReadsATableOfCommaSeparatedValues) {
    const test::TemporaryFolder folder;
    const IndexCurve n = read_material_file(folder.file("glass.csv", "# mine\n700,1.5\n400,1.6\n400,1.6\n"));
    EXPECT_EQ(n.name, "glass.csv");
    EXPECT_EQ(std::get<SampledCurve>(n.n), (SampledCurve{{400, 700}, {1.6, 1.5}}));
    EXPECT_EQ(std::get<double>(n.k), 0.0);
    EXPECT_EQ(n.first_nm, 400.0);
    EXPECT_EQ(n.last_nm, 700.0);
    const IndexCurve nk =
        read_material_file(folder.file("ink.csv", "\xEF\xBB\xBFwavelength_nm;n;k\r\n400;1.6;0.5\r\n700;1.5;0\r\n"));
    EXPECT_EQ(nk.at(400), RefractiveIndex(1.6, 0.5));
    EXPECT_EQ(std::get<SampledCurve>(nk.k), (SampledCurve{{400, 700}, {0.5, 0}}));
}

TEST(MaterialFile, ReadsDecimalCommas) {
    const test::TemporaryFolder folder;
    const IndexCurve nk = read_material_file(folder.file("x.csv", "400;1,5;0,1\n500;1,4;0\n"));
    EXPECT_EQ(std::get<SampledCurve>(nk.n), (SampledCurve{{400, 500}, {1.5, 1.4}}));
    EXPECT_EQ(std::get<SampledCurve>(nk.k), (SampledCurve{{400, 500}, {0.1, 0}}));
}

// Micrometres under `wl`; n and k behind each other, on wavelengths of their own.
TEST(MaterialFile, ReadsTheCsvOfRefractiveindexInfo) {
    const test::TemporaryFolder folder;
    const IndexCurve nk =
        read_material_file(folder.file("ag.csv", "wl,n\n0.3,0.1\n1.005,0.2\n\nwl,k\n0.2,2\n0.5,3\n0.9,4\n"));
    EXPECT_EQ(std::get<SampledCurve>(nk.n), (SampledCurve{{300, 1005}, {0.1, 0.2}}));
    EXPECT_EQ(std::get<SampledCurve>(nk.k), (SampledCurve{{200, 500, 900}, {2, 3, 4}}));
    EXPECT_EQ(nk.first_nm, 300.0);
    EXPECT_EQ(nk.last_nm, 900.0);
    EXPECT_EQ(std::get<SampledCurve>(read_material_file(folder.file("n.csv", "wl,n\n0.4,1.5\n0.8,1.4\n")).n),
              (SampledCurve{{400, 800}, {1.5, 1.4}}));
}

TEST(MaterialFile, OfOneRowIsKnownAtOneWavelength) {
    const test::TemporaryFolder folder;
    const IndexCurve n = read_material_file(folder.file("x.csv", "550,1.5\n"));
    EXPECT_EQ(n.first_nm, 550.0);
    EXPECT_EQ(n.last_nm, 550.0);
    EXPECT_EQ(parse_material_yaml("DATA:\n - type: tabulated nk\n   data: 0.55 1.5 0.1\n", "x.yml").at(550.0),
              RefractiveIndex(1.5, 0.1));
}

TEST(MaterialFile, SaysWhatIsWrongWithATableOfCommaSeparatedValues) {
    EXPECT_EQ(csv_message(""), ": has no numbers; allowed: columns wavelength_nm,n or wavelength_nm,n,k");
    EXPECT_EQ(csv_message("nm,n\n"), ": has no numbers; allowed: columns wavelength_nm,n or wavelength_nm,n,k");
    EXPECT_EQ(csv_message("400\n"), ":1: has 1 columns; allowed: wavelength_nm,n or wavelength_nm,n,k");
    EXPECT_EQ(csv_message("nm,n\n400,1.5\n500,1.5,0\n"),
              ":3: has 3 columns, the first row has 2; every row must have the same number");
    EXPECT_EQ(csv_message("400,1.5\n500,abc\n"), ":2:5: \"abc\" is not a finite number");
    EXPECT_EQ(csv_message("4OO,1.5\n500,1.5\n"), ":1:1: \"4OO\" is not a finite number");
    EXPECT_EQ(csv_message("wl,k\n0.4,0.1\n0.7,0.2\n"), ":2: gives k only; n is needed too");
    EXPECT_EQ(csv_message("wl,n\n0.4,1.5\n0.5,1.5\nwl,k\n0.6,0.1\n0.7,0.2\n"),
              ":5: n is known from 400 to 500 nm and k from 600 to 700 nm; they must overlap");
    EXPECT_EQ(csv_message("0.4,1.5\n0.7,1.4\n"),
              ":1: wavelengths end at 0.7 nm, as if they were micrometres; give nanometres");
    EXPECT_EQ(csv_message("400,1.5,0\n500,1.5,-1e-9\n"),
              ":2: k = -1e-09 at 500 nm is negative, which would be gain; allowed: 0 or more");
    EXPECT_EQ(csv_message("400,1.5\n500,1.5\n400,1.6\n"),
              ":3: 400 nm is given twice, with n = 1.6 and in line 1 with n = 1.5; give it once");
    EXPECT_EQ(csv_message("-400,1.5\n500,1.5\n"), ":1: wavelength -400 nm is not above 0; allowed: above 0");
}

TEST(MaterialFile, SaysWhyAFileCannotBeRead) {
    const test::TemporaryFolder folder;
    const auto message = [](const std::string& path) {
        std::string text = "no refusal of the disk's";
        try {
            read_material_file(path);
        } catch (const IoError& error) {
            text = error.what();
        }
        return text;
    };
    const std::string none = (folder.path() / "none.yml").string();
    EXPECT_EQ(message(none), none + ": cannot be opened: No such file or directory");
    const std::string sub_folder = (folder.path() / "folder.yml").string();
    std::filesystem::create_directory(sub_folder);
    EXPECT_EQ(message(sub_folder), sub_folder + ": is a folder; give a file");
    const std::string big = folder.file("big.yaml", formula_block);
    std::filesystem::resize_file(big, (16u << 20) + 1);
    EXPECT_EQ(message(big), big + ": is larger than 16 MB, the most that nacre reads");
    EXPECT_EQ(message_of([] { read_material_file("glass.txt"); }),
              "glass.txt: is not a .yml, .yaml or .csv file; give one of these");
}

}  // namespace
}  // namespace nacre
