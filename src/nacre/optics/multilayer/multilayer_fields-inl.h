// Fields in a stack, and what layers do to them. Compiled once per instruction set.
#if defined(NACRE_OPTICS_MULTILAYER_FIELDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_OPTICS_MULTILAYER_FIELDS_INL_H_
#undef NACRE_OPTICS_MULTILAYER_FIELDS_INL_H_
#else
#define NACRE_OPTICS_MULTILAYER_FIELDS_INL_H_
#endif

#include "nacre/optics/multilayer/multilayer_numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

// What layers do to the fields (E, iH) of s or (H, iE) of p:
// x above = a x - b y, y above = c x + d y. Real for plain layers, because of the i.
template <class Number>
struct Matrix {
    Number a, b, c, d;
};

// Fields at a depth.
struct Column {
    Complex x, y;
};

// A column or matrix of one polarisation. True value = value * 2^log2, but for a sign.
template <class Value>
struct Scaled {
    Value value;
    V log2;
};

template <class Number>
HWY_INLINE void set(Matrix<Number>& to, const Matrix<Number>& from) {
    set(to.a, from.a);
    set(to.b, from.b);
    set(to.c, from.c);
    set(to.d, from.d);
}
HWY_INLINE void set(Column& to, const Column& from) {
    set(to.x, from.x);
    set(to.y, from.y);
}
template <class Value>
HWY_INLINE void set(Scaled<Value>& to, const Scaled<Value>& from) {
    set(to.value, from.value);
    to.log2 = from.log2;
}
template <class Value, int count>
HWY_INLINE void set(Polarised<Value, count>& to, const Polarised<Value, count>& from) {
    set(to.s, from.s);
    if constexpr (count == 2) set(to.p, from.p);
}

template <class Number>
HWY_INLINE void set_identity(Matrix<Number>& m) {
    const D d;
    const Complex zero{hn::Zero(d), hn::Zero(d)};
    const Complex one{hn::Set(d, 1.0), hn::Zero(d)};
    if constexpr (sizeof(Number) == sizeof(Real)) {
        m = {{one.re}, {zero.re}, {zero.re}, {one.re}};
    } else {
        m = {one, zero, zero, one};
    }
}
template <class Value>
HWY_INLINE void set_identity(Scaled<Value>& m) {
    set_identity(m.value);
    m.log2 = hn::Zero(D());
}
template <class Value, int count>
HWY_INLINE void set_identity(Polarised<Value, count>& m) {
    set_identity(m.s);
    if constexpr (count == 2) set_identity(m.p);
}

template <class Number>
HWY_INLINE void apply(const Matrix<Number>& m, Column& f) {
    const Complex x = difference_of_products(m.a, f.x, m.b, f.y);
    set(f.y, sum_of_products(m.c, f.x, m.d, f.y));
    set(f.x, x);
}
template <class Number>
HWY_INLINE void apply(const Matrix<Number>& m, Matrix<Number>& f) {
    const Number a = difference_of_products(m.a, f.a, m.b, f.c);
    const Number b = sum_of_products(m.a, f.b, m.b, f.d);
    set(f.c, sum_of_products(m.c, f.a, m.d, f.c));
    set(f.d, difference_of_products(m.d, f.d, m.c, f.b));
    set(f.a, a);
    set(f.b, b);
}
HWY_INLINE void apply(const Matrix<Real>& m, Matrix<Complex>& f) {
    const Matrix<Complex> wide{widened(m.a), widened(m.b), widened(m.c), widened(m.d)};
    apply(wide, f);
}
template <class Number, class Value>
HWY_INLINE void apply(const Scaled<Matrix<Number>>& m, Scaled<Value>& f) {
    apply(m.value, f.value);
    f.log2 = hn::Add(f.log2, m.log2);
}
template <class Number, class Value, int count>
HWY_INLINE void apply(const Polarised<Scaled<Matrix<Number>>, count>& m, Polarised<Scaled<Value>, count>& f) {
    apply(m.s, f.s);
    if constexpr (count == 2) apply(m.p, f.p);
}

// Plain squaring: shortcuts through the trace or through sines of the period's phase lose their digits at band edges.
template <class Number>
HWY_INLINE void square(Matrix<Number>& m) {
    const Number trace = m.a + m.d;
    const Number bc = m.b * m.c;
    set(m.a, square_minus(m.a, bc));
    set(m.d, square_minus(m.d, bc));
    set(m.b, m.b * trace);
    set(m.c, m.c * trace);
}
template <class Value>
HWY_INLINE void square(Scaled<Value>& m) {
    square(m.value);
    m.log2 = hn::Add(m.log2, m.log2);
}
template <class Value, int count>
HWY_INLINE void square(Polarised<Value, count>& m) {
    square(m.s);
    if constexpr (count == 2) square(m.p);
}

HWY_INLINE V largest_part(const Column& f) {
    return hn::Max(largest_part(f.x), largest_part(f.y));
}
template <class Number>
HWY_INLINE V largest_part(const Matrix<Number>& m) {
    return hn::Max(hn::Max(largest_part(m.a), largest_part(m.b)), hn::Max(largest_part(m.c), largest_part(m.d)));
}
HWY_INLINE void scale(Column& f, V factor) {
    set(f.x, scaled(f.x, factor));
    set(f.y, scaled(f.y, factor));
}
template <class Number>
HWY_INLINE void scale(Matrix<Number>& m, V factor) {
    set(m.a, scaled(m.a, factor));
    set(m.b, scaled(m.b, factor));
    set(m.c, scaled(m.c, factor));
    set(m.d, scaled(m.d, factor));
}

// Brings the largest part to [1, 2) by a power of 2, which costs no digits, and notes it.
template <class Value>
HWY_INLINE void rescale(Scaled<Value>& scaled) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    const auto exponent = hn::ShiftRight<52>(hn::BitCast(du, largest_part(scaled.value)));  // biased by 1023
    scale(scaled.value, hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(du, 2046), exponent))));
    // As a number: the bits of a whole number of at most 52 bits, behind those of 2^52.
    const V whole = hn::BitCast(d, hn::Or(exponent, hn::BitCast(du, hn::Set(d, 0x1p52))));
    scaled.log2 = hn::Add(scaled.log2, hn::Sub(whole, hn::Set(d, 0x1p52 + 1023)));
}
template <class Value, int count>
HWY_INLINE void rescale(Polarised<Value, count>& both) {
    rescale(both.s);
    if constexpr (count == 2) rescale(both.p);
}

// A bound on the growth since the last rescaling, as a power of 2: at this size the fourth power still is a double,
// and results are ratios of products of four.
constexpr int most_growth = 200;

// The power of a group's matrix, by the bits of the exponent from the top, squaring in between.
// @param growth  of the matrix, well below the most. @return  that of the power
template <class Number, int count>
HWY_INLINE int raise(Polarised<Scaled<Matrix<Number>>, count>& m, int exponent, int growth) {
    Polarised<Scaled<Matrix<Number>>, count> once;
    set(once, m);
    const int growth_once = growth;
    int bit = 1;
    while (bit <= exponent / 2) bit *= 2;
    for (bit /= 2; bit > 0; bit /= 2) {
        // A square is a sum of two products of at most two parts each.
        if (HWY_UNLIKELY(2 * growth + 2 + growth_once > most_growth)) {
            rescale(m);
            growth = 1;
        }
        square(m);
        growth = 2 * growth + 2;
        if ((exponent & bit) == 0) continue;
        apply(once, m);
        growth += growth_once;
    }
    return growth;
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
