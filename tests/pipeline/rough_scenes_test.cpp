// Shipped materials over angle and roughness: what is fetched is the mean over a million visible normals of the true
// colour of a facet, to the bound that was asked for. A sphere under an even sky is nothing but such fetches.
// NACRE_EFFECTS_SWEEP=1 takes every shipped palette, film, stack, crystal and measurement; else a few do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "io/ocio/ocio_spaces.h"
#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/reference.h"
#include "nacre/accuracy/trial.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/fetch.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/shade/facets.h"
#include "nacre/shade/kinks.h"
#include "pipeline/loaded_scene.h"
#include "reference/facets.h"
#include "support/test_encoding.h"

namespace nacre {
namespace {

constexpr double bound = 0.5;
constexpr int side = 1000;

bool takes_all() {
    const char* sweep = std::getenv("NACRE_EFFECTS_SWEEP");
    return sweep != nullptr && std::string(sweep) == "1";
}

// The materials of the shipped scenes that may be rough, each once, as LUTs over angle and roughness.
std::vector<PlannedLut> rough_luts() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(NACRE_SOURCE_DIR) + "/configs/scenes")) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    const std::set<std::string> few{"morpho.toml", "soap_film.toml", "beetle_stack.toml", "opal.toml"};
    SceneRequest request;
    request.open_colours = open_ocio_spaces;
    request.want_swatches = false;
    std::vector<PlannedLut> luts;
    for (const auto& file : files) {
        if (!takes_all() && !few.count(file.filename().string())) continue;
        std::set<std::string> seen;
        for (PlannedLut lut : plan_file(file.string(), request).luts) {
            Job& job = lut.job;
            Mechanism& mechanism = job.material.mechanism;
            if (quantity_of(mechanism) != Quantity::incidence || !seen.insert(job.material.name).second) continue;
            mechanism.effects.relief = {};
            lut.name = file.stem().string() + " " + job.material.name;
            job.x = default_axis();
            job.y = parameter_axis(mechanism, "roughness", 0.0, 1.0);
            lut.request = {};
            lut.request.max_de00 = bound;
            luts.push_back(std::move(lut));
        }
    }
    return luts;
}

// What a facet shows, by the independent reference.
XyzCurve facet_colours(const Job& job) {
    Job plain = job;
    plain.y.reset();
    const Reference reference(plain, 1e-3 * bound);
    const auto colour = [&](const Incidence& incidence) { return reference.at(std::sqrt(incidence.cos_theta)); };
    return facet_curve(colour, kinks_deg(plain.material.mechanism));
}

TEST(RoughScenes, KeepHalfACiede2000AgainstAMillionFacets) {
    const Encoding encoding = test::rec709_encoding();
    double worst = 0.0;
    const std::vector<PlannedLut> luts = rough_luts();
    for (const PlannedLut& lut : luts) {
        const ChosenLut chosen = choose_lut(lut, encoding);
        EXPECT_TRUE(chosen.is_reached) << lut.name << ": " << chosen.limiting_factor;
        const Image<Rgb> stored = test::stored_as(encoding.to_rgb(bake(chosen.lut.job)), chosen.lut.format);
        const double scale = display_scale(encoding.to_xyz(stored));
        const XyzCurve facet = facet_colours(lut.job);
        double largest = 0.0;
        for (const double roughness : {0.0, 0.03, 0.17, 0.4, 0.73, 1.0}) {
            for (const double theta_deg : {0.0, 21.0, 47.0, 66.0, 81.0, 89.0}) {
                const double s = std::sqrt(Incidence::from_degrees(theta_deg).cos_theta);
                Xyz meant;
                if (roughness == 0.0) {
                    meant = facet.at(s);
                } else {
                    for (const auto& [cos_beta, share] : reference::rough_facets_seen(roughness, theta_deg, side)) {
                        const Xyz seen = facet.at(std::sqrt(cos_beta));
                        meant = {meant.x + share * seen.x, meant.y + share * seen.y, meant.z + share * seen.z};
                    }
                }
                const Image<Rgb> fetched(1, 1, fetch(stored, {s, roughness}));
                const double de00 = difference_at(encoding.to_xyz(fetched).at(0, 0), meant, scale);
                EXPECT_LE(de00, bound) << lut.name << " at roughness " << roughness << " and " << theta_deg << " deg";
                largest = std::max(largest, de00);
            }
        }
        worst = std::max(worst, largest);
        std::cout << "[ ROUGH    ] " << lut.name << ": " << largest << ", " << size_text(chosen.lut.job) << std::endl;
    }
    std::cout << "[ ROUGH    ] " << luts.size() << " materials, at most " << worst << " of " << bound << std::endl;
    EXPECT_GT(worst, 0.1 * bound);
}

}  // namespace
}  // namespace nacre
