#include "nacre/colour/whole_cells.h"

#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/colour/whole_cells.cpp"
#include <hwy/foreach_target.h>  // compiles the rest of this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Sum of weight[i] * cos(phase + i * per_nm) for i in [0, count), for three weights at once.
// Two registers of cosines step on by a fixed angle; two, because one would wait for its own result.
Xyz cosine_sum(const double* HWY_RESTRICT x, const double* HWY_RESTRICT y, const double* HWY_RESTRICT z, size_t count,
               double cos_phase, double sin_phase, double cos_step, double sin_step) {
    const hn::ScalableTag<double> d;
    const size_t lanes = hn::Lanes(d);
    // Lane i starts i steps on: for every bit of i the lanes that have it turn by that power of two. Short chains, and
    // no way through memory, where a wide load would wait for narrow stores.
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto lane = hn::Iota(du, 0);
    double turn_c = cos_step;
    double turn_s = sin_step;
    auto cos_a = hn::Set(d, cos_phase);
    auto sin_a = hn::Set(d, sin_phase);
    const auto double_turn = [&] {
        const double doubled = (turn_c - turn_s) * (turn_c + turn_s);
        turn_s = 2.0 * turn_c * turn_s;
        turn_c = doubled;
    };
    for (size_t bit = 1; bit < lanes; bit *= 2) {
        const auto has_bit = hn::RebindMask(d, hn::TestBit(lane, hn::Set(du, bit)));
        const auto c = hn::Set(d, turn_c);
        const auto s = hn::Set(d, turn_s);
        const auto turned_cos = hn::NegMulAdd(sin_a, s, hn::Mul(cos_a, c));
        const auto turned_sin = hn::MulAdd(cos_a, s, hn::Mul(sin_a, c));
        cos_a = hn::IfThenElse(has_bit, turned_cos, cos_a);
        sin_a = hn::IfThenElse(has_bit, turned_sin, sin_a);
        double_turn();
    }
    const auto next_cos = hn::Set(d, turn_c);
    const auto next_sin = hn::Set(d, turn_s);
    auto cos_b = hn::NegMulAdd(sin_a, next_sin, hn::Mul(cos_a, next_cos));
    const auto sin_b = hn::MulAdd(cos_a, next_sin, hn::Mul(sin_a, next_cos));
    double_turn();

    // From here on cosines alone: c(n + 1) - c(n) = c(n) - c(n - 1) - 4 sin^2(turn / 2) c(n). Reinsch's form of the
    // three-term recurrence carries the difference, and so keeps its digits however small the turn is.
    const double four_sin2 = turn_c > 0.0 ? 2.0 * turn_s * turn_s / (1.0 + turn_c) : 2.0 * (1.0 - turn_c);
    const auto bend = hn::Set(d, four_sin2);
    const auto turn_cos = hn::Set(d, turn_c);
    const auto turn_sin = hn::Set(d, turn_s);
    // Difference to the step before, from the cosine of the step before.
    const auto difference = [&](auto cosine, auto sine) {
        const auto minus_turned = hn::MulAdd(sine, turn_sin, hn::Mul(cosine, turn_cos));
        return hn::Sub(cosine, minus_turned);
    };
    auto step_a = difference(cos_a, sin_a);
    auto step_b = difference(cos_b, sin_b);

    auto sum_x = hn::Zero(d);
    auto sum_y = hn::Zero(d);
    auto sum_z = hn::Zero(d);
    size_t i = 0;
    for (; i + 2 * lanes <= count; i += 2 * lanes) {
        sum_x = hn::MulAdd(hn::LoadU(d, x + i), cos_a, sum_x);
        sum_y = hn::MulAdd(hn::LoadU(d, y + i), cos_a, sum_y);
        sum_z = hn::MulAdd(hn::LoadU(d, z + i), cos_a, sum_z);
        sum_x = hn::MulAdd(hn::LoadU(d, x + i + lanes), cos_b, sum_x);
        sum_y = hn::MulAdd(hn::LoadU(d, y + i + lanes), cos_b, sum_y);
        sum_z = hn::MulAdd(hn::LoadU(d, z + i + lanes), cos_b, sum_z);
        step_a = hn::NegMulAdd(bend, cos_a, step_a);
        step_b = hn::NegMulAdd(bend, cos_b, step_b);
        cos_a = hn::Add(cos_a, step_a);
        cos_b = hn::Add(cos_b, step_b);
    }
    // What is left fills less than two registers; the weights' padding makes the reading past the end legal.
    for (int half = 0; half < 2 && i < count; ++half, i += lanes) {
        const auto inside = hn::FirstN(d, count - i);
        const auto cosine = hn::IfThenElseZero(inside, half == 0 ? cos_a : cos_b);
        sum_x = hn::MulAdd(hn::LoadU(d, x + i), cosine, sum_x);
        sum_y = hn::MulAdd(hn::LoadU(d, y + i), cosine, sum_y);
        sum_z = hn::MulAdd(hn::LoadU(d, z + i), cosine, sum_z);
    }
    return {hn::GetLane(hn::SumOfLanes(d, sum_x)), hn::GetLane(hn::SumOfLanes(d, sum_y)),
            hn::GetLane(hn::SumOfLanes(d, sum_z))};
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(cosine_sum);

// (k - sin k) / k^2: how much of a sine the half hat at an end sees. The quotient itself cancels for small k;
// the series' next term is below 1e-17 relative at 0.5.
double half_hat_sine(double k) {
    if (k > 0.5) return (k - std::sin(k)) / (k * k);
    const double q = k * k;
    return k * (1.0 / 6.0 -
                q * (1.0 / 120.0 -
                     q * (1.0 / 5040.0 -
                          q * (1.0 / 362880.0 -
                               q * (1.0 / 39916800.0 - q * (1.0 / 6227020800.0 - q * (1.0 / 1307674368000.0)))))));
}

}  // namespace

