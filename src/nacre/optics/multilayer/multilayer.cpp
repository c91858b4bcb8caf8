#include "nacre/optics/multilayer/multilayer.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "nacre/optics/refractive_index.h"
#include "nacre/optics/transverse.h"

namespace nacre {
namespace {

using Complex = std::complex<double>;

// A medium at one wavelength and angle.
struct Wave {
    Complex n;
    Complex q;  // normal component of the wave vector, in units of 2 pi / wavelength; Im q >= 0
};

// What a coherent part does to amplitudes, squared: reflected, and transmitted (E for s, H for p). One polarisation.
struct Amplitudes {
    double r2 = 0.0;
    double t2 = 1.0;
};
struct BothPolarisations {
    Amplitudes s;
    Amplitudes p;
};

// The light that leaves a system, one polarisation; t2 relative to the field's amplitude.
struct Below {
    double r2;
    double t2;
};

// Tangential fields of one polarisation, up to the scale exp(log_scale).
struct Fields {
    Complex first;   // E of s, H of p
    Complex second;  // H of s, E of p
    double log_scale = 0.0;

    // One layer up: cosine, and the two sines with the admittance that divides or multiplies them.
    void climb(Complex cosine, Complex divided_sine, Complex multiplied_sine, double log_factor) {
        const Complex minus_i{0.0, -1.0};
        const Complex above = cosine * first + minus_i * divided_sine * second;
        second = minus_i * multiplied_sine * first + cosine * second;
        first = above;
        log_scale += log_factor;
        const double largest = std::max(std::abs(first), std::abs(second));
        constexpr double too_large = 1e100;
        if (largest > 1.0 / too_large && largest < too_large) return;
        if (largest == 0.0) return;
        first /= largest;
        second /= largest;
        log_scale += std::log(largest);
    }
};

Wave wave_in(RefractiveIndex n, double n0, const Transverse& transverse) {
    const double u = n0 * transverse.u_per_n0;
    const double v = n0 * n0 * transverse.v_per_n0_squared;
    const double real = (n.real() - u) * (n.real() + u) - n.imag() * n.imag() + v;
    const Complex q = std::sqrt(Complex(real, 2.0 * n.real() * n.imag()));
    // A wave that runs along the layer, as the limit of one that hardly does not: admittances stay what they are.
    return {n, q == 0.0 ? Complex(1e-100) : q};
}

// cos a and sin a, both times exp(-|Im a|).
struct ScaledCircle {
    Complex cosine;
    Complex sine;
};
ScaledCircle scaled_circle(Complex a) {
    const double em = std::expm1(-2.0 * a.imag());
    const double cosh = 1.0 + 0.5 * em;
    const double sinh = -0.5 * em;
    const double c = std::cos(a.real());
    const double s = std::sin(a.real());
    return {{c * cosh, -s * sinh}, {s * cosh, c * sinh}};
}

struct Film {
    Wave wave;
    double thickness_nm;
};

// @param films  in the order in which this light meets them
BothPolarisations amplitudes(const Wave& above, const std::vector<Film>& films, const Wave& below, double per_nm) {
    Fields s{1.0, below.q};
    Fields p{1.0, below.q / (below.n * below.n)};
    for (auto film = films.rbegin(); film != films.rend(); ++film) {
        const Complex q = film->wave.q;
        const Complex n2 = film->wave.n * film->wave.n;
        const Complex a = per_nm * film->thickness_nm * q;
        const auto [cosine, sine] = scaled_circle(a);
        const Complex sine_by_q = sine / q;  // regular: it tends to 2 pi d / wavelength
        const Complex sine_q = sine * q;
        s.climb(cosine, sine_by_q, sine_q, a.imag());
        p.climb(cosine, n2 * sine_by_q, sine_q / n2, a.imag());
    }
    const auto finish = [](const Fields& fields, Complex admittance) {
        const Complex sum = admittance * fields.first + fields.second;
        const Complex difference = admittance * fields.first - fields.second;
        const double reflected = std::norm(difference / sum);
        return Amplitudes{reflected, std::norm(2.0 * admittance / sum) * std::exp(-2.0 * fields.log_scale)};
    };
    // For p the recursion ran as (H, E): H = first, E = second, and the admittance is that of E.
    return {finish(s, above.q), finish(p, above.q / (above.n * above.n))};
}

// Adds a coherent part and the incoherent layer below it on top of what lies further down.
Below add_intensities(Amplitudes down, Amplitudes up, double pass, Below below) {
    // Below a rounding this is noise: so little of the light that is trapped gets in or out that it does not count.
    const double leaving = std::max(1.0 - up.r2 * pass * pass * below.r2, 1e-16);
    const double entering = down.t2 / leaving;
    return {down.r2 + entering * up.t2 * pass * pass * below.r2, entering * pass * below.t2};
}

// The power that is left after one pass through an incoherent layer. Light that is evanescent in it does not cross it.
double power_after(const Wave& wave, double thickness_nm, double per_nm) {
    if (wave.q.real() <= wave.q.imag()) return 0.0;
    return std::exp(-2.0 * per_nm * thickness_nm * wave.q.imag());
}

// Every layer, repeats walked through.
void expand(const std::vector<LayerNode>& nodes, std::size_t begin, std::size_t end,
            std::vector<const LayerNode*>& layers) {
    for (std::size_t i = begin; i < end; ++i) {
        if (nodes[i].repeat == 0) {
            layers.push_back(&nodes[i]);
            continue;
        }
        const std::size_t members = static_cast<std::size_t>(nodes[i].count);
        for (int time = 0; time < nodes[i].repeat; ++time) expand(nodes, i + 1, i + 1 + members, layers);
        i += members;
    }
}

double fraction(double value) {
    return std::clamp(value, 0.0, 1.0);
}

}  // namespace

Response multilayer_response(const LayerSystem& system, const Incidence& incidence, double wavelength_nm) {
    const Transverse transverse(incidence);
    const double per_nm = 2.0 * std::numbers::pi / wavelength_nm;
    const double n0 = system.index_at(system.incident, wavelength_nm).real();
    const auto wave = [&](int medium) { return wave_in(system.index_at(medium, wavelength_nm), n0, transverse); };

    // Coherent parts from the top down, with the incoherent layers between them.
    std::vector<const LayerNode*> layers;
    expand(system.nodes, 0, system.nodes.size(), layers);
    std::vector<std::vector<Film>> parts(1);
    std::vector<Film> between;
    for (const LayerNode* layer : layers) {
        const Film film{wave(layer->medium), layer->thickness_nm};
        if (layer->is_incoherent) {
            between.push_back(film);
            parts.emplace_back();
        } else {
            parts.back().push_back(film);
        }
    }

    const Wave incident = wave(system.incident);
    const Wave substrate = wave(system.substrate);
    const auto above = [&](std::size_t part) { return part == 0 ? incident : between[part - 1].wave; };
    const BothPolarisations last = amplitudes(above(parts.size() - 1), parts.back(), substrate, per_nm);
    Below s{last.s.r2, last.s.t2};
    Below p{last.p.r2, last.p.t2};
    for (std::size_t part = parts.size() - 1; part-- > 0;) {
        const Film& layer = between[part];
        const std::vector<Film> reversed(parts[part].rbegin(), parts[part].rend());
        const BothPolarisations down = amplitudes(above(part), parts[part], layer.wave, per_nm);
        const BothPolarisations up = amplitudes(layer.wave, reversed, above(part), per_nm);
        const double pass = power_after(layer.wave, layer.thickness_nm, per_nm);
        s = add_intensities(down.s, up.s, pass, s);
        p = add_intensities(down.p, up.p, pass, p);
    }
    // From amplitudes to power.
    const double n0_squared = n0 * n0;
    const double into_s = substrate.q.real() / incident.q.real();
    const double into_p = (substrate.q / (substrate.n * substrate.n)).real() * n0_squared / incident.q.real();
    return {fraction(s.r2), fraction(p.r2), fraction(s.t2 * into_s), fraction(p.t2 * into_p)};
}

}  // namespace nacre
