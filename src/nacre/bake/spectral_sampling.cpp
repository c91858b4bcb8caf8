#include "nacre/bake/spectral_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "nacre/bake/layered_colour.h"
#include "nacre/bake/plan.h"
#include "nacre/bake/sampler.h"
#include "nacre/colour/difference.h"

namespace nacre {
namespace {

constexpr Xyz d65 = xyz_from_chromaticity(d65_chromaticity);

constexpr int fewest_nodes = 16;
constexpr int probes_along = 9;
constexpr int probes_across = 3;
constexpr int fewest_realisations = 32;
constexpr int most_realisations = 2048;
// What an irregular stack may err by, in tolerances: its mean converges slowly, and costs what it converges with.
constexpr double irregular_share = 5.0;

// Of a film or stack at one wavelength; palettes have none.
double optical_path_nm(const LayerSystem& system, double wavelength_nm, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const LayerNode& node = system.nodes[i];
        const auto members = static_cast<std::size_t>(node.count);
        if (node.repeat > 0) {
            sum += node.repeat * optical_path_nm(system, wavelength_nm, i + 1, i + 1 + members);
        } else if (!node.is_incoherent) {
            sum += node.thickness_nm * system.index_at(node.medium, wavelength_nm).real();
        }
        i += members;
    }
    return sum;
}

double fringes_of(const LayerSystem& system, const LightSettings& light) {
    double path_nm = 0.0;
    for (const int nm : {light.first_nm, (light.first_nm + light.last_nm) / 2, light.last_nm})
        path_nm = std::max(path_nm, optical_path_nm(system, nm, 0, system.nodes.size()));
    return 2.0 * path_nm * (1.0 / light.first_nm - 1.0 / light.last_nm);
}

// Fringes that may be too fine to be seen: of some 16 micrometres of glass.
constexpr double fine_fringes = 75.0;

// The next count that is worth trying: steps of a third or a half.
int next_count(int count) {
    int power = 16;
    while (2 * power <= count) power *= 2;
    for (const int quarters : {4, 5, 6, 8}) {
        if (power * quarters / 4 > count) return power * quarters / 4;
    }
    return 2 * power;
}

class Chooser {
public:
    Chooser(const Job& job) : job_(job) {
        for (int j = 0; j < (job.y ? probes_across : 1); ++j) {
            for (int i = 0; i < probes_along; ++i) {
                probes_.push_back(
                    {coordinate_of_texel(i, probes_along), job.y ? coordinate_of_texel(j, probes_across) : 0.0});
            }
        }
    }

    ChosenSampling choose(double tolerance, int node_count, int realisations) {
        const Light& light = *job_.light;
        blur_thick_layers(tolerance);
        // The regular stack decides on the nodes: an irregular one is smoother.
        if (light.settings.wavelengths) {
            chosen_.sampling.nodes =
                std::make_shared<const SpectralNodes>(make_spectral_nodes(light.grid_weights, light.grid));
        } else if (node_count > 0) {
            choose_nodes(tolerance);
            const std::vector<Xyz> good = colours({chosen_.sampling.nodes, 1, chosen_.sampling.blurred});
            chosen_.sampling.nodes =
                std::make_shared<const SpectralNodes>(make_spectral_nodes(light.weights, node_count));
            chosen_.error = largest_difference(colours({chosen_.sampling.nodes, 1, chosen_.sampling.blurred}), good);
        } else {
            choose_nodes(tolerance);
        }
        const bool is_mean = std::any_of(probes_.begin(), probes_.end(), [&](const Probe& probe) {
            return is_irregular(mechanism_at(job_, probe.x, probe.y));
        });
        if (is_mean && realisations > 0) take_realisations(realisations);
        if (is_mean && realisations == 0) choose_realisations(irregular_share * tolerance);
        return std::move(chosen_);
    }

private:
    struct Probe {
        double x;
        double y;
    };

    std::vector<Xyz> colours(const SpectralSampling& sampling) {
        std::vector<Xyz> result;
        for (const Probe& probe : probes_) {
            const LayeredColour colour(mechanism_at(job_, probe.x, probe.y), sampling);
            result.push_back(adapt(job_.light->adaptation, colour.at(incidence_at(job_, probe.x, probe.y))));
            ++chosen_.spectra;
        }
        return result;
    }

    static double largest_difference(const std::vector<Xyz>& one, const std::vector<Xyz>& other) {
        double brightest = 0.0;
        for (const Xyz& colour : other) brightest = std::max(brightest, colour.y);
        if (!(brightest > 0.0)) return 0.0;
        const auto lab = [&](const Xyz& colour) {
            return to_lab({colour.x / brightest, colour.y / brightest, colour.z / brightest}, d65);
        };
        double largest = 0.0;
        for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, ciede2000(lab(one[i]), lab(other[i])));
        return largest;
    }

    // Fringes of every layer that stands alone, and what is left of the whole without it: fine ones must be so beside
    // all the others, for two layers of one thickness have coarse beats.
    std::vector<std::size_t> thick_layers() const {
        LayerSystem system = layer_systems(job_.material.mechanism, 1).front();
        std::vector<std::size_t> thick;
        for (;;) {
            std::size_t thickest = 0;
            double most = 0.0;
            for (std::size_t i = 0; i < system.nodes.size(); i += 1 + static_cast<std::size_t>(system.nodes[i].count)) {
                if (system.nodes[i].repeat > 0 || system.nodes[i].is_incoherent) continue;
                LayerSystem alone = system;
                alone.nodes = {system.nodes[i]};
                const double fringes = fringes_of(alone, job_.light->settings);
                if (fringes <= most) continue;
                most = fringes;
                thickest = i;
            }
            const double others = fringes_of(system, job_.light->settings) - most;
            if (most < fine_fringes || most < 3.0 * others) return thick;
            thick.push_back(thickest);
            system.nodes[thickest].is_incoherent = true;
        }
    }

