#include <gtest/gtest.h>

#include "io/scene/scene_file.h"
#include "nacre/paper/paper.h"
#include "nacre/scene/plan.h"

namespace nacre {
namespace {

TEST(PaperScenes, ScenesThatShipCarryThePapersPicksAndShapes) {
    for (const Specimen& specimen : {paper_morpho(), paper_beetle()}) {
        const Plan plan = plan_scene(
            read_scene_file(NACRE_TEST_DATA_DIR "/../../configs/scenes/" + specimen.name + ".toml"), scene_files());
        ASSERT_EQ(plan.materials.size(), 1u);
        EXPECT_EQ(plan.materials.front().name, specimen.name);
        EXPECT_EQ(std::get<Palette>(plan.materials.front().mechanism), specimen.palette);
    }
}

}  // namespace
}  // namespace nacre
