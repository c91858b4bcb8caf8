// What must hold for any stack whatever, on ten thousand of them: energy, reciprocity, scaling, splitting, continuity,
// and one answer from both solvers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "hard_cases/hard_case.h"
#include "nacre/optics/incidence.h"
#include "reference/number.h"

namespace nacre::hard_cases {
namespace {

constexpr int stack_count = 10000;

/// Each the same whatever the others are.
class RandomCase {
public:
    explicit RandomCase(int number) : uniform_(0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(number)) {
        is_lossless = number % 3 == 0;
        const double incident = half_space();
        // A third have like half-spaces on both sides, some lie on a metal.
        RefractiveIndex substrate = number % 5 < 2 ? incident : half_space();
        if (!is_lossless && number % 7 == 0) substrate = metal();
        hard_case = {"random stack " + std::to_string(number), Stack(incident, substrate), angle(),
                     uniform_.between(200.0, 2000.0)};
        const int parts = whole(0, number % 4 == 0 ? 40 : 10);
        for (int i = 0; i < parts; ++i) {
            const double kind = uniform_.between(0.0, 1.0);
            if (kind > 0.97) {
                hard_case.stack.incoherent_layer({uniform_.between(1.3, 2.0), is_lossless ? 0.0 : decades(1e-9, 1e-3)},
                                                 decades(1e5, 1e7));
                continue;
            }
            const bool is_group = kind < 0.15;
            const int members = is_group ? whole(1, 5) : 1;
            if (is_group) hard_case.stack.begin_group(whole(2, 12));
            for (int j = 0; j < members; ++j) add_layer();
            if (is_group) hard_case.stack.end_group();
        }
    }

    HardCase hard_case{"", Stack(1.0, 1.0)};
    bool is_lossless = false;

private:
    int whole(int low, int high) { return static_cast<int>(uniform_.between(low, high)); }
    double decades(double low, double high) { return std::exp(uniform_.between(std::log(low), std::log(high))); }
    double half_space() { return std::array{1.0, 1.0, 1.33, 1.52, 2.4}.at(static_cast<std::size_t>(whole(0, 5))); }
    RefractiveIndex metal() { return {decades(0.03, 3.0), uniform_.between(1.0, 8.0)}; }
    double angle() {
        // Around 45 degrees sine and cosine change their parts in the solvers.
        const std::array ends{0.0, 1e-9, 89.9, 89.9999, 89.999999999, 90.0, std::nextafter(45.0, 0.0), 45.0};
        if (uniform_.between(0.0, 1.0) < 0.2) return ends.at(static_cast<std::size_t>(whole(0, 8)));
        return uniform_.between(0.0, 90.0);
    }
    void add_layer() {
        const double kind = uniform_.between(0.0, 1.0);
        RefractiveIndex index = uniform_.between(1.0, 4.0);
        if (!is_lossless && kind < 0.15) {
            index = metal();
        } else if (!is_lossless && kind < 0.5) {
            index = {index.real(), decades(1e-8, 1.0)};
        } else if (kind > 0.9) {
            index = hard_case.stack.incident;
        }
        hard_case.stack.layer(index, kind < 0.15 ? decades(0.5, 100.0) : decades(1.0, 2000.0));
    }

