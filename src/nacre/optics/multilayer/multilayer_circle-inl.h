// Circular and hyperbolic functions of the multilayer kernel. Compiled once per instruction set.
#if defined(NACRE_OPTICS_MULTILAYER_CIRCLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_OPTICS_MULTILAYER_CIRCLE_INL_H_
#undef NACRE_OPTICS_MULTILAYER_CIRCLE_INL_H_
#else
#define NACRE_OPTICS_MULTILAYER_CIRCLE_INL_H_
#endif

#include <cstddef>

#include "nacre/optics/multilayer/multilayer_numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

// Angles are in quarter turns and exponents are those of 2: what is left after the nearest whole number is exact, at
// any size. Polynomials are minimax ones (Remez 1934; coefficients rounded one by one, the rest fitted again).

// A number as a whole one and a rest.
struct Split {
    V rest;                                 // in [-1/2, 1/2]
    hn::Vec<hn::RebindToUnsigned<D>> bits;  // the last ones are those of the whole number
};

HWY_INLINE Split split(V x) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    // Adding 1.5 * 2^52 rounds to a whole number and leaves its bits at the end of the mantissa.
    const V magic = hn::Set(d, 0x1.8p52);
    const V shifted = hn::Add(x, magic);
    return {hn::Sub(x, hn::Sub(shifted, magic)), hn::BitCast(du, shifted)};
}

// Coefficients, each in a register's worth of memory: x86 takes them from there as operands, where constants would
// have to be spread over a register first, every time.
class Coefficients {
public:
    static constexpr std::size_t sine = 0;
    static constexpr std::size_t cosine = 8;
    static constexpr std::size_t sinh = 15;
    static constexpr std::size_t cosh = 21;
    static constexpr std::size_t count = 26;

    Coefficients() {
        const D d;
        constexpr double values[count] = {
            // sin(pi/2 x) / x in powers of x^2, within 1.6e-18; the first two are pi/2
            0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.4abbce625be3cp-1, 0x1.466bc67757e00p-4,
            -0x1.32d2cce2380e6p-8, 0x1.50782f355037ap-13, -0x1.e2ffe29388abcp-19, 0x1.e3c4e5a44a58ap-25,
            // (cos(pi/2 x) - 1) / x^2, within 3.1e-19 of the cosine
            -0x1.3bd3cc9be45dep+0, 0x1.03c1f081b5a4fp-2, -0x1.55d3c7e3bf5abp-6, 0x1.e1f506749a430p-11,
            -0x1.a6d1e138cec3fp-16, 0x1.f9c3d3caac6dfp-22, -0x1.afee49c6b6487p-28,
            // sinh(ln 2 x) / x, within 2.7e-19
            0x1.62e42fefa39efp-1, 0x1.c6b08d704a0c4p-5, 0x1.5d87fe78a46a0p-10, 0x1.ffcbfc6b92c5ap-17,
            0x1.b524f010c6560p-24, 0x1.e9e5db398a053p-32,
            // (cosh(ln 2 x) - 1) / x^2, within 3.5e-18 of the cosine
            0x1.ebfbdff82c5a5p-3, 0x1.3b2ab6fb9ff4fp-7, 0x1.4309130f30eb1p-13, 0x1.62bfc6c90dbbep-20,
            0x1.e61caef467b53p-28};
        for (std::size_t i = 0; i < count; ++i) hn::Store(hn::Set(d, values[i]), d, lanes_[i]);
    }

    HWY_INLINE V operator[](std::size_t i) const { return hn::Load(D(), lanes_[i]); }

private:
    HWY_ALIGN double lanes_[count][hn::MaxLanes(D())];
};

