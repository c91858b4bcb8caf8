// A stack's media at a register of wavelengths. Compiled once per instruction set.
#if defined(NACRE_OPTICS_MULTILAYER_MEDIA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_OPTICS_MULTILAYER_MEDIA_INL_H_
#undef NACRE_OPTICS_MULTILAYER_MEDIA_INL_H_
#else
#define NACRE_OPTICS_MULTILAYER_MEDIA_INL_H_
#endif

#include <cstddef>
#include <vector>

#include "nacre/optics/multilayer/multilayer_circle-inl.h"
#include "nacre/optics/multilayer/multilayer_kernel.h"
#include "nacre/optics/multilayer/multilayer_numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

// A medium at a register of wavelengths and an angle. q: normal component of the wave vector over 2 pi / wavelength.
template <class Number>
struct Admittance {
    Number value;  // of s: q, of p: q / n^2
    Number inverse;
};
// In memory: value and inverse of s, and then of p.
constexpr std::size_t numbers_of_waves = 4;

// One register of wavelengths: what layers are asked for. Media are prepared in planes, that is registers: the real
// parts of the admittances, the imaginary ones, and what the phase and the loss are per nm.
class Block {
public:
    static constexpr std::size_t phase_plane = 2 * numbers_of_waves;
    static constexpr std::size_t loss_plane = phase_plane + 1;
    static constexpr std::size_t planes = loss_plane + 1;

    // @param cache  of the media, `cached` of them and a spare one, as the block before this one left it; zeros at
    // first
    // @param polarisation  mean: both
    HWY_INLINE Block(const LayersAtAngle& angle, Polarisation polarisation, std::size_t first, double* cache,
                     std::size_t cached, const Coefficients& coefficients)
        : coefficients_(coefficients),
          angle_(angle),
          layers_(*angle.layers),
          steps_(layers_.steps.data()),
          is_plain_step_(angle.is_plain_step.data()),
          first_number_(polarisation == Polarisation::p ? 2 : 0),
          first_(first),
          cache_(cache),
          cached_(cached) {
        for (std::size_t medium = 0; medium < cached_; ++medium) {
            double* at = planes_of(medium);
            if (first == 0 || layers_.is_dispersive[medium]) prepare(medium, at);
            prepare_phase(medium, at);
        }
    }

    bool is_plain(int medium) const { return angle_.is_plain[std::size_t(medium)] != 0; }
    bool is_plain_step(int step) const { return is_plain_step_[step] != 0; }
    const LayerStep& step(int i) const { return steps_[i]; }
    const Coefficients& coefficients() const { return coefficients_; }
    const PreparedLayers& layers() const { return layers_; }

    HWY_INLINE const double* medium(int i) const {
        if (HWY_LIKELY(std::size_t(i) < cached_)) return planes_of(std::size_t(i));
        return spare(std::size_t(i));
    }
    template <class Number, int count>
    HWY_INLINE Polarised<Admittance<Number>, count> admittances(const double* medium) const {
        if constexpr (count == 1) {
            return {admittance<Number>(medium, first_number_)};
        } else {
            return {admittance<Number>(medium, 0), admittance<Number>(medium, 2)};
        }
    }
    template <class Number, int count>
    HWY_INLINE Polarised<Admittance<Number>, count> admittances(int i) const {
        return admittances<Number, count>(medium(i));
    }
    // q
    static HWY_INLINE Complex normal_component(const double* medium) { return number<Complex>(medium, 0); }
    static HWY_INLINE V plane(const double* medium, std::size_t i) {
        const D d;
        return hn::Load(d, medium + i * hn::Lanes(d));
    }

private:
    template <class Number>
    static HWY_INLINE Number number(const double* medium, std::size_t i) {
        if constexpr (sizeof(Number) == sizeof(Real)) {
            return {plane(medium, i)};
        } else {
            return {plane(medium, i), plane(medium, i + numbers_of_waves)};
        }
    }
    template <class Number>
    static HWY_INLINE Admittance<Number> admittance(const double* medium, std::size_t first) {
        return {number<Number>(medium, first), number<Number>(medium, first + 1)};
    }
    static HWY_INLINE void store(V value, double* medium, std::size_t i) {
        const D d;
        hn::Store(value, d, medium + i * hn::Lanes(d));
    }
    static HWY_INLINE void store(Complex value, double* medium, std::size_t i) {
        store(value.re, medium, i);
        store(value.im, medium, i + numbers_of_waves);
    }

    HWY_INLINE double* planes_of(std::size_t medium) const { return cache_ + medium * planes * hn::Lanes(D()); }

    // A medium beyond those that are cached, until the next of them is asked for.
    HWY_NOINLINE const double* spare(std::size_t medium) const {
        double* at = planes_of(cached_);
        for (std::size_t i = 0; i < planes; ++i) store(hn::Zero(D()), at, i);
        prepare(medium, at);
        prepare_phase(medium, at);
        return at;
    }

