#include "nacre/accuracy/choose_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "nacre/accuracy/thick_layers.h"
#include "nacre/colour/colour_distance.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/job.h"
#include "nacre/lut/sampler.h"
#include "nacre/shade/integral.h"
#include "nacre/shade/kinks.h"
#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

constexpr int fewest_nodes = 16;
// What the mean over many uneven layers errs by falls as slowly as 1 / sqrt(count), so that the next two counts err as
// well.
constexpr double of_slow_means = 1.5;
constexpr int realisations_for_nodes = 16;
// Enough to see whether a spread of thicknesses counts at all.
constexpr int realisations_of_a_look = 64;
constexpr int sizes_of_a_look = 32;

// Of a choice, in reflectances of a film: some five seconds.
constexpr double most_effort = 5e8;

// Square roots of the cosines at which each band is probed.
constexpr std::array<std::array<double, 6>, band_least_cos_theta.size()> probe_sqrt_cos{
    {{1.0, 0.92, 0.82, 0.72, 0.63, 0.56},
     {0.53, 0.47, 0.4, 0.34, 0.28, 0.23},
     {0.21, 0.17, 0.14, 0.11, 0.09, 0.07},
     {0.06, 0.045, 0.03, 0.02, 0.01, 0.005}}};
// Next to grazing, fringes hit nodes or miss them: it takes many angles to meet a bad one.
constexpr std::array more_grazing_sqrt_cos{0.0561, 0.0523, 0.0487, 0.0421, 0.0377, 0.0333, 0.0271, 0.0237,
                                           0.0213, 0.0177, 0.0153, 0.0131, 0.0113, 0.0087, 0.0073, 0.0061,
                                           0.0047, 0.0041, 0.0037, 0.0029, 0.0023, 0.0017, 0.0011, 0.0007};
// Facets' means are cheap, and differ most at grazing and where the colour of a facet bends: they are probed at so many
// even steps, at some beside 0, and at bends.
constexpr int tilt_probe_steps = 256;
constexpr std::array grazing_sqrt_cos{0.0005, 0.001, 0.002};

// How many tolerances a band may err by. In a film that stands free, light that grazes it runs to and fro so often that
// no grid resolves its fringes: there an error falls only as they are hit by more nodes.
constexpr std::array<double, band_least_cos_theta.size()> band_patience{1.0, 1.0, 2.0, 3.0};

// What an effect changes between the probes may be half as much again.
constexpr double between_probes = 1.5;

