#include "nacre/optics/mie.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "reference/exact_mie.h"

namespace nacre {
namespace {

using reference::distance;
using reference::relative_distance;
using Complex = std::complex<double>;

struct Case {
    double x;
    Complex m;
};

// Small and large, dielectric, bubble, metal, black; absorption of every size beside scattering of every other.
const std::vector<Case> hard_spheres{
    {1e-6, 1.5},          {1e-6, {1.5, 1e-12}},  {1e-6, {1.5, 1e-18}}, {1e-6, {0.2, 3.4}},  {1e-6, {100.0, 100.0}},
    {1e-4, {1.33, 1e-9}}, {1e-3, {0.05, 1.4}},   {1e-3, {1e3, 1e3}},   {0.02, {0.0, 5.0}},  {0.0999, {1.5, 1e-10}},
    {0.1, 0.75},          {0.3, {1.0, 1e-3}},    {0.5, {20.0, 1e-3}},  {0.99, 2.5},         {1.0, 1.5},
    {1.01, {0.13, 3.1}},  {3.0, {1.33, 1e-8}},   {8.0, 1e-3},          {10.0, {0.0, 3.0}},  {10.0, {10.0, 10.0}},
    {30.0, 1.59},         {100.0, {1.5, 1e-14}}, {100.0, 0.75},        {1e3, {1.5, 1e-12}}, {1e3, 1.1},
    {1e3, {0.7, 0.3}},    {1e4, {1.5, 1.0}},     {1e4, {0.1, 5.0}},    {1e4, {1.33, 1e-5}}, {1e4, 0.9},
};

double larger(double left, double right) {
    return left < right ? right : left;
}

TEST(MieSphere, AgreesWithFiftyDigitsFromTinySpheresToDrops) {
    for (const Case& hard : hard_spheres) {
        const MieSphere sphere = mie_sphere(hard.x, hard.m);
        const reference::ExactMie exact = reference::exact_mie(hard.x, hard.m);
        // What m and x are rounded to moves the phase inside by up to 1e4 * 1e-16: 1e-12; most are 1e-15.
        EXPECT_LT(relative_distance(sphere.q_sca, exact.q_sca), 1e-12) << hard.x << hard.m;
        EXPECT_LT(relative_distance(sphere.q_ext, exact.q_ext), 1e-12) << hard.x << hard.m;
        EXPECT_LT(distance(mie_asymmetry(sphere, hard.x), exact.g), 1e-12) << hard.x << hard.m;
        if (hard.m.real() > 0.0 && hard.m.imag() > 0.0)
            EXPECT_LT(relative_distance(sphere.q_abs, exact.q_abs()), 1e-12) << hard.x << hard.m;
        else
            EXPECT_EQ(sphere.q_abs, 0.0) << hard.x << hard.m;
    }
}

TEST(MieSphere, HasTheAmplitudesThatFiftyDigitsHave) {
    for (const Case& hard : hard_spheres) {
        const MieSphere sphere = mie_sphere(hard.x, hard.m);
        const reference::ExactMie exact = reference::exact_mie(hard.x, hard.m);
        const double forward = std::abs(mie_amplitudes(sphere, 1.0).s1);
        for (const double cosine : {1.0, 0.9999, 0.3, 0.0, -0.7, -1.0}) {
            const ScatteringAmplitudes amplitudes = mie_amplitudes(sphere, cosine);
            const reference::ExactAmplitudes wanted = reference::exact_amplitudes(exact, cosine);
            const double error = larger(larger(distance(amplitudes.s1.real(), wanted.s1.real()),
                                               distance(amplitudes.s1.imag(), wanted.s1.imag())),
                                        larger(distance(amplitudes.s2.real(), wanted.s2.real()),
                                               distance(amplitudes.s2.imag(), wanted.s2.imag())));
            // Coefficients that are left out are of the size of 1e-12, the first of them.
            EXPECT_LT(error, 1e-11 * forward) << hard.x << hard.m << " " << cosine;
        }
    }
}

TEST(MieSphere, LosesDigitsOnlyInProportionAsItVanishesInItsMedium) {
    for (const double contrast : {1e-3, 1e-6, 1e-9}) {
        for (const double x : {0.01, 1.0, 50.0}) {
            const Complex m(1.0 + contrast, 0.1 * contrast);
            const reference::ExactMie exact = reference::exact_mie(x, m);
            const MieSphere sphere = mie_sphere(x, m);
            EXPECT_LT(relative_distance(sphere.q_sca, exact.q_sca), 1e-14 / contrast) << x << m;
            EXPECT_LT(relative_distance(sphere.q_abs, exact.q_abs()), 1e-12) << x << m;
        }
    }
    const MieSphere none = mie_sphere(3.0, 1.0);
    EXPECT_EQ(none.q_ext, 0.0);
    EXPECT_EQ(mie_asymmetry(none, 3.0), 0.0);
    EXPECT_EQ(mie_amplitudes(none, 0.5).s1, 0.0);
}

// Bohren & Huffman 1983, appendix A, the sample of BHMIE: radius 0.525 um at 0.6328 um, m = 1.55.
TEST(MieSphere, IsTheSampleOfBohrenAndHuffman) {
    const double x = 2.0 * std::numbers::pi * 0.525 / 0.6328;
    const MieSphere sphere = mie_sphere(x, 1.55);
    EXPECT_NEAR(sphere.q_sca, 3.10543, 5e-6);
    EXPECT_NEAR(sphere.q_ext, 3.10543, 5e-6);
    EXPECT_NEAR(4.0 / (x * x) * std::norm(mie_amplitudes(sphere, -1.0).s1), 2.92534, 5e-6);
}

// Wiscombe 1979, Mie scattering calculations, NCAR/TN-140+STR, its test cases, to the decimals printed.
TEST(MieSphere, IsWhatWiscombePrinted) {
    struct Printed {
        Case sphere;
        double q_ext, q_sca;
    };
    const std::vector<Printed> printed{
        {{0.099, 0.75}, 0.000007, 0.000007},
        {{0.101, 0.75}, 0.000008, 0.000008},
        {{10.0, 0.75}, 2.232265, 2.232265},
        {{1000.0, 0.75}, 1.997908, 1.997908},
        {{10.0, 1.5}, 2.881999, 2.881999},
        {{100.0, 1.5}, 2.094388, 2.094388},
        {{1000.0, 1.5}, 2.013945, 2.013945},
        {{0.055, {1.5, 1.0}}, 0.101491, 0.000011},
        {{1.0, {1.5, 1.0}}, 2.336321, 0.663454},
        {{100.0, {1.5, 1.0}}, 2.097502, 1.283697},
        {{10000.0, {1.5, 1.0}}, 2.004368, 1.236574},
        {{1.0, {10.0, 10.0}}, 2.532993, 2.049405},
        {{100.0, {10.0, 10.0}}, 2.071124, 1.836785},
        {{10000.0, {10.0, 10.0}}, 2.005914, 1.795393},
        {{1.0, {1.33, 1e-5}}, 0.093952, 0.093923},
        {{100.0, {1.33, 1e-5}}, 2.101321, 2.096594},
        {{10000.0, {1.33, 1e-5}}, 2.004089, 1.723857},
    };
    for (const Printed& row : printed) {
        const MieSphere sphere = mie_sphere(row.sphere.x, row.sphere.m);
        EXPECT_NEAR(sphere.q_ext, row.q_ext, 5.1e-7) << row.sphere.x << row.sphere.m;
        EXPECT_NEAR(sphere.q_sca, row.q_sca, 5.1e-7) << row.sphere.x << row.sphere.m;
    }
}

// Bohren & Huffman 5.8 and 5.11; what comes next is smaller by x^2, times a factor of the order of |m|^2.
TEST(MieSphere, TendsToTheDipoleOfRayleigh) {
    for (const Complex m : {Complex(1.5), Complex(0.75), Complex(1.33, 1e-7), Complex(1.7, 0.3), Complex(0.2, 3.0)}) {
        for (const double x : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
            const Complex dipole = (m * m - 1.0) / (m * m + 2.0);
            const MieSphere sphere = mie_sphere(x, m);
            const double next = 1e-13 + 10.0 * x * x;
            EXPECT_NEAR(sphere.q_sca / (8.0 / 3.0 * std::pow(x, 4.0) * std::norm(dipole)), 1.0, next) << x << m;
            // Without absorption both are 0.
            EXPECT_NEAR(sphere.q_abs, 4.0 * x * dipole.imag(), (1e-8 + next) * sphere.q_abs) << x << m;
            const ScatteringAmplitudes across = mie_amplitudes(sphere, 0.5);
            EXPECT_NEAR(std::abs(across.s2) / std::abs(across.s1), 0.5, next) << x << m;
        }
    }
}

TEST(MieSphere, TakesFromTheBeamWhatItsForwardAmplitudeSays) {
    for (const Case& hard : hard_spheres) {
        const MieSphere sphere = mie_sphere(hard.x, hard.m);
        const ScatteringAmplitudes forward = mie_amplitudes(sphere, 1.0);
        // The real part of a tiny sphere's amplitude is what is left of it: rounding is that of the whole.
        EXPECT_NEAR(sphere.q_ext, 4.0 / (hard.x * hard.x) * forward.s1.real(),
                    1e-12 * 4.0 / (hard.x * hard.x) * std::abs(forward.s1))
            << hard.x << hard.m;
    }
}

TEST(MieSphere, DoesNotKnowPolarisationStraightAheadAndStraightBack) {
    for (const Case& hard : hard_spheres) {
        const MieSphere sphere = mie_sphere(hard.x, hard.m);
        const ScatteringAmplitudes ahead = mie_amplitudes(sphere, 1.0);
        const ScatteringAmplitudes back = mie_amplitudes(sphere, -1.0);
        const double rounding = 1e-13 * std::abs(ahead.s1);
        EXPECT_LE(std::abs(ahead.s1 - ahead.s2), rounding) << hard.x << hard.m;
        EXPECT_LE(std::abs(back.s1 + back.s2), rounding) << hard.x << hard.m;
    }
}

TEST(MieSphere, ScattersLessThanItTakesWhateverItIsMadeOf) {
    reference::Uniform uniform(20260101);
    for (int i = 0; i < 10000; ++i) {
        const double x = std::pow(10.0, uniform.between(-6.0, i % 50 == 0 ? 4.0 : 2.5));
        const double n = std::pow(10.0, uniform.between(-3.0, 1.5));
        const double k = i % 4 == 0 ? 0.0 : std::pow(10.0, uniform.between(-16.0, 1.5));
        const MieSphere sphere = mie_sphere(x, Complex(i % 97 == 0 ? 0.0 : n, i % 97 == 0 ? k + 0.1 : k));
        ASSERT_TRUE(std::isfinite(sphere.q_ext) && std::isfinite(mie_asymmetry(sphere, x)))
            << x << " " << n << " " << k;
        ASSERT_TRUE(0.0 < sphere.q_sca && sphere.q_sca <= sphere.q_ext) << x << " " << n << " " << k;
        const ScatteringAmplitudes amplitudes = mie_amplitudes(sphere, uniform.between(-1.0, 1.0));
        ASSERT_TRUE(std::isfinite(std::norm(amplitudes.s1) + std::norm(amplitudes.s2))) << x << " " << n << " " << k;
    }
}

}  // namespace
}  // namespace nacre
