#include "reference/effects_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "reference/weights.h"

namespace nacre::reference {
namespace {

using Complex = std::complex<double>;
using Triple = std::array<double, 3>;
using Spectrum = std::vector<double>;

constexpr double pi_double = std::numbers::pi;
constexpr int first_nm = 360;
constexpr int last_nm = 830;

double square(double value) {
    return value * value;
}

// Products and quotients written out: the numbers are finite, and the library's are slow because they need not be.
Complex times(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
double norm_of(const Complex& a) {
    return a.real() * a.real() + a.imag() * a.imag();
}
// 0 for 0 / 0: a face between equal media, both with the wave running along it.
Complex over(const Complex& a, const Complex& b) {
    const double size = norm_of(b);
    return size == 0.0 ? Complex(0.0) : times(a, std::conj(b)) / size;
}

// ---- Materials ----

double linear_at(const SampledCurve& table, double nm, bool holds) {
    const auto& at = table.wavelength_nm;
    if (nm < at.front() || nm > at.back()) {
        if (!holds) throw std::runtime_error("a table ends before the light does");
        return nm < at.front() ? table.value.front() : table.value.back();
    }
    std::size_t right = 1;
    while (right + 1 < at.size() && at[right] < nm) ++right;
    const double t = (nm - at[right - 1]) / (at[right] - at[right - 1]);
    return (1.0 - t) * table.value[right - 1] + t * table.value[right];
}

// refractiveindex.info's formulas 1 (Sellmeier) and 5 (Cauchy).
double formula_at(const IndexFormula& formula, double nm) {
    const double um = nm / 1000.0;
    const auto& c = formula.coefficients;
    double sum = formula.number == 1 ? 1.0 + c[0] : c[0];
    for (std::size_t i = 1; i + 1 < c.size(); i += 2)
        sum += formula.number == 1 ? c[i] * um * um / (um * um - c[i + 1] * c[i + 1]) : c[i] * std::pow(um, c[i + 1]);
    if (formula.number != 1 && formula.number != 5) throw std::runtime_error("a formula that the model does not know");
    return formula.number == 1 ? std::sqrt(sum) : sum;
}

Complex index_at(const Index& index, double nm) {
    if (index.curve == nullptr) return index.constant;
    const IndexCurve& curve = *index.curve;
    double n = 0.0, k = 0.0;
    if (const auto* constant = std::get_if<double>(&curve.n)) n = *constant;
    if (const auto* formula = std::get_if<IndexFormula>(&curve.n)) n = formula_at(*formula, nm);
    if (const auto* table = std::get_if<SampledCurve>(&curve.n)) n = linear_at(*table, nm, curve.holds_outside);
    if (const auto* constant = std::get_if<double>(&curve.k)) k = *constant;
    if (const auto* table = std::get_if<SampledCurve>(&curve.k)) k = linear_at(*table, nm, curve.holds_outside);
    return {n, k};
}

double diffuse(const Base& base, double nm) {
    if (const auto* grey = std::get_if<GreyBase>(&base)) return grey->reflectance;
    if (const auto* rgb = std::get_if<RgbBase>(&base)) {
        const double t = (nm - 360.0) / 470.0;
        const double x = rgb->coefficients[0] * t * t + rgb->coefficients[1] * t + rgb->coefficients[2];
        return 0.5 * (1.0 + x / std::hypot(1.0, x));
    }
    if (const auto* spectrum = std::get_if<SpectrumBase>(&base)) return linear_at(spectrum->reflectance, nm, true);
    const auto& pigment = std::get<PigmentBase>(base);
    const double k_per_um =
        2.0 * pigment.share * 4.0 * pi_double * index_at(pigment.pigment, nm).imag() / (nm / 1000.0);
    const double q = k_per_um / pigment.scattering_per_um;
    return 1.0 + q - std::sqrt(q * q + 2.0 * q);
}

// ---- Light ----

// Lam's cone responses (ICC profile specification, annex E).
constexpr double cones[3][3] = {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};

Triple responses(const Triple& colour) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = cones[i][0] * colour[0] + cones[i][1] * colour[1] + cones[i][2] * colour[2];
    return result;
}

double determinant(const Triple& a, const Triple& b, const Triple& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
}

// Cramer's rule.
Triple colour_of_responses(const Triple& response) {
    std::array<Triple, 3> columns{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) columns[j][i] = cones[i][j];
    const double whole = determinant(columns[0], columns[1], columns[2]);
    return {determinant(response, columns[1], columns[2]) / whole,
            determinant(columns[0], response, columns[2]) / whole,
            determinant(columns[0], columns[1], response) / whole};
}

// Wavelengths at even steps, and what a smooth spectrum given there weighs: cubics through four neighbours, integrated
// against observer times illuminant at four midpoints per nanometre.
struct Nodes {
    std::vector<double> nm;
    std::vector<Triple> weight;
};

// Observer times illuminant at whole nanometres, Y of the perfect reflector 1.
struct Light {
    std::vector<Triple> weights;
    Triple gain{};                          // per cone
    mutable std::map<double, Nodes> nodes;  // per step

    Light(const std::string& illuminant, int observer_deg) {
        const char* file = observer_deg == 10 ? "cmf_cie1964_10deg_1nm.csv" : "cmf_cie1931_2deg_1nm.csv";
        const Weights table = weights_from_files(file, illuminant, first_nm, last_nm);
        const Number whole = integral_of(table.y);
        for (std::size_t i = 0; i < table.y.size(); ++i) {
            weights.push_back({static_cast<double>(table.x[i] / whole), static_cast<double>(table.y[i] / whole),
                               static_cast<double>(table.z[i] / whole)});
        }
        const XyzNumbers white = white_of(table);
        const Triple from = responses({static_cast<double>(white.x), 1.0, static_cast<double>(white.z)});
        const Triple to = responses({0.3127 / 0.3290, 1.0, (1.0 - 0.3127 - 0.3290) / 0.3290});
        for (std::size_t i = 0; i < 3; ++i) gain[i] = to[i] / from[i];
    }

    Triple weight_at(double nm) const {
        const auto cell = std::min(static_cast<std::size_t>(nm - first_nm), weights.size() - 2);
        const double t = nm - first_nm - static_cast<double>(cell);
        Triple here{};
        for (std::size_t c = 0; c < 3; ++c) here[c] = (1.0 - t) * weights[cell][c] + t * weights[cell + 1][c];
        return here;
    }

