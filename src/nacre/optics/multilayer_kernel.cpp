#include "nacre/optics/multilayer_kernel.h"

#include <cmath>
#include <cstddef>

// Registers of these have no fixed size, and structs of them are what this file is made of.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/optics/multilayer_kernel.cpp"
#include <hwy/foreach_target.h>  // compiles the rest of this file once per instruction set
#include <hwy/highway.h>

// Behind the line above: it is compiled as often.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// Numbers of a matrix's entries: real ones where layers neither absorb nor are met by an evanescent wave.
struct Real {
    V re;
};
struct Complex {
    V re;
    V im;
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
HWY_INLINE V largest_part(Real a) {
    return hn::Abs(a.re);
}
HWY_INLINE V largest_part(Complex a) {
    return hn::Max(hn::Abs(a.re), hn::Abs(a.im));
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

// What a layer does to the fields (E, iH) of s or (H, iE) of p:
// x above = a x - b y, y above = c x + d y. Real for a plain layer, because of the i.
template <class Number>
struct Matrix {
    Number a, b, c, d;
};

// Fields at a depth.
struct Column {
    Complex x, y;
};

// Assignments member by member: GCC 12 copies structs of registers through memory, in halves.
HWY_INLINE void set(Real& to, Real from) {
    to.re = from.re;
}
HWY_INLINE void set(Complex& to, Complex from) {
    to.re = from.re;
    to.im = from.im;
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
// Plain squaring: shortcuts through the trace or through sines of the period's phase lose their digits at band edges.
template <class Number>
HWY_INLINE void square(Matrix<Number>& m) {
    const Number trace = m.a + m.d;
    const Number bc = m.b * m.c;
    set(m.a, m.a * m.a - bc);
    set(m.d, m.d * m.d - bc);
    set(m.b, m.b * trace);
    set(m.c, m.c * trace);
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

// Both polarisations of a column or matrix. True value = value * exp(log_scale).
template <class Value>
struct Pair {
    Value s, p;
    V log_s, log_p;
};

// Eight layers of index 1e6 multiply fields by 1e48, two squarings give the fourth power: 1e300 is not reached.
constexpr double rescaled_size = 1e40;

// Brings values that have grown or shrunk by much back to 1, and notes it.
template <class Value>
HWY_INLINE void rescale(Value& value, V& log_scale) {
    const D d;
    const V size = largest_part(value);
    const auto is_off = hn::Or(hn::Gt(size, hn::Set(d, rescaled_size)), hn::Lt(size, hn::Set(d, 1.0 / rescaled_size)));
    if (hn::AllFalse(d, is_off)) return;
    const auto applies = hn::And(is_off, hn::Gt(size, hn::Zero(d)));
    const V divisor = hn::IfThenElse(applies, size, hn::Set(d, 1.0));
    scale(value, hn::Div(hn::Set(d, 1.0), divisor));
    log_scale = hn::Add(log_scale, hn::Log(d, divisor));
}
template <class Value>
HWY_INLINE void rescale(Pair<Value>& pair) {
    rescale(pair.s, pair.log_s);
    rescale(pair.p, pair.log_p);
}

// Phases beyond this would need more digits of pi than the three parts below have.
constexpr double largest_phase = 1e6;

HWY_NOINLINE void sin_cos_of_huge(V x, V& sine, V& cosine) {
    const D d;
    HWY_ALIGN double in[hn::MaxLanes(d)];
    HWY_ALIGN double s[hn::MaxLanes(d)];
    HWY_ALIGN double c[hn::MaxLanes(d)];
    hn::Store(x, d, in);
    for (size_t i = 0; i < hn::Lanes(d); ++i) {
        s[i] = std::sin(in[i]);
        c[i] = std::cos(in[i]);
    }
    sine = hn::Load(d, s);
    cosine = hn::Load(d, c);
}

// Both at once, within 1e-16 of 1, for x >= 0. Highway's own are two calls and end at 39000, which is 2 mm of glass.
// pi / 2 is taken off in three parts of which two have 33 bits, so that their multiples are exact (Cody & Waite 1980);
// on what is left, at most pi / 4, Taylor's series end below 1e-17.
HWY_INLINE void sin_cos(V x, V& sine, V& cosine) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Le(x, hn::Set(d, largest_phase))))) return sin_cos_of_huge(x, sine, cosine);
    // Adding 1.5 * 2^52 rounds to a whole number and leaves its last bits at the end of the mantissa.
    const V magic = hn::Set(d, 6755399441055744.0);
    const V shifted = hn::MulAdd(x, hn::Set(d, 0.63661977236758134308), magic);
    const auto quarter = hn::BitCast(du, shifted);
    const V turns = hn::Sub(shifted, magic);
    V r = hn::NegMulAdd(turns, hn::Set(d, 0x1.921fb544p+0), x);
    r = hn::NegMulAdd(turns, hn::Set(d, 0x1.0b4611a6p-34), r);
    r = hn::NegMulAdd(turns, hn::Set(d, 0x1.3198a2e037073p-69), r);
    const V z = hn::Mul(r, r);
    V p = hn::Set(d, -1.0 / 1307674368000.0);
    V q = hn::Set(d, 1.0 / 20922789888000.0);
    p = hn::MulAdd(p, z, hn::Set(d, 1.0 / 6227020800.0));
    q = hn::MulAdd(q, z, hn::Set(d, -1.0 / 87178291200.0));
    p = hn::MulAdd(p, z, hn::Set(d, -1.0 / 39916800.0));
    q = hn::MulAdd(q, z, hn::Set(d, 1.0 / 479001600.0));
    p = hn::MulAdd(p, z, hn::Set(d, 1.0 / 362880.0));
    q = hn::MulAdd(q, z, hn::Set(d, -1.0 / 3628800.0));
    p = hn::MulAdd(p, z, hn::Set(d, -1.0 / 5040.0));
    q = hn::MulAdd(q, z, hn::Set(d, 1.0 / 40320.0));
    p = hn::MulAdd(p, z, hn::Set(d, 1.0 / 120.0));
    q = hn::MulAdd(q, z, hn::Set(d, -1.0 / 720.0));
    p = hn::MulAdd(p, z, hn::Set(d, -1.0 / 6.0));
    q = hn::MulAdd(q, z, hn::Set(d, 1.0 / 24.0));
    q = hn::MulAdd(q, z, hn::Set(d, -0.5));
    const V s = hn::MulAdd(hn::Mul(p, z), r, r);
    const V c = hn::MulAdd(q, z, hn::Set(d, 1.0));
    // -1 or 1 rather than -0 or 0: emulated vectors compare where real ones look at the sign bit.
    const V odd = hn::Or(hn::BitCast(d, hn::ShiftLeft<63>(quarter)), hn::Set(d, 1.0));
    const V signs = hn::SignBit(d);
    const V sine_sign = hn::And(signs, hn::BitCast(d, hn::ShiftLeft<62>(quarter)));
    const V cosine_sign = hn::Xor(sine_sign, hn::And(signs, odd));
    sine = hn::Xor(hn::IfNegativeThenElse(odd, c, s), sine_sign);
    cosine = hn::Xor(hn::IfNegativeThenElse(odd, s, c), cosine_sign);
}