constexpr std::array hemisphere_points{3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
constexpr std::array slice_counts{8, 12, 16, 20, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};
constexpr std::array size_points{4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};

// The next count that is worth trying: steps of a third or a quarter.
int next_count(int count) {
    int power = fewest_nodes;
    while (2 * power <= count) power *= 2;
    for (const int quarters : {5, 6, 8}) {
        if (power * quarters / 4 > count) return power * quarters / 4;
    }
    return 2 * power;
}

// A material, and where light and eye are when it is looked at.
struct Probes {
    Mechanism mechanism;  // without what the job does without
    Mechanism whole;      // with all that the scene says
    std::vector<Geometry> geometries;
};

class Chooser {
public:
    Chooser(const Job& job, const SamplingTolerance& tolerance, const SamplingWish& wish,
            const std::function<void()>& after_step)
        : job_(job), tolerance_(tolerance), wish_(wish), after_step_(after_step) {
        chosen_.without = job.without;
        place_probes();
        per_sample_ = effort_per_sample(job.material.mechanism);
    }

    ChosenSampling choose() {
        const EffectSet named = effects_in(job_);
        const bool is_spread_in_size = named.has(Effect::size_spread) && !chosen_.without.has(Effect::size_spread);
        if (is_spread_in_size) choose_sizes();
        if (std::holds_alternative<Crystal>(job_.material.mechanism)) choose_slices();
        if (samples_spectra(job_.material.mechanism)) choose_all_nodes();
        look_at_effects(named);
        const auto is_in = [&](Effect effect) { return named.has(effect) && !chosen_.without.has(effect); };
        if (!is_in(Effect::size_spread)) chosen_.sampling.sizes = 1;
        if (is_in(Effect::base) && is_layered(job_.material.mechanism)) choose_hemisphere();
        if (is_in(Effect::thickness_spread)) choose_realisations();
        if (is_in(Effect::tilt) && only_tilt_moves()) {
            Mechanism mechanism = bands_.front().front().mechanism;
            mechanism.effects.tilt_deg = 0.0;
            chosen_.sampling.facets = std::make_shared<const XyzCurve>(curve_of(mechanism));
        }
        return std::move(chosen_);
    }

private:
    using Colours = std::vector<Xyz>;

    void place_probes() {
        const Quantity quantity = quantity_of(job_.material.mechanism);
        const bool has_angle = job_.x.is_angle() || (job_.y && job_.y->is_angle());
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            std::vector<Geometry> geometries;
            if (!has_angle) {
                geometries = {job_.fixed};
            } else if (quantity == Quantity::incidence) {
                for (const double s : probe_sqrt_cos[band]) geometries.push_back(Incidence::from_sqrt_cos(s));
                if (band + 1 == bands_.size()) {
                    for (const double s : more_grazing_sqrt_cos) geometries.push_back(Incidence::from_sqrt_cos(s));
                }
            } else if (band == 0) {
                constexpr int count = 17;
                const AxisKind& kind = default_axis_kind(quantity);
                for (int i = 0; i < count; ++i) geometries.push_back(kind.geometry(coordinate_of_texel(i, count)));
            }
            if (geometries.empty() || (!has_angle && !is_band_of_fixed(band))) continue;
            place_mechanisms(band, geometries);
        }
    }

    // Without an angle on an axis one band is all there is; the others are never asked for.
    bool is_band_of_fixed(std::size_t band) const {
        return band == 0 ||
               (quantity_of(job_.material.mechanism) == Quantity::incidence && band == band_of(job_.fixed.incidence));
    }

    void place_mechanisms(std::size_t band, const std::vector<Geometry>& geometries) {
        const bool x_moves = !job_.x.is_angle();
        const bool y_moves = job_.y && !job_.y->is_angle();
        const int along = x_moves ? (y_moves ? 5 : 9) : 1;
        const int across = y_moves ? (x_moves ? 5 : 9) : 1;
        for (int i = 0; i < along * across; ++i) {
            const double x = coordinate_of_texel(i % along, along);
            const double y = coordinate_of_texel(i / along, across);
            bands_[band].push_back({simulated_at(job_, x, y), mechanism_at(job_, x, y), geometries});
        }
    }

    double first_nm() const { return job_.light->settings.first_nm; }
    double effort() const { return per_sample_ * static_cast<double>(chosen_.work.samples); }

    // Of the surface itself, without facets.
    Colours colours(std::size_t band, const SpectralSampling& sampling, const EffectSet& less = {}) {
        EffectSet without = less;
        without.insert(Effect::tilt);
        Colours result;
        for (const Probes& probes : bands_[band]) {
            Mechanism mechanism = probes.mechanism;
            remove(without, mechanism, first_nm());
            PreparedColour prepared = prepare_colour(mechanism, sampling, *job_.light, Integral::exact);
            for (const Geometry& geometry : probes.geometries) {
                result.push_back(adapt(job_.light->adaptation, colour_at(prepared, geometry, chosen_.work)));
                if (after_step_) after_step_();
            }
        }
        return result;
    }

    // At the scale of what is brightest anywhere: the first band has been seen by then.
    double largest_difference(const Colours& one, const Colours& other) {
        for (const Xyz& colour : other) brightest_ = std::max(brightest_, colour.y);
        double largest = 0.0;
        for (std::size_t i = 0; i < one.size(); ++i)
            largest = std::max(largest, distance_at(one[i], other[i], brightest_));
        return largest;
    }

    std::shared_ptr<const SpectralNodes> nodes(int count) const {
        return std::make_shared<const SpectralNodes>(make_spectral_nodes(job_.light->weights, count));
    }

    SpectralSampling with_nodes(std::shared_ptr<const SpectralNodes> nodes) const {
        SpectralSampling sampling = chosen_.sampling;
        sampling.nodes.fill(std::move(nodes));
        return sampling;
    }

    // Some uneven layers decide on the nodes, if they are uneven: their mean is smoother than what is regular.
    void choose_all_nodes() {
        const Light& light = *job_.light;
        if (light.settings.wavelengths) {
            // A scene that insists on its wavelengths gets every fringe as they sample it.
            chosen_.sampling.nodes.fill(
                std::make_shared<const SpectralNodes>(make_spectral_nodes(light.grid_weights, light.grid)));
            return;
        }
        if (is_layered(job_.material.mechanism)) chosen_.sampling.blurred = thick_layers(job_, tolerance_.nodes);
        if (is_uneven()) chosen_.sampling.realisations = realisations_for_nodes;
        int fewest = fewest_nodes;
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            if (bands_[band].empty()) {
                chosen_.sampling.nodes[band] = chosen_.sampling.nodes.front();
                continue;
            }
            choose_nodes(band, fewest, band_patience[band] * tolerance_.nodes, share_of_grazed(band));
            fewest = chosen_.sampling.nodes[band]->count;
        }
        if (wish_.nodes.front() > 0) take_nodes(wish_.nodes);
        chosen_.sampling.realisations = 1;
    }

    // What of a surface's facets is seen within so small a cosine goes with its square: of facets that lean every way,
    // those that are grazed hardly count, nor does what they err by.
    double share_of_grazed(std::size_t band) const {
        constexpr double rad_per_deg = 0.017453292519943295;
        constexpr double least = 1e-3;
        double least_tilt_deg = 90.0;
        for (const Probes& probes : bands_[band])
            least_tilt_deg = std::min(least_tilt_deg, probes.mechanism.effects.tilt_deg);
        if (band == 0 || !(least_tilt_deg > 0.0)) return 1.0;
        const double share = band_least_cos_theta[band - 1] / std::sin(least_tilt_deg * rad_per_deg);
        return std::clamp(share * share, least, 1.0);
    }

    bool is_uneven() const {
        return std::all_of(bands_.front().begin(), bands_.front().end(),
                           [](const Probes& probes) { return is_irregular(probes.mechanism); });
    }

    // The first count that the next two agree with.
    // @param share  of the error that is seen
    void choose_nodes(std::size_t band, int fewest, double tolerance, double share) {
        double fringes = 0.0;
        for (const Probes& probes : bands_[band]) {
            if (!is_layered(probes.mechanism)) break;
            const auto system = even_system(probes.mechanism, chosen_.sampling.blurred, chosen_.sampling.slices);
            fringes = std::max(fringes, fringe_count(system, job_.light->settings));
        }
        int count = fewest;
        while (count < 2.0 * fringes && count < most_nodes) count = next_count(count);
        struct Try {
            std::shared_ptr<const SpectralNodes> nodes;
            Colours colours;
        };
        std::vector<Try> tries;
        for (;; count = next_count(count)) {
            const auto these = nodes(count);
            tries.push_back({these, colours(band, with_nodes(these))});
            if (tries.size() < 3) continue;
            const Try& candidate = tries[tries.size() - 3];
            const double error =
                share * std::max(largest_difference(candidate.colours, tries.back().colours),
                                 largest_difference(tries[tries.size() - 2].colours, tries.back().colours));
            const bool may_go_on = count < most_nodes_of(band, fringes) && effort() < most_effort;
            if (error > tolerance && may_go_on) continue;
            chosen_.sampling.nodes[band] = candidate.nodes;
            chosen_.error = std::max(chosen_.error, error);
            return;
        }
    }

    // At grazing, fringes that are too sharp for any grid reflect everything but a trace.
    static int most_nodes_of(std::size_t band, double fringes) {
        if (band != 2) return most_nodes;  // of the last there is so little that they do not cost
        constexpr double per_fringe = 64.0;
        constexpr int at_least = 16384;
        return std::min(most_nodes, std::max(at_least, static_cast<int>(per_fringe * fringes)));
    }

    // Counts that the user gives are held against those that would do.
    void take_nodes(const NodeCounts& counts) {
        chosen_.error = 0.0;
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            const Colours good = colours(band, with_nodes(chosen_.sampling.nodes[band]));
            chosen_.sampling.nodes[band] = nodes(counts[band]);
            const Colours taken = colours(band, with_nodes(chosen_.sampling.nodes[band]));
            chosen_.error = std::max(chosen_.error, share_of_grazed(band) * largest_difference(taken, good));
        }
    }

    // Leaves every effect out for once.
    void look_at_effects(const EffectSet& named) {
        const EffectSet given = chosen_.without;
        const double share = named.is_empty() ? 0.0 : tolerance_.effects / named.size();
        std::array<Colours, band_least_cos_theta.size()> whole;
        for (const EffectRow& row : effect_rows()) {
            if (!named.has(row.effect)) continue;
            EffectChoice choice{row.effect, !given.has(row.effect), given.has(row.effect), false, 0.0, share};
            if (choice.is_given) {
                choice.is_measured = true;
                choice.contribution = between_probes * contribution_of_given(row.effect);
                chosen_.effects_error += choice.contribution;
            } else if (share > 0.0) {
                choice.is_measured = true;
                choice.contribution =
                    between_probes *
                    (row.effect == Effect::tilt ? contribution_of_tilt() : contribution_of(row.effect, whole));
                choice.is_simulated = choice.contribution > share;
                if (!choice.is_simulated) {
                    chosen_.without.insert(row.effect);
                    chosen_.effects_error += choice.contribution;
                }
            }
            chosen_.effects.push_back(choice);
        }
    }

    // Against the surface with all its other effects. A few uneven layers stand for a spread of thicknesses.
    double contribution_of(Effect effect, std::array<Colours, band_least_cos_theta.size()>& whole) {
        double largest = 0.0;
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            if (bands_[band].empty()) continue;
            SpectralSampling sampling = chosen_.sampling;
            if (effect == Effect::thickness_spread) {
                sampling.realisations = realisations_of_a_look;
                const Colours even = colours(band, chosen_.sampling);
                largest = std::max(largest, largest_difference(colours(band, sampling), even));
                continue;
            }
            sampling.realisations = realisations_for_nodes;
            if (whole[band].empty()) whole[band] = colours(band, sampling);
            if (effect == Effect::incoherent_layers) sampling.blurred.clear();  // they may be nodes that are gone
            EffectSet less;
            less.insert(effect);
            const Colours other = colours(band, sampling, less);
            largest = std::max(largest, largest_difference(other, whole[band]));
        }
        return largest;
    }

    // Of what the scene does without although its material has it.
    double contribution_of_given(Effect effect) {
        EffectSet rest = chosen_.without;
        rest.erase(effect);
        double largest = 0.0;
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            Colours less;
            Colours more;
            for (const Probes& probes : bands_[band]) {
                Mechanism mechanism = probes.whole;
                remove(rest, mechanism, first_nm());
                SpectralSampling sampling = chosen_.sampling;
                if (effect == Effect::thickness_spread) sampling.realisations = realisations_of_a_look;
                if (effect == Effect::size_spread) sampling.sizes = sizes_of_a_look;
                add_colours(probes.mechanism, probes.geometries, chosen_.sampling, less);
                add_colours(mechanism, probes.geometries, sampling, more);
            }
            largest = std::max(largest, largest_difference(less, more));
        }
        return largest;
    }

    // Facets and all.
    void add_colours(Mechanism mechanism, const std::vector<Geometry>& geometries, const SpectralSampling& sampling,
                     Colours& out) {
        const double tilt_deg = std::exchange(mechanism.effects.tilt_deg, 0.0);
        PreparedColour prepared = prepare_colour(mechanism, sampling, *job_.light, Integral::exact);
        const auto flat = [&](const Geometry& geometry) {
            return adapt(job_.light->adaptation, colour_at(prepared, geometry, chosen_.work));
        };
        FacetColours facets;
        if (tilt_deg > 0.0) facets = FacetColours(facet_curve(flat, kinks_deg(mechanism), after_step_));
        for (const Geometry& geometry : geometries) {
            std::uint64_t& points = work_of(chosen_.work.effects, Effect::tilt).points;
            out.push_back(tilt_deg > 0.0 ? facets.mean(tilt_deg, geometry.incidence, points) : flat(geometry));
            if (after_step_) after_step_();
        }
    }

    bool only_tilt_moves() const {
        const auto is_else = [](const Axis& axis) { return !axis.is_angle() && axis.parameter.name != "tilt_deg"; };
        return !is_else(job_.x) && !(job_.y && is_else(*job_.y));
    }

    void choose_realisations() {
        const auto seen = [&](int count) {
            SpectralSampling sampling = chosen_.sampling;
            sampling.realisations = count;
            Colours all = colours(0, sampling, chosen_.without);
            if (bands_[1].empty()) return all;
            const Colours oblique = colours(1, sampling, chosen_.without);
            all.insert(all.end(), oblique.begin(), oblique.end());
            return all;
        };
        const RealisationCounts counts = realisation_counts(bands_.front().front().mechanism);
        const double least_factor = counts.converge_fast ? 1.0 : of_slow_means;
        if (wish_.realisations > 0) {
            chosen_.sampling.realisations = wish_.realisations;
            chosen_.spread_error =
                least_factor * largest_difference(seen(wish_.realisations), seen(2 * wish_.realisations));
            return;
        }
        const Choice choice = choose_points(counts.list, tolerance_.spread / least_factor, seen);
        chosen_.sampling.realisations = choice.points;
        chosen_.spread_error = least_factor * choice.error;
    }

    struct Choice {
        int points;
        double error;
    };
    // The first of a list that the next two agree with; the last but two, if none does.
    // @param seen  what is seen with a number of points
    Choice choose_points(std::span<const int> list, double tolerance, const std::function<Colours(int)>& seen) {
        std::vector<Colours> tries;
        for (std::size_t i = 0;; ++i) {
            tries.push_back(seen(list[i]));
            if (i < 2) continue;
            const double error =
                std::max(largest_difference(tries[i - 2], tries[i]), largest_difference(tries[i - 1], tries[i]));
            if (error > tolerance && i + 1 < list.size() && effort() < most_effort) continue;
            return {list[i - 2], error};
        }
    }
    // Of a sum whose error is the quadrature's.
    // @param wish  what the user insists on, held against twice and thrice as many; 0: nothing
    int choose_quadrature(std::span<const int> list, int wish, const std::function<Colours(int)>& seen) {
        constexpr int beyond_doubt = 512;
        if (wish > beyond_doubt) return wish;
        if (wish > 0) {
            const Colours taken = seen(wish);
            chosen_.quadrature_error +=
                std::max(largest_difference(taken, seen(2 * wish)), largest_difference(taken, seen(3 * wish)));
            return wish;
        }
        const Choice choice = choose_points(list, tolerance_.quadrature, seen);
        chosen_.quadrature_error += choice.error;
        return choice.points;
    }

    // Before anything else of a crystal: with nodes that are enough to see what slices change.
    void choose_slices() {
        // Two per fringe: what is missed of a fringe is missed of all slices alike.
        constexpr int enough_nodes = 64;
        constexpr double most_look_nodes = 4096.0;
        const double fringes = fringe_count(bands_.front().front().mechanism, job_.light->settings);
        const auto look = nodes(std::max(enough_nodes, static_cast<int>(std::min(2.0 * fringes, most_look_nodes))));
        per_sample_ = effort_per_sample(job_.material.mechanism, slice_counts.back());
        chosen_.sampling.slices = choose_quadrature(slice_counts, wish_.points.slices, [&](int count) {
            SpectralSampling sampling = with_nodes(look);
            sampling.slices = count;
            return colours(0, sampling);
        });
        per_sample_ = effort_per_sample(job_.material.mechanism, chosen_.sampling.slices);
    }

    void choose_hemisphere() {
        chosen_.sampling.hemisphere = choose_quadrature(hemisphere_points, wish_.points.hemisphere, [&](int points) {
            SpectralSampling sampling = chosen_.sampling;
            sampling.hemisphere = points;
            return colours(0, sampling, chosen_.without);
        });
    }

    void choose_sizes() {
        constexpr int enough_nodes = 48;
        const auto look = nodes(enough_nodes);
        chosen_.sampling.sizes = choose_quadrature(size_points, wish_.points.sizes, [&](int points) {
            SpectralSampling sampling = with_nodes(look);
            sampling.sizes = points;
            return colours(0, sampling);
        });
    }

    // Facets' colours along the axes, each with its tilt; made once.
    struct TiltProbe {
        double tilt_deg;
        std::shared_ptr<FacetColours> facets;
        std::vector<double> sqrt_cos;  // at which the mean is looked at
    };
    static std::vector<double> tilt_probe_places(const Mechanism& mechanism) {
        std::vector<double> places(grazing_sqrt_cos.begin(), grazing_sqrt_cos.end());
        for (int i = 0; i <= tilt_probe_steps; ++i) places.push_back(static_cast<double>(i) / tilt_probe_steps);
        for (const double bend_deg : kinks_deg(mechanism))
            places.push_back(std::sqrt(std::max(Incidence::from_degrees(bend_deg).cos_theta, 0.0)));
        return places;
    }
    const std::vector<TiltProbe>& tilt_probes() {
        if (!tilt_probes_.empty()) return tilt_probes_;
        constexpr std::size_t most = 9;
        const std::vector<Probes>& all = bands_.front();
        const std::size_t step = (all.size() + most - 1) / most;
        std::optional<Mechanism> last;
        for (std::size_t i = 0; i < all.size(); i += step) {
            Mechanism mechanism = all[i].mechanism;
            const double tilt_deg = mechanism.effects.tilt_deg;
            if (!(tilt_deg > 0.0)) continue;
            mechanism.effects.tilt_deg = 0.0;
            if (!last || !(*last == mechanism)) {
                last = mechanism;
                tilt_probes_.push_back(
                    {tilt_deg, std::make_shared<FacetColours>(facets_of(mechanism)), tilt_probe_places(mechanism)});
            } else {
                tilt_probes_.push_back({tilt_deg, tilt_probes_.back().facets, tilt_probes_.back().sqrt_cos});
            }
        }
        return tilt_probes_;
    }

    FacetColours facets_of(const Mechanism& mechanism) { return FacetColours(curve_of(mechanism)); }

    XyzCurve curve_of(Mechanism mechanism) {
        remove(chosen_.without, mechanism, first_nm());
        PreparedColour prepared = prepare_colour(mechanism, chosen_.sampling, *job_.light, Integral::exact);
        const auto colour = [&](const Incidence& incidence) { return colour_at(prepared, incidence, chosen_.work); };
        return facet_curve(colour, kinks_deg(mechanism), after_step_);
    }

    Colours tilted() {
        Colours result;
        std::uint64_t& count = work_of(chosen_.work.effects, Effect::tilt).points;
        for (const TiltProbe& probe : tilt_probes()) {
            for (const double s : probe.sqrt_cos)
                result.push_back(adapt(job_.light->adaptation,
                                       probe.facets->mean(probe.tilt_deg, Incidence::from_sqrt_cos(s), count)));
            if (after_step_) after_step_();
        }
        return result;
    }

    double contribution_of_tilt() {
        Colours flat;
        for (const TiltProbe& probe : tilt_probes()) {
            for (const double s : probe.sqrt_cos)
                flat.push_back(adapt(job_.light->adaptation, probe.facets->colour().at(s)));
        }
        return largest_difference(flat, tilted());
    }

    const Job& job_;
    const SamplingTolerance tolerance_;
    const SamplingWish wish_;
    const std::function<void()>& after_step_;
    double per_sample_ = 1.0;  // what a reflectance takes, in those of a film
    std::array<std::vector<Probes>, band_least_cos_theta.size()> bands_;
    double brightest_ = 0.0;
    std::vector<TiltProbe> tilt_probes_;
    ChosenSampling chosen_;
};

}  // namespace

ChosenSampling choose_sampling(const Job& job, const SamplingTolerance& tolerance, const SamplingWish& wish,
                               const std::function<void()>& after_step) {
    const EffectSet named = effects_in(job);
    if (!samples_spectra(job.material.mechanism) && named.is_empty()) {
        ChosenSampling nothing;
        nothing.without = job.without;
        return nothing;
    }
    return Chooser(job, tolerance, wish, after_step).choose();
}

SpectralSampling default_sampling(const Job& job) {
    return choose_sampling(job, {}).sampling;
}

}  // namespace nacre
