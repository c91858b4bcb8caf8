// Layers and groups of them, applied to fields. Compiled once per instruction set.
#if defined(NACRE_OPTICS_MULTILAYER_STEPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_OPTICS_MULTILAYER_STEPS_INL_H_
#undef NACRE_OPTICS_MULTILAYER_STEPS_INL_H_
#else
#define NACRE_OPTICS_MULTILAYER_STEPS_INL_H_
#endif

#include "nacre/optics/multilayer/multilayer_circle-inl.h"
#include "nacre/optics/multilayer/multilayer_fields-inl.h"
#include "nacre/optics/multilayer/multilayer_media-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

// From the cosine and the sine of a layer's phase.
template <class Number>
HWY_INLINE void set_layer(Scaled<Matrix<Number>>& m, Number cosine, Number sine, Admittance<Number> admittance,
                          V log2) {
    set(m.value.a, cosine);
    set(m.value.b, sine * admittance.inverse);
    set(m.value.c, sine * admittance.value);
    set(m.value.d, cosine);
    m.log2 = log2;
}
template <class Number, int count>
HWY_INLINE void set_layer(Polarised<Scaled<Matrix<Number>>, count>& m, Number cosine, Number sine,
                          const Polarised<Admittance<Number>, count>& admittances, V log2) {
    set_layer(m.s, cosine, sine, admittances.s, log2);
    if constexpr (count == 2) set_layer(m.p, cosine, sine, admittances.p, log2);
}

template <int count>
HWY_INLINE void layer(const Block& block, const LayerStep& step, Polarised<Scaled<Matrix<Real>>, count>& m) {
    const D d;
    const double* medium = block.medium(step.medium);
    const auto [sine, cosine] = sine_cosine(
        hn::Mul(hn::Set(d, step.thickness_nm), Block::plane(medium, Block::phase_plane)), block.coefficients());
    set_layer(m, Real{cosine}, Real{sine}, block.admittances<Real, count>(medium), hn::Zero(d));
}

template <int count>
HWY_INLINE void layer(const Block& block, const LayerStep& step, Polarised<Scaled<Matrix<Complex>>, count>& m) {
    const D d;
    const V thickness = hn::Set(d, step.thickness_nm);
    const double* medium = block.medium(step.medium);
    const auto [sine, cosine] =
        sine_cosine(hn::Mul(thickness, Block::plane(medium, Block::phase_plane)), block.coefficients());
    const auto [sinh, cosh, doublings] =
        sinh_cosh(hn::Mul(thickness, Block::plane(medium, Block::loss_plane)), block.coefficients());
    const Complex cos_a{hn::Mul(cosine, cosh), hn::Neg(hn::Mul(sine, sinh))};
    const Complex sin_a{hn::Mul(sine, cosh), hn::Mul(cosine, sinh)};
    set_layer(m, cos_a, sin_a, block.admittances<Complex, count>(medium), doublings);
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

// A plain layer has no scale of its own.
template <class Number, class Value>
HWY_INLINE void apply_layer(const Scaled<Matrix<Number>>& m, Scaled<Value>& f) {
    if constexpr (sizeof(Number) == sizeof(Real)) {
        apply(m.value, f.value);
    } else {
        apply(m, f);
    }
}

// Layers one after the other, as long as they are of one kind: the fields stay in registers.
// @return  how many of the steps these are
template <class Number, class Value, int count>
HWY_INLINE int apply_layers(const Block& block, Walk walk, Polarised<Scaled<Value>, count>& fields, int& growth) {
    constexpr bool is_plain = sizeof(Number) == sizeof(Real);
    Polarised<Scaled<Value>, count> f;
    set(f, fields);
    int grown = growth;
    int applied = 0;
    for (int i = walk.begin; applied < walk.count; ++applied, i += walk.direction) {
        const LayerStep& step = block.step(i);
        if (step.repeat > 0 || block.is_plain_step(i) != is_plain) break;
        grown += step.growth;
        if (HWY_UNLIKELY(grown > most_growth)) {
            rescale(f);
            grown = 1 + step.growth;
        }
        Polarised<Scaled<Matrix<Number>>, count> m;
        layer(block, step, m);
        apply_layer(m.s, f.s);
        if constexpr (count == 2) apply_layer(m.p, f.p);
    }
    growth = grown;
    set(fields, f);
    return applied;
}

template <class Value, int count>
void apply_steps(const Block& block, Walk walk, Polarised<Scaled<Value>, count>& fields, int& growth);

// The matrix of one period of a group. @return  growth
template <class Number, int count>
HWY_NOINLINE int any_period(const Block& block, Walk members, Polarised<Scaled<Matrix<Number>>, count>& m) {
    int growth = 0;
    set_identity(m);
    apply_steps(block, members, m, growth);
    return growth;
}

// The same for a few layers: the usual mirror. No identity to begin with, nothing through memory. A plain layer among
// lossy ones is taken for a lossy one without loss.
template <class Number, int count>
HWY_INLINE int short_period(const Block& block, Walk members, Polarised<Scaled<Matrix<Number>>, count>& m) {
    int i = members.begin;
    layer(block, block.step(i), m);
    int growth = block.step(i).growth;
    for (int left = members.count - 1; left > 0; --left) {
        const LayerStep& step = block.step(i += members.direction);
        Polarised<Scaled<Matrix<Number>>, count> next;
        layer(block, step, next);
        apply(next, m);
        growth += step.growth;
    }
    return growth;
}

// The matrix of a group. @return  growth
template <class Number, int count>
HWY_INLINE int group(const Block& block, const LayerStep& step, int direction,
                     Polarised<Scaled<Matrix<Number>>, count>& m) {
    const Walk members = walk_through(step.first, step.last, direction);
    int growth = 0;
    if (step.is_short) {
        growth = short_period(block, members, m);
    } else {
        // A matrix of its own: one whose address goes to a function that is not inlined stays in memory for good.
        Polarised<Scaled<Matrix<Number>>, count> any;
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

template <class Number, class Value, int count>
HWY_NOINLINE void apply_group(const Block& block, const LayerStep& step, int direction,
                              Polarised<Scaled<Value>, count>& fields, int& growth) {
    Polarised<Scaled<Matrix<Number>>, count> m;
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

template <class Value, int count>
void apply_steps(const Block& block, Walk walk, Polarised<Scaled<Value>, count>& fields, int& growth) {
    const int end = walk.begin + walk.count * walk.direction;
    const auto rest = [&] { return Walk{walk.begin, (end - walk.begin) * walk.direction, walk.direction}; };
    while (walk.begin != end) {
        const LayerStep& step = block.step(walk.begin);
        const bool is_plain = block.is_plain_step(walk.begin);
        int applied = 1;
        if (is_plain || !takes_lossy<Value>) {
            if (step.repeat > 0) {
                apply_group<Real>(block, step, walk.direction, fields, growth);
            } else {
                applied = apply_layers<Real>(block, rest(), fields, growth);
            }
        } else if constexpr (takes_lossy<Value>) {
            if (step.repeat > 0) {
                apply_group<Complex>(block, step, walk.direction, fields, growth);
            } else {
                applied = apply_layers<Complex>(block, rest(), fields, growth);
            }
        }
        walk.begin += applied * walk.direction;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
