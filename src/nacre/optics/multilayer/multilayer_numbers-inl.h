// Numbers of which the multilayer kernel's matrices are made. Compiled once per instruction set.
#if defined(NACRE_OPTICS_MULTILAYER_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_OPTICS_MULTILAYER_NUMBERS_INL_H_
#undef NACRE_OPTICS_MULTILAYER_NUMBERS_INL_H_
#else
#define NACRE_OPTICS_MULTILAYER_NUMBERS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// Real where layers neither absorb nor are met by an evanescent wave.
struct Real {
    V re;
};
struct Complex {
    V re;
    V im;
};

// What both polarisations have of their own, or one of the two: s stands for whichever it is, as they differ in their
// admittances only.
template <class Value, int count>
struct Polarised;
template <class Value>
struct Polarised<Value, 1> {
    Value s;
};
template <class Value>
struct Polarised<Value, 2> {
    Value s, p;
};

HWY_INLINE Real operator*(Real a, Real b) {
    return {hn::Mul(a.re, b.re)};
}
HWY_INLINE Real operator+(Real a, Real b) {
    return {hn::Add(a.re, b.re)};
}
HWY_INLINE Real operator-(Real a, Real b) {
    return {hn::Sub(a.re, b.re)};
}
HWY_INLINE Complex operator+(Complex a, Complex b) {
    return {hn::Add(a.re, b.re), hn::Add(a.im, b.im)};
}
HWY_INLINE Complex operator-(Complex a, Complex b) {
    return {hn::Sub(a.re, b.re), hn::Sub(a.im, b.im)};
}
HWY_INLINE Complex operator*(Complex a, Complex b) {
    return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)), hn::MulAdd(a.re, b.im, hn::Mul(a.im, b.re))};
}
HWY_INLINE Complex operator*(Real a, Complex b) {
    return {hn::Mul(a.re, b.re), hn::Mul(a.re, b.im)};
}
HWY_INLINE Complex operator*(Complex a, Real b) {
    return b * a;
}

// a * x + b * y and a * x - b * y, with as few roundings as the machine can do.
HWY_INLINE Real sum_of_products(Real a, Real x, Real b, Real y) {
    return {hn::MulAdd(b.re, y.re, hn::Mul(a.re, x.re))};
}
HWY_INLINE Real difference_of_products(Real a, Real x, Real b, Real y) {
    return {hn::NegMulAdd(b.re, y.re, hn::Mul(a.re, x.re))};
}
HWY_INLINE Complex sum_of_products(Real a, Complex x, Real b, Complex y) {
    return {hn::MulAdd(b.re, y.re, hn::Mul(a.re, x.re)), hn::MulAdd(b.re, y.im, hn::Mul(a.re, x.im))};
}
HWY_INLINE Complex difference_of_products(Real a, Complex x, Real b, Complex y) {
    return {hn::NegMulAdd(b.re, y.re, hn::Mul(a.re, x.re)), hn::NegMulAdd(b.re, y.im, hn::Mul(a.re, x.im))};
}
HWY_INLINE Complex sum_of_products(Complex a, Complex x, Complex b, Complex y) {
    const V re = hn::NegMulAdd(b.im, y.im, hn::MulAdd(b.re, y.re, hn::NegMulAdd(a.im, x.im, hn::Mul(a.re, x.re))));
    const V im = hn::MulAdd(b.im, y.re, hn::MulAdd(b.re, y.im, hn::MulAdd(a.im, x.re, hn::Mul(a.re, x.im))));
    return {re, im};
}
HWY_INLINE Complex difference_of_products(Complex a, Complex x, Complex b, Complex y) {
    const V re = hn::MulAdd(b.im, y.im, hn::NegMulAdd(b.re, y.re, hn::NegMulAdd(a.im, x.im, hn::Mul(a.re, x.re))));
    const V im = hn::NegMulAdd(b.im, y.re, hn::NegMulAdd(b.re, y.im, hn::MulAdd(a.im, x.re, hn::Mul(a.re, x.im))));
    return {re, im};
}

// a^2 - b
HWY_INLINE Real square_minus(Real a, Real b) {
    return {hn::MulSub(a.re, a.re, b.re)};
}
HWY_INLINE Complex square_minus(Complex a, Complex b) {
    return {hn::NegMulAdd(a.im, a.im, hn::MulSub(a.re, a.re, b.re)), hn::MulSub(hn::Add(a.re, a.re), a.im, b.im)};
}

HWY_INLINE V largest_part(Real a) {
    return hn::Abs(a.re);
}
HWY_INLINE V largest_part(Complex a) {
    return hn::Max(hn::Abs(a.re), hn::Abs(a.im));
}
HWY_INLINE V norm_of(Real a) {
    return hn::Mul(a.re, a.re);
}
HWY_INLINE V norm_of(Complex a) {
    return hn::MulAdd(a.re, a.re, hn::Mul(a.im, a.im));
}
HWY_INLINE Real scaled(Real a, V factor) {
    return {hn::Mul(a.re, factor)};
}
HWY_INLINE Complex scaled(Complex a, V factor) {
    return {hn::Mul(a.re, factor), hn::Mul(a.im, factor)};
}
HWY_INLINE Complex widened(Real a) {
    return {a.re, hn::Zero(D())};
}
HWY_INLINE Complex widened(Complex a) {
    return a;
}
HWY_INLINE Complex conjugate(Complex a) {
    return {a.re, hn::Neg(a.im)};
}
HWY_INLINE Complex times_i(Complex a) {
    return {hn::Neg(a.im), a.re};
}

// Assignments member by member: GCC 12 copies structs of registers through memory, in halves.
HWY_INLINE void set(Real& to, Real from) {
    to.re = from.re;
}
HWY_INLINE void set(Complex& to, Complex from) {
    to.re = from.re;
    to.im = from.im;
}

// What normal components of wave vectors are kept from 0 by, so that there is an inverse.
constexpr double least_q = 1e-100;

// Square root in the first quadrant, never 0. @param z  imaginary part >= 0
HWY_INLINE Complex square_root(Complex z) {
    const D d;
    const V half = hn::Set(d, 0.5);
    const V size = hn::Sqrt(hn::MulAdd(z.re, z.re, hn::Mul(z.im, z.im)));
    const V square = hn::Max(hn::Mul(half, hn::Add(size, hn::Abs(z.re))), hn::Set(d, least_q * least_q));
    const V larger = hn::Sqrt(square);
    const V smaller = hn::Div(hn::Mul(half, z.im), larger);
    const auto is_right = hn::Ge(z.re, hn::Zero(d));
    return {hn::IfThenElse(is_right, larger, smaller), hn::IfThenElse(is_right, smaller, larger)};
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