// A medium at a register of wavelengths and an angle.
struct Lanes {
    Complex q;        // normal component of the wave vector over 2 pi / wavelength
    Complex inverse;  // 1 / q, 0 where q is; only of layers
    Complex n2;       // squared index
    Complex n2_inverse;
};
constexpr size_t parts_of_lanes = 8;

HWY_INLINE Complex inverse_of(Complex a) {
    const D d;
    const V norm = hn::MulAdd(a.re, a.re, hn::Mul(a.im, a.im));
    const V by = hn::IfThenElseZero(hn::Gt(norm, hn::Zero(d)), hn::Div(hn::Set(d, 1.0), norm));
    return {hn::Mul(a.re, by), hn::Neg(hn::Mul(a.im, by))};
}

// Square root in the first quadrant. @param z  imaginary part >= 0
HWY_INLINE Complex square_root(Complex z) {
    const D d;
    const V size = hn::Sqrt(hn::MulAdd(z.re, z.re, hn::Mul(z.im, z.im)));
    const V larger = hn::Sqrt(hn::Mul(hn::Set(d, 0.5), hn::Add(size, hn::Abs(z.re))));
    const V smaller = hn::IfThenElseZero(hn::Gt(larger, hn::Zero(d)), hn::Div(hn::Mul(hn::Set(d, 0.5), z.im), larger));
    const auto is_right = hn::Ge(z.re, hn::Zero(d));
    return {hn::IfThenElse(is_right, larger, smaller), hn::IfThenElse(is_right, smaller, larger)};
}