    // Held against every fringe at angles up to 60 degrees. Beyond these fringes are sharper, but none is coarser.
    void blur_thick_layers(double tolerance) {
        const bool moves = !job_.x.is_angle() || (job_.y && !job_.y->is_angle());
        if (moves) return;  // a thickness that is an axis may be any
        const Mechanism& mechanism = job_.material.mechanism;
        std::vector<std::size_t> thick = thick_layers();
        if (thick.empty()) return;
        const LightSettings& light = job_.light->settings;
        constexpr double nodes_per_fringe = 8.0;
        constexpr int fine_nodes = 128;
        const auto nodes_of = [&](double fringes) {
            const int count = std::max(fine_nodes, static_cast<int>(nodes_per_fringe * fringes));
            return std::make_shared<const SpectralNodes>(make_spectral_nodes(job_.light->weights, count));
        };
        const SpectralSampling sharp{nodes_of(fringe_count(mechanism, light)), 1, {}};
        const SpectralSampling blurred{nodes_of(fringes_of(layer_systems(mechanism, 1, thick).front(), light)), 1,
                                       thick};
        std::vector<Xyz> seen;
        std::vector<Xyz> meant;
        for (const double angle_deg : {0.0, 25.0, 45.0, 60.0}) {
            const Incidence incidence = Incidence::from_degrees(angle_deg);
            seen.push_back(adapt(job_.light->adaptation, LayeredColour(mechanism, blurred).at(incidence)));
            meant.push_back(adapt(job_.light->adaptation, LayeredColour(mechanism, sharp).at(incidence)));
        }
        if (largest_difference(seen, meant) <= tolerance) chosen_.sampling.blurred = std::move(thick);
    }

    // The first count that the one after the next agrees with.
    void choose_nodes(double tolerance) {
        double fringes = 0.0;
        for (const Probe& probe : probes_)
            fringes = std::max(
                fringes,
                fringes_of(layer_systems(mechanism_at(job_, probe.x, probe.y), 1, chosen_.sampling.blurred).front(),
                           job_.light->settings));
        int count = fewest_nodes;
        while (count < 2.0 * fringes && count < most_nodes) count = next_count(count);
        struct Try {
            SpectralSampling sampling;
            std::vector<Xyz> colours;
        };
        std::vector<Try> tries;
        for (;; count = next_count(count)) {
            SpectralSampling sampling{
                std::make_shared<const SpectralNodes>(make_spectral_nodes(job_.light->weights, count)), 1,
                chosen_.sampling.blurred};
            std::vector<Xyz> found = colours(sampling);
            tries.push_back({std::move(sampling), std::move(found)});
            if (tries.size() < 3) continue;
            const Try& candidate = tries[tries.size() - 3];
            chosen_.error = std::max(largest_difference(candidate.colours, tries.back().colours),
                                     largest_difference(tries[tries.size() - 2].colours, tries.back().colours));
            chosen_.sampling.nodes = candidate.sampling.nodes;
            if (chosen_.error <= tolerance || count >= most_nodes) return;
        }
    }

    void take_realisations(int realisations) {
        chosen_.sampling.realisations = realisations;
        SpectralSampling twice = chosen_.sampling;
        twice.realisations *= 2;
        chosen_.error += largest_difference(colours(chosen_.sampling), colours(twice));
    }

    void choose_realisations(double tolerance) {
        SpectralSampling& sampling = chosen_.sampling;
        sampling.realisations = fewest_realisations;
        std::vector<Xyz> some = colours(sampling);
        double error = 0.0;
        for (;; sampling.realisations *= 2) {
            SpectralSampling twice = sampling;
            twice.realisations *= 2;
            std::vector<Xyz> more = colours(twice);
            error = largest_difference(some, more);
            if (error <= tolerance || sampling.realisations >= most_realisations) break;
            some = std::move(more);
        }
        chosen_.error += error;
    }

    const Job& job_;
    std::vector<Probe> probes_;
    ChosenSampling chosen_;
};

}  // namespace

double fringe_count(const Mechanism& mechanism, const LightSettings& light) {
    return needs_sampling(mechanism) ? fringes_of(layer_systems(mechanism, 1).front(), light) : 0.0;
}

ChosenSampling choose_sampling(const Job& job, double tolerance, int node_count, int realisations) {
    if (!needs_sampling(job.material.mechanism)) return {};
    return Chooser(job).choose(tolerance, node_count, realisations);
}

SpectralSampling default_sampling(const Job& job) {
    return choose_sampling(job, 1e-3).sampling;
}

SpectralSampling finer_sampling(const Job& job) {
    SpectralSampling finer = job.sampling;
    if (!finer.nodes || job.light->settings.wavelengths) return finer;
    const int count = std::min(2 * finer.node_count(), most_nodes);
    finer.nodes = std::make_shared<const SpectralNodes>(make_spectral_nodes(job.light->weights, count));
    return finer;
}

}  // namespace nacre