    reference::Uniform uniform_;
};

HardCase with(const HardCase& hard_case, const Stack& stack) {
    return {hard_case.name, stack, hard_case.theta_deg, hard_case.wavelength_nm};
}

TEST(RandomStacks, ReflectAndTransmitNoMoreThanAllAndAllOfItWithoutLoss) {
    for (int i = 0; i < stack_count; ++i) {
        const RandomCase random(i);
        for (const Four& got : {scalar_response(random.hard_case), solver_response(random.hard_case)}) {
            for (const double fraction : got) {
                ASSERT_GE(fraction, 0.0) << i;
                ASSERT_LE(fraction, 1.0) << i;
            }
            EXPECT_LE(got[0] + got[2], 1.0 + base_tolerance) << i;
            EXPECT_LE(got[1] + got[3], 1.0 + base_tolerance) << i;
            if (!random.is_lossless) continue;
            // A gain of one is the other's loss, whatever is typed in: conditioning has no say.
            EXPECT_NEAR(got[0] + got[2], 1.0, base_tolerance) << i;
            EXPECT_NEAR(got[1] + got[3], 1.0, base_tolerance) << i;
        }
    }
}

TEST(RandomStacks, TransmitAlikeFromEitherSide) {
    // Helmholtz's reciprocity: holds with absorption between the half-spaces, not within one.
    int seen = 0;
    for (int i = 0; i < stack_count; ++i) {
        HardCase front = RandomCase(i).hard_case;
        const double sine = front.stack.incident.real() / front.stack.substrate.real() *
                            std::sin(front.theta_deg * std::numbers::pi / 180.0);
        const bool is_same = front.stack.incident == front.stack.substrate;
        // Between unlike half-spaces the angle behind is rounded, which conditioning forgives for moderate ones.
        if (front.stack.substrate.imag() != 0.0 || (!is_same && (sine > 0.99 || front.theta_deg > 80.0))) continue;
        HardCase back = with(front, front.stack.reversed());
        if (!is_same) back.theta_deg = std::asin(sine) * 180.0 / std::numbers::pi;
        const std::array ways{std::pair{scalar_response(front), scalar_response(back)},
                              std::pair{solver_response(front), solver_response(back)}};
        for (const auto& [one, other] : ways) {
            const Four t_of_one{0.0, 0.0, one[2], one[3]}, t_of_other{0.0, 0.0, other[2], other[3]};
            expect_equal(front, t_of_one, t_of_other, "front and back");
        }
        ++seen;
    }
    EXPECT_GT(seen, stack_count / 2);
}

Stack with_halved_layers(const Stack& stack) {
    Stack halved(stack.incident, stack.substrate);
    for (Stack::Item item : stack.items) {
        if (item.kind == Stack::Kind::layer || item.kind == Stack::Kind::incoherent_layer) {
            item.thickness_nm *= 0.5;
            halved.items.push_back(item);
        }
        halved.items.push_back(item);
    }
    return halved;
}

TEST(RandomStacks, DoNotNoticeThatALayerIsSplit) {
    for (int i = 0; i < stack_count; ++i) {
        const HardCase whole = RandomCase(i).hard_case;
        const HardCase halved = with(whole, with_halved_layers(whole.stack));
        expect_equal(whole, scalar_response(whole), scalar_response(halved), "halved, scalar");
        expect_equal(whole, solver_response(whole), solver_response(halved), "halved, solver");
    }
}

TEST(RandomStacks, KnowNoLengthButTheWavelength) {
    for (int i = 0; i < stack_count; ++i) {
        const HardCase once = RandomCase(i).hard_case;
        HardCase twice = once;
        twice.wavelength_nm *= 2.0;
        for (Stack::Item& item : twice.stack.items) item.thickness_nm *= 2.0;
        // A power of two is not rounded: the same bits.
        EXPECT_EQ(scalar_response(once), scalar_response(twice)) << i;
        EXPECT_EQ(solver_response(once), solver_response(twice)) << i;
    }
}

TEST(RandomStacks, KnowNoPolarisationAtTheNormal) {
    for (int i = 0; i < stack_count; ++i) {
        HardCase normal = RandomCase(i).hard_case;
        normal.theta_deg = 0.0;
        for (const Four& got : {scalar_response(normal), solver_response(normal)}) {
            expect_equal(normal, {got[0], 0.0, got[2], 0.0}, {got[1], 0.0, got[3], 0.0}, "s and p");
        }
    }
}

TEST(RandomStacks, DoNotJumpBetweenNeighbouringDoubles) {
    for (int i = 0; i < stack_count; ++i) {
        const HardCase here = RandomCase(i).hard_case;
        HardCase there = here;
        there.theta_deg = std::nextafter(here.theta_deg, 45.0);
        expect_equal(here, scalar_response(here), scalar_response(there), "next angle, scalar");
        expect_equal(here, solver_response(here), solver_response(there), "next angle, solver");
        there = here;
        there.wavelength_nm = std::nextafter(here.wavelength_nm, 1e4);
        expect_equal(here, scalar_response(here), scalar_response(there), "next wavelength, scalar");
        expect_equal(here, solver_response(here), solver_response(there), "next wavelength, solver");
    }
}

TEST(RandomStacks, AreTheSameInEveryLaneAndOneByOne) {
    for (int i = 0; i < stack_count; ++i) {
        const HardCase base = RandomCase(i).hard_case;
        reference::Uniform uniform(static_cast<std::uint64_t>(i));
        std::vector<double> wavelengths_nm(1 + static_cast<std::size_t>(i) % 13);
        for (double& nm : wavelengths_nm) nm = uniform.between(200.0, 2000.0);
        std::vector<Response> together(wavelengths_nm.size());
        const Incidence incidence = Incidence::from_degrees(base.theta_deg);
        MultilayerSolver(layer_system(base.stack), wavelengths_nm).responses(incidence, together);
        for (std::size_t lane = 0; lane < wavelengths_nm.size(); ++lane) {
            const HardCase alone{base.name, base.stack, base.theta_deg, wavelengths_nm[lane]};
            expect_equal(alone, four(together[lane]), scalar_response(alone), "lane " + std::to_string(lane));
        }
    }
}

TEST(RandomStacks, AreWeightedAsTheirReflectancesAre) {
    for (int i = 0; i < stack_count; ++i) {
        const HardCase base = RandomCase(i).hard_case;
        reference::Uniform uniform(static_cast<std::uint64_t>(i));
        std::vector<double> wavelengths_nm(1 + static_cast<std::size_t>(i) % 13);
        for (double& nm : wavelengths_nm) nm = uniform.between(200.0, 2000.0);
        const MultilayerSolver solver(layer_system(base.stack), wavelengths_nm);
        const Incidence incidence = Incidence::from_degrees(base.theta_deg);
        std::vector<Response> responses(wavelengths_nm.size());
        solver.responses(incidence, responses);
        std::array<std::vector<double>, 3> weights;
        std::array<double, 3> expected{};
        for (std::size_t j = 0; j < 3; ++j) {
            weights[j].assign(solver.padded_count(), 0.0);
            for (std::size_t at = 0; at < wavelengths_nm.size(); ++at) {
                weights[j][at] = uniform.between(0.0, 1.0);
                expected[j] += weights[j][at] * responses[at].reflectance();
            }
        }
        const std::array<double, 3> sums =
            solver.weighted_reflectances(incidence, {weights[0].data(), weights[1].data(), weights[2].data()});
        // At most 13 terms below 1 in another order.
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(sums[j], expected[j], 1e-14) << i;
    }
}

TEST(RandomStacks, AreExact) {
    Family family;
    for (int i = 0; i < stack_count; i += 5) family.expect_exact(RandomCase(i).hard_case);
}

}  // namespace
}  // namespace nacre::hard_cases