// One register of wavelengths: what layers are asked for.
class Block {
public:
    // @param cache  of the media, at the block before this one; the first block has none
    HWY_INLINE Block(const LayersAtAngle& angle, size_t first, double* cache, size_t cached)
        : angle_(angle), layers_(*angle.layers), first_(first), cache_(cache), cached_(cached) {
        const D d;
        per_nm_ = hn::LoadU(d, layers_.per_nm.data() + first);
        const V n0 = hn::LoadU(d, layers_.n.data() + curve_row(layers_.media[size_t(layers_.incident)].curve));
        u_ = hn::Mul(n0, hn::Set(d, angle.transverse.u_per_n0));
        v_ = hn::Mul(hn::Mul(n0, n0), hn::Set(d, angle.transverse.v_per_n0_squared));
        for (size_t medium = 0; medium < cached_; ++medium) {
            if (first == 0 || layers_.is_dispersive[medium]) store(medium, compute(medium));
        }
    }

    HWY_INLINE V per_nm() const { return per_nm_; }
    bool is_plain(int medium) const { return angle_.is_plain[size_t(medium)] != 0; }
    bool is_plain_step(int step) const { return angle_.is_plain_step[size_t(step)] != 0; }
    const LayerStep& step(int i) const { return layers_.steps[size_t(i)]; }
    const PreparedLayers& layers() const { return layers_; }

    HWY_INLINE Lanes lanes(int medium) const {
        if (size_t(medium) >= cached_) return compute(size_t(medium));
        const D d;
        const size_t n = hn::Lanes(d);
        const double* at = cache_ + size_t(medium) * parts_of_lanes * n;
        return {{hn::Load(d, at), hn::Load(d, at + n)},
                {hn::Load(d, at + 2 * n), hn::Load(d, at + 3 * n)},
                {hn::Load(d, at + 4 * n), hn::Load(d, at + 5 * n)},
                {hn::Load(d, at + 6 * n), hn::Load(d, at + 7 * n)}};
    }

private:
    size_t curve_row(int curve) const { return size_t(curve) * layers_.wavelengths + first_; }

    HWY_INLINE void store(size_t medium, const Lanes& m) const {
        const D d;
        const size_t n = hn::Lanes(d);
        double* at = cache_ + medium * parts_of_lanes * n;
        for (const Complex& part : {m.q, m.inverse, m.n2, m.n2_inverse}) {
            hn::Store(part.re, d, at);
            hn::Store(part.im, d, at + n);
            at += 2 * n;
        }
    }

    HWY_INLINE V mixed(const std::vector<double>& rows, const Medium& medium) const {
        const D d;
        const V a = hn::LoadU(d, rows.data() + curve_row(medium.curve));
        if (medium.share == 0.0) return a;
        const V b = hn::LoadU(d, rows.data() + curve_row(medium.other));
        return hn::MulAdd(hn::Set(d, medium.share), b, hn::Mul(hn::Set(d, 1.0 - medium.share), a));
    }

