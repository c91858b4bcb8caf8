#include "nacre/optics/multilayer_kernel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// Registers of these have no fixed size, and structs of them are what the kernel is made of.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/optics/multilayer_kernel.cpp"
// Compiles the rest of this file once per instruction set. Has to come before whatever else is Highway's.
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "nacre/optics/multilayer_circle-inl.h"
#include "nacre/optics/multilayer_fields-inl.h"
#include "nacre/optics/multilayer_media-inl.h"
#include "nacre/optics/multilayer_numbers-inl.h"
#include "nacre/optics/multilayer_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

// Fields above what lies on a medium of admittance g: those of the wave that leaves downwards, climbed through m.
HWY_INLINE void start(const Matrix<Real>& m, V g, Column& f) {
    f.x.re = m.a.re;
    f.x.im = hn::Neg(hn::Mul(m.b.re, g));
    f.y.re = m.c.re;
    f.y.im = hn::Mul(m.d.re, g);
}
HWY_INLINE void start(const Pair<Matrix<Real>>& m, const Waves<Real>& below, Pair<Column>& fields) {
    start(m.s, below.s.re, fields.s);
    start(m.p, below.p.re, fields.p);
    fields.log2_s = m.log2_s;
    fields.log2_p = m.log2_p;
}
HWY_INLINE void start(const Waves<Complex>& below, Pair<Column>& fields) {
    const D d;
    fields.s.x.re = fields.p.x.re = hn::Set(d, 1.0);
    fields.s.x.im = fields.p.x.im = hn::Zero(d);
    set(fields.s.y, times_i(below.s));
    set(fields.p.y, times_i(below.p));
    fields.log2_s = fields.log2_p = hn::Zero(d);
}

// Light from medium `above` through a part into medium `below`: the fields on top.
HWY_INLINE void part_fields(const Block& block, const CoherentPart& part, bool downwards, Pair<Column>& fields) {
    const int into = downwards ? part.below : part.above;
    Walk walk = walk_through(part.first, part.last, downwards ? -1 : 1);
    int growth = 0;
    if (walk.count > 0 && block.is_plain(into) && block.is_plain_step(walk.begin)) {
        const LayerStep& step = block.step(walk.begin);
        if (step.repeat > 0) {
            Pair<Matrix<Real>> m;
            growth = group(block, step, walk.direction, m);
            start(m, block.waves<Real>(into), fields);
        } else {
            Pair<Matrix<Real>> m;
            layer(block, step, m);
            growth = step.growth;
            start(m, block.waves<Real>(into), fields);
        }
        walk.begin += walk.direction;
        --walk.count;
    } else {
        start(block.waves<Complex>(into), fields);
    }
    if (walk.count > 0) {
        Pair<Column> climbing;  // the one that is in memory, see group()
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

template <class Number>
HWY_INLINE Amplitudes amplitudes(const Column& f, Number g, V log2) {
    const D d;
    const auto [down, up] = intensities(f, g);
    const V by = hn::Div(hn::Set(d, 1.0), down);
    return {hn::Mul(up, by), hn::Mul(hn::Mul(hn::Mul(hn::Set(d, 4.0), norm_of(g)), by), inverse_square_of_power(log2))};
}

HWY_NOINLINE void part_amplitudes(const Block& block, const CoherentPart& part, bool downwards, Amplitudes& s,
                                  Amplitudes& p) {
    Pair<Column> fields;
    part_fields(block, part, downwards, fields);
    const int from = downwards ? part.above : part.below;
    const Waves<Complex> waves = block.waves<Complex>(from);
    s = amplitudes(fields.s, waves.s, fields.log2_s);
    p = amplitudes(fields.p, waves.p, fields.log2_p);
}

// The power left after one pass through an incoherent layer. Light that is evanescent in it does not cross it.
HWY_INLINE V power_after(const Block& block, const LayerStep& layer) {
    const D d;
    const double* medium = block.medium(layer.medium);
    const Complex q = Block::waves<Complex>(medium).s;
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
HWY_INLINE void whole_amplitudes(const Block& block, Amplitudes& s, Amplitudes& p) {
    const PreparedLayers& layers = block.layers();
    const auto& parts = layers.parts;
    part_amplitudes(block, parts.back(), true, s, p);
    for (std::size_t i = parts.size() - 1; i-- > 0;) {
        Amplitudes down_s, down_p, up_s, up_p;
        part_amplitudes(block, parts[i], true, down_s, down_p);
        part_amplitudes(block, parts[i], false, up_s, up_p);
        const V pass = power_after(block, layers.incoherent[i]);
        add_intensities(down_s, up_s, pass, s);
        add_intensities(down_p, up_p, pass, p);
    }
}

HWY_INLINE V fraction(V value) {
    const D d;
    return hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 1.0));
}

struct ResponseLanes {
    V r_s, r_p, t_s, t_p;
};

HWY_INLINE ResponseLanes response_of(const Block& block) {
    Amplitudes s, p;
    whole_amplitudes(block, s, p);
    // From amplitudes to power.
    const Waves<Complex> incident = block.waves<Complex>(block.layers().incident);
    const Waves<Complex> substrate = block.waves<Complex>(block.layers().substrate);
    const V into_s = hn::Div(substrate.s.re, incident.s.re);
    const V into_p = hn::Div(substrate.p.re, incident.p.re);
    return {fraction(s.r2), fraction(p.r2), fraction(hn::Mul(s.t2, into_s)), fraction(hn::Mul(p.t2, into_p))};
}

// Twice the reflectance of unpolarised light.
HWY_INLINE V reflectances(const Block& block) {
    const PreparedLayers& layers = block.layers();
    if (layers.parts.size() > 1) {
        Amplitudes s, p;
        whole_amplitudes(block, s, p);
        return hn::Add(fraction(s.r2), fraction(p.r2));
    }
    Pair<Column> fields;
    part_fields(block, layers.parts[0], true, fields);
    const Waves<Real> waves = block.waves<Real>(layers.incident);
    const auto [down_s, up_s] = intensities(fields.s, waves.s);
    const auto [down_p, up_p] = intensities(fields.p, waves.p);
    // One division for both.
    const V up = hn::MulAdd(hn::Min(up_s, down_s), down_p, hn::Mul(hn::Min(up_p, down_p), down_s));
    return hn::Div(up, hn::Mul(down_s, down_p));
}

// Media that every register prepares once; the rest, of stacks whose index keeps changing, are computed as they come.
constexpr std::size_t most_cached = 256;

template <class Sink>
HWY_INLINE void for_each_block(const LayersAtAngle& angle, const Sink& sink) {
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
        const Block block(angle, i, aligned, cached, coefficients);
        sink(i, block);
    }
}

