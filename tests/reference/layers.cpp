#include "reference/layers.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/materials.h"

namespace nacre::reference {
namespace {

std::size_t medium_of(const Index& index, std::vector<Index>& media) {
    std::size_t medium = 0;
    while (medium < media.size() && !same(media[medium], index)) ++medium;
    if (medium == media.size()) media.push_back(index);
    return medium;
}

// @param written  how many were written down before
std::size_t write_out(const std::vector<Layer>& layers, std::size_t written, PlainLayers& out) {
    for (const Layer& layer : layers) {
        if (layer.last_index || layer.last_thickness_nm) throw std::runtime_error("a graded layer");
        if (layer.repeat == 0) {
            out.layers.push_back({medium_of(layer.index, out.media), layer.thickness_nm, layer.is_incoherent});
            out.written.push_back(written++);
            continue;
        }
        std::size_t behind = written;
        for (int i = 0; i < layer.repeat; ++i) behind = write_out(layer.layers, written, out);
        written = behind;
    }
    return written;
}

constexpr std::size_t incident = 0, substrate = 1;

ModelPowers powers_of(const Port& port, const Seen& above, const Seen& below) {
    ModelPowers powers{squared_magnitude(port.r), 0.0, squared_magnitude(port.r_below), 0.0};
    const double ratio = below.admittance.real() / above.admittance.real();
    powers.transmittance = squared_magnitude(port.t) * ratio;
    powers.transmittance_below = below.admittance.real() > 1e-12 ? squared_magnitude(port.t_below) / ratio : 0.0;
    // Beyond the critical angle of a lossless medium rounding leaves next to nothing of a real part.
    if (above.admittance.real() <= 1e-12) powers.transmittance = powers.transmittance_below = 0.0;
    return powers;
}

ModelPowers joined(const ModelPowers& above, const ModelPowers& below) {
    const double bounces = 1.0 / (1.0 - above.reflectance_below * below.reflectance);
    return {
        above.reflectance + above.transmittance * bounces * below.reflectance * above.transmittance_below,
        above.transmittance * bounces * below.transmittance,
        below.reflectance_below + below.transmittance_below * bounces * above.reflectance_below * below.transmittance,
        below.transmittance_below * bounces * above.transmittance_below};
}

// Slices of a period err by the square of their thickness: what twice as many change tells how far off the profile is
// (Richardson).
constexpr int coarse_slices = 24;
constexpr int fine_slices = 48;

ModelPowers crystal_powers(const PlainLayers& layers, const MediaAt& media, const Wave& wave) {
    const Seen from = seen_in(media.index[incident], wave), to = seen_in(media.index[substrate], wave);
    const std::vector<Complex> slices(media.index.begin() + 2, media.index.end());
    const auto planes_of = [&](const std::vector<Complex>& indices) {
        return powers_of(crystal_port(layers, media.nm, indices, from, to, wave), from, to);
    };
    const ModelPowers fine = planes_of(slices), coarse = planes_of(media.coarse);
    const auto limit = [](double of_fine, double of_coarse) { return of_fine + (of_fine - of_coarse) / 3.0; };
    const ModelPowers planes{limit(fine.reflectance, coarse.reflectance),
                             limit(fine.transmittance, coarse.transmittance),
                             limit(fine.reflectance_below, coarse.reflectance_below),
                             limit(fine.transmittance_below, coarse.transmittance_below)};
    if (layers.metal == nullptr) return planes;
    const Seen metal = seen_in(media.metal, wave);
    return joined(planes, powers_of(face(to.admittance, metal.admittance), to, metal));
}

std::vector<Seen> seen_in_all(const MediaAt& media, const Wave& wave) {
    std::vector<Seen> seen;
    seen.reserve(media.index.size());
    for (const Complex& index : media.index) seen.push_back(seen_in(index, wave));
    return seen;
}

}  // namespace

bool PlainLayers::is_coherent() const {
    for (const PlainLayer& layer : layers)
        if (layer.is_incoherent) return false;
    return crystal == nullptr && metal == nullptr;
}

PlainLayers layers_of(const Mechanism& mechanism) {
    PlainLayers result;
    if (const auto* film = std::get_if<Film>(&mechanism)) {
        result.media = {film->incident, film->substrate};
        result.layers = {{medium_of(film->index, result.media), film->thickness_nm, false}};
        result.written = {0};
    } else if (const auto* stack = std::get_if<Stack>(&mechanism)) {
        result.media = {stack->incident, stack->substrate};
        write_out(stack->layers, 0, result);
    } else {
        result.crystal = &std::get<Crystal>(mechanism);
        result.media = {result.crystal->incident, result.crystal->substrate};
    }
    if (mechanism.effects.base) result.metal = std::get_if<MetalBase>(&*mechanism.effects.base);
    return result;
}

MediaAt media_at(const PlainLayers& layers, double nm) {
    MediaAt media;
    media.nm = nm;
    for (const Index& index : layers.media) media.index.push_back(index_at(index, nm));
    if (layers.metal != nullptr) media.metal = index_at(layers.metal->metal, nm);
    if (layers.crystal != nullptr) {
        const std::vector<Complex> slices = plane_indices(*layers.crystal, fine_slices, nm);
        media.index.insert(media.index.end(), slices.begin(), slices.end());
        media.coarse = plane_indices(*layers.crystal, coarse_slices, nm);
    }
    return media;
}

Port face(const Complex& above, const Complex& below) {
    const Complex sum = above + below, r = over(above - below, sum);
    if (squared_magnitude(sum) == 0.0) return {};
    return {r, over(2.0 * above, sum), -r, over(2.0 * below, sum)};
}

Port joined(const Port& above, const Port& below) {
    const Complex bounces = over(1.0, 1.0 - times(above.r_below, below.r));
    const Complex down = times(above.t, bounces), up = times(below.t_below, bounces);
    return {above.r + times(times(down, below.r), above.t_below), times(down, below.t),
            below.r_below + times(times(up, above.r_below), below.t), times(up, above.t_below)};
}

Seen seen_in(const Complex& n, const Wave& wave) {
    // Written so that a medium like the wave's own has its wave to the last digit.
    Complex square_of_q = times(n - wave.index, n + wave.index) + square(wave.index * wave.cosine);
    // Bounces of a wave that runs along its layer cannot be summed; next to that they can. A layer is even in q, so
    // that it errs by 1e-14; rounding costs 1e-9.
    if (squared_magnitude(square_of_q) < 1e-28) square_of_q = 1e-14;
    Complex q = std::sqrt(square_of_q);
    if (q.imag() < 0.0) q = -q;
    return {q, wave.is_p ? over(q, times(n, n)) : q};
}

Port passage(const Complex& q, double thickness_nm, double nm) {
    const Complex phase = q * (2.0 * std::numbers::pi * thickness_nm / nm);
    const Complex turn = std::polar(std::exp(-phase.imag()), phase.real());
    return {0.0, turn, 0.0, turn};
}

ModelPowers powers_at(const PlainLayers& layers, const MediaAt& media, const Wave& wave) {
    if (layers.crystal != nullptr) return crystal_powers(layers, media, wave);
    const std::vector<Seen> seen = seen_in_all(media, wave);
    ModelPowers all{0.0, 1.0, 0.0, 1.0};
    Seen from = seen[incident], above = from;
    Port port;
    const auto end_part = [&](const Seen& below) {
        all = joined(all, powers_of(joined(port, face(above.admittance, below.admittance)), from, below));
        port = {};
        from = above = below;
    };
    for (const PlainLayer& layer : layers.layers) {
        const Seen& medium = seen[layer.medium];
        if (layer.is_incoherent) {
            end_part(medium);
            const double left = std::exp(-4.0 * std::numbers::pi * medium.q.imag() * layer.thickness_nm / media.nm);
            all = joined(all, ModelPowers{0.0, left, 0.0, left});
            continue;
        }
        port = joined(port, face(above.admittance, medium.admittance));
        port = joined(port, passage(medium.q, layer.thickness_nm, media.nm));
        above = medium;
    }
    end_part(seen[substrate]);
    if (layers.metal != nullptr) end_part(seen_in(media.metal, wave));
    return all;
}

ModelPowers layer_powers(const Mechanism& mechanism, const Wave& wave, double nm) {
    const PlainLayers layers = layers_of(mechanism);
    return powers_at(layers, media_at(layers, nm), wave);
}

double coherent_reflectance(const PlainLayers& layers, const MediaAt& media, const Wave& wave) {
    const std::vector<Seen> seen = seen_in_all(media, wave);
    // Amplitude from below a face, r; above it (r_face + r) / (1 + r_face r) with r_face = difference / sum.
    const auto across = [](const Complex& above, const Complex& below, const Complex& r) {
        const Complex difference = above - below, sum = above + below;
        return over(difference + times(sum, r), sum + times(difference, r));
    };
    Complex r = 0.0, below = seen[substrate].admittance;
    for (std::size_t i = layers.layers.size(); i-- > 0;) {
        const PlainLayer& layer = layers.layers[i];
        const Seen& medium = seen[layer.medium];
        const Complex turn = passage(medium.q, 2.0 * layer.thickness_nm, media.nm).t;  // there and back
        r = times(turn, across(medium.admittance, below, r));
        below = medium.admittance;
    }
    return squared_magnitude(across(seen[incident].admittance, below, r));
}

}  // namespace nacre::reference