    HWY_INLINE Lanes compute(size_t medium) const {
        const D d;
        const V zero = hn::Zero(d);
        const V n = mixed(layers_.n, layers_.media[medium]);
        const V distance = hn::MulAdd(hn::Sub(n, u_), hn::Add(n, u_), v_);
        if (angle_.is_plain[medium]) {
            const V one = hn::Set(d, 1.0);
            const V q = hn::Sqrt(hn::Max(distance, zero));
            const V n2 = hn::Mul(n, n);
            V inverse = zero;
            if (layers_.is_layer[medium]) inverse = hn::IfThenElseZero(hn::Gt(q, zero), hn::Div(one, q));
            return {{q, zero}, {inverse, zero}, {n2, zero}, {hn::Div(one, n2), zero}};
        }
        const V k = mixed(layers_.k, layers_.media[medium]);
        const V twice_nk = hn::Mul(hn::Add(n, n), k);
        const Complex q = square_root({hn::NegMulAdd(k, k, distance), twice_nk});
        const Complex n2{hn::Mul(hn::Sub(n, k), hn::Add(n, k)), twice_nk};
        return {q, layers_.is_layer[medium] ? inverse_of(q) : q, n2, inverse_of(n2)};
    }

    const LayersAtAngle& angle_;
    const PreparedLayers& layers_;
    size_t first_;
    double* cache_;
    size_t cached_;
    V per_nm_, u_, v_;
};

HWY_INLINE void plain_layer(const Block& block, const LayerStep& step, Matrix<Real>& s, Matrix<Real>& p) {
    const D d;
    const Lanes m = block.lanes(step.medium);
    const V path = hn::Mul(block.per_nm(), hn::Set(d, step.thickness_nm));
    V sine, cosine;
    sin_cos(hn::Mul(path, m.q.re), sine, cosine);
    // sin a / q is regular: it tends to 2 pi d / wavelength.
    const V by_q = hn::IfThenElse(hn::Gt(m.q.re, hn::Zero(d)), hn::Mul(sine, m.inverse.re), path);
    const V times_q = hn::Mul(sine, m.q.re);
    s = {{cosine}, {by_q}, {times_q}, {cosine}};
    p = {{cosine}, {hn::Mul(by_q, m.n2.re)}, {hn::Mul(times_q, m.n2_inverse.re)}, {cosine}};
}

// @return  Im a, the logarithm of the scale that was taken off
HWY_INLINE V lossy_layer(const Block& block, const LayerStep& step, Matrix<Complex>& s, Matrix<Complex>& p) {
    const D d;
    const Lanes m = block.lanes(step.medium);
    const V path = hn::Mul(block.per_nm(), hn::Set(d, step.thickness_nm));
    const V loss = hn::Mul(path, m.q.im);
    V sine, cosine;
    sin_cos(hn::Mul(path, m.q.re), sine, cosine);
    const V half = hn::Mul(hn::Set(d, 0.5), hn::Expm1(d, hn::Mul(hn::Set(d, -2.0), loss)));
    const V cosh = hn::Add(hn::Set(d, 1.0), half);
    const V sinh = hn::Neg(half);
    const Complex cos_a{hn::Mul(cosine, cosh), hn::Neg(hn::Mul(sine, sinh))};
    const Complex sin_a{hn::Mul(sine, cosh), hn::Mul(cosine, sinh)};
    const auto has_q = hn::Or(hn::Gt(m.q.re, hn::Zero(d)), hn::Gt(m.q.im, hn::Zero(d)));
    Complex by_q = sin_a * m.inverse;
    by_q.re = hn::IfThenElse(has_q, by_q.re, path);
    const Complex times_q = sin_a * m.q;
    s = {cos_a, by_q, times_q, cos_a};
    p = {cos_a, by_q * m.n2, times_q * m.n2_inverse, cos_a};
    return loss;
}

template <class Number>
HWY_INLINE Matrix<Number> identity() {
    const D d;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0);
    if constexpr (sizeof(Number) == sizeof(Real)) {
        return {{one}, {zero}, {zero}, {one}};
    } else {
        return {{one, zero}, {zero, zero}, {zero, zero}, {one, zero}};
    }
}

constexpr int steps_between_rescales = 8;

template <class Value>
void apply_steps(const Block& block, int first, int last, bool upwards, Pair<Value>& fields);

