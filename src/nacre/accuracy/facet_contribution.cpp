// What leaving out that a surface's facets lean would change.
//
// In: the probes of a job, and everything about its sampling but the sums that come last. The colour of a single facet
// is computed once per material, as a curve over the angle; where only tilt or roughness differs from one probe to the
// next, the curve is kept. The mean over facets and the colour of the even surface are then compared along all angles.
#include "nacre/accuracy/facet_contribution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "nacre/shade/facets.h"
#include "nacre/shade/kinks.h"
#include "nacre/shade/prepared_colour.h"

namespace nacre {
namespace {

// Materials along the parameter axes that are compared at most, each with a curve of its own; as many as one axis has.
constexpr std::size_t most_materials = 9;
// Even steps in the square root of the cosine, and some places beside 0, where the means change fastest (empirical).
constexpr int even_steps = 256;
constexpr std::array grazing_sqrt_cos{0.0005, 0.001, 0.002};

struct FacetProbe {
    Relief relief;
    std::shared_ptr<FacetColours> facets;
    std::vector<double> sqrt_cos;  // where the mean is compared
};

std::vector<double> places_of(const Mechanism& mechanism) {
    std::vector<double> places(grazing_sqrt_cos.begin(), grazing_sqrt_cos.end());
    for (int i = 0; i <= even_steps; ++i) places.push_back(static_cast<double>(i) / even_steps);
    for (const double kink_deg : kinks_deg(mechanism))
        places.push_back(std::sqrt(std::max(Incidence::from_degrees(kink_deg).cos_theta, 0.0)));
    return places;
}

std::vector<FacetProbe> facet_probes(const Probes& probes, const SpectralSampling& sampling, const EffectSet& without,
                                     ProbeTally& tally) {
    const std::vector<Probe>& all = probes.bands.front();
    const std::size_t step = (all.size() + most_materials - 1) / most_materials;
    std::vector<FacetProbe> result;
    std::optional<Mechanism> last;
    for (std::size_t i = 0; i < all.size(); i += step) {
        Mechanism mechanism = all[i].simulated;
        const Relief relief = std::exchange(mechanism.effects.relief, {});
        if (relief.is_plane()) continue;
        if (last && *last == mechanism) {
            result.push_back({relief, result.back().facets, result.back().sqrt_cos});
            continue;
        }
        FacetColours facets(facet_colours(probes, mechanism, sampling, without, tally));
        result.push_back({relief, std::make_shared<FacetColours>(std::move(facets)), places_of(mechanism)});
        last = std::move(mechanism);
    }
    return result;
}

}  // namespace

XyzCurve facet_colours(const Probes& probes, Mechanism mechanism, const SpectralSampling& sampling,
                       const EffectSet& without, ProbeTally& tally) {
    const Light& light = *probes.job.light;
    remove(without, mechanism, light.settings.first_nm);
    PreparedColour prepared = prepare_colour(mechanism, sampling, light);
    const auto colour = [&](const Incidence& incidence) { return colour_at(prepared, incidence, tally.work); };
    return facet_curve(colour, kinks_deg(mechanism), probes.after_step);
}

double contribution_of_facets(const Probes& probes, const SpectralSampling& sampling, const EffectSet& without,
                              ProbeTally& tally) {
    const glm::dmat3& adaptation = probes.job.light->adaptation;
    Colours flat;
    Colours with_facets;
    for (const FacetProbe& probe : facet_probes(probes, sampling, without, tally)) {
        std::uint64_t& points = work_of(tally.work.effects, facet_effect(probe.relief)).points;
        for (const double s : probe.sqrt_cos) {
            flat.push_back(adapt(adaptation, probe.facets->colour().at(s)));
            const Xyz mean = probe.facets->mean(probe.relief, Incidence::from_sqrt_cos(s), points);
            with_facets.push_back(adapt(adaptation, mean));
        }
        if (probes.after_step) probes.after_step();
    }
    return largest_difference(flat, with_facets, tally);
}

}  // namespace nacre
