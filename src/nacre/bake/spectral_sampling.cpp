#include "nacre/bake/spectral_sampling.h"

#include <algorithm>
#include <cmath>

#include "nacre/bake/layered_colour.h"
#include "nacre/bake/plan.h"
#include "nacre/bake/sampler.h"
#include "nacre/bake/thick_layers.h"
#include "nacre/colour/difference.h"

namespace nacre {
namespace {

constexpr Xyz d65 = xyz_from_chromaticity(d65_chromaticity);

constexpr int fewest_nodes = 16;
constexpr int fewest_realisations = 32;

// Of a choice, in reflectances of a film: some five seconds.
constexpr double most_effort = 5e8;

// Square roots of the cosines at which each band is probed.
constexpr std::array<std::array<double, 6>, band_least_cos_theta.size()> probe_sqrt_cos{
    {{1.0, 0.92, 0.82, 0.72, 0.63, 0.56},
     {0.53, 0.47, 0.4, 0.34, 0.28, 0.23},
     {0.21, 0.17, 0.14, 0.11, 0.09, 0.07},
     {0.06, 0.045, 0.03, 0.02, 0.01, 0.005}}};

// How many tolerances a band may err by. In a film that stands free, light that grazes it runs to and fro so often that
// no grid resolves its fringes: there an error falls only as they are hit by more nodes.
constexpr std::array<double, band_least_cos_theta.size()> band_patience{1.0, 1.0, 2.0, 3.0};

// The next count that is worth trying: steps of a third or a quarter.
int next_count(int count) {
    int power = fewest_nodes;
    while (2 * power <= count) power *= 2;
    for (const int quarters : {5, 6, 8}) {
        if (power * quarters / 4 > count) return power * quarters / 4;
    }
    return 2 * power;
}

// A material, and the angles of one band at which it is looked at.
struct Probes {
    Mechanism mechanism;
    std::vector<Incidence> incidences;
};

class Chooser {
public:
    Chooser(const Job& job, const std::function<void()>& after_step) : job_(job), after_step_(after_step) {
        place_probes();
        per_sample_ = 1.0 + 0.25 * expanded_layers(layer_systems(job.material.mechanism, 1).front());
    }

    ChosenSampling choose(double tolerance, double spread_tolerance, const SamplingWish& wish) {
        const Light& light = *job_.light;
        // A scene that insists on its wavelengths gets every fringe as they sample it.
        if (!light.settings.wavelengths) chosen_.sampling.blurred = thick_layers(job_, tolerance);
        if (light.settings.wavelengths) {
            chosen_.sampling.nodes.fill(
                std::make_shared<const SpectralNodes>(make_spectral_nodes(light.grid_weights, light.grid)));
        } else {
            // The regular stack decides on the nodes: an irregular one is smoother.
            int fewest = fewest_nodes;
            for (std::size_t band = 0; band < bands_.size(); ++band) {
                choose_nodes(band, fewest, band_patience[band] * tolerance);
                fewest = chosen_.sampling.nodes[band]->count;
            }
            if (wish.nodes.front() > 0) take_nodes(wish.nodes);
        }
        const bool is_mean = std::any_of(bands_.front().begin(), bands_.front().end(),
                                         [](const Probes& probes) { return is_irregular(probes.mechanism); });
        if (is_mean) choose_realisations(spread_tolerance, wish.realisations);
        return std::move(chosen_);
    }

private:
    using Colours = std::vector<Xyz>;

    void place_probes() {
        const bool has_angle = job_.x.is_angle() || (job_.y && job_.y->is_angle());
        const bool x_moves = !job_.x.is_angle();
        const bool y_moves = job_.y && !job_.y->is_angle();
        const int along = x_moves ? (y_moves ? 5 : 9) : 1;
        const int across = y_moves ? (x_moves ? 5 : 9) : 1;
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            std::vector<Incidence> incidences;
            for (const double s : probe_sqrt_cos[band]) incidences.push_back(Incidence::from_sqrt_cos(s));
            if (!has_angle) incidences = {Incidence::from_degrees(job_.angle_deg)};
            for (int i = 0; i < along * across; ++i) {
                const double x = coordinate_of_texel(i % along, along);
                bands_[band].push_back({mechanism_at(job_, x, coordinate_of_texel(i / along, across)), incidences});
            }
        }
    }

    Colours colours(std::size_t band, const SpectralSampling& sampling) {
        Colours result;
        for (const Probes& probes : bands_[band]) {
            LayeredColour colour(probes.mechanism, sampling);
            for (const Incidence& incidence : probes.incidences) {
                result.push_back(adapt(job_.light->adaptation, colour.at(incidence)));
                ++chosen_.spectra;
                effort_ += per_sample_ * static_cast<double>(colour.samples(incidence));
                if (after_step_) after_step_();
            }
        }
        return result;
    }