// Squarings after which values of at most `rescaled_size` still fit, with room for their product with fields.
constexpr int squarings_between_rescales = 2;

// Applies the repeat-th power of a group's matrix: by the bits of the exponent, squaring in between.
template <class Number, class Value>
HWY_INLINE void apply_power(Pair<Matrix<Number>>& power, int repeat, Pair<Value>& fields) {
    int squarings = 0;
    for (int left = repeat;;) {
        if (left & 1) {
            apply(power.s, fields.s);
            apply(power.p, fields.p);
            fields.log_s = hn::Add(fields.log_s, power.log_s);
            fields.log_p = hn::Add(fields.log_p, power.log_p);
        }
        left >>= 1;
        if (left == 0) return;
        square(power.s);
        square(power.p);
        power.log_s = hn::Add(power.log_s, power.log_s);
        power.log_p = hn::Add(power.log_p, power.log_p);
        if (++squarings % squarings_between_rescales == 0) {
            rescale(power);
            rescale(fields);
        }
    }
}

template <class Number, class Value>
HWY_NOINLINE void apply_group(const Block& block, const LayerStep& group, bool upwards, Pair<Value>& fields) {
    const D d;
    Pair<Matrix<Number>> power{identity<Number>(), identity<Number>(), hn::Zero(d), hn::Zero(d)};
    apply_steps(block, group.first, group.last, upwards, power);
    rescale(power);
    rescale(fields);
    apply_power(power, group.repeat, fields);
    rescale(fields);
}

// The same for a few plain layers that repeat: the usual mirror. No identity to begin with, nothing through memory.
template <class Value>
HWY_INLINE void apply_plain_pairs(const Block& block, const LayerStep& group, bool upwards, Pair<Value>& fields) {
    const D d;
    const int direction = upwards ? -1 : 1;
    int i = upwards ? group.last - 1 : group.first;
    Pair<Matrix<Real>> power;
    power.log_s = power.log_p = hn::Zero(d);
    plain_layer(block, block.step(i), power.s, power.p);
    for (int left = group.last - group.first - 1; left > 0; --left) {
        Matrix<Real> s, p;
        plain_layer(block, block.step(i += direction), s, p);
        apply(s, power.s);
        apply(p, power.p);
    }
    apply_power(power, group.repeat, fields);
    rescale(fields);
}

// Real matrices take real layers only: a group is plain if all that is in it is.
template <class Value>
constexpr bool takes_lossy = true;
template <>
constexpr bool takes_lossy<Matrix<Real>> = false;

template <class Value>
constexpr bool is_column = false;
template <>
constexpr bool is_column<Column> = true;

template <class Value>
HWY_INLINE void apply_step(const Block& block, int i, bool upwards, Pair<Value>& fields) {
    const LayerStep& step = block.step(i);
    const bool is_plain = block.is_plain_step(i);
    if (step.repeat > 0) {
        if constexpr (takes_lossy<Value>) {
            if (!is_plain) return apply_group<Complex>(block, step, upwards, fields);
        }
        if (step.is_short) return apply_plain_pairs(block, step, upwards, fields);
        return apply_group<Real>(block, step, upwards, fields);
    }
    if constexpr (takes_lossy<Value>) {
        if (!is_plain) {
            Matrix<Complex> s, p;
            const V loss = lossy_layer(block, step, s, p);
            apply(s, fields.s);
            apply(p, fields.p);
            fields.log_s = hn::Add(fields.log_s, loss);
            fields.log_p = hn::Add(fields.log_p, loss);
            return;
        }
    }
    Matrix<Real> s, p;
    plain_layer(block, step, s, p);
    apply(s, fields.s);
    apply(p, fields.p);
}

