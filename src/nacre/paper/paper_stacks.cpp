#include "nacre/paper/paper_stacks.h"

#include <cassert>
#include <utility>

#include "nacre/optics/incidence.h"
#include "nacre/optics/refractive_index.h"

namespace nacre {
namespace {

// More films change nothing: cuticle absorbs, and 8 of them reflect within 1 % of what 20 do.
constexpr int morpho_films = 10;
// With this spread Sun's closed form of an irregular stack of these films is about as wide as the picks: 49 and 43 nm
// at half height, at 0 and 40 degrees, where they have 47 and 40.
constexpr double sun_spread_nm = 16.0;

Layer group(int repeat, std::vector<Layer> layers) {
    Layer group;
    group.repeat = repeat;
    group.layers = std::move(layers);
    return group;
}

Layer layer(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

// Films with air between, free in air.
Stack films_in_air(int films, const Layer& film, double air_nm, double spread_nm) {
    Stack stack;
    stack.incident = 1.0;
    stack.layers = {group(films - 1, {film, layer(1.0, air_nm)}), film};
    stack.substrate = 1.0;
    stack.thickness_spread_nm = spread_nm;
    return stack;
}

// Sixteen layers, two kinds in turn, each a quarter of the wave that is reflected most at the normal.
Stack sixteen_layers(double high, double low, double peak_nm) {
    constexpr int pairs = 8;
    // Round value of insect chitin, Stavenga et al. 2012. Having no far side, it sends nothing back, as dark cuticle
    // would not; absorption that is strong enough to reflect by itself is left out (see `facts`).
    constexpr double cuticle = 1.55;
    Stack stack;
    stack.incident = 1.0;
    stack.layers = {group(pairs, {layer(high, peak_nm / (4.0 * high)), layer(low, peak_nm / (4.0 * low))})};
    stack.substrate = cuticle;
    return stack;
}

std::vector<ExactStack> morpho_stacks(const BraggStack& implied) {
    const Layer cuticle = layer(RefractiveIndex{implied.solid_index, 0.06}, implied.solid_nm);
    return {
        {"perfect", "10 even films",
         "10 films of cuticle, n = 1.56 + 0.06i (measured: Vukusic et al. 1999; sure to ±0.01), 94.1 nm thick, with "
         "83.2 nm of air between (not measured: solved from the two picks by Bragg's law; unsure, 2.5 nm in the "
         "picks' peaks move the film by 10 nm). How many films this specimen's scales have is not known to us. None "
         "matches the picks' width at half height, 47 nm at the normal: 4 films reflect 171 nm, 10 films 130 nm and "
         "20 films no less, so 10 it is.",
         films_in_air(morpho_films, cuticle, implied.air_nm, 0.0)},
        {"uneven", "10 uneven films (16 nm)",
         "the same with thicknesses that spread by 16 nm (standard deviation). Sun's closed form of an irregular "
         "stack has about the picks' width with that spread (49 nm; in a third party's code, not checked against the "
         "article). The exact mean does not: irregularity widens a band that is broad from contrast.",
         films_in_air(morpho_films, cuticle, implied.air_nm, sun_spread_nm)},
        {"osaka", "Osaka: 6 films of 65 nm",
         "6 films, n = 1.6, 65 nm thick, with 130 nm of air between: the example of Osaka University's structural "
         "colour society, seen in a third party's code; medium sure, and it absorbs nothing.",
         films_in_air(6, layer(1.6, 65.0), 130.0, 0.0)}};
}

std::vector<ExactStack> beetle_stacks(const BraggStack& implied) {
    const double normal_peak_nm = 2.0 * implied.solid_index * implied.solid_nm;
    return {
        {"implied", "16 layers, 1.667/1.767",
         "16 layers of n = 1.767 and 1.667 in turn, the upper first: the mean index, 1.717, that the two picks imply "
         "by Bragg's law, with the published difference of 0.1. Each layer is a quarter wave of the 532.7 nm that "
         "the picks imply at the normal. Below it cuticle of n = 1.55 without an end: light that passes is lost.",
         sixteen_layers(implied.solid_index + 0.05, implied.solid_index - 0.05, normal_peak_nm)},
        {"published", "16 layers, 1.6/1.7",
         "the same with n = 1.7 and 1.6 (16 layers between 1.6 and 1.7 in the green area: Stavenga et al. 2011, read "
         "in its abstract, sure). Thicknesses, absorption and which kind lies on top are not known to us: with 1.6 on "
         "top the surface would spoil the band and put its peak near 567 nm, against the 530 nm that were measured; "
         "dark cuticle below, as its relative C. raja has it (n = 1.55 + 0.14i, measured), would move peaks up by "
         "5 nm. The band that was measured is 100 to 150 nm wide, broader than that of any even stack of so little "
         "contrast.",
         sixteen_layers(1.7, 1.6, normal_peak_nm)}};
}

}  // namespace

std::vector<ExactStack> exact_stacks(const Specimen& specimen) {
    return specimen.name == paper_morpho().name ? morpho_stacks(specimen.stack) : beetle_stacks(specimen.stack);
}

double bragg_peak_nm(const Stack& stack, const Incidence& incidence) {
    assert(!stack.layers.empty() && stack.layers.front().repeat > 0);
    double path_nm = 0.0;
    for (const Layer& layer : stack.layers.front().layers)
        path_nm += layer.thickness_nm * path_factor(layer.index.constant.real(), incidence);
    return 2.0 * path_nm;
}

}  // namespace nacre
