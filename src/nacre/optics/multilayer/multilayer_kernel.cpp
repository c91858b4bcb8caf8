#include "nacre/optics/multilayer/multilayer_kernel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// Registers of these have no fixed size, and structs of them are what the kernel is made of.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/optics/multilayer/multilayer_kernel.cpp"
// Compiles the rest of this file once per instruction set. Has to come before whatever else is Highway's.
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "nacre/optics/multilayer/multilayer_circle-inl.h"
#include "nacre/optics/multilayer/multilayer_fields-inl.h"
#include "nacre/optics/multilayer/multilayer_media-inl.h"
#include "nacre/optics/multilayer/multilayer_numbers-inl.h"
#include "nacre/optics/multilayer/multilayer_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

// Fields above what lies on a medium of admittance g: those of the wave that leaves downwards, climbed through m.
HWY_INLINE void start(const Scaled<Matrix<Real>>& m, const Admittance<Real>& below, Scaled<Column>& f) {
    const V g = below.value.re;
    f.value.x.re = m.value.a.re;
    f.value.x.im = hn::Neg(hn::Mul(m.value.b.re, g));
    f.value.y.re = m.value.c.re;
    f.value.y.im = hn::Mul(m.value.d.re, g);
    f.log2 = m.log2;
}
template <int count>
HWY_INLINE void start(const Polarised<Scaled<Matrix<Real>>, count>& m, const Polarised<Admittance<Real>, count>& below,
                      Polarised<Scaled<Column>, count>& fields) {
    start(m.s, below.s, fields.s);
    if constexpr (count == 2) start(m.p, below.p, fields.p);
}
HWY_INLINE void start(const Admittance<Complex>& below, Scaled<Column>& f) {
    const D d;
    f.value.x.re = hn::Set(d, 1.0);
    f.value.x.im = hn::Zero(d);
    set(f.value.y, times_i(below.value));
    f.log2 = hn::Zero(d);
}
template <int count>
HWY_INLINE void start(const Polarised<Admittance<Complex>, count>& below, Polarised<Scaled<Column>, count>& fields) {
    start(below.s, fields.s);
    if constexpr (count == 2) start(below.p, fields.p);
}

// Light from medium `above` through a part into medium `below`: the fields on top.
template <int count>
HWY_INLINE void part_fields(const Block& block, const CoherentPart& part, bool downwards,
                            Polarised<Scaled<Column>, count>& fields) {
    const int into = downwards ? part.below : part.above;
    Walk walk = walk_through(part.first, part.last, downwards ? -1 : 1);
    int growth = 0;
    if (walk.count > 0 && block.is_plain(into) && block.is_plain_step(walk.begin)) {
        const LayerStep& step = block.step(walk.begin);
        if (step.repeat > 0) {
            Polarised<Scaled<Matrix<Real>>, count> m;
            growth = group(block, step, walk.direction, m);
            start(m, block.admittances<Real, count>(into), fields);
        } else {
            Polarised<Scaled<Matrix<Real>>, count> m;
            layer(block, step, m);
            growth = step.growth;
            start(m, block.admittances<Real, count>(into), fields);
        }
        walk.begin += walk.direction;
        --walk.count;
    } else {
        start(block.admittances<Complex, count>(into), fields);
    }
    if (walk.count > 0) {
        Polarised<Scaled<Column>, count> climbing;  // the one that is in memory, see group()
        set(climbing, fields);
        apply_steps(block, walk, climbing, growth);
        set(fields, climbing);
    }
}

// Squared amplitudes of the waves in a medium of admittance g that go down and up, both times 2 g.
struct Intensities {
    V down, up;
};

template <class Number>
HWY_INLINE Intensities intensities(const Column& f, Number g) {
    // With y = i H the waves are proportional to g x - i y and g x + i y.
    const Complex gx = g * f.x;
    const Complex iy = times_i(f.y);
    return {norm_of(gx - iy), norm_of(gx + iy)};
}

// Of what a coherent part reflects and transmits (E of s, H of p).
struct Amplitudes {
    V r2, t2;
};

HWY_INLINE Amplitudes amplitudes(const Scaled<Column>& f, const Admittance<Complex>& admittance) {
    const D d;
    const Complex g = admittance.value;
    const auto [down, up] = intensities(f.value, g);
    const V by = hn::Div(hn::Set(d, 1.0), down);
    return {hn::Mul(up, by),
            hn::Mul(hn::Mul(hn::Mul(hn::Set(d, 4.0), norm_of(g)), by), inverse_square_of_power(f.log2))};
}

