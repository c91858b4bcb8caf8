// Layers and groups of them, applied to fields. Compiled once per instruction set.
#if defined(NACRE_OPTICS_MULTILAYER_STEPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_OPTICS_MULTILAYER_STEPS_INL_H_
#undef NACRE_OPTICS_MULTILAYER_STEPS_INL_H_
#else
#define NACRE_OPTICS_MULTILAYER_STEPS_INL_H_
#endif

#include "nacre/optics/multilayer_circle-inl.h"
#include "nacre/optics/multilayer_fields-inl.h"
#include "nacre/optics/multilayer_media-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

HWY_INLINE void layer(const Block& block, const LayerStep& step, Pair<Matrix<Real>>& m) {
    const D d;
    const double* medium = block.medium(step.medium);
    const auto [sine, cosine] = sine_cosine(
        hn::Mul(hn::Set(d, step.thickness_nm), Block::plane(medium, Block::phase_plane)), block.coefficients());
    const Waves<Real> waves = Block::waves<Real>(medium);
    m.s.a.re = m.s.d.re = m.p.a.re = m.p.d.re = cosine;
    m.s.b.re = hn::Mul(sine, waves.s_inverse.re);
    m.s.c.re = hn::Mul(sine, waves.s.re);
    m.p.b.re = hn::Mul(sine, waves.p_inverse.re);
    m.p.c.re = hn::Mul(sine, waves.p.re);
    m.log2_s = m.log2_p = hn::Zero(d);
}

HWY_INLINE void layer(const Block& block, const LayerStep& step, Pair<Matrix<Complex>>& m) {
    const D d;
    const V thickness = hn::Set(d, step.thickness_nm);
    const double* medium = block.medium(step.medium);
    const auto [sine, cosine] =
        sine_cosine(hn::Mul(thickness, Block::plane(medium, Block::phase_plane)), block.coefficients());
    const auto [sinh, cosh, doublings] =
        sinh_cosh(hn::Mul(thickness, Block::plane(medium, Block::loss_plane)), block.coefficients());
    const Complex cos_a{hn::Mul(cosine, cosh), hn::Neg(hn::Mul(sine, sinh))};
    const Complex sin_a{hn::Mul(sine, cosh), hn::Mul(cosine, sinh)};
    const Waves<Complex> waves = Block::waves<Complex>(medium);
    set(m.s.a, cos_a);
    set(m.s.b, sin_a * waves.s_inverse);
    set(m.s.c, sin_a * waves.s);
    set(m.s.d, cos_a);
    set(m.p.a, cos_a);
    set(m.p.b, sin_a * waves.p_inverse);
    set(m.p.c, sin_a * waves.p);
    set(m.p.d, cos_a);
    m.log2_s = m.log2_p = doublings;
}

// Steps in the order in which fields climb through them.
struct Walk {
    int begin;
    int count;
    int direction;  // 1 or -1
};

// Steps [first, last) are in the order in which light meets them; fields climb from the last to the first, or, for
// light that comes from below, from the first to the last.
HWY_INLINE Walk walk_through(int first, int last, int direction) {
    return {direction < 0 ? last - 1 : first, last - first, direction};
}

// Layers one after the other, as long as they are of one kind: the fields stay in registers.
// @return  how many of the steps these are
template <class Number, class Value>
HWY_INLINE int apply_layers(const Block& block, Walk walk, Pair<Value>& fields, int& growth) {
    constexpr bool is_plain = sizeof(Number) == sizeof(Real);
    Pair<Value> f;
    set(f, fields);
    int grown = growth;
    int count = 0;
    for (int i = walk.begin; count < walk.count; ++count, i += walk.direction) {
        const LayerStep& step = block.step(i);
        if (step.repeat > 0 || block.is_plain_step(i) != is_plain) break;
        grown += step.growth;
        if (HWY_UNLIKELY(grown > most_growth)) {
            rescale(f);
            grown = 1 + step.growth;
        }
        Pair<Matrix<Number>> m;
        layer(block, step, m);
        apply(m.s, f.s);
        apply(m.p, f.p);
        if constexpr (!is_plain) {
            f.log2_s = hn::Add(f.log2_s, m.log2_s);
            f.log2_p = hn::Add(f.log2_p, m.log2_p);
        }
    }
    growth = grown;
    set(fields, f);
    return count;
}

