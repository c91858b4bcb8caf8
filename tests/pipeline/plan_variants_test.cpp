#include "pipeline/plan_variants.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/ocio/ocio_spaces.h"
#include "nacre/base/error.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/optics/palette.h"
#include "nacre/scene/planned_swatch.h"
#include "support/folders.h"

namespace nacre {
namespace {

const std::string hero =
    "[material.hero]\npicks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1 } ]\n"
    "[variants]\nred = { \"material.hero.picks[0].peak_nm\" = 650 }\ngreen = { \"material.hero.picks[0].peak_nm\" = "
    "530 }\n";
const std::string sheet = "[swatch.all]\ndraw = \"contact_sheet\"\n";

struct Opened {
    std::vector<std::string> luts{}, swatches{}, names{};
    std::vector<double> peaks_nm{};
    std::vector<LoadedScene> scenes{};
};

Opened opened(const std::string& scene, std::vector<std::string> only = {}, std::vector<SceneEdit> edits = {}) {
    const test::TemporaryFolder folder;
    const test::CurrentFolder here(folder.path());
    folder.file("s.toml", scene);
    SceneRequest request;
    request.open_colours = open_ocio_spaces;
    request.only = std::move(only);
    request.edits = std::move(edits);
    Opened result;
    result.scenes = load_scenes({"s.toml"}, request);
    for (const LoadedScene& one : result.scenes) {
        for (const PlannedLut& lut : one.plan.luts) {
            result.luts.push_back(lut.name);
            if (const auto* palette = std::get_if<Palette>(&lut.job.material.mechanism))
                result.peaks_nm.push_back(palette->picks.front().lobe.peak_nm);
        }
        for (const PlannedSwatch& swatch : one.plan.swatches) result.swatches.push_back(swatch.name);
        result.names.insert(result.names.end(), one.plan.names.begin(), one.plan.names.end());
    }
    return result;
}

using Names = std::vector<std::string>;

TEST(PlanVariants, MakesOneLutPerVariantNamedAfterIt) {
    const Opened result = opened(hero);
    EXPECT_EQ(result.luts, (Names{"red", "green"}));
    EXPECT_EQ(result.peaks_nm, (std::vector<double>{650, 530}));
    EXPECT_EQ(result.scenes[1].plan.luts[0].edits, Names{"material.hero.picks[0].peak_nm = 530"});
    EXPECT_EQ(result.scenes[1].plan.luts[0].where.text(), "s.toml:5:1");
}

TEST(PlanVariants, NamesSeveralLutsAndSwatchesAfterTheVariantAndThemselves) {
    const Opened result = opened(hero + "[lut.a]\n[lut.b]\n[swatch.ball]\ndraw = \"sphere\"\n");
    EXPECT_EQ(result.luts, (Names{"red_a", "red_b", "green_a", "green_b"}));
    EXPECT_EQ(result.swatches, (Names{"red_ball", "green_ball"}));
}

TEST(PlanVariants, PolarisationsOfTheOnlyLutAreThoseOfTheVariant) {
    const Opened result = opened(
        "[material.hero]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n"
        "polarisation = \"both\"\n[variants]\nthick = { material.hero.thickness_nm = 500 }\n");
    EXPECT_EQ(result.scenes.front().plan.names, (Names{"thick_s", "thick_p"}));
}

TEST(PlanVariants, ContactSheetShowsTheLutsOfAllVariantsOnce) {
    for (const Names& only : {Names{}, Names{"all"}}) {
        const Opened result = opened(hero + sheet + "panels = \"sphere\"\n", only);
        ASSERT_EQ(result.swatches, Names{"all"});
        const PlannedSwatch& all = result.scenes.front().plan.swatches.front();
        EXPECT_EQ(all.labels, (Names{"red", "green"}));
        EXPECT_EQ(all.panels, SwatchKind::sphere);
        ASSERT_EQ(all.jobs.size(), 2u);
        EXPECT_EQ(std::get<Palette>(all.jobs[1].material.mechanism).picks.front().lobe.peak_nm, 530.0);
        EXPECT_EQ(result.luts.empty(), !only.empty());
    }
}

TEST(PlanVariants, OnlyNamesVariantsAndWhatIsMadeOfThem) {
    EXPECT_EQ(opened(hero + sheet, {"green"}).luts, Names{"green"});
    EXPECT_TRUE(opened(hero + sheet, {"green"}).swatches.empty());
    EXPECT_EQ(opened(hero + "[lut.a]\n[lut.b]\n", {"green_b"}).luts, Names{"green_b"});
    EXPECT_EQ(opened(hero, {"elsewhere"}).names, (Names{"red", "green"})) << "what the message can offer";
}

TEST(PlanVariants, EditsOfTheCommandLineComeBeforeThoseOfAVariant) {
    const Where where{"--set"};
    const auto edit = [&](const std::string& key, std::int64_t value) { return SceneEdit{key, {value, where}, where}; };
    const Opened result =
        opened(hero, {}, {edit("material.hero.picks[0].peak_nm", 400), edit("material.hero.picks[0].width_nm", 90)});
    EXPECT_EQ(result.peaks_nm, (std::vector<double>{650, 530}));
    EXPECT_EQ(result.scenes[0].plan.luts[0].edits,
              (Names{"material.hero.picks[0].peak_nm = 400", "material.hero.picks[0].width_nm = 90",
                     "material.hero.picks[0].peak_nm = 650"}));
}

TEST(PlanVariants, MistakesOfAllVariantsAreReportedOnceEach) {
    const auto message_of = [](const std::string& scene) {
        try {
            opened(scene);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("was accepted");
    };
    EXPECT_EQ(
        message_of(hero + "blue = { \"material.heor.shape\" = 1 }\npale = { accuracy.max_de00 = 0 }\n"
                          "[light]\nilluminant = \"D66\"\n"),
        "s.toml:9:14 [light]: unknown illuminant \"D66\"; known: D65, D50, D55, D75, A, E, FL2, FL7, FL11, or the name "
        "of a .csv file of wavelength_nm,power\n"
        "s.toml:6:34: s.toml has no material.heor; known in material: hero\n"
        "s.toml:7:30 [accuracy]: max_de00 = 0 is out of range; allowed [1e-05, 100]");
    EXPECT_EQ(message_of(hero + "RED = {}\n"),
              "s.toml:6:1: this would write RED.exr, and so would s.toml:4:1; rename one of them");
}

}  // namespace
}  // namespace nacre