// A polynomial in z, its even and its odd powers side by side: half as long a chain as Horner's.
template <std::size_t first, std::size_t count>
HWY_INLINE V polynomial(V z, V z2, const Coefficients& c) {
    constexpr std::size_t last_even = first + (count - 1) / 2 * 2;
    constexpr std::size_t last_odd = first + count / 2 * 2 - 1;
    V even = c[last_even];
    V odd = c[last_odd];
    for (std::size_t i = last_even; i > first; i -= 2) even = hn::MulAdd(even, z2, c[i - 2]);
    for (std::size_t i = last_odd; i > first + 1; i -= 2) odd = hn::MulAdd(odd, z2, c[i - 2]);
    return hn::MulAdd(odd, z, even);
}

struct SineCosine {
    V sine;
    V cosine;
};

// Within 1e-16 (1.4e-16 on machines that do not fuse multiplication and addition), but for a sign that both share: only
// intensities are asked for, which do not know it.
// @param quarter_turns  >= 0. From 2^50 on they have no digits that count, and any angle is as good
HWY_INLINE SineCosine sine_cosine(V quarter_turns, const Coefficients& c) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    const Split angle = split(hn::Min(quarter_turns, hn::Set(d, 0x1p50)));
    const V x = angle.rest;
    const V z = hn::Mul(x, x);
    const V z2 = hn::Mul(z, z);
    using C = Coefficients;
    const V s_rest = hn::MulAdd(z, polynomial<C::sine + 2, 6>(z, z2, c), c[C::sine + 1]);
    const V s = hn::MulAdd(x, c[C::sine], hn::Mul(x, s_rest));
    const V c_rest = hn::MulAdd(z, polynomial<C::cosine + 1, 6>(z, z2, c), c[C::cosine]);
    const V cosine = hn::MulAdd(z, c_rest, hn::Set(d, 1.0));
    // An odd number of quarter turns turns (c, s) into (-s, c).
    const auto is_odd = hn::RebindMask(d, hn::TestBit(angle.bits, hn::Set(du, 1)));
    return {hn::IfThenElse(is_odd, cosine, s), hn::IfThenElse(is_odd, hn::Neg(s), cosine)};
}

struct Hyperbolic {
    V sinh;
    V cosh;
    V doublings;  // true values = 2^doublings * these
};

// Both within 7e-16 of themselves, the sine however small it is.
// @param doublings  exponent over ln 2, >= 0
HWY_INLINE Hyperbolic sinh_cosh(V doublings, const Coefficients& coefficients) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    // Beyond 2^500 both are half the exponential.
    const Split exponent = split(hn::Min(doublings, hn::Set(d, 500.0)));
    const V x = exponent.rest;
    const V z = hn::Mul(x, x);
    const V z2 = hn::Mul(z, z);
    using C = Coefficients;
    const V s = hn::Mul(x, hn::MulAdd(z, polynomial<C::sinh + 1, 5>(z, z2, coefficients), coefficients[C::sinh]));
    const V c_rest = hn::MulAdd(z, polynomial<C::cosh + 1, 4>(z, z2, coefficients), coefficients[C::cosh]);
    const V c = hn::MulAdd(z, c_rest, hn::Set(d, 1.0));
    // With k whole doublings, e^a / 2^k = c + s and e^-a / 2^k = (c - s) / 4^k. Nothing cancels, and at k = 0 the two
    // are s and c themselves. Half of 4^-k by its exponent:
    const V half = hn::Set(d, 0.5);
    const V decayed = hn::BitCast(d, hn::Sub(hn::BitCast(du, half), hn::ShiftLeft<53>(exponent.bits)));
    const V sum = hn::Add(half, decayed);
    const V difference = hn::Sub(half, decayed);
    return {hn::MulAdd(s, sum, hn::Mul(c, difference)), hn::MulAdd(c, sum, hn::Mul(s, difference)),
            hn::Sub(doublings, x)};
}

// 2^(-2 log2), of a whole number; beyond what a double holds, the last that it does.
HWY_INLINE V inverse_square_of_power(V log2) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    const V most = hn::Set(d, 511.0);
    const Split exponent = split(hn::Max(hn::Min(log2, most), hn::Neg(most)));
    return hn::BitCast(d, hn::Sub(hn::BitCast(du, hn::Set(d, 1.0)), hn::ShiftLeft<53>(exponent.bits)));
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