    ModelXyz adapted(const Triple& seen) const {
        Triple response = responses(seen);
        for (std::size_t i = 0; i < 3; ++i) response[i] *= gain[i];
        const Triple colour = colour_of_responses(response);
        return {colour[0], colour[1], colour[2]};
    }

    const Nodes& at_step(double step_nm) const {
        Nodes& made = nodes[step_nm];
        if (!made.nm.empty()) return made;
        const auto count = static_cast<int>(std::lround((last_nm - first_nm) / step_nm)) + 1;
        for (int i = 0; i < count; ++i) made.nm.push_back(first_nm + i * step_nm);
        made.weight.resize(made.nm.size());
        const int parts = std::max(4, static_cast<int>(std::lround(4.0 / step_nm)));
        for (int part = 0; part < parts * (last_nm - first_nm); ++part) {
            const double nm = first_nm + (part + 0.5) / parts;
            const int cell = std::clamp(static_cast<int>((nm - first_nm) / step_nm) - 1, 0, count - 4);
            const double t = (nm - first_nm) / step_nm - cell;
            const Triple weight = weight_at(nm);
            for (int j = 0; j < 4; ++j) {
                double share = 1.0 / parts;
                for (int k = 0; k < 4; ++k)
                    if (k != j) share *= (t - k) / (j - k);
                Triple& sum = made.weight[static_cast<std::size_t>(cell + j)];
                for (std::size_t c = 0; c < 3; ++c) sum[c] += share * weight[c];
            }
        }
        return made;
    }
};

const Light& light_of(const std::string& illuminant, int observer_deg) {
    static std::map<std::pair<std::string, int>, std::unique_ptr<const Light>> known;
    auto& light = known[{illuminant, observer_deg}];
    if (!light) light = std::make_unique<const Light>(illuminant, observer_deg);
    return *light;
}

// A table at even steps in [0, 1], cubics through four neighbours.
template <class Value, class Plus>
Value cubic_at(const std::vector<Value>& table, double x, const Plus& plus) {
    const auto count = static_cast<int>(table.size());
    const double place = x * (count - 1);
    const int cell = std::clamp(static_cast<int>(place) - 1, 0, count - 4);
    Value sum{};
    for (int j = 0; j < 4; ++j) {
        double share = 1.0;
        for (int k = 0; k < 4; ++k)
            if (k != j) share *= (place - cell - k) / (j - k);
        sum = plus(sum, share, table[static_cast<std::size_t>(cell + j)]);
    }
    return sum;
}

// ---- Layers ----

struct PlainLayer {
    Index index;
    double thickness_nm = 0.0;
    bool is_incoherent = false;
};

// Of one material after another; or of planes, whose period is too long to be written out.
struct Layers {
    Index incident, substrate;
    std::vector<PlainLayer> layers;
    const Crystal* crystal = nullptr;
    double stretch = 1.0;  // of a crystal's planes
    const MetalBase* metal = nullptr;
};

void write_out(const std::vector<Layer>& layers, std::vector<PlainLayer>& out) {
    for (const Layer& layer : layers) {
        if (layer.last_index || layer.last_thickness_nm) throw std::runtime_error("a graded layer");
        if (layer.repeat == 0) out.push_back({layer.index, layer.thickness_nm, layer.is_incoherent});
        for (int i = 0; i < layer.repeat; ++i) write_out(layer.layers, out);
    }
}

Layers layers_of(const Mechanism& mechanism) {
    Layers result;
    if (const auto* film = std::get_if<Film>(&mechanism)) {
        result = {film->incident, film->substrate, {{film->index, film->thickness_nm, false}}, nullptr, 1.0, nullptr};
    } else if (const auto* stack = std::get_if<Stack>(&mechanism)) {
        result.incident = stack->incident;
        result.substrate = stack->substrate;
        write_out(stack->layers, result.layers);
    } else {
        result.crystal = &std::get<Crystal>(mechanism);
        result.incident = result.crystal->incident;
        result.substrate = result.crystal->substrate;
    }
    if (mechanism.effects.base) result.metal = std::get_if<MetalBase>(&*mechanism.effects.base);
    return result;
}

// Amplitudes of light from above and from below.
struct Port {
    Complex r = 0.0, t = 1.0, r_below = 0.0, t_below = 1.0;
};

Port face(const Complex& above, const Complex& below) {
    const Complex sum = above + below, r = over(above - below, sum);
    if (norm_of(sum) == 0.0) return {};
    return {r, over(2.0 * above, sum), -r, over(2.0 * below, sum)};
}

// All bounces between two ports.
Port joined(const Port& above, const Port& below) {
    const Complex bounces = over(1.0, 1.0 - times(above.r_below, below.r));
    const Complex down = times(above.t, bounces), up = times(below.t_below, bounces);
    return {above.r + times(times(down, below.r), above.t_below), times(down, below.t),
            below.r_below + times(times(up, above.r_below), below.t), times(up, above.t_below)};
}

// A medium as a wave with a given n sin(theta) sees it.
struct Seen {
    Complex q;           // n cos(theta) inside; Im q >= 0
    Complex admittance;  // q, or q / n^2
};

Seen seen_in(const Complex& n, double sine, bool is_p) {
    Complex square_of_q = times(n - sine, n + sine);
    // Bounces of a wave that runs along its layer cannot be summed; next to that they can. A layer is even in q.
    if (norm_of(square_of_q) < 1e-28) square_of_q = 1e-14;
    Complex q = std::sqrt(square_of_q);
    if (q.imag() < 0.0) q = -q;
    return {q, is_p ? over(q, times(n, n)) : q};
}

Port passage(const Complex& q, double thickness_nm, double nm) {
    const Complex phase = q * (2.0 * pi_double * thickness_nm / nm);
    const Complex turn = std::polar(std::exp(-phase.imag()), phase.real());
    return {0.0, turn, 0.0, turn};
}

// Cells of two spheres' height: circles that spheres of this and the next planes leave at a height, of a hexagonal
// lattice; permittivities in proportion.
std::vector<Complex> plane_indices(const Crystal& crystal, int slices, double nm) {
    constexpr int samples = 16;
    const double spacing = crystal.spacing_nm > 0.0 ? crystal.spacing_nm : std::sqrt(2.0 / 3.0) * crystal.diameter_nm;
    const double radius = 0.5 * crystal.diameter_nm, cell = 2.0 * std::sqrt(3.0) * square(radius);
    const Complex holes = times(index_at(crystal.medium, nm), index_at(crystal.medium, nm));
    const Complex balls = times(index_at(crystal.sphere, nm), index_at(crystal.sphere, nm));
    std::vector<Complex> indices;
    for (int slice = 0; slice < slices; ++slice) {
        double share = 0.0;
        for (int sample = 0; sample < samples; ++sample) {
            const double z = spacing * ((slice + (sample + 0.5) / samples) / slices - 0.5);
            double area = 0.0;
            for (int plane = -4; plane <= 4; ++plane)
                area += std::max(0.0, pi_double * (square(radius) - square(z - plane * spacing)));
            share += std::min(area / cell, 1.0) / samples;
        }
        indices.push_back(std::sqrt(holes + share * (balls - holes)));
    }
    return indices;
}

// Slices of a period err by the square of their thickness: what twice as many change tells how far off the profile is
// (Richardson).
constexpr int coarse_slices = 24;
constexpr int fine_slices = 48;

// What of layers depends on the wavelength alone, kept for all angles.
struct MediaAt {
    double nm = 0.0;
    Complex incident, substrate, metal;
    std::vector<Complex> index;   // of every layer, or every slice of a period
    std::vector<Complex> coarse;  // of a crystal: the same of fewer slices
};

MediaAt media_at(const Layers& layers, double nm) {
    MediaAt media{nm, index_at(layers.incident, nm), index_at(layers.substrate, nm), {}, {}, {}};
    if (layers.metal != nullptr) media.metal = index_at(layers.metal->metal, nm);
    if (layers.crystal != nullptr) {
        media.index = plane_indices(*layers.crystal, fine_slices, nm);
        media.coarse = plane_indices(*layers.crystal, coarse_slices, nm);
        return media;
    }
    for (const PlainLayer& layer : layers.layers) media.index.push_back(index_at(layer.index, nm));
    return media;
}

Port crystal_port(const Layers& layers, double nm, const std::vector<Complex>& indices, const Seen& from,
                  const Seen& to, double sine, bool is_p) {
    const Crystal& crystal = *layers.crystal;
    const double spacing = crystal.spacing_nm > 0.0 ? crystal.spacing_nm : std::sqrt(2.0 / 3.0) * crystal.diameter_nm;
    const double slice_nm = layers.stretch * spacing / static_cast<double>(indices.size());
    std::vector<Seen> slices;
    for (const Complex& n : indices) slices.push_back(seen_in(n, sine, is_p));
    Port last = passage(slices[0].q, slice_nm, nm);
    for (std::size_t i = 1; i < slices.size(); ++i) {
        last = joined(last, face(slices[i - 1].admittance, slices[i].admittance));
        last = joined(last, passage(slices[i].q, slice_nm, nm));
    }
    Port power = joined(last, face(slices.back().admittance, slices.front().admittance));  // a period, to the next
    Port all = face(from.admittance, slices.front().admittance);
    for (int left = crystal.planes - 1; left > 0; left /= 2) {
        if (left % 2 == 1) all = joined(all, power);
        power = joined(power, power);
    }
    return joined(joined(all, last), face(slices.back().admittance, to.admittance));
}

ModelPowers powers_of(const Port& port, const Seen& above, const Seen& below) {
    ModelPowers powers{norm_of(port.r), 0.0, norm_of(port.r_below), 0.0};
    const double ratio = below.admittance.real() / above.admittance.real();
    powers.transmittance = norm_of(port.t) * ratio;
    powers.transmittance_below = below.admittance.real() > 1e-12 ? norm_of(port.t_below) / ratio : 0.0;
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

ModelPowers powers_at(const Layers& layers, const MediaAt& media, double sine, bool is_p) {
    Seen from = seen_in(media.incident, sine, is_p);
    const Seen substrate = seen_in(media.substrate, sine, is_p);
    const Seen metal = layers.metal != nullptr ? seen_in(media.metal, sine, is_p) : Seen{};
    if (layers.crystal != nullptr) {
        const auto planes_of = [&](const std::vector<Complex>& indices) {
            return powers_of(crystal_port(layers, media.nm, indices, from, substrate, sine, is_p), from, substrate);
        };
        const ModelPowers fine = planes_of(media.index), coarse = planes_of(media.coarse);
        const auto limit = [](double of_fine, double of_coarse) { return of_fine + (of_fine - of_coarse) / 3.0; };
        const ModelPowers planes{limit(fine.reflectance, coarse.reflectance),
                                 limit(fine.transmittance, coarse.transmittance),
                                 limit(fine.reflectance_below, coarse.reflectance_below),
                                 limit(fine.transmittance_below, coarse.transmittance_below)};
        if (layers.metal == nullptr) return planes;
        return joined(planes, powers_of(face(substrate.admittance, metal.admittance), substrate, metal));
    }
    ModelPowers all{0.0, 1.0, 0.0, 1.0};
    Seen above = from;
    Port port;
    const auto end_part = [&](const Seen& below) {
        all = joined(all, powers_of(joined(port, face(above.admittance, below.admittance)), from, below));
        port = {};
        from = above = below;
    };
    for (std::size_t i = 0; i < layers.layers.size(); ++i) {
        const PlainLayer& layer = layers.layers[i];
        const Seen medium = seen_in(media.index[i], sine, is_p);
        if (layer.is_incoherent) {
            end_part(medium);
            const double left = std::exp(-4.0 * pi_double * medium.q.imag() * layer.thickness_nm / media.nm);
            all = joined(all, ModelPowers{0.0, left, 0.0, left});
            continue;
        }
        port = joined(port, face(above.admittance, medium.admittance));
        port = joined(port, passage(medium.q, layer.thickness_nm, media.nm));
        above = medium;
    }
    end_part(substrate);
    if (layers.metal != nullptr) end_part(metal);
    return all;
}

// How uneven thicknesses are spread: layer systems, each with its share.
struct Realisation {
    Layers layers;
    double share = 1.0;
};

double spread_of(const Mechanism& mechanism) {
    if (const auto* film = std::get_if<Film>(&mechanism)) return film->thickness_spread_nm;
    if (const auto* stack = std::get_if<Stack>(&mechanism)) return stack->thickness_spread_nm;
    return std::get<Crystal>(mechanism).thickness_spread_nm;
}

double largest_n(const Index& index) {
    double largest = 0.0;
    for (int nm = first_nm; nm <= last_nm; nm += 10) largest = std::max(largest, index_at(index, nm).real());
    return largest;
}

// A normal variable by the trapezium rule, whose error falls as a Gaussian of 2 pi / step less the highest frequency.
std::vector<std::pair<double, double>> normal_steps(double highest_frequency) {
    const double step = 2.0 * pi_double / (highest_frequency + 6.0);
    std::vector<std::pair<double, double>> steps;
    double whole = 0.0;
    const int side = static_cast<int>(std::ceil(4.6 / step));
    for (int i = -side; i <= side; ++i) {
        steps.emplace_back(i * step, std::exp(-0.5 * square(i * step)));
        whole += steps.back().second;
    }
    for (auto& [at, share] : steps) share /= whole;
    return steps;
}

std::vector<Realisation> realisations_of(const Mechanism& mechanism) {
    const Layers even = layers_of(mechanism);
    const double spread = spread_of(mechanism);
    if (spread == 0.0) return {{even, 1.0}};
    std::vector<Realisation> made{{even, 1.0}};
    // Of light that goes there and back so many times.
    const double bounces = std::holds_alternative<Film>(mechanism) ? 6.0 : 2.0;
    const auto frequency = [&](double n, double deviation_nm) {
        return bounces * 4.0 * pi_double * n * deviation_nm / first_nm;
    };
    if (even.crystal != nullptr) {
        const Crystal& crystal = *even.crystal;
        const double spacing =
            crystal.spacing_nm > 0.0 ? crystal.spacing_nm : std::sqrt(2.0 / 3.0) * crystal.diameter_nm;
        const double n = std::max(largest_n(crystal.sphere), largest_n(crystal.medium));
        made.clear();
        for (const auto& [z, share] : normal_steps(frequency(n, 0.6 * spread * crystal.planes))) {
            made.push_back({even, share});
            made.back().layers.stretch = std::max(1.0 + z * spread / spacing, 0.05);
        }
        return made;
    }
    std::size_t uneven = 0;
    for (std::size_t i = 0; i < even.layers.size(); ++i) {
        if (even.layers[i].is_incoherent) continue;
        if (++uneven > 2) throw std::runtime_error("a spread of more than two layers");
        std::vector<Realisation> next;
        const auto steps = normal_steps(frequency(largest_n(even.layers[i].index), spread));
        for (const Realisation& realisation : made) {
            for (const auto& [z, share] : steps) {
                next.push_back(realisation);
                next.back().share *= share;
                double& thickness_nm = next.back().layers.layers[i].thickness_nm;
                thickness_nm = std::max(thickness_nm + z * spread, 0.0);
            }
        }
        made = std::move(next);
    }
    return made;
}

double factor_of_base(const std::vector<Realisation>& realisations, const Base& base, double nm) {
    constexpr int directions = 40;
    double reflected = 0.0, passed = 0.0;
    for (const Realisation& realisation : realisations) {
        const MediaAt media = media_at(realisation.layers, nm);
        const double n = media.substrate.real(), n_above = media.incident.real();
        const double critical = n > n_above ? 1.0 - square(n_above / n) : 0.0;
        for (const auto& [from, to] : {std::pair{0.0, critical}, std::pair{critical, 1.0}}) {
            if (!(to > from)) continue;
            for (int i = 0; i < directions; ++i) {
                // Steps of the square of the cosine, crowded at either end: s^3 (10 - 15 s + 6 s^2), so that its slope
                // is 0 there twice over, and the midpoint rule errs by the fourth power of the step.
                const double s = (i + 0.5) / directions;
                const double cos_square = from + (to - from) * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
                const double weight = realisation.share * (to - from) * 30.0 * square(s * (1.0 - s)) / directions;
                const double sine = n * std::sqrt(1.0 - cos_square);
                for (const bool is_p : {false, true}) {
                    const ModelPowers powers = powers_at(realisation.layers, media, sine, is_p);
                    reflected += 0.5 * weight * powers.reflectance_below;
                    passed += 0.5 * weight * powers.transmittance_below;
                }
            }
        }
    }
    const double rho = diffuse(base, nm);
    return rho * passed / (1.0 - rho * reflected);
}

bool has_diffuse_base(const Mechanism& mechanism) {
    return mechanism.effects.base && !std::holds_alternative<MetalBase>(*mechanism.effects.base);
}

// ---- Colours at one step of wavelength ----

// A colour without facets, wavelengths at even steps.
class FlatColour {
public:
    virtual ~FlatColour() = default;
    virtual Triple at(double x, double step_nm) const = 0;
    // Nanometres per wavelength that it takes at least to see all there is.
    virtual double longest_step_nm(double /*x*/) const { return 2.0; }
};

Triple sum_of(const Nodes& nodes, const Spectrum& spectrum) {
    Triple sum{};
    for (std::size_t i = 0; i < spectrum.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += spectrum[i] * nodes.weight[i][c];
    return sum;
}

class LayersColour : public FlatColour {
public:
    LayersColour(const Mechanism& mechanism, const Light& light)
        : light_(light), polarisation_(mechanism.effects.polarisation), realisations_(realisations_of(mechanism)) {
        if (!has_diffuse_base(mechanism)) return;
        constexpr int intervals = 188;  // of 2.5 nm: what comes evenly from everywhere has blurred fringes
        for (int i = 0; i <= intervals; ++i) {
            const double nm = first_nm + (last_nm - first_nm) * static_cast<double>(i) / intervals;
            base_factor_.push_back(factor_of_base(realisations_, *mechanism.effects.base, nm));
        }
    }

    // Towards grazing either face of a layer in thinner media is a mirror, and its fringes are sharp.
    double longest_step_nm(double x) const override {
        const Layers& layers = realisations_.front().layers;
        const bool is_free = index_at(layers.substrate, 550.0).real() < 1.15 * index_at(layers.incident, 550.0).real();
        const double shortest_nm = is_free ? 0.0625 : 1.0;
        double step_nm = 2.0;
        while (step_nm > shortest_nm && step_nm > 16.0 * x * x) step_nm *= 0.5;
        return step_nm;
    }

    Triple at(double x, double step_nm) const override {
        const double cos_theta = std::max(x * x, 1e-9);
        const Nodes& nodes = light_.at_step(step_nm);
        const std::vector<MediaAt>& media = media_of(step_nm, nodes);
        Spectrum spectrum(nodes.nm.size(), 0.0);
        for (std::size_t i = 0; i < spectrum.size(); ++i) {
            const double sine = media[i].incident.real() * std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta));
            double factor = 0.0;
            if (!base_factor_.empty()) {
                factor = cubic_at(base_factor_, (nodes.nm[i] - first_nm) / (last_nm - first_nm),
                                  [](double sum, double share, double value) { return sum + share * value; });
            }
            for (const Realisation& realisation : realisations_) {
                for (const bool is_p : {false, true}) {
                    if (polarisation_ != Polarisation::mean && (polarisation_ == Polarisation::p) != is_p) continue;
                    const double share = realisation.share * (polarisation_ == Polarisation::mean ? 0.5 : 1.0);
                    const ModelPowers powers = powers_at(realisation.layers, media[i], sine, is_p);
                    spectrum[i] += share * (powers.reflectance + factor * powers.transmittance);
                }
            }
        }
        return sum_of(nodes, spectrum);
    }

private:
    const std::vector<MediaAt>& media_of(double step_nm, const Nodes& nodes) const {
        std::vector<MediaAt>& made = media_[step_nm];
        if (made.empty())
            for (const double nm : nodes.nm) made.push_back(media_at(realisations_.front().layers, nm));
        return made;
    }

    const Light& light_;
    Polarisation polarisation_;
    std::vector<Realisation> realisations_;
    Spectrum base_factor_;
    mutable std::map<double, std::vector<MediaAt>> media_;
};

// |m| in [0, largest]; J_m(z) by its integral, 1 / pi times that of cos(m t - z sin t) from 0 to pi.
double bessel(int m, double z) {
    const int count = 64 + 2 * m + static_cast<int>(4.0 * z);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double t = pi_double * (i + 0.5) / count;
        sum += std::cos(m * t - z * std::sin(t));
    }
    return sum / count;
}

class LinesColour : public FlatColour {
public:
    LinesColour(const Mechanism& mechanism, const Light& light)
        : light_(light), grating_(std::get<Grating>(mechanism)) {
        const int largest = static_cast<int>(2.0 * grating_.period_nm / first_nm);
        for (int m = 0; m <= largest; ++m) {
            const bool is_named = std::find(grating_.orders.begin(), grating_.orders.end(), m) != grating_.orders.end();
            if (grating_.orders.empty() ? m > 0 : is_named) orders_.push_back(m);
        }
    }

