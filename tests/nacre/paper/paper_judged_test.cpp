#include "nacre/paper/paper_judged.h"
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nacre/colour/adaptation.h"
#include "nacre/lut/bake.h"
#include "nacre/shade/band.h"

namespace nacre {
namespace {

const Series& angles_of(const Specimen& specimen) {
    static const Series morpho = judged_angles(paper_morpho(), exact_stacks(paper_morpho()), default_light());
    static const Series beetle = judged_angles(paper_beetle(), exact_stacks(paper_beetle()), default_light());
    return specimen.name == morpho.name.substr(morpho.name.find('_') + 1) ? morpho : beetle;
}

TEST(PaperJudged, PaletteAgainstItselfDiffersByNothing) {
    const auto light = default_light();
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        const std::vector<Xyz> colours = colours_at_degrees(specimen.palette, light);
        ASSERT_EQ(colours.size(), 91u);
        for (const double difference : differences(colours, colours)) EXPECT_EQ(difference, 0.0) << specimen.name;
        std::vector<Xyz> halves;
        for (const Xyz& colour : colours) halves.push_back({0.5 * colour.x, 0.5 * colour.y, 0.5 * colour.z});
        for (const double difference : differences(colours, halves, 2.0)) EXPECT_EQ(difference, 0.0) << specimen.name;
        EXPECT_GT(differences(colours, halves).front(), 5.0);
    }
}

// The beetle's two indices make its path, sqrt(n^2 - s^2) / n, the mean of two: 0.05 / 1.717 squared is 0.9e-3, times a
// curvature of less than a half, times 533 nm.
TEST(PaperJudged, FirstStackHasTheBraggLawThatThePicksImply) {
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        const Stack stack = exact_stacks(specimen).front().stack;
        for (const Incidence& incidence : whole_degrees())
            EXPECT_NEAR(bragg_peak_nm(stack, incidence), bragg_peak_nm(specimen.stack, incidence), 0.4);
    }
}

// As the facts say: by which the upper kind of layer is chosen, and what darkness below would do.
TEST(PaperJudged, BeetleWithItsLayersTheOtherWayRoundPeaksFarFromWhatWasMeasured) {
    const Incidence seen = Incidence::from_degrees(10.0);
    Stack stack = exact_stacks(paper_beetle()).back().stack;
    EXPECT_NEAR(find_band(stack, seen, 530.0)->peak_nm, 530.0, 1.0);
    Stack dark = stack;
    dark.substrate = RefractiveIndex{1.55, 0.14};
    EXPECT_NEAR(find_band(dark, seen, 530.0)->peak_nm, 535.0, 1.0);
    std::swap(stack.layers.front().layers[0], stack.layers.front().layers[1]);
    EXPECT_NEAR(find_band(stack, seen, 530.0)->peak_nm, 567.0, 1.0);
}

// A tenth of a percent is what nodes for CIEDE2000 0.01 may err by.
TEST(PaperJudged, BrightnessIsThatOfTheStacksOwnSpectrum) {
    const auto light = default_light();
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        const ExactStack stack = exact_stacks(specimen).front();
        const Xyz colour =
            adapt(light->adaptation, reflectance_xyz(stack.stack, Incidence::from_degrees(40.0), *light));
        EXPECT_NEAR(angles_of(specimen).value(40.0, stack.name + "_Y"), colour.y, 1e-3 * colour.y);
    }
}

TEST(PaperJudged, ScaledStackIsAsBrightAsThePaletteAtTheFirstPick) {
    const auto light = default_light();
    const Specimen morpho = paper_morpho();
    const ExactStack stack = exact_stacks(morpho).front();
    const Series& angles = angles_of(morpho);
    const double scale = angles.value(0.0, "palette_Y") / angles.value(0.0, stack.name + "_Y");
    const std::vector<double> expected =
        differences(colours_at_degrees(morpho.palette, light), colours_at_degrees(stack.stack, light), scale);
    for (const double degrees : {0.0, 30.0, 75.0}) {
        EXPECT_NEAR(angles.value(degrees, stack.name + "_scaled_de00"), expected[static_cast<std::size_t>(degrees)],
                    1e-9);
    }
}

TEST(PaperJudged, PalettePickedAnewHasTheStacksBandsAtThePicks) {
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        for (const ExactStack& stack : exact_stacks(specimen)) {
            for (const Pick& pick : specimen.palette.picks) {
                EXPECT_NEAR(angles_of(specimen).value(pick.angle_deg, stack.name + "_repicked_error_nm"), 0.0, 1e-9);
            }
        }
    }
}

TEST(PaperJudged, TableAndSummaryRepeatTheAngles) {
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        const auto stacks = exact_stacks(specimen);
        const Series& angles = angles_of(specimen);
        const Series table = judged_table(specimen, stacks, angles);
        ASSERT_EQ(table.rows.size(), stacks.size() * specimen.angles_deg.size());
        double largest = 0.0;
        for (const auto& row : table.rows) {
            if (row[0] != 2.0) continue;
            EXPECT_EQ(row[6], angles.value(row[1], stacks[1].name + "_nm"));
            EXPECT_EQ(row[7], row[2] - row[6]);  // positive where the palette's peak is the longer wave
            largest = std::max(largest, std::abs(row[7]));
        }
        EXPECT_EQ(judged_summary(specimen, stacks, angles).value(2.0, "largest_error_nm_here"), largest);
    }
}

TEST(PaperJudged, OnlyBandsAreMissingAndOnlyTowardsGrazing) {
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        const auto stacks = exact_stacks(specimen);
        const Series& angles = angles_of(specimen);
        for (const Series& series : {angles, judged_spectra(specimen, stacks), judged_table(specimen, stacks, angles),
                                     judged_summary(specimen, stacks, angles)}) {
            EXPECT_EQ(std::set<std::string>(series.columns.begin(), series.columns.end()).size(),
                      series.columns.size());
            for (const auto& row : series.rows) {
                ASSERT_EQ(row.size(), series.columns.size()) << series.name;
                for (std::size_t i = 0; i < row.size(); ++i) {
                    const std::string& column = series.columns[i];
                    const bool is_of_band = !column.ends_with("de00") && !column.ends_with("_Y");
                    const bool may_lack = series.name == angles.name && is_of_band && row.front() > 60.0;
                    EXPECT_TRUE(std::isfinite(row[i]) || may_lack) << series.name << " " << column;
                }
            }
        }
    }
}

}  // namespace
}  // namespace nacre