template <int count>
HWY_NOINLINE void part_amplitudes(const Block& block, const CoherentPart& part, bool downwards,
                                  Polarised<Amplitudes, count>& out) {
    Polarised<Scaled<Column>, count> fields;
    part_fields(block, part, downwards, fields);
    const auto admittances = block.admittances<Complex, count>(downwards ? part.above : part.below);
    out.s = amplitudes(fields.s, admittances.s);
    if constexpr (count == 2) out.p = amplitudes(fields.p, admittances.p);
}

// The power left after one pass through an incoherent layer. Light that is evanescent in it does not cross it.
HWY_INLINE V power_after(const Block& block, const LayerStep& layer) {
    const D d;
    const double* medium = block.medium(layer.medium);
    const Complex q = Block::normal_component(medium);
    const V doublings = hn::Mul(hn::Set(d, layer.thickness_nm), Block::plane(medium, Block::loss_plane));
    constexpr double twice_ln_2 = 1.3862943611198906;
    const auto crosses = hn::Gt(q.re, hn::Max(q.im, hn::Set(d, 10.0 * least_q)));
    return hn::IfThenElseZero(crosses, hn::Exp(d, hn::Mul(hn::Set(d, -twice_ln_2), doublings)));
}

HWY_INLINE void add_intensities(const Amplitudes& down, const Amplitudes& up, V pass, Amplitudes& below) {
    const D d;
    const V back = hn::Mul(hn::Mul(pass, pass), below.r2);
    // Below a rounding this is noise: so little of the light that is trapped gets in or out that it does not count.
    const V leaving = hn::Max(hn::NegMulAdd(up.r2, back, hn::Set(d, 1.0)), hn::Set(d, 1e-16));
    const V entering = hn::Div(down.t2, leaving);
    below.r2 = hn::MulAdd(hn::Mul(entering, up.t2), back, down.r2);
    below.t2 = hn::Mul(hn::Mul(entering, pass), below.t2);
}

// All parts, with the incoherent layers between them.
template <int count>
HWY_INLINE void whole_amplitudes(const Block& block, Polarised<Amplitudes, count>& whole) {
    const PreparedLayers& layers = block.layers();
    const auto& parts = layers.parts;
    part_amplitudes(block, parts.back(), true, whole);
    for (std::size_t i = parts.size() - 1; i-- > 0;) {
        Polarised<Amplitudes, count> down, up;
        part_amplitudes(block, parts[i], true, down);
        part_amplitudes(block, parts[i], false, up);
        const V pass = power_after(block, layers.incoherent[i]);
        add_intensities(down.s, up.s, pass, whole.s);
        if constexpr (count == 2) add_intensities(down.p, up.p, pass, whole.p);
    }
}

HWY_INLINE V fraction(V value) {
    const D d;
    return hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 1.0));
}

// From the amplitude that comes out below to its power.
HWY_INLINE V power_below(const Amplitudes& whole, const Admittance<Complex>& above, const Admittance<Complex>& below) {
    return fraction(hn::Mul(whole.t2, hn::Div(below.value.re, above.value.re)));
}

// The sum of the polarisations' reflectances.
template <int count>
HWY_INLINE V reflectances(const Block& block) {
    const PreparedLayers& layers = block.layers();
    if (layers.parts.size() > 1) {
        Polarised<Amplitudes, count> whole;
        whole_amplitudes(block, whole);
        if constexpr (count == 1) return fraction(whole.s.r2);
        if constexpr (count == 2) return hn::Add(fraction(whole.s.r2), fraction(whole.p.r2));
    }
    Polarised<Scaled<Column>, count> fields;
    part_fields(block, layers.parts[0], true, fields);
    const auto admittances = block.admittances<Real, count>(layers.incident);
    const auto [down_s, up_s] = intensities(fields.s.value, admittances.s.value);
    if constexpr (count == 1) {
        return hn::Div(hn::Min(up_s, down_s), down_s);
    } else {
        const auto [down_p, up_p] = intensities(fields.p.value, admittances.p.value);
        // One division for both.
        const V up = hn::MulAdd(hn::Min(up_s, down_s), down_p, hn::Mul(hn::Min(up_p, down_p), down_s));
        return hn::Div(up, hn::Mul(down_s, down_p));
    }
}