Xyz weighted_cosines(const double* x, const double* y, const double* z, std::size_t count, Phasor first, Phasor step) {
    return HWY_DYNAMIC_DISPATCH(cosine_sum)(x, y, z, count, first.cosine, first.sine, step.cosine, step.sine);
}

Xyz integrate_whole_cells(const TristimulusWeights& weights, const WholeCells& cells) {
    const auto begin = static_cast<std::size_t>(cells.first_nm - weights.first_cell());
    const auto end = static_cast<std::size_t>(cells.last_nm - weights.first_cell());
    const Phasor half_step = small_phasor(0.5 * cells.per_nm);
    const double sinc = half_step.sine / (0.5 * cells.per_nm);
    const double hat = sinc * sinc;
    const double edge = half_hat_sine(cells.per_nm);
    const Phasor& first = cells.first_phase;
    const Phasor& last = cells.last_phase;

    const Xyz nodes = HWY_DYNAMIC_DISPATCH(cosine_sum)(
        weights.x.data() + begin, weights.y.data() + begin, weights.z.data() + begin, end - begin + 1, first.cosine,
        first.sine, 1.0 - 2.0 * half_step.sine * half_step.sine, 2.0 * half_step.sine * half_step.cosine);
    // The end nodes own half a hat each, and half a hat is not even: that is the sine term.
    const auto component = [&](double node_sum, double first_weight, double last_weight) {
        const double ends = 0.5 * (first_weight * first.cosine + last_weight * last.cosine);
        return hat * (node_sum - ends) - edge * (first_weight * first.sine - last_weight * last.sine);
    };
    return {component(nodes.x, weights.x[begin], weights.x[end]), component(nodes.y, weights.y[begin], weights.y[end]),
            component(nodes.z, weights.z[begin], weights.z[end])};
}

}  // namespace nacre
#endif  // HWY_ONCE
