#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/// Plane-parallel layers in 100 digits, by another road than the library's.
///
/// No fields and no characteristic matrices: Fresnel's coefficients of every face, and all internal bounces summed
/// (Airy 1833; for compound parts Rouard 1937; the composition of two parts is Redheffer's star product). The road is
/// unfit for double - 0/0 at grazing, digits lost where a wave runs along its layer, q = 0 - which 100 digits forgive:
/// no case loses more than 80. n + ik, exp(-i omega t), Im q >= 0.
namespace nacre::reference {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using WideComplex =
    boost::multiprecision::number<boost::multiprecision::cpp_complex_backend<100>, boost::multiprecision::et_off>;

enum class Polarisation { s, p };

struct ExactIndex {
    Wide n = 1, k = 0;
};

/// A layer, or (repeat > 0) a group of nodes that is there so many times.
struct ExactNode {
    std::size_t medium = 0;     ///< into ExactMultilayer::media
    std::size_t thickness = 0;  ///< into ExactMultilayer::thicknesses_nm
    bool is_incoherent = false;
    int repeat = 0;
    std::vector<ExactNode> members;
};

/// Every number that is typed in stands once, so that a change of it changes all layers that have it.
struct ExactMultilayer {
    std::vector<ExactIndex> media;
    std::vector<Wide> thicknesses_nm;
    std::vector<ExactNode> nodes;  ///< in the order in which light meets them
    std::size_t incident = 0, substrate = 0;
    Wide theta_deg = 0;  ///< in the incident medium
    Wide wavelength_nm = 500;
};

/// What a part does to a wave from its front and to one from behind: amplitudes, or intensities.
template <class Value>
struct Scattering {
    Value front = 0, forward = 1, back = 0, backward = 1;

    /// This part and the next behind it, with all bounces between the two.
    Scattering then(const Scattering& next) const {
        const Value bounces = Value(1) / (Value(1) - back * next.front);
        return {front + forward * next.front * backward * bounces, forward * next.forward * bounces,
                next.back + next.backward * back * next.forward * bounces, backward * next.backward * bounces};
    }
    /// This part, and then a way on which a wave is multiplied by a factor, there and back alike.
    Scattering then_travel(const Value& factor) const {
        return {front, forward * factor, back * factor * factor, backward * factor};
    }
};

/// One polarisation of one multilayer.
class ExactWaves {
public:
    ExactWaves(const ExactMultilayer& layers, Polarisation polarisation) : layers_(layers) {
        // 90 degrees is the limit from below: 1e-30 degrees short of it, R and T differ from it by 1e-31 or so.
        const Wide above_grazing_deg = layers.theta_deg == 90 ? Wide("1e-30") : Wide(90 - layers.theta_deg);
        const Wide cosine = sin(above_grazing_deg * boost::math::constants::pi<Wide>() / 180);
        const Wide n0 = layers.media.at(layers.incident).n;
        for (const ExactIndex& index : layers.media) {
            const WideComplex n(index.n, index.k), square = n * n;
            // Written so that a medium like the incident one has the incident wave to the last digit.
            WideComplex q_square = (n - n0) * (n + n0) + WideComplex(n0 * n0 * cosine * cosine);
            // A wave along its layer is the limit of waves nearly along it; a layer is even in q, so that 1e-80 is
            // as good as 0. In the substrate it leaves an error of 1e-40.
            if (abs(q_square) < Wide("1e-90")) q_square = WideComplex(Wide("1e-80"));
            WideComplex q = sqrt(q_square);
            if (q.imag() < 0 || (q.imag() == 0 && q.real() < 0)) q = -q;
            q_.push_back(q);
            // Ratio of the tangential magnetic and electric fields of s, of electric and magnetic of p.
            ratio_.push_back(polarisation == Polarisation::s ? q : WideComplex(q / square));
        }
    }