    // At the scale of what is brightest anywhere: the first band has been seen by then.
    double largest_difference(const Colours& one, const Colours& other) {
        for (const Xyz& colour : other) brightest_ = std::max(brightest_, colour.y);
        if (!(brightest_ > black_luminance)) return 0.0;
        const auto lab = [&](const Xyz& colour) {
            return to_lab({colour.x / brightest_, colour.y / brightest_, colour.z / brightest_}, d65);
        };
        double largest = 0.0;
        for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, ciede2000(lab(one[i]), lab(other[i])));
        return largest;
    }

    std::shared_ptr<const SpectralNodes> nodes(int count) const {
        return std::make_shared<const SpectralNodes>(make_spectral_nodes(job_.light->weights, count));
    }

    SpectralSampling regular(std::shared_ptr<const SpectralNodes> nodes) const {
        SpectralSampling sampling;
        sampling.nodes.fill(std::move(nodes));
        sampling.blurred = chosen_.sampling.blurred;
        return sampling;
    }

    // The first count that the next two agree with.
    void choose_nodes(std::size_t band, int fewest, double tolerance) {
        double fringes = 0.0;
        for (const Probes& probes : bands_[band]) {
            const auto system = layer_systems(probes.mechanism, 1, chosen_.sampling.blurred).front();
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
            tries.push_back({these, colours(band, regular(these))});
            if (tries.size() < 3) continue;
            const Try& candidate = tries[tries.size() - 3];
            const double error = std::max(largest_difference(candidate.colours, tries.back().colours),
                                          largest_difference(tries[tries.size() - 2].colours, tries.back().colours));
            const bool may_go_on = count < most_nodes_of(band, fringes) && effort_ < most_effort;
            if (error > tolerance && may_go_on) continue;
            chosen_.sampling.nodes[band] = candidate.nodes;
            chosen_.error = std::max(chosen_.error, error);
            return;
        }
    }

    // At grazing, fringes that are too sharp for any grid reflect everything but a trace.
    static int most_nodes_of(std::size_t band, double fringes) {
        if (band < 2) return most_nodes;
        constexpr double per_fringe = 64.0;
        constexpr int at_least = 16384;
        return std::min(most_nodes, std::max(at_least, static_cast<int>(per_fringe * fringes)));
    }

    // Counts that the user gives are held against those that would do.
    void take_nodes(const NodeCounts& counts) {
        chosen_.error = 0.0;
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            const Colours good = colours(band, regular(chosen_.sampling.nodes[band]));
            chosen_.sampling.nodes[band] = nodes(counts[band]);
            const Colours taken = colours(band, regular(chosen_.sampling.nodes[band]));
            chosen_.error = std::max(chosen_.error, largest_difference(taken, good));
        }
    }

    void choose_realisations(double tolerance, int wish) {
        SpectralSampling& sampling = chosen_.sampling;
        sampling.realisations = wish > 0 ? wish : fewest_realisations;
        Colours some = colours(0, sampling);
        for (;; sampling.realisations *= 2) {
            SpectralSampling twice = sampling;
            twice.realisations *= 2;
            Colours more = colours(0, twice);
            chosen_.spread_error = largest_difference(some, more);
            const bool is_enough = chosen_.spread_error <= tolerance;
            const bool may_go_on = sampling.realisations < most_chosen_realisations && effort_ < most_effort;
            if (wish > 0 || is_enough || !may_go_on) return;
            some = std::move(more);
        }
    }

    const Job& job_;
    const std::function<void()>& after_step_;
    double per_sample_ = 1.0;  // what a reflectance takes, in those of a film
    double effort_ = 0.0;      // so far
    std::array<std::vector<Probes>, band_least_cos_theta.size()> bands_;
    double brightest_ = 0.0;
    ChosenSampling chosen_;
};

}  // namespace

std::size_t band_of(const Incidence& incidence) {
    std::size_t band = 0;
    while (incidence.cos_theta < band_least_cos_theta[band]) ++band;
    return band;
}

NodeCounts SpectralSampling::node_counts() const {
    NodeCounts counts{};
    for (std::size_t band = 0; band < counts.size(); ++band) counts[band] = nodes[band] ? nodes[band]->count : 0;
    return counts;
}

double fringe_count(const Mechanism& mechanism, const LightSettings& light) {
    return needs_sampling(mechanism) ? fringe_count(layer_systems(mechanism, 1).front(), light) : 0.0;
}

ChosenSampling choose_sampling(const Job& job, double tolerance, double spread_tolerance, const SamplingWish& wish,
                               const std::function<void()>& after_step) {
    if (!needs_sampling(job.material.mechanism)) return {};
    return Chooser(job, after_step).choose(tolerance, spread_tolerance, wish);
}

SpectralSampling default_sampling(const Job& job) {
    return choose_sampling(job, 1e-3, 0.1).sampling;
}

}  // namespace nacre