    Triple at(double x, double step_nm) const override {
        const double azimuth = grating_.azimuth_deg * pi_double / 180.0;
        const double u = 2.0 * x * std::cos(azimuth), d = grating_.period_nm;
        const double along_nm = 2.0 * x * std::sin(azimuth) * 1000.0 * grating_.groove_length_um;
        Triple sum{};
        for (double nm = first_nm; nm < last_nm;) {
            const double ripples_per_nm = grating_.grooves * u * d / square(nm);
            const double length = std::min({0.5 * step_nm, 0.05 * step_nm / std::max(ripples_per_nm, 1e-12),
                                            last_nm - nm, std::floor(nm) + 1.0 - nm + 1e-12});
            const double middle = nm + 0.5 * length;
            double density = 0.0;
            for (std::size_t i = 0; i < orders_.size(); ++i) {
                const int m = orders_[i];
                double line = line_at(u * d / middle - m);
                if (m > 0) line += line_at(u * d / middle + m);
                density += efficiency_at(i, middle) * line;
            }
            density *= grating_.grooves * d / middle * std::exp(-pi_double * square(along_nm / middle));
            const Triple weight = light_.weight_at(middle);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += length * density * weight[c];
            nm += length;
        }
        return sum;
    }

private:
    double line_at(double from_order) const {
        const double t = grating_.grooves * from_order;
        return std::abs(t) < 1e-8 ? 1.0 : square(std::sin(pi_double * t) / (pi_double * t));
    }
    // Of one sign; slowly varying: a table.
    double efficiency_at(std::size_t i, double nm) const {
        if (efficiency_.empty()) {
            for (const int m : orders_) {
                efficiency_.emplace_back();
                for (int at_nm = first_nm; at_nm <= last_nm; ++at_nm) efficiency_.back().push_back(exact(m, at_nm));
            }
        }
        return cubic_at(efficiency_[i], (nm - first_nm) / (last_nm - first_nm),
                        [](double sum, double share, double value) { return sum + share * value; });
    }
    double exact(int m, double nm) const {
        double coat = 1.0;
        if (grating_.coat) {
            const Complex n = index_at(*grating_.coat, nm);
            coat = norm_of((n - 1.0) / (n + 1.0));
        }
        if (grating_.profile == GratingProfile::given) {
            double others = 0.0;
            for (const double efficiency : grating_.efficiency) others += 2.0 * efficiency;
            if (m == 0) return coat * (1.0 - others);
            const auto place = static_cast<std::size_t>(m) - 1;
            return place < grating_.efficiency.size() ? coat * grating_.efficiency[place] : 0.0;
        }
        const double half_phase = 2.0 * pi_double * grating_.depth_nm / nm;
        if (grating_.profile == GratingProfile::sinusoidal) return coat * square(bessel(m, half_phase));
        // Fourier's coefficient of exp(i phase) on the land and 1 beside it.
        if (m == 0) return coat * norm_of(grating_.land * std::polar(1.0, 2.0 * half_phase) + (1.0 - grating_.land));
        const Complex of_land =
            (std::polar(1.0, 2.0 * half_phase) - 1.0) * std::sin(pi_double * m * grating_.land) / (pi_double * m);
        return coat * norm_of(of_land);
    }