void responses(const LayersAtAngle& angle, Response* out) {
    for_each_block(angle, [&](std::size_t first, const Block& block) {
        const D d;
        const ResponseLanes r = response_of(block);
        HWY_ALIGN double values[4][hn::MaxLanes(D())];
        hn::Store(r.r_s, d, values[0]);
        hn::Store(r.r_p, d, values[1]);
        hn::Store(r.t_s, d, values[2]);
        hn::Store(r.t_p, d, values[3]);
        for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
            out[first + lane] = {values[0][lane], values[1][lane], values[2][lane], values[3][lane]};
    });
}

void weighted(const LayersAtAngle& angle, const double* const* weights, double* sums) {
    const D d;
    V sum_0 = hn::Zero(d);
    V sum_1 = hn::Zero(d);
    V sum_2 = hn::Zero(d);
    for_each_block(angle, [&](std::size_t first, const Block& block) {
        const V r = reflectances(block);
        sum_0 = hn::MulAdd(hn::LoadU(d, weights[0] + first), r, sum_0);
        sum_1 = hn::MulAdd(hn::LoadU(d, weights[1] + first), r, sum_1);
        sum_2 = hn::MulAdd(hn::LoadU(d, weights[2] + first), r, sum_2);
    });
    sums[0] = 0.5 * hn::GetLane(hn::SumOfLanes(d, sum_0));
    sums[1] = 0.5 * hn::GetLane(hn::SumOfLanes(d, sum_1));
    sums[2] = 0.5 * hn::GetLane(hn::SumOfLanes(d, sum_2));
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(responses);
HWY_EXPORT(weighted);

}  // namespace

void multilayer_responses(const LayersAtAngle& angle, Response* out) {
    HWY_DYNAMIC_DISPATCH(responses)(angle, out);
}

std::array<double, 3> multilayer_weighted(const LayersAtAngle& angle, const std::array<const double*, 3>& weights) {
    std::array<double, 3> sums{};
    HWY_DYNAMIC_DISPATCH(weighted)(angle, weights.data(), sums.data());
    return sums;
}

}  // namespace nacre
#endif  // HWY_ONCE