// Plain layers one after the other, the fields in registers: what most stacks are made of.
// @return  how many of the steps these are, at most `most`
HWY_INLINE int apply_plain_layers(const Block& block, int first, int direction, int most, Pair<Column>& fields) {
    Column s, p;
    set(s.x, fields.s.x);
    set(s.y, fields.s.y);
    set(p.x, fields.p.x);
    set(p.y, fields.p.y);
    int count = 0;
    for (int i = first; count < most; ++count, i += direction) {
        const LayerStep& step = block.step(i);
        if (!block.is_plain_step(i) || step.repeat > 0) break;
        Matrix<Real> layer_s, layer_p;
        plain_layer(block, step, layer_s, layer_p);
        apply(layer_s, s);
        apply(layer_p, p);
    }
    set(fields.s.x, s.x);
    set(fields.s.y, s.y);
    set(fields.p.x, p.x);
    set(fields.p.y, p.y);
    return count;
}

// Steps are in the order in which light meets them; fields climb from the last to the first, or, for light that comes
// from below, from the first to the last.
template <class Value>
void apply_steps(const Block& block, int first, int last, bool upwards, Pair<Value>& fields) {
    const int count = last - first;
    const int direction = upwards ? -1 : 1;
    const int begin = upwards ? last - 1 : first;
    for (int i = 0; i < count;) {
        const int end = HWY_MIN(count, i + steps_between_rescales);
        while (i < end) {
            if constexpr (is_column<Value>) {
                const int plain = apply_plain_layers(block, begin + i * direction, direction, end - i, fields);
                i += plain;
                if (plain > 0) continue;
            }
            apply_step(block, begin + i * direction, upwards, fields);
            ++i;
        }
        if (end < count) rescale(fields);
    }
}

HWY_INLINE V norm_of(Real a) {
    return hn::Mul(a.re, a.re);
}
HWY_INLINE V norm_of(Complex a) {
    return hn::MulAdd(a.re, a.re, hn::Mul(a.im, a.im));
}
HWY_INLINE Complex times_i(Complex a) {
    return {hn::Neg(a.im), a.re};
}

// Squared amplitudes of what a coherent part reflects and transmits (E of s, H of p).
struct Amplitudes {
    V r2, t2;
};

template <bool wants_transmittance, class Number>
HWY_INLINE Amplitudes finish(const Column& f, Number g, V log_scale) {
    const D d;
    // With y = i H the waves going down and up are proportional to g x - i y and g x + i y.
    const Complex gx = g * f.x;
    const Complex iy = times_i(f.y);
    const V down = norm_of(gx - iy);
    const V up = norm_of(gx + iy);
    Amplitudes result{hn::Div(up, down), hn::Zero(d)};
    if constexpr (wants_transmittance) {
        const V scale = hn::Exp(d, hn::Mul(hn::Set(d, -2.0), log_scale));
        result.t2 = hn::Mul(hn::Div(hn::Mul(hn::Set(d, 4.0), norm_of(g)), down), scale);
    }
    return result;
}

// Light from medium `above` through a part into medium `below`, or the other way round.
template <bool wants_transmittance>
HWY_INLINE void part_amplitudes(const Block& block, const CoherentPart& part, bool downwards, Amplitudes& s,
                                Amplitudes& p) {
    const D d;
    const Lanes from = block.lanes(downwards ? part.above : part.below);
    const Lanes into = block.lanes(downwards ? part.below : part.above);
    const V zero = hn::Zero(d);
    const Complex one{hn::Set(d, 1.0), zero};
    Pair<Column> fields{{one, times_i(into.q)}, {one, times_i(into.q * into.n2_inverse)}, zero, zero};
    apply_steps(block, part.first, part.last, downwards, fields);
    if (part.last - part.first > 1) rescale(fields);
    if (block.is_plain(downwards ? part.above : part.below)) {
        const Real q{from.q.re};
        s = finish<wants_transmittance>(fields.s, q, fields.log_s);
        p = finish<wants_transmittance>(fields.p, q * Real{from.n2_inverse.re}, fields.log_p);
    } else {
        s = finish<wants_transmittance>(fields.s, from.q, fields.log_s);
        p = finish<wants_transmittance>(fields.p, from.q * from.n2_inverse, fields.log_p);
    }
}