    const Light& light_;
    Grating grating_;
    std::vector<int> orders_;
    mutable std::vector<std::vector<double>> efficiency_;
};

// Percus and Yevick's direct correlation in closed form (Kinning & Thomas 1984, Macromolecules 17, 1712, equations 9 to
// 11): S = 1 / (1 + 24 f G / A), A = q diameter.
double structure_factor(double f, double a) {
    if (a < 0.05) return square(square(1.0 - f)) / square(1.0 + 2.0 * f);  // where the closed form cancels
    const double alpha = square(1.0 + 2.0 * f) / square(square(1.0 - f));
    const double beta = -6.0 * f * square(1.0 + 0.5 * f) / square(square(1.0 - f));
    const double gamma = 0.5 * f * alpha;
    const double sine = std::sin(a), cosine = std::cos(a);
    const double g =
        alpha * (sine - a * cosine) / square(a) + beta * (2.0 * a * sine + (2.0 - a * a) * cosine - 2.0) / (a * a * a) +
        gamma *
            (-square(square(a)) * cosine + 4.0 * ((3.0 * a * a - 6.0) * cosine + (a * a * a - 6.0 * a) * sine + 6.0)) /
            (a * square(square(a)));
    return 1.0 / (1.0 + 24.0 * f * g / a);
}

class ScatterColour : public FlatColour {
public:
    ScatterColour(const Mechanism& mechanism, const Light& light)
        : light_(light),
          scatter_(std::get<Scatter>(mechanism)),
          polarisation_(mechanism.effects.polarisation),
          hard_nm_(scatter_.hard_radius_nm > 0.0 ? scatter_.hard_radius_nm : scatter_.radius_nm) {
        hard_fraction_ = scatter_.volume_fraction * std::pow(hard_nm_ / scatter_.radius_nm, 3.0);
        set_sizes();
    }

