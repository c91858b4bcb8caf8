#include "nacre/optics/layer_system.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/optics/layered.h"

namespace nacre {
namespace {

Index cauchy(double a, double b_um2) {
    IndexCurve curve;
    curve.n = IndexFormula{5, {a, b_um2, -2.0}};
    return Index(std::make_shared<const IndexCurve>(curve));
}

Layer layer_of(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

Layer group_of(int repeat, std::vector<Layer> layers) {
    Layer group;
    group.repeat = repeat;
    group.layers = std::move(layers);
    return group;
}

// Indices and thicknesses in the order in which light meets the layers, groups walked through.
struct Met {
    RefractiveIndex index;
    double thickness_nm;
    bool is_incoherent;
    friend bool operator==(const Met&, const Met&) = default;
};
void walk(const LayerSystem& system, std::size_t begin, std::size_t end, std::vector<Met>& met) {
    for (std::size_t i = begin; i < end; ++i) {
        const LayerNode& node = system.nodes[i];
        const auto members = static_cast<std::size_t>(node.count);
        if (node.repeat == 0)
            met.push_back({system.index_at(node.medium, 500.0), node.thickness_nm, node.is_incoherent});
        for (int time = 0; time < node.repeat; ++time) walk(system, i + 1, i + 1 + members, met);
        i += members;
    }
}
std::vector<Met> met_by_light(const LayerSystem& system) {
    std::vector<Met> met;
    walk(system, 0, system.nodes.size(), met);
    return met;
}

TEST(LayerSystem, EqualMaterialsAreOneCurveAndOneMedium) {
    const Index glass = cauchy(1.5, 0.004);
    const Index twin = cauchy(1.5, 0.004);  // equal, but another object
    LayerSystemBuilder builder(1.0, glass);
    builder.layer(glass, 100.0);
    builder.layer(2.4, 50.0);
    builder.layer(glass, 70.0);
    builder.layer(1.0, 30.0);
    builder.layer(twin, 10.0);
    const LayerSystem system = builder.take();
    EXPECT_EQ(system.curves.size(), 4u) << "air, glass, 2.4, and the twin";
    EXPECT_EQ(system.media.size(), 4u);
    EXPECT_EQ(system.nodes[0].medium, system.substrate);
    EXPECT_EQ(system.nodes[2].medium, system.substrate);
    EXPECT_EQ(system.nodes[3].medium, system.incident);
    EXPECT_NE(system.nodes[4].medium, system.substrate);
    for (const double nm : {360.0, 500.0, 830.0}) {
        EXPECT_EQ(system.index_at(system.substrate, nm), glass.at(nm)) << nm;
        EXPECT_EQ(system.index_at(system.incident, nm), RefractiveIndex(1.0)) << nm;
    }
}

TEST(LayerSystem, AMixtureHasTheIndexBetweenItsMaterials) {
    const Index glass = cauchy(1.5, 0.004);
    const RefractiveIndex metal(2.0, 3.0);
    LayerSystemBuilder builder(1.0, 1.0);
    builder.graded_layer(glass, metal, 0.25, 10.0);
    builder.graded_layer(glass, metal, 0.0, 20.0);
    builder.graded_layer(glass, metal, 1.0, 30.0);
    const LayerSystem system = builder.take();
    for (const double nm : {360.0, 500.0, 830.0}) {
        const RefractiveIndex mixed = system.index_at(system.nodes[0].medium, nm);
        EXPECT_NEAR(mixed.real(), 0.75 * glass.at(nm).real() + 0.25 * 2.0, 1e-15) << nm;
        EXPECT_NEAR(mixed.imag(), 0.75, 1e-15) << nm;
        EXPECT_EQ(system.index_at(system.nodes[1].medium, nm), glass.at(nm)) << "the ends are the materials themselves";
        EXPECT_EQ(system.index_at(system.nodes[2].medium, nm), metal) << nm;
    }
}

TEST(LayerSystem, LayersAreCountedWithAllTheirRepeats) {
    LayerSystemBuilder builder(1.0, 1.5);
    EXPECT_EQ(expanded_layers(LayerSystemBuilder(1.0, 1.5).take()), 0.0);
    builder.layer(1.3, 10.0);
    builder.begin_group(100000);
    builder.layer(2.0, 10.0);
    builder.begin_group(100000);
    builder.layer(1.4, 1.0);
    builder.layer(1.6, 1.0);
    builder.end_group();
    builder.end_group();
    builder.layer(1.3, 10.0);
    const LayerSystem system = builder.take();
    EXPECT_EQ(expanded_layers(system), 2.0 + 1e5 * (1.0 + 1e5 * 2.0));
    ASSERT_EQ(system.nodes.size(), 7u);
    EXPECT_EQ(system.nodes[1].count, 4) << "the inner group and its members belong to it";
    EXPECT_EQ(system.nodes[3].count, 2);
    const std::vector<Layer> layers{
        layer_of(1.3, 10.0),
        group_of(100000, {layer_of(2.0, 10.0), group_of(100000, {layer_of(1.4, 1.0), layer_of(1.6, 1.0)})}),
        layer_of(1.3, 10.0)};
    EXPECT_EQ(expanded_layers(layers), expanded_layers(system));
    EXPECT_EQ(layer_system(Stack{1.0, layers, 1.5}).nodes, system.nodes);
}

TEST(LayerSystem, AFilmIsOneLayerOnItsSubstrate) {
    const LayerSystem system = layer_system(Film{1.33, RefractiveIndex(2.0, 0.5), 123.0, 1.7});
    EXPECT_EQ(met_by_light(system), (std::vector<Met>{{{2.0, 0.5}, 123.0, false}}));
    EXPECT_EQ(system.index_at(system.incident, 500.0), RefractiveIndex(1.33));
    EXPECT_EQ(system.index_at(system.substrate, 500.0), RefractiveIndex(1.7));
}

TEST(LayerSystem, AStackKeepsTheOrderInWhichLightMeetsItsLayers) {
    Layer window = layer_of(1.52, 1e6);
    window.is_incoherent = true;
    const Stack stack{
        1.0,
        {layer_of(1.38, 90.0), window, group_of(2, {layer_of(2.0, 50.0), group_of(3, {layer_of(1.4, 7.0)})})},
        1.5};
    std::vector<Met> expected{{1.38, 90.0, false}, {1.52, 1e6, true}};
    for (int outer = 0; outer < 2; ++outer) {
        expected.push_back({2.0, 50.0, false});
        for (int inner = 0; inner < 3; ++inner) expected.push_back({1.4, 7.0, false});
    }
    EXPECT_EQ(met_by_light(layer_system(stack)), expected);
}

TEST(LayerSystem, AGradedGroupRunsFromItsFirstRepeatToItsLastOnAStraightLine) {
    Layer film = layer_of(1.5, 100.0);
    film.last_thickness_nm = 200.0;
    film.last_index = Index(2.0);
    const Layer gap = layer_of(1.0, 83.0);
    const auto met = met_by_light(layer_system(Stack{1.0, {group_of(5, {film, gap})}, 1.0}));
    ASSERT_EQ(met.size(), 10u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(met[2 * i].thickness_nm, 100.0 + 25.0 * static_cast<double>(i), 1e-12);
        EXPECT_NEAR(met[2 * i].index.real(), 1.5 + 0.125 * static_cast<double>(i), 1e-15);
        EXPECT_EQ(met[2 * i + 1], (Met{1.0, 83.0, false})) << "what is not graded stays as it is";
    }
    EXPECT_EQ(met[0], (Met{1.5, 100.0, false})) << "ends are exact";
    EXPECT_EQ(met[8], (Met{2.0, 200.0, false}));
}

TEST(LayerSystem, AGradedGroupOfOneIsItsFirst) {
    Layer film = layer_of(1.5, 100.0);
    film.last_thickness_nm = 200.0;
    EXPECT_EQ(met_by_light(layer_system(Stack{1.0, {group_of(1, {film})}, 1.0})),
              (std::vector<Met>{{1.5, 100.0, false}}));
}

TEST(LayerSystem, GradingBelongsToTheInnermostGroup) {
    Layer film = layer_of(1.5, 100.0);
    film.last_thickness_nm = 300.0;
    // The outer group repeats a graded one: each time it starts anew.
    const auto met = met_by_light(layer_system(Stack{1.0, {group_of(2, {group_of(3, {film})})}, 1.0}));
    const std::vector<Met> once{{1.5, 100.0, false}, {1.5, 200.0, false}, {1.5, 300.0, false}};
    std::vector<Met> twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    EXPECT_EQ(met, twice);
    // A graded group repeats a plain one: that is the same every time.
    const auto other =
        met_by_light(layer_system(Stack{1.0, {group_of(3, {film, group_of(2, {layer_of(1.0, 50.0)})})}, 1.0}));
    ASSERT_EQ(other.size(), 9u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(other[3 * i], once[i]);
        EXPECT_EQ(other[3 * i + 1], (Met{1.0, 50.0, false}));
        EXPECT_EQ(other[3 * i + 2], (Met{1.0, 50.0, false}));
    }
}

TEST(LayerSystem, GroupsWithoutGradingAreNotWrittenOut) {
    const LayerSystem system =
        layer_system(Stack{1.0, {group_of(1000000, {layer_of(1.5, 100.0), layer_of(1.0, 80.0)})}, 1.0});
    EXPECT_EQ(system.nodes.size(), 3u);
    EXPECT_EQ(expanded_layers(system), 2e6);
}

}  // namespace
}  // namespace nacre