// The power left after one pass through an incoherent layer. Light that is evanescent in it does not cross it.
HWY_INLINE V power_after(const Block& block, const LayerStep& layer) {
    const D d;
    const Complex q = block.lanes(layer.medium).q;
    const V path = hn::Mul(block.per_nm(), hn::Set(d, -2.0 * layer.thickness_nm));
    return hn::IfThenElseZero(hn::Gt(q.re, q.im), hn::Exp(d, hn::Mul(path, q.im)));
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

struct ResponseLanes {
    V r_s, r_p, t_s, t_p;
};

template <bool wants_transmittance>
HWY_INLINE ResponseLanes response_of(const Block& block) {
    const D d;
    const PreparedLayers& layers = block.layers();
    Amplitudes s, p;
    const auto& parts = layers.parts;
    part_amplitudes<wants_transmittance>(block, parts.back(), true, s, p);
    for (size_t i = parts.size() - 1; i-- > 0;) {
        Amplitudes down_s, down_p, up_s, up_p;
        part_amplitudes<true>(block, parts[i], true, down_s, down_p);
        part_amplitudes<true>(block, parts[i], false, up_s, up_p);
        const V pass = power_after(block, layers.incoherent[i]);
        add_intensities(down_s, up_s, pass, s);
        add_intensities(down_p, up_p, pass, p);
    }
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0);
    const auto fraction = [&](V value) { return hn::Min(hn::Max(value, zero), one); };
    ResponseLanes result{fraction(s.r2), fraction(p.r2), zero, zero};
    if constexpr (wants_transmittance) {
        // From amplitudes to power.
        const Lanes incident = block.lanes(layers.incident);
        const Lanes substrate = block.lanes(layers.substrate);
        const V into_s = hn::Div(substrate.q.re, incident.q.re);
        const V into_p = hn::Div(hn::Mul((substrate.q * substrate.n2_inverse).re, incident.n2.re), incident.q.re);
        result.t_s = fraction(hn::Mul(s.t2, into_s));
        result.t_p = fraction(hn::Mul(p.t2, into_p));
    }
    return result;
}

// Media that every register prepares once; the rest, of stacks whose index keeps changing, are computed as they come.
constexpr size_t most_cached = 256;

template <bool wants_transmittance, class Sink>
HWY_INLINE void for_each_block(const LayersAtAngle& angle, const Sink& sink) {
    const D d;
    const size_t lanes = hn::Lanes(d);
    const size_t cached = HWY_MIN(angle.layers->media.size(), most_cached);
    std::vector<double> cache(cached * parts_of_lanes * lanes + lanes);
    // Aligned by hand to a register.
    const size_t bytes = lanes * sizeof(double);
    double* aligned =
        reinterpret_cast<double*>((reinterpret_cast<uintptr_t>(cache.data()) + bytes - 1) / bytes * bytes);
    for (size_t i = 0; i < angle.layers->wavelengths; i += lanes) {
        const Block block(angle, i, aligned, cached);
        sink(i, response_of<wants_transmittance>(block));
    }
}

void responses(const LayersAtAngle& angle, Response* out) {
    for_each_block<true>(angle, [&](size_t first, const ResponseLanes& r) {
        const D d;
        HWY_ALIGN double values[4][hn::MaxLanes(D())];
        hn::Store(r.r_s, d, values[0]);
        hn::Store(r.r_p, d, values[1]);
        hn::Store(r.t_s, d, values[2]);
        hn::Store(r.t_p, d, values[3]);
        for (size_t lane = 0; lane < hn::Lanes(d); ++lane)
            out[first + lane] = {values[0][lane], values[1][lane], values[2][lane], values[3][lane]};
    });
}

void weighted(const LayersAtAngle& angle, const double* const* weights, double* sums) {
    const D d;
    V sum_0 = hn::Zero(d);
    V sum_1 = hn::Zero(d);
    V sum_2 = hn::Zero(d);
    for_each_block<false>(angle, [&](size_t first, const ResponseLanes& response) {
        const V r = hn::Add(response.r_s, response.r_p);
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