    Triple at(double x, double step_nm) const override {
        const Nodes& nodes = light_.at_step(step_nm);
        std::vector<At>& made = at_[step_nm];
        if (made.empty())
            for (const double nm : nodes.nm) made.push_back(prepared(nm));
        Spectrum spectrum;
        for (const At& at : made) {
            const auto [s, p] = intensity(at, 2.0 * x - 1.0);
            const double mean = polarisation_ == Polarisation::s   ? s
                                : polarisation_ == Polarisation::p ? p
                                                                   : 0.5 * (s + p);
            spectrum.push_back(at.scale * mean);
        }
        return sum_of(nodes, spectrum);
    }

private:
    struct Size {
        double radius_nm, per_nm3;
    };
    struct At {
        double wave_number = 0.0, scale = 0.0;
        Complex dipole;  // alpha / r^3 of rayleigh
        std::vector<ModelSphere> spheres;
    };

    // Log-normal numbers, mean radius and volume fraction as given.
    void set_sizes() {
        const double variance = std::log(1.0 + square(scatter_.radius_spread)), deviation = std::sqrt(variance);
        if (scatter_.radius_spread == 0.0) {
            sizes_ = {{scatter_.radius_nm, 1.0}};
        } else {
            const double step = scatter_.model == ScatterModel::rayleigh ? 0.1 : 0.2;
            // Volumes lie 3 deviations squared higher than numbers, what scatters 6: there the rule has to reach.
            for (double z = -5.0; z <= 6.0 * deviation + 5.0; z += step)
                sizes_.push_back(
                    {scatter_.radius_nm * std::exp(deviation * z - 0.5 * variance), std::exp(-0.5 * z * z)});
        }
        double volume = 0.0;
        for (const Size& size : sizes_) volume += size.per_nm3 * 4.0 / 3.0 * pi_double * std::pow(size.radius_nm, 3.0);
        for (Size& size : sizes_) size.per_nm3 *= scatter_.volume_fraction / volume;
    }

