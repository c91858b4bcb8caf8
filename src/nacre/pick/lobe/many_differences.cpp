#include "nacre/pick/lobe/many_differences.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/pick/lobe/many_differences.cpp"
#include <hwy/foreach_target.h>  // compiles the rest of this file once per instruction set
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, RootColours::padding>;
using V = hn::Vec<D>;

HWY_INLINE V number(double value) {
    return hn::Set(D(), static_cast<float>(value));
}

// difference.cpp's, of the cube root.
HWY_INLINE V lab_function(V root) {
    constexpr double bend = 6.0 / 29.0;
    const V straight = hn::MulAdd(number(841.0 / 108.0), hn::Mul(root, hn::Mul(root, root)), number(4.0 / 29.0));
    return hn::IfThenElse(hn::Gt(root, number(bend)), root, straight);
}

HWY_INLINE V length(V a, V b) {
    return hn::Sqrt(hn::MulAdd(a, a, hn::Mul(b, b)));
}

// Of a chroma over 25, so that the seventh power stays a number.
HWY_INLINE V seventh_power_share(V chroma) {
    const V c = hn::Min(hn::Mul(chroma, number(1.0 / 25.0)), number(1e4));
    const V c2 = hn::Mul(c, c);
    const V c7 = hn::Mul(hn::Mul(c2, c2), hn::Mul(c2, c));
    return hn::Sqrt(hn::Div(c7, hn::Add(c7, number(1.0))));
}

// Cosine and sine of the mean hue: the direction half way between both colours'.
struct Hue {
    V cosine, sine;
};

// 1 - 0.17 cos(h - 30) + 0.24 cos(2 h) + 0.32 cos(3 h + 6) - 0.20 cos(4 h - 63), by the cosines and sines of multiples.
HWY_INLINE V hue_weight(const Hue& hue) {
    const V one = number(1.0);
    const V c1 = hue.cosine, s1 = hue.sine;
    const V c2 = hn::MulSub(hn::Add(c1, c1), c1, one), s2 = hn::Mul(hn::Add(c1, c1), s1);
    const V c3 = hn::NegMulAdd(s2, s1, hn::Mul(c2, c1)), s3 = hn::MulAdd(s2, c1, hn::Mul(c2, s1));
    const V c4 = hn::MulSub(hn::Add(c2, c2), c2, one), s4 = hn::Mul(hn::Add(c2, c2), s2);
    V sum = one;
    const auto add = [&](V cosine, double by_cosine, V sine, double by_sine) {
        sum = hn::MulAdd(cosine, number(by_cosine), hn::MulAdd(sine, number(by_sine), sum));
    };
    add(c1, -0.17 * 0.86602540378443865, s1, -0.17 * 0.5);
    sum = hn::MulAdd(c2, number(0.24), sum);
    add(c3, 0.32 * 0.99452189536827333, s3, -0.32 * 0.10452846326765347);
    add(c4, -0.20 * 0.45399049973954680, s4, -0.20 * 0.89100652418836787);
    return sum;
}

// -2 R_C sin(60 deg exp(-((h - 275) / 25)^2)); nothing where no hue is within 80 degrees of blue (it is below 1e-4).
HWY_INLINE V rotation_of(const Hue& hue, V chroma) {
    constexpr double cos275 = 0.08715574274765817, sin275 = -0.99619469809174553, cos80 = 0.17364817766693035;
    const D d;
    const V cosine = hn::MulAdd(hue.cosine, number(cos275), hn::Mul(hue.sine, number(sin275)));
    const auto is_blue = hn::Gt(cosine, number(cos80));
    if (hn::AllFalse(d, is_blue)) return hn::Zero(d);
    const V sine = hn::MulSub(hue.sine, number(cos275), hn::Mul(hue.cosine, number(sin275)));
    const V half = hn::Atan(d, hn::Div(sine, hn::Max(hn::Add(number(1.0), cosine), number(1.0))));
    const V blue = hn::Mul(half, number(2.0 * 57.295779513082321 / 25.0));
    const V angle = hn::Mul(number(1.0471975511965977), hn::Exp(d, hn::Neg(hn::Mul(blue, blue))));
    const V q = hn::Mul(angle, angle);
    V series = number(1.0 / 362880.0);
    for (const double term : {-1.0 / 5040.0, 1.0 / 120.0, -1.0 / 6.0, 1.0})
        series = hn::MulAdd(series, q, number(term));
    const V rotation = hn::Mul(hn::Mul(number(-2.0), seventh_power_share(chroma)), hn::Mul(angle, series));
    return hn::IfThenElseZero(is_blue, rotation);
}