// The same of transmittances.
template <int count>
HWY_INLINE V transmittances(const Block& block) {
    Polarised<Amplitudes, count> whole;
    whole_amplitudes(block, whole);
    const auto above = block.admittances<Complex, count>(block.layers().incident);
    const auto below = block.admittances<Complex, count>(block.layers().substrate);
    const V s = power_below(whole.s, above.s, below.s);
    if constexpr (count == 1) return s;
    if constexpr (count == 2) return hn::Add(s, power_below(whole.p, above.p, below.p));
}

// Media that every register prepares once; the rest, of stacks whose index keeps changing, are computed as they come.
constexpr std::size_t most_cached = 256;

template <class Sink>
HWY_INLINE void for_each_block(const LayersAtAngle& angle, Polarisation polarisation, const Sink& sink) {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t cached = HWY_MIN(angle.layers->media.size(), most_cached);
    std::vector<double> cache((cached + 1) * Block::planes * lanes + lanes);
    // Aligned by hand to a register.
    const std::size_t bytes = lanes * sizeof(double);
    double* aligned =
        reinterpret_cast<double*>((reinterpret_cast<std::uintptr_t>(cache.data()) + bytes - 1) / bytes * bytes);
    const Coefficients coefficients;
    for (std::size_t i = 0; i < angle.layers->wavelengths; i += lanes) {
        const Block block(angle, polarisation, i, aligned, cached, coefficients);
        sink(i, block);
    }
}

void responses(const LayersAtAngle& angle, Response* out) {
    for_each_block(angle, Polarisation::mean, [&](std::size_t first, const Block& block) {
        const D d;
        Polarised<Amplitudes, 2> whole;
        whole_amplitudes(block, whole);
        const auto above = block.admittances<Complex, 2>(block.layers().incident);
        const auto below = block.admittances<Complex, 2>(block.layers().substrate);
        HWY_ALIGN double values[4][hn::MaxLanes(D())];
        hn::Store(fraction(whole.s.r2), d, values[0]);
        hn::Store(fraction(whole.p.r2), d, values[1]);
        hn::Store(power_below(whole.s, above.s, below.s), d, values[2]);
        hn::Store(power_below(whole.p, above.p, below.p), d, values[3]);
        for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
            out[first + lane] = {values[0][lane], values[1][lane], values[2][lane], values[3][lane]};
    });
}

template <int count>
HWY_INLINE void weighted(const LayersAtAngle& angle, Observed observed, Polarisation polarisation,
                         const double* const* weights, double* sums) {
    const D d;
    V sum_0 = hn::Zero(d);
    V sum_1 = hn::Zero(d);
    V sum_2 = hn::Zero(d);
    for_each_block(angle, polarisation, [&](std::size_t first, const Block& block) {
        const V r = observed == Observed::reflectance ? reflectances<count>(block) : transmittances<count>(block);
        sum_0 = hn::MulAdd(hn::LoadU(d, weights[0] + first), r, sum_0);
        sum_1 = hn::MulAdd(hn::LoadU(d, weights[1] + first), r, sum_1);
        sum_2 = hn::MulAdd(hn::LoadU(d, weights[2] + first), r, sum_2);
    });
    constexpr double share = 1.0 / count;
    sums[0] = share * hn::GetLane(hn::SumOfLanes(d, sum_0));
    sums[1] = share * hn::GetLane(hn::SumOfLanes(d, sum_1));
    sums[2] = share * hn::GetLane(hn::SumOfLanes(d, sum_2));
}
void weighted_sums(const LayersAtAngle& angle, Observed observed, Polarisation polarisation,
                   const double* const* weights, double* sums) {
    if (polarisation == Polarisation::mean) {
        weighted<2>(angle, observed, polarisation, weights, sums);
    } else {
        weighted<1>(angle, observed, polarisation, weights, sums);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(responses);
HWY_EXPORT(weighted_sums);

}  // namespace

void multilayer_responses(const LayersAtAngle& angle, Response* out) {
    HWY_DYNAMIC_DISPATCH(responses)(angle, out);
}

std::array<double, 3> multilayer_weighted(const LayersAtAngle& angle, const std::array<const double*, 3>& weights,
                                          Observed observed, Polarisation polarisation) {
    std::array<double, 3> sums{};
    HWY_DYNAMIC_DISPATCH(weighted_sums)(angle, observed, polarisation, weights.data(), sums.data());
    return sums;
}

}  // namespace nacre
#endif  // HWY_ONCE