    At prepared(double nm) const {
        At at;
        const double medium = index_at(scatter_.medium, nm).real();
        at.wave_number = 2.0 * pi_double * medium / nm;
        const Complex m = index_at(scatter_.particle, nm) / medium;
        at.dipole = (m * m - 1.0) / (m * m + 2.0);
        double scattered = 0.0, absorbed = 0.0;
        for (const Size& size : sizes_) {
            const double x = at.wave_number * size.radius_nm;
            const double area = size.per_nm3 * pi_double * square(size.radius_nm);
            if (scatter_.model == ScatterModel::rayleigh) {
                scattered += area * 8.0 / 3.0 * std::pow(x, 4.0) * norm_of(at.dipole);
                absorbed += area * 4.0 * x * at.dipole.imag();
                continue;
            }
            at.spheres.push_back(model_sphere(x, m));
            scattered += area * at.spheres.back().q_sca;
            absorbed += area * std::max(at.spheres.back().q_ext - at.spheres.back().q_sca, 0.0);
        }
        if (m.imag() == 0.0) absorbed = 0.0;
        if (scatter_.model == ScatterModel::quasi_ordered) {
            scattered = 0.0;
            constexpr int angles = 300;
            for (int i = 0; i < angles; ++i) {
                const double theta = pi_double * (i + 0.5) / angles;
                const auto [s, p] = intensity(at, std::cos(theta));
                scattered += pi_double * (s + p) * std::sin(theta) * pi_double / angles / square(at.wave_number);
            }
        }
        const double extinction = scattered + absorbed;
        const double depth = extinction * 1e3 * scatter_.thickness_um;
        // albedo times phase function is 4 pi / k^2 |S|^2 / extinction.
        at.scale =
            extinction > 0.0 ? (1.0 - std::exp(-depth)) * 4.0 * pi_double / square(at.wave_number) / extinction : 0.0;
        return at;
    }

    // |S|^2 of the particles in 1 nm^3, s and p.
    std::pair<double, double> intensity(const At& at, double cos_scatter) const {
        double s = 0.0, p = 0.0, count = 0.0;
        Complex of_all_s, of_all_p;
        for (std::size_t i = 0; i < sizes_.size(); ++i) {
            ModelSphere::Amplitudes amplitudes;
            if (scatter_.model == ScatterModel::rayleigh) {
                const double cube = std::pow(at.wave_number * sizes_[i].radius_nm, 3.0);
                amplitudes = {Complex(0.0, -cube) * at.dipole, Complex(0.0, -cube * cos_scatter) * at.dipole};
            } else {
                amplitudes = at.spheres[i].amplitudes(cos_scatter);
            }
            s += sizes_[i].per_nm3 * norm_of(amplitudes.s1);
            p += sizes_[i].per_nm3 * norm_of(amplitudes.s2);
            of_all_s += sizes_[i].per_nm3 * amplitudes.s1;
            of_all_p += sizes_[i].per_nm3 * amplitudes.s2;
            count += sizes_[i].per_nm3;
        }
        if (scatter_.model != ScatterModel::quasi_ordered) return {s, p};
        const double q = 2.0 * at.wave_number * std::sqrt(std::max(0.5 * (1.0 - cos_scatter), 0.0));
        const double order = structure_factor(hard_fraction_, q * 2.0 * hard_nm_) - 1.0;
        return {s + order * norm_of(of_all_s) / count, p + order * norm_of(of_all_p) / count};
    }

    const Light& light_;
    Scatter scatter_;
    Polarisation polarisation_;
    double hard_nm_ = 0.0, hard_fraction_ = 0.0;
    std::vector<Size> sizes_;
    mutable std::map<double, std::vector<At>> at_;
};

class MeasuredColour : public FlatColour {
public:
    MeasuredColour(const Mechanism& mechanism, const Light& light)
        : light_(light), spectra_(std::get<MeasuredSpectra>(mechanism)) {}

