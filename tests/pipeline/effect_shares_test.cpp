#include "pipeline/effect_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/ocio/ocio_spaces.h"
#include "pipeline/decide.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/plan_seconds.h"

namespace nacre {
namespace {

std::vector<LoadedScene> tilted_film() {
    SceneRequest request;
    request.open_colours = open_ocio_spaces;
    std::vector<LoadedScene> scenes;
    scenes.push_back(load_scene_text(R"(
[material.scale]
mechanism = "film"
index = 1.56
thickness_nm = 420
substrate = 1.4
tilt_deg = 10
thickness_spread_nm = 10
[accuracy]
effects = "all"
[lut.scale]
material = "scale"
)",
                                     "scale.toml", request));
    return scenes;
}

// How much is a matter of the machine: ./run bench compares it with bakes.
TEST(EffectShares, AreOfATiltedMaterialNotZero) {
    const std::vector<LoadedScene> scenes = tilted_film();
    std::vector<DecidedLut> luts = undecided_luts(scenes);
    decide_all(luts, {});
    ASSERT_EQ(luts.front().failure, "");
    ASSERT_NE(luts.front().lut.lut.job.sampling.facets, nullptr) << "deciding has made the curve";
    const std::vector<EffectShare> shares = effect_shares(luts.front(), {});
    ASSERT_EQ(shares.size(), 3U);
    for (const EffectShare& share : shares) {
        EXPECT_TRUE(share.choice.is_simulated);
        EXPECT_LE(share.time_share, 1.0);
        if (share.choice.effect == Effect::polarisation) continue;
        EXPECT_GT(share.time_share, 0.0) << row_of(share.choice.effect).name;
    }
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end(), [](const EffectShare& one, const EffectShare& other) {
        return one.time_share > other.time_share;
    }));
}

TEST(PlanSeconds, OfABakeHoldThoseOfItsTexels) {
    const std::vector<LoadedScene> scenes = tilted_film();
    std::vector<DecidedLut> luts = undecided_luts(scenes);
    decide_all(luts, {});
    EXPECT_GT(seconds_of_texels(luts.front().lut.lut.job), 0.0);
    EXPECT_GT(seconds_of_facets(luts.front().lut.lut.job), 0.0);
    EXPECT_GT(seconds_of_bake(luts.front(), {}), 0.0);
}

}  // namespace
}  // namespace nacre
