#include "nacre/optics/irregular.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "nacre/optics/incidence.h"
#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {
namespace {

LayerSystem morpho(int repeat) {
    LayerSystemBuilder builder(1.0, 1.0);
    builder.begin_group(repeat);
    builder.layer(RefractiveIndex(1.56, 0.06), 94.0);
    builder.layer(1.0, 83.0);
    builder.end_group();
    return builder.take();
}

TEST(Irregular, EveryLayerHasTheMeanAndTheSpreadThatWereAskedFor) {
    const LayerSystem regular = morpho(10);
    for (const int count : {2, 16, 64, 512}) {
        const std::vector<LayerSystem> systems = irregular_systems(regular, 5.0, count).systems;
        ASSERT_EQ(systems.size(), static_cast<std::size_t>(count));
        for (std::size_t layer = 0; layer < 20; ++layer) {
            double mean = 0.0;
            double square = 0.0;
            const double nominal_nm = layer % 2 == 0 ? 94.0 : 83.0;
            for (const LayerSystem& system : systems) {
                ASSERT_EQ(system.nodes.size(), 20u);
                const double off = system.nodes[layer].thickness_nm - nominal_nm;
                mean += off / count;
                square += off * off / count;
            }
            EXPECT_NEAR(mean, 0.0, 1e-12) << count << " " << layer;
            EXPECT_NEAR(std::sqrt(square), 5.0, 1e-11) << count << " " << layer;
        }
    }
}

TEST(Irregular, LayersAreUncorrelatedWhereThereArePairsEnough) {
    const std::vector<LayerSystem> systems = irregular_systems(morpho(10), 5.0, 64).systems;
    for (std::size_t i = 0; i < 20; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            double sum = 0.0;
            for (const LayerSystem& system : systems) {
                sum += (system.nodes[i].thickness_nm - (i % 2 == 0 ? 94.0 : 83.0)) *
                       (system.nodes[j].thickness_nm - (j % 2 == 0 ? 94.0 : 83.0));
            }
            EXPECT_NEAR(sum / 64.0, 0.0, 1e-10) << i << " " << j;
        }
    }
}

// The moments of a normal variable: 0, 1, 0, 3, 0, 15; of layers that know nothing of each other, their products.
TEST(Irregular, UpToThreeLayersHaveAGrid) {
    for (const std::size_t layers : {1u, 2u, 3u}) {
        LayerSystemBuilder builder(1.0, 1.5);
        for (std::size_t layer = 0; layer < layers; ++layer) builder.layer(1.6, 100.0);
        const LayerEnsemble ensemble = irregular_systems(builder.take(), 2.0, 250);
        EXPECT_EQ(ensemble.systems.size(), ensemble.shares.size());
        EXPECT_LE(ensemble.systems.size(), 250u);
        EXPECT_GT(ensemble.systems.size(), 150u);
        double total = 0.0, fourth = 0.0, product = 0.0;
        for (std::size_t i = 0; i < ensemble.systems.size(); ++i) {
            const auto off = [&](std::size_t layer) {
                return (ensemble.systems[i].nodes[layer].thickness_nm - 100.0) / 2.0;
            };
            total += ensemble.shares[i];
            fourth += ensemble.shares[i] * std::pow(off(0), 4);
            product += ensemble.shares[i] * std::pow(off(0), 2) * std::pow(off(layers - 1), 2);
        }
        EXPECT_NEAR(total, 1.0, 1e-14);
        EXPECT_NEAR(fourth, 3.0, 1e-5) << layers;
        EXPECT_NEAR(product, layers == 1 ? 3.0 : 1.0, 1e-5) << layers;
    }
}

TEST(Irregular, WithoutSpreadEveryStackIsTheRegularOne) {
    const LayerSystem regular = morpho(4);
    for (const LayerSystem& system : irregular_systems(regular, 0.0, 8).systems) {
        ASSERT_EQ(system.nodes.size(), 8u);
        for (std::size_t layer = 0; layer < 8; ++layer)
            EXPECT_EQ(system.nodes[layer].thickness_nm, layer % 2 == 0 ? 94.0 : 83.0);
        const Incidence incidence = Incidence::from_degrees(40.0);
        EXPECT_EQ(multilayer_response(system, incidence, 460.0).reflectance(),
                  multilayer_response(regular, incidence, 460.0).reflectance());
    }
}

TEST(Irregular, IncoherentLayersDoNotMove) {
    LayerSystemBuilder builder(1.0, 1.5);
    builder.layer(1.6, 100.0);
    builder.layer(1.5, 1e5, true);
    builder.layer(1.7, 120.0);
    const LayerSystem regular = builder.take();
    for (const LayerSystem& system : irregular_systems(regular, 10.0, 16).systems) {
        ASSERT_EQ(system.nodes.size(), 3u);
        EXPECT_EQ(system.nodes[1], regular.nodes[1]);
        EXPECT_NE(system.nodes[0], regular.nodes[0]);
        EXPECT_NE(system.nodes[2], regular.nodes[2]);
    }
    LayerSystemBuilder bare(1.0, 1.5);
    bare.layer(1.5, 1e5, true);
    EXPECT_EQ(irregular_systems(bare.take(), 10.0, 4).systems.size(), 4u);
}

TEST(Irregular, NoLayerIsThinnerThanNothing) {
    LayerSystemBuilder builder(1.0, 1.5);
    builder.layer(1.6, 3.0);
    bool touches_zero = false;
    for (const LayerSystem& system : irregular_systems(builder.take(), 10.0, 32).systems) {
        EXPECT_GE(system.nodes[0].thickness_nm, 0.0);
        touches_zero = touches_zero || system.nodes[0].thickness_nm == 0.0;
    }
    EXPECT_TRUE(touches_zero);
}

TEST(Irregular, PointsAreTheSameEveryTime) {
    const std::vector<LayerSystem> once = irregular_systems(morpho(12), 7.0, 16).systems;
    const std::vector<LayerSystem> again = irregular_systems(morpho(12), 7.0, 16).systems;
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].nodes, again[i].nodes);
}

TEST(Irregular, HundredsOfLayersStayFinite) {
    for (const int count : {2, 4, 64}) {
        for (const LayerSystem& system : irregular_systems(morpho(150), 10.0, count).systems) {
            for (const LayerNode& node : system.nodes) {
                ASSERT_TRUE(std::isfinite(node.thickness_nm));
                ASSERT_LT(node.thickness_nm, 94.0 + 10.0 * std::sqrt(count));
            }
        }
    }
}

}  // namespace
}  // namespace nacre