    Triple at(double x, double step_nm) const override {
        const double theta_deg = std::acos(std::min(x * x, 1.0)) * 180.0 / pi_double;
        SampledCurve spectrum{spectra_.wavelength_nm, {}};
        for (std::size_t i = 0; i < spectra_.wavelength_nm.size(); ++i)
            spectrum.value.push_back(at_angle(i, theta_deg));
        const int parts = static_cast<int>(std::lround(8.0 / step_nm));
        Triple sum{};
        for (int part = 0; part < parts * (last_nm - first_nm); ++part) {
            const double nm = first_nm + (part + 0.5) / parts, r = linear_at(spectrum, nm, true) / parts;
            const Triple weight = light_.weight_at(nm);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += r * weight[c];
        }
        return sum;
    }

private:
    double value(std::size_t angle, std::size_t wavelength) const {
        return spectra_.reflectance[angle * spectra_.wavelength_nm.size() + wavelength];
    }
    // Fritsch and Butland's slopes in the form of Matlab's pchip; Hermite's basis.
    double at_angle(std::size_t i, double theta_deg) const {
        const std::vector<double>& at = spectra_.angle_deg;
        const std::size_t count = at.size();
        if (count == 1 || theta_deg <= at.front()) return value(0, i);
        if (theta_deg >= at.back()) return value(count - 1, i);
        const auto h = [&](std::size_t k) { return at[k + 1] - at[k]; };
        const auto secant = [&](std::size_t k) { return (value(k + 1, i) - value(k, i)) / h(k); };
        const auto end = [&](std::size_t k, std::size_t next) {
            const double d = ((2.0 * h(k) + h(next)) * secant(k) - h(k) * secant(next)) / (h(k) + h(next));
            if (d * secant(k) <= 0.0) return 0.0;
            return std::abs(d) > 3.0 * std::abs(secant(k)) ? 3.0 * secant(k) : d;
        };
        const auto slope = [&](std::size_t k) {
            if (count == 2) return secant(0);
            if (k == 0) return end(0, 1);
            if (k == count - 1) return end(count - 2, count - 3);
            if (secant(k - 1) * secant(k) <= 0.0) return 0.0;
            const double w1 = 2.0 * h(k) + h(k - 1), w2 = h(k) + 2.0 * h(k - 1);
            return (w1 + w2) / (w1 / secant(k - 1) + w2 / secant(k));
        };
        std::size_t k = 0;
        while (at[k + 1] < theta_deg) ++k;
        const double t = (theta_deg - at[k]) / h(k);
        return value(k, i) * (1.0 + 2.0 * t) * square(1.0 - t) + slope(k) * h(k) * t * square(1.0 - t) +
               value(k + 1, i) * t * t * (3.0 - 2.0 * t) + slope(k + 1) * h(k) * t * t * (t - 1.0);
    }

    const Light& light_;
    MeasuredSpectra spectra_;
};

SceneModel scene_of(const Palette& palette, const std::string& illuminant, int observer_deg) {
    SceneModel scene;
    for (const Pick& pick : palette.picks)
        scene.picks.push_back({pick.angle_deg, pick.lobe.peak_nm, pick.lobe.width_nm, pick.lobe.height});
    scene.shape = palette.shape;
    scene.illuminant = illuminant;
    scene.observer_deg = observer_deg;
    return scene;
}

std::unique_ptr<FlatColour> flat_colour(const Mechanism& mechanism, const Light& light) {
    if (std::holds_alternative<Grating>(mechanism)) return std::make_unique<LinesColour>(mechanism, light);
    if (std::holds_alternative<Scatter>(mechanism)) return std::make_unique<ScatterColour>(mechanism, light);
    if (std::holds_alternative<MeasuredSpectra>(mechanism)) return std::make_unique<MeasuredColour>(mechanism, light);
    return std::make_unique<LayersColour>(mechanism, light);
}

ModelXyz plus(const ModelXyz& sum, double share, const ModelXyz& colour) {
    return {sum.x + share * colour.x, sum.y + share * colour.y, sum.z + share * colour.z};
}

}  // namespace

ModelPowers layer_powers(const Mechanism& mechanism, double sine, double wavelength_nm, bool is_p) {
    const Layers layers = layers_of(mechanism);
    return powers_at(layers, media_at(layers, wavelength_nm), sine, is_p);
}

double base_factor(const Mechanism& mechanism, double wavelength_nm) {
    return factor_of_base(realisations_of(mechanism), *mechanism.effects.base, wavelength_nm);
}

std::vector<ModelFacet> facets_seen(double tilt_deg, double theta_deg) {
    constexpr int rings = 240;
    constexpr int around = 120;
    constexpr double deviations = 6.0;
    const double tilt = tilt_deg * pi_double / 180.0, theta = theta_deg * pi_double / 180.0;
    const double steepest = std::min(deviations * tilt, 0.5 * pi_double);
    const double from = std::max(theta - steepest, 0.0), to = std::min(theta + steepest, 0.5 * pi_double);
    std::vector<ModelFacet> facets;
    double whole = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double beta = from + (to - from) * (i + 0.5) / rings;
        // The arc around the eye on which normals are within `steepest` of the surface's.
        const double reach = (std::cos(steepest) - std::cos(theta) * std::cos(beta)) /
                             std::max(std::sin(theta) * std::sin(beta), 1e-300);
        if (reach >= 1.0) continue;
        const double arc = reach <= -1.0 ? pi_double : std::acos(reach);
        double density = 0.0;
        for (int j = 0; j < around; ++j) {
            const double phi = arc * (j + 0.5) / around;
            // cos(tau) by half angles: near the normal its arc cosine would lose digits.
            const double haversine =
                square(std::sin(0.5 * (theta - beta))) + std::sin(theta) * std::sin(beta) * square(std::sin(0.5 * phi));
            const double tau = 2.0 * std::asin(std::min(std::sqrt(haversine), 1.0));
            density += arc / around * std::exp(-0.5 * square(tau / tilt));
        }
        facets.push_back({std::cos(beta), density * std::sin(beta) * std::cos(beta)});
        whole += facets.back().share;
    }
    for (ModelFacet& facet : facets) facet.share /= whole;
    return facets;
}