    /// R and T.
    std::pair<Wide, Wide> reflectance_and_transmittance() {
        Scattering<Wide> whole;
        Part part{{}, layers_.incident};
        for (const ExactNode& node : layers_.nodes) {
            if (!node.is_incoherent) {
                append(part, node);
                continue;
            }
            cross(part, node.medium);
            // A wave that decays more than it advances carries nothing of its own: its intensities, added, give
            // R = 1.6 for air between prisms. Nothing crosses then.
            const WideComplex& q = q_.at(node.medium);
            const Wide passing = q.real() <= q.imag() ? Wide(0) : norm_of(travel(node));
            whole = whole.then(intensities(part.waves)).then_travel(passing);
            part.waves = {};
        }
        cross(part, layers_.substrate);
        whole = whole.then(intensities(part.waves));
        // Time-averaged flux through a face: Re(ratio) times the squared amplitude.
        const Wide into = ratio_.at(layers_.substrate).real() / ratio_.at(layers_.incident).real();
        return {whole.front, into * whole.forward};
    }

private:
    /// From the incident medium, or wherever it began, into a medium.
    struct Part {
        Scattering<WideComplex> waves;
        std::size_t medium = 0;
    };

    static Wide norm_of(const WideComplex& value) { return value.real() * value.real() + value.imag() * value.imag(); }
    static Scattering<Wide> intensities(const Scattering<WideComplex>& waves) {
        return {norm_of(waves.front), norm_of(waves.forward), norm_of(waves.back), norm_of(waves.backward)};
    }

    /// Fresnel's coefficients from the part's medium into another.
    void cross(Part& part, std::size_t medium) const {
        if (medium == part.medium) return;
        const WideComplex &from = ratio_.at(part.medium), &into = ratio_.at(medium);
        const WideComplex r = (from - into) / (from + into), one = WideComplex(1);
        part.waves = part.waves.then({r, one + r, -r, one - r});
        part.medium = medium;
    }
    /// exp(i 2 pi d q / wavelength)
    const WideComplex& travel(const ExactNode& layer) {
        const auto found = travel_.find({layer.medium, layer.thickness});
        if (found != travel_.end()) return found->second;
        const Wide turns = 2 * layers_.thicknesses_nm.at(layer.thickness) / layers_.wavelength_nm;
        const WideComplex phase = q_.at(layer.medium) * WideComplex(turns * boost::math::constants::pi<Wide>());
        const Wide size = exp(-phase.imag());
        const WideComplex factor(size * cos(phase.real()), size * sin(phase.real()));
        return travel_.emplace(std::pair{layer.medium, layer.thickness}, factor).first->second;
    }
    static std::size_t first_medium(const ExactNode& node) {
        return node.repeat > 0 ? first_medium(node.members.front()) : node.medium;
    }
    void append(Part& part, const ExactNode& node) {
        const std::size_t first = first_medium(node);
        cross(part, first);
        if (node.repeat == 0) {
            part.waves = part.waves.then_travel(travel(node));
            return;
        }
        // A period begins and ends in a film of no thickness of its first medium.
        Part period{{}, first};
        for (const ExactNode& member : node.members) append(period, member);
        cross(period, first);
        Scattering<WideComplex> power = period.waves;
        for (int left = node.repeat; left > 0; left /= 2) {
            if (left % 2 == 1) part.waves = part.waves.then(power);
            if (left > 1) power = power.then(power);
        }
    }

    const ExactMultilayer& layers_;
    std::vector<WideComplex> q_, ratio_;  // per medium
    std::map<std::pair<std::size_t, std::size_t>, WideComplex> travel_;
};

struct ExactResponse {
    Wide reflectance_s, reflectance_p, transmittance_s, transmittance_p;
};

inline ExactResponse exact_response(const ExactMultilayer& layers) {
    const auto [rs, ts] = ExactWaves(layers, Polarisation::s).reflectance_and_transmittance();
    const auto [rp, tp] = ExactWaves(layers, Polarisation::p).reflectance_and_transmittance();
    return {rs, rp, ts, tp};
}

}  // namespace nacre::reference