    HWY_INLINE V row(const std::vector<double>& rows, int curve) const {
        return hn::LoadU(D(), rows.data() + std::size_t(curve) * layers_.wavelengths + first_);
    }
    static HWY_INLINE V between(V a, V b, double share) {
        const D d;
        return hn::MulAdd(hn::Set(d, share), b, hn::Mul(hn::Set(d, 1.0 - share), a));
    }
    HWY_INLINE Complex permittivity(int curve) const {
        const Complex index{row(layers_.n, curve), row(layers_.k, curve)};
        return index * index;
    }

    // Of a lossless medium.
    HWY_INLINE V real_index(const Medium& medium) const {
        const V a = row(layers_.n, medium.curve);
        if (medium.share == 0.0) return a;
        const V b = row(layers_.n, medium.other);
        if (medium.mixing == Mixing::index) return between(a, b, medium.share);
        return hn::Sqrt(between(hn::Mul(a, a), hn::Mul(b, b), medium.share));
    }
    HWY_INLINE Complex index(const Medium& medium) const {
        if (medium.share != 0.0 && medium.mixing == Mixing::permittivity) {
            const Complex a = permittivity(medium.curve);
            const Complex b = permittivity(medium.other);
            return square_root({between(a.re, b.re, medium.share), between(a.im, b.im, medium.share)});
        }
        const V n = row(layers_.n, medium.curve);
        const V k = row(layers_.k, medium.curve);
        if (medium.share == 0.0) return {n, k};
        return {between(n, row(layers_.n, medium.other), medium.share),
                between(k, row(layers_.k, medium.other), medium.share)};
    }

    // q is kept from 0, so that what is regular there needs no case of its own.
    HWY_INLINE void prepare(std::size_t medium, double* at) const {
        const D d;
        const V n0 = real_index(layers_.media[std::size_t(layers_.incident)]);
        const V u = hn::Mul(n0, hn::Set(d, angle_.transverse.u_per_n0));
        const V v = hn::Mul(hn::Mul(n0, n0), hn::Set(d, angle_.transverse.v_per_n0_squared));
        const auto distance = [&](V n) HWY_ATTR { return hn::MulAdd(hn::Sub(n, u), hn::Add(n, u), v); };
        if (angle_.is_plain[medium]) {
            const V n = real_index(layers_.media[medium]);
            prepare_plain(n, distance(n), at);
        } else {
            const auto [n, k] = index(layers_.media[medium]);
            prepare_lossy(n, k, distance(n), at);
        }
    }

    static HWY_INLINE void prepare_plain(V n, V distance, double* at) {
        const D d;
        const V q2 = hn::Max(distance, hn::Set(d, least_q * least_q));
        const V q = hn::Sqrt(q2);
        const V n2 = hn::Mul(n, n);
        const V inverse = hn::Div(hn::Set(d, 1.0), hn::Mul(q, n2));  // divisions are slow: one for all
        const V s_inverse = hn::Mul(n2, inverse);
        store(q, at, 0);
        store(s_inverse, at, 1);
        store(hn::Mul(q2, inverse), at, 2);
        store(hn::Mul(n2, s_inverse), at, 3);
    }

    static HWY_INLINE void prepare_lossy(V n, V k, V distance, double* at) {
        const D d;
        const V twice_nk = hn::Mul(hn::Add(n, n), k);
        const Complex q = square_root({hn::NegMulAdd(k, k, distance), twice_nk});
        const Complex n2{hn::Mul(hn::Sub(n, k), hn::Add(n, k)), twice_nk};
        const V size_q = norm_of(q);
        const V size_n = hn::Max(norm_of(n2), hn::Set(d, 1e-100));
        const V inverse = hn::Div(hn::Set(d, 1.0), hn::Mul(size_q, size_n));
        const Complex q_inverse = scaled(conjugate(q), hn::Mul(size_n, inverse));
        const Complex n2_inverse = scaled(conjugate(n2), hn::Mul(size_q, inverse));
        store(q, at, 0);
        store(q_inverse, at, 1);
        store(q * n2_inverse, at, 2);
        store(q_inverse * n2, at, 3);
    }

    // Of a medium that is not dispersive, too: phase and loss change with the wavelength.
    HWY_INLINE void prepare_phase(std::size_t medium, double* at) const {
        const D d;
        const V per_nm = hn::LoadU(d, layers_.quarter_turns_per_nm.data() + first_);
        store(hn::Mul(per_nm, plane(at, 0)), at, phase_plane);
        if (angle_.is_plain[medium]) return;
        constexpr double doublings_per_quarter_turn = 2.2661800709135966;  // pi / 2 / ln 2
        const V loss_per_nm = hn::Mul(per_nm, hn::Set(d, doublings_per_quarter_turn));
        store(hn::Mul(loss_per_nm, plane(at, numbers_of_waves)), at, loss_plane);
    }

    const Coefficients& coefficients_;
    const LayersAtAngle& angle_;
    const PreparedLayers& layers_;
    const LayerStep* steps_;
    const char* is_plain_step_;
    std::size_t first_number_;  // of the one polarisation, if there is one only
    std::size_t first_;
    double* cache_;
    std::size_t cached_;
};

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