template <class Value>
void apply_steps(const Block& block, Walk walk, Pair<Value>& fields, int& growth);

// The matrix of one period of a group. @return  growth
template <class Number>
HWY_NOINLINE int any_period(const Block& block, Walk members, Pair<Matrix<Number>>& m) {
    int growth = 0;
    set_identity(m.s);
    set_identity(m.p);
    m.log2_s = m.log2_p = hn::Zero(D());
    apply_steps(block, members, m, growth);
    return growth;
}

// The same for a few layers: the usual mirror. No identity to begin with, nothing through memory. A plain layer among
// lossy ones is taken for a lossy one without loss.
template <class Number>
HWY_INLINE int short_period(const Block& block, Walk members, Pair<Matrix<Number>>& m) {
    int i = members.begin;
    layer(block, block.step(i), m);
    int growth = block.step(i).growth;
    for (int left = members.count - 1; left > 0; --left) {
        const LayerStep& step = block.step(i += members.direction);
        Pair<Matrix<Number>> next;
        layer(block, step, next);
        apply(next, m);
        growth += step.growth;
    }
    return growth;
}

// The matrix of a group. @return  growth
template <class Number>
HWY_INLINE int group(const Block& block, const LayerStep& step, int direction, Pair<Matrix<Number>>& m) {
    const Walk members = walk_through(step.first, step.last, direction);
    int growth = 0;
    if (step.is_short) {
        growth = short_period(block, members, m);
    } else {
        // A matrix of its own: one whose address goes to a function that is not inlined stays in memory for good.
        Pair<Matrix<Number>> any;
        growth = any_period(block, members, any);
        set(m, any);
    }
    constexpr int much = most_growth / 4;
    if (growth > much) {
        rescale(m);
        growth = 1;
    }
    return raise(m, step.repeat, growth);
}

template <class Number, class Value>
HWY_NOINLINE void apply_group(const Block& block, const LayerStep& step, int direction, Pair<Value>& fields,
                              int& growth) {
    Pair<Matrix<Number>> m;
    const int grows = group(block, step, direction, m);
    if (growth + grows > most_growth) {
        rescale(fields);
        growth = 1;
    }
    apply(m, fields);
    growth += grows;
}

// Real matrices take plain layers only: a group is plain if all that is in it is.
template <class Value>
constexpr bool takes_lossy = true;
template <>
constexpr bool takes_lossy<Matrix<Real>> = false;

template <class Value>
void apply_steps(const Block& block, Walk walk, Pair<Value>& fields, int& growth) {
    const int end = walk.begin + walk.count * walk.direction;
    const auto rest = [&] { return Walk{walk.begin, (end - walk.begin) * walk.direction, walk.direction}; };
    while (walk.begin != end) {
        const LayerStep& step = block.step(walk.begin);
        const bool is_plain = block.is_plain_step(walk.begin);
        int count = 1;
        if (is_plain || !takes_lossy<Value>) {
            if (step.repeat > 0) {
                apply_group<Real>(block, step, walk.direction, fields, growth);
            } else {
                count = apply_layers<Real>(block, rest(), fields, growth);
            }
        } else if constexpr (takes_lossy<Value>) {
            if (step.repeat > 0) {
                apply_group<Complex>(block, step, walk.direction, fields, growth);
            } else {
                count = apply_layers<Complex>(block, rest(), fields, growth);
            }
        }
        walk.begin += count * walk.direction;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