HWY_INLINE V square_of_difference(const Lab& target, double target_chroma, double side, V fx, V fy, V fz) {
    const V zero = number(0.0), half = number(0.5), one = number(1.0);
    const V l1 = number(target.l), b1 = number(target.b);
    const V l2 = hn::MulSub(number(116.0), fy, number(16.0));
    const V plain_a2 = hn::Mul(number(500.0), hn::Sub(fx, fy)), b2 = hn::Mul(number(200.0), hn::Sub(fy, fz));
    const V plain_chroma = hn::Mul(half, hn::Add(number(target_chroma), length(plain_a2, b2)));
    const V stretch = hn::NegMulAdd(half, seventh_power_share(plain_chroma), number(1.5));
    const V a1 = hn::Mul(stretch, number(target.a)), a2 = hn::Mul(stretch, plain_a2);
    const V chroma1 = length(a1, b1), chroma2 = length(a2, b2);

    const V product = hn::Mul(chroma1, chroma2);
    const V cosines = hn::MulAdd(a1, a2, hn::Mul(b1, b2));
    const V sines = hn::MulSub(a1, b2, hn::Mul(a2, b1));
    // 4 C1 C2 sin^2(half the angle between) is 2 (C1 C2 - cosines), which cancels for hues that are near.
    const V tiny = number(1e-20);
    const V near_square = hn::Div(hn::Mul(hn::Add(sines, sines), sines), hn::Add(hn::Add(product, cosines), tiny));
    const V far_square = hn::Add(hn::Sub(product, cosines), hn::Sub(product, cosines));
    const auto is_near = hn::Gt(cosines, zero);
    // The mean hue is half way round on that side: of hues that are nearly opposite, across their difference.
    const V turn = side == 0.0 ? hn::CopySign(one, sines) : number(side);
    const V hue_step = hn::IfThenElse(is_near, hn::CopySign(hn::Sqrt(near_square), sines),
                                      hn::Mul(turn, hn::Sqrt(hn::Max(far_square, zero))));
    const V left_a = hn::Mul(a1, chroma2), right_a = hn::Mul(a2, chroma1);
    const V left_b = hn::Mul(b1, chroma2), right_b = hn::Mul(b2, chroma1);
    const V mean_a = hn::IfThenElse(is_near, hn::Add(left_a, right_a), hn::Mul(turn, hn::Sub(right_b, left_b)));
    const V mean_b = hn::IfThenElse(is_near, hn::Add(left_b, right_b), hn::Mul(turn, hn::Sub(left_a, right_a)));
    const V per_length = hn::Div(one, hn::Add(length(mean_a, mean_b), tiny));
    const Hue hue{hn::Mul(mean_a, per_length), hn::Mul(mean_b, per_length)};

    const V chroma = hn::Mul(half, hn::Add(chroma1, chroma2));
    const V off_middle = hn::MulSub(half, hn::Add(l1, l2), number(50.0));
    const V middle_square = hn::Mul(off_middle, off_middle);
    // S_L as a fraction, so that one division serves all three steps.
    const V bent = hn::Sqrt(hn::Add(middle_square, number(20.0)));
    const V s_l = hn::MulAdd(number(0.015), middle_square, bent);
    const V s_c = hn::MulAdd(number(0.045), chroma, one);
    const V s_h = hn::MulAdd(number(0.015), hn::Mul(chroma, hue_weight(hue)), one);
    const V s_ch = hn::Mul(s_c, s_h);
    const V per_all = hn::Div(one, hn::Mul(s_l, s_ch));
    const V l = hn::Mul(hn::Mul(hn::Sub(l2, l1), bent), hn::Mul(per_all, s_ch));
    const V per_ch = hn::Mul(per_all, s_l);
    const V c = hn::Mul(hn::Sub(chroma2, chroma1), hn::Mul(per_ch, s_h));
    const V h = hn::Mul(hue_step, hn::Mul(per_ch, s_c));
    const V rotation = rotation_of(hue, chroma);
    const V square = hn::MulAdd(l, l, hn::MulAdd(c, c, hn::MulAdd(h, h, hn::Mul(rotation, hn::Mul(c, h)))));
    return hn::Max(square, zero);
}

void differences(const Lab& target, const RootColours& colours, double side, float* HWY_RESTRICT squares) {
    const D d;
    const double chroma = std::sqrt(target.a * target.a + target.b * target.b);
    for (std::size_t i = 0; i < colours.count; i += hn::Lanes(d)) {
        const V factor = hn::LoadU(d, colours.factor + i);
        const auto part = [&](const float* roots) { return lab_function(hn::Mul(factor, hn::LoadU(d, roots + i))); };
        hn::StoreU(square_of_difference(target, chroma, side, part(colours.x), part(colours.y), part(colours.z)), d,
                   squares + i);
    }
}

// A third of the exponent, straight from the bits (3 % off), and Halley's method, which triples the digits.
void roots(float* HWY_RESTRICT values, std::size_t count) {
    const D d;
    const hn::RebindToSigned<D> di;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V value = hn::LoadU(d, values + i);
        const V x = hn::Abs(value);
        const V bits = hn::ConvertTo(d, hn::BitCast(di, x));
        V y = hn::BitCast(d, hn::ConvertTo(di, hn::MulAdd(bits, number(1.0 / 3.0), number(709921077.0))));
        for (int step = 0; step < 2; ++step) {
            const V cube = hn::Mul(y, hn::Mul(y, y));
            y = hn::Mul(y, hn::Div(hn::Add(cube, hn::Add(x, x)), hn::Add(hn::Add(cube, cube), x)));
        }
        hn::StoreU(hn::CopySign(y, value), d, values + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(differences);
HWY_EXPORT(roots);

void many_differences(const Lab& target, const RootColours& colours, float* squares, double side) {
    HWY_DYNAMIC_DISPATCH(differences)(target, colours, side, squares);
}

void cube_roots(float* values, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(roots)(values, count);
}

}  // namespace nacre
#endif  // HWY_ONCE