ModelSphere model_sphere(double x, Complex m) {
    const auto terms = static_cast<int>(x + 4.0 * std::cbrt(x) + 6.0);
    const Complex z = m * x;
    // The logarithmic derivative of psi_n downward from where it does not matter.
    const int start = std::max(terms, static_cast<int>(std::abs(z))) + 30;
    std::vector<Complex> slope(static_cast<std::size_t>(start) + 1, 0.0);
    for (int n = start; n > 0; --n) {
        const Complex ratio = static_cast<double>(n) / z;
        slope[static_cast<std::size_t>(n) - 1] = ratio - 1.0 / (slope[static_cast<std::size_t>(n)] + ratio);
    }
    // psi downward too: upward it drowns beyond n = x.
    std::vector<double> psi(static_cast<std::size_t>(start) + 2, 0.0);
    psi[static_cast<std::size_t>(start)] = 1e-280;
    for (int n = start; n > 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        psi[i - 1] = (2.0 * n + 1.0) / x * psi[i] - psi[i + 1];
        if (std::abs(psi[i - 1]) > 1e200)
            for (std::size_t k = i - 1; k <= static_cast<std::size_t>(start); ++k) psi[k] *= 1e-200;
    }
    const double first = std::sin(x) / x - std::cos(x);
    const double scale = std::abs(std::sin(x)) > std::abs(first) ? std::sin(x) / psi[0] : first / psi[1];
    ModelSphere sphere;
    sphere.a.resize(static_cast<std::size_t>(terms) + 1);
    sphere.b.resize(sphere.a.size());
    double chi_before = -std::sin(x), chi = std::cos(x);
    for (int n = 0; n <= terms; ++n) {
        const auto i = static_cast<std::size_t>(n);
        if (n > 0) {
            const Complex xi(scale * psi[i], -chi), xi_before(scale * psi[i - 1], -chi_before);
            const double up = n / x;
            const Complex of_a = slope[i] / m + up, of_b = slope[i] * m + up;
            sphere.a[i] = (of_a * scale * psi[i] - scale * psi[i - 1]) / (of_a * xi - xi_before);
            sphere.b[i] = (of_b * scale * psi[i] - scale * psi[i - 1]) / (of_b * xi - xi_before);
            const double weight = 2.0 / (x * x) * (2.0 * n + 1.0);
            sphere.q_ext += weight * (sphere.a[i].real() + sphere.b[i].real());
            sphere.q_sca += weight * (norm_of(sphere.a[i]) + norm_of(sphere.b[i]));
        }
        const double next = (2.0 * n + 1.0) / x * chi - chi_before;
        chi_before = chi;
        chi = next;
    }
    return sphere;
}

ModelSphere::Amplitudes ModelSphere::amplitudes(double mu) const {
    Amplitudes sum{};
    double before = 0.0, now = 1.0;  // pi_(n-1), pi_n
    for (std::size_t i = 1; i < a.size(); ++i) {
        const auto n = static_cast<double>(i);
        const double tau = n * mu * now - (n + 1.0) * before;
        const double weight = (2.0 * n + 1.0) / (n * (n + 1.0));
        sum.s1 += weight * (a[i] * now + b[i] * tau);
        sum.s2 += weight * (a[i] * tau + b[i] * now);
        const double next = ((2.0 * n + 1.0) * mu * now - (n + 1.0) * before) / n;
        before = now;
        now = next;
    }
    return sum;
}

struct EffectsModel::Parts {
    const Light& light;
    Mechanism mechanism;
    double tolerance;
    std::unique_ptr<DenseModel> palette;
    std::unique_ptr<FlatColour> flat;
    std::vector<ModelXyz> curve;  // over sqrt(cos), if there are facets
    double brightest = 0.0;
    std::size_t unsettled = 0;

    ModelXyz facet(double x) { return curve.empty() ? settled(x) : cubic_at(curve, x, plus); }

    ModelXyz settled(double x) {
        if (palette) return palette->at(x);
        double step_nm = flat->longest_step_nm(x);
        ModelXyz colour = light.adapted(flat->at(x, step_nm));
        while (step_nm > 0.017) {
            step_nm *= 0.5;
            const ModelXyz finer = light.adapted(flat->at(x, step_nm));
            brightest = std::max(brightest, finer.y);
            const double scale = brightest > 0.0 ? 1.0 / brightest : 1.0;
            const auto lab = [&](const ModelXyz& c) { return lab_of({scale * c.x, scale * c.y, scale * c.z}); };
            const double change = ciede2000(lab(colour), lab(finer));
            colour = finer;
            if (change <= tolerance) return colour;
        }
        ++unsettled;
        return colour;
    }
};

EffectsModel::EffectsModel(const Mechanism& mechanism, const std::string& illuminant, int observer_deg,
                           double tolerance)
    : parts_(new Parts{light_of(illuminant, observer_deg), mechanism, tolerance, nullptr, nullptr, {}, 0.0, 0}) {
    if (const auto* palette = std::get_if<Palette>(&parts_->mechanism))
        parts_->palette = std::make_unique<DenseModel>(scene_of(*palette, illuminant, observer_deg));
    else
        parts_->flat = flat_colour(parts_->mechanism, parts_->light);
    // What is measured bends at its angles: that is asked facet by facet.
    if (mechanism.effects.tilt_deg == 0.0 || std::holds_alternative<MeasuredSpectra>(mechanism)) return;
    // Palettes bend at their picks, and cost nothing; fringes towards grazing are what others need points for.
    const int intervals = parts_->palette ? 8192 : 192;
    for (int i = intervals; i >= 0; --i) parts_->curve.push_back(parts_->settled(static_cast<double>(i) / intervals));
    std::reverse(parts_->curve.begin(), parts_->curve.end());
}

EffectsModel::~EffectsModel() = default;
EffectsModel::EffectsModel(EffectsModel&&) noexcept = default;
EffectsModel& EffectsModel::operator=(EffectsModel&&) noexcept = default;

ModelXyz EffectsModel::at(double x) const {
    const double tilt_deg = parts_->mechanism.effects.tilt_deg;
    if (tilt_deg == 0.0) return parts_->settled(x);
    const double theta_deg = 2.0 * std::asin(std::sqrt(0.5 * (1.0 - x) * (1.0 + x))) * 180.0 / pi_double;
    ModelXyz sum;
    for (const ModelFacet& facet : facets_seen(tilt_deg, theta_deg))
        sum = plus(sum, facet.share, parts_->facet(std::sqrt(facet.cos_beta)));
    return sum;
}

std::size_t EffectsModel::unsettled() const {
    return parts_->unsettled;
}

}  // namespace nacre::reference
