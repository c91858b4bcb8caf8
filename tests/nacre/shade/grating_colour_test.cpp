#include "nacre/shade/grating_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "reference/number.h"

namespace nacre {
namespace {

Light light_of(const std::string& illuminant, std::optional<int> wavelengths = {}) {
    LightSettings settings;
    settings.illuminant = illuminant;
    settings.power = *illuminant_by_name(illuminant);
    settings.wavelengths = wavelengths;
    return make_light(settings);
}

const Light& daylight() {
    static const Light light = light_of("D65");
    return light;
}

Grating disc(int grooves) {
    Grating grating;
    grating.grooves = grooves;
    grating.depth_nm = 120.0;
    grating.land = 0.3;
    return grating;
}

Xyz weight_at(const TristimulusWeights& weights, double nm) {
    const auto cell = std::min(static_cast<std::size_t>(nm - weights.first_nm), std::size_t(weights.count()) - 2);
    const double along = nm - weights.first_nm - static_cast<double>(cell);
    const auto at = [&](const std::vector<double>& weight) {
        return (1.0 - along) * weight[cell] + along * weight[cell + 1];
    };
    return {at(weights.x), at(weights.y), at(weights.z)};
}

template <class Function>  // Xyz of a wavelength
Xyz integral(const Function& function, double from, double to, int parts) {
    using Rule = boost::math::quadrature::gauss<double, 10>;
    Xyz sum;
    for (int part = 0; part < parts; ++part) {
        const double half = 0.5 * (to - from) / parts, middle = from + (2 * part + 1) * half;
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
            for (const double sign : {-1.0, 1.0}) {
                const Xyz value = function(middle + sign * half * Rule::abscissa()[i]);
                sum.x += half * Rule::weights()[i] * value.x;
                sum.y += half * Rule::weights()[i] * value.y;
                sum.z += half * Rule::weights()[i] * value.z;
            }
        }
    }
    return sum;
}

// The second road: Gauss and Legendre over the density itself, with `parts` stretches per nanometre, each a small part
// of a line. @param change_per_nm  phase of whatever else is steep
Xyz brute_force(const Grating& grating, const Light& light, double u, double change_per_nm = 0.0) {
    const std::vector<int> orders = counted_orders(grating, light.settings.first_nm);
    Xyz sum;
    for (int nm = light.settings.first_nm; nm < light.settings.last_nm; ++nm) {
        // Ten nodes for half a ripple, or half a radian.
        const double ripples = grating.grooves * u * grating.period_nm / (static_cast<double>(nm) * nm);
        const int parts = 1 + static_cast<int>(2.0 * ripples + 2.0 * change_per_nm);
        const Xyz cell = integral(
            [&](double wavelength_nm) {
                const double density = grating_density(grating, orders, u, wavelength_nm);
                const Xyz weight = weight_at(light.weights, wavelength_nm);
                return Xyz{density * weight.x, density * weight.y, density * weight.z};
            },
            nm, nm + 1.0, parts);
        sum = {sum.x + cell.x, sum.y + cell.y, sum.z + cell.z};
    }
    return sum;
}

// The largest difference of a component, in parts of it.
double difference(const Xyz& seen, const Xyz& expected) {
    const auto relative = [](double a, double b) { return a == b ? 0.0 : std::abs(a - b) / std::abs(b); };
    return std::max({relative(seen.x, expected.x), relative(seen.y, expected.y), relative(seen.z, expected.z)});
}

// What N without end comes to: sum of efficiency * (d / m) * weight at the wavelength u d / m.
Xyz ideal_lines(const Grating& grating, const Light& light, double u) {
    Xyz sum;
    for (const int m : counted_orders(grating, light.settings.first_nm)) {
        const double per_order_nm = grating.period_nm / m;
        const double wavelength_nm = u * per_order_nm;
        if (wavelength_nm < light.settings.first_nm || wavelength_nm > light.settings.last_nm) continue;
        const double power = grating_efficiency(grating, m, wavelength_nm) * per_order_nm;
        const Xyz weight = weight_at(light.weights, wavelength_nm);
        sum = {sum.x + power * weight.x, sum.y + power * weight.y, sum.z + power * weight.z};
    }
    return sum;
}

TEST(GratingColour, EqualsQuadratureOverWavelengthsFarFinerThanItsLines) {
    for (const int grooves : {1, 2, 10, 40, 100, 1000}) {
        Grating sinusoidal = disc(grooves);
        sinusoidal.profile = GratingProfile::sinusoidal;
        sinusoidal.coat = Index(RefractiveIndex{0.9, 6.5});
        sinusoidal.orders = {0, 1, 3, 4};
        for (const Grating& grating : {disc(grooves), sinusoidal}) {
            const GratingColour colour(grating, daylight());
            for (const double u : {1e-5, 0.003, 0.29, 0.55, 0.7, 1.21, 2.0}) {
                if (grooves == 1000 && u > 1.0) continue;  // to save time: 30 lines, but the same
                // 2e-7: the header's.
                EXPECT_LT(difference(colour.at(u), brute_force(grating, daylight(), u)), 2e-7) << grooves << ' ' << u;
            }
        }
    }
}

TEST(GratingColour, EqualsQuadratureForRandomGratings) {
    reference::Uniform random(11);
    for (int i = 0; i < 150; ++i) {
        Grating grating = disc(static_cast<int>(std::exp(random.between(0.0, 6.0))));
        grating.profile = i % 2 == 0 ? GratingProfile::lamellar : GratingProfile::sinusoidal;
        grating.land = random.between(0.05, 0.95);
        grating.period_nm = std::exp(random.between(5.3, 8.5));
        grating.depth_nm = random.between(5.0, 400.0);
        const double u = random.between(0.0, 2.0);
        const Xyz seen = GratingColour(grating, daylight()).at(u), expected = brute_force(grating, daylight(), u);
        EXPECT_NEAR(seen.x, expected.x, 2e-7 * expected.x + 3e-8) << i;  // the header's
        EXPECT_NEAR(seen.y, expected.y, 2e-7 * expected.y + 3e-8) << i;
        EXPECT_NEAR(seen.z, expected.z, 2e-7 * expected.z + 3e-8) << i;
    }
}

TEST(GratingColour, EqualsQuadratureUnderLampsWithSteepSpectraToo) {
    const Light lamp = light_of("FL11");
    for (const int grooves : {1, 30, 300}) {
        const GratingColour colour(disc(grooves), lamp);
        for (const double u : {0.2, 0.343, 0.9})
            EXPECT_LT(difference(colour.at(u), brute_force(disc(grooves), lamp, u)), 2e-7) << grooves << ' ' << u;
    }
}

TEST(GratingColour, EqualsQuadratureForLongPeriodsWithManyOrdersInANanometre) {
    Grating grating = disc(3);
    grating.period_nm = 2e5;
    const GratingColour colour(grating, daylight());
    for (const double u : {1e-3, 0.01, 0.05})
        EXPECT_LT(difference(colour.at(u), brute_force(grating, daylight(), u, 0.5)), 5e-7) << u;
}

TEST(GratingColour, EqualsQuadratureForProfilesWhoseOrdersFlickerWithinANanometre) {
    // 20 um deep: the phase changes by up to 1.9 per nanometre.
    for (const GratingProfile profile : {GratingProfile::lamellar, GratingProfile::sinusoidal}) {
        Grating grating = disc(50);
        grating.profile = profile;
        grating.depth_nm = 20000.0;
        const GratingColour colour(grating, daylight());
        for (const double u : {0.1, 0.35, 0.8})
            EXPECT_LT(difference(colour.at(u), brute_force(grating, daylight(), u, 2.0)), 2e-6) << u;
    }
}

TEST(GratingColour, EqualsQuadratureBesideThePlaneAcrossTheGrooves) {
    for (const double groove_length_um : {0.5, 3.0, 12.0}) {
        for (const double azimuth_deg : {5.0, 60.0, 90.0}) {
            Grating grating = disc(20);
            grating.orders = {0, 1, 2};
            grating.groove_length_um = groove_length_um;
            grating.azimuth_deg = azimuth_deg;
            const GratingColour colour(grating, daylight());
            for (const double u : {0.02, 0.3, 0.5}) {
                // Down to exp(-400): where next to nothing is left it is right too. 5e-6: the factor's parabolas, 1e-6
                // each at worst, under a line whose own accuracy is the header's.
                const double steepness = 2.0 * azimuth_exponent(grating, u, 360.0) / 360.0;
                if (azimuth_exponent(grating, u, 360.0) > 400.0) continue;
                EXPECT_LT(difference(colour.at(u), brute_force(grating, daylight(), u, steepness)), 5e-6)
                    << groove_length_um << ' ' << azimuth_deg << ' ' << u;
            }
        }
    }
}

TEST(GratingColour, LinesOfAMillionGroovesAreIdeal) {
    const GratingColour colour(disc(1000000), daylight());
    reference::Uniform random(5);
    for (int i = 0; i < 100; ++i) {
        const double u = random.between(0.0, 2.0);
        const Xyz seen = colour.at(u), expected = ideal_lines(disc(1000000), daylight(), u);
        // Tails: the weights under them, 1 / (2 pi^2) of a line's width (8e-4 nm at most) times the line's colour (7.5
        // at most) over the some 10 nm in which weights change. What they are exactly is the next test's.
        EXPECT_NEAR(seen.x, expected.x, 3e-5) << u;
        EXPECT_NEAR(seen.y, expected.y, 3e-5) << u;
        EXPECT_NEAR(seen.z, expected.z, 3e-5) << u;
    }
}

// Quadrature that can afford a million grooves: beyond `far` widths from a line its sin^2 counts as its mean, 1/2.
Xyz brute_force_of_narrow_lines(const Grating& grating, const Light& light, double u) {
    constexpr double far = 500.0;
    const double n = grating.grooves;
    const std::vector<int> orders = counted_orders(grating, light.settings.first_nm);
    const auto integrand = [&](double nm) {
        double sum = 0.0;
        for (const int m : orders) {
            for (const int sign : {-1, 1}) {
                const double angle = 3.14159265358979324 * n * (u * grating.period_nm / nm - sign * m);
                const double wave = std::abs(angle) > 3.14159265358979324 * far ? std::sqrt(0.5) : std::sin(angle);
                const double line = angle == 0.0 ? 1.0 : wave / angle;
                sum += grating_efficiency(grating, m, nm) * line * line;
            }
        }
        const double density = sum * n * grating.period_nm / nm;
        const Xyz weight = weight_at(light.weights, nm);
        return Xyz{density * weight.x, density * weight.y, density * weight.z};
    };
    std::vector<double> ends;
    for (int nm = light.settings.first_nm; nm <= light.settings.last_nm; ++nm) ends.push_back(nm);
    for (const int m : orders) {
        for (const double side : {-far, 0.0, far}) {
            const double nm = u * grating.period_nm / (m + side / n);
            if (nm > light.settings.first_nm && nm < light.settings.last_nm) ends.push_back(nm);
        }
    }
    std::sort(ends.begin(), ends.end());
    Xyz sum;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double x = u * grating.period_nm / (0.5 * (ends[i] + ends[i + 1]));
        const bool has_line = n * std::abs(x - std::nearbyint(x)) < far;
        const Xyz stretch = integral(integrand, ends[i], ends[i + 1], has_line ? 1000 : 16);
        sum = {sum.x + stretch.x, sum.y + stretch.y, sum.z + stretch.z};
    }
    return sum;
}

TEST(GratingColour, LinesOfAMillionGroovesHaveTheirTails) {
    const GratingColour colour(disc(1000000), daylight());
    // Lines in sight (at 440.05 and 549.9 nm, and two orders at once), and tails alone.
    for (const double u : {0.27503, 0.3437, 0.7, 0.2, 0.05}) {
        // The header's 2e-7, and as much for a kink of the weights in a stretch of the quadrature.
        EXPECT_LT(difference(colour.at(u), brute_force_of_narrow_lines(disc(1000000), daylight(), u)), 4e-7) << u;
    }
}

TEST(GratingColour, LinesComeNearerToIdealOnesAsGroovesGrow) {
    // 1 / N, whether from the tails or from the curvature of the weights under the line.
    double before = 0.0;
    for (const int grooves : {1000, 10000, 100000, 1000000}) {
        const double y = GratingColour(disc(grooves), daylight()).at(0.3437).y;
        const double distance = std::abs(y - ideal_lines(disc(grooves), daylight(), 0.3437).y);
        if (before > 0.0) {
            EXPECT_LT(distance, 0.2 * before) << grooves;
        }
        before = distance;
    }
}

TEST(GratingColour, SpreadsOverUTheColoursOfItsEfficiencies) {
    // Orders 1 and 2 of 1600 nm lie between u = 0.22 and 1.04.
    Grating grating = disc(500);
    grating.orders = {1, 2};
    grating.coat = Index(RefractiveIndex{0.9, 6.5});
    const GratingColour colour(grating, daylight());
    constexpr int steps = 20000;  // of a third of a line's width; Simpson
    Xyz sum;
    for (int i = 0; i <= steps; ++i) {
        const double share = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * 2.0 / steps / 3.0;
        const Xyz here = colour.at(2.0 * i / steps);
        sum = {sum.x + share * here.x, sum.y + share * here.y, sum.z + share * here.z};
    }
    const Xyz expected = integral(
        [&](double nm) {
            const Xyz weight = weight_at(daylight().weights, nm);
            double power = 0.0;
            for (const int m : grating.orders) {
                // Less the tails beyond u = 2, see EveryOrderSpreadsItsEfficiencyOverU.
                const double end = 2.0 * grating.period_nm / nm;
                const double beyond = (1.0 / (end - m) + 1.0 / (end + m)) / (2.0 * 9.869604401089358 * 500.0);
                power += grating_efficiency(grating, m, nm) * (1.0 - beyond);
            }
            return Xyz{power * weight.x, power * weight.y, power * weight.z};
        },
        360.0, 830.0, 470);
    EXPECT_LT(difference(sum, expected), 1e-6);  // Simpson's rule at the kinks of the weights, and the header's 2e-7
}

TEST(GratingColour, NothingIsSeenWhereOrdersCannotBe) {
    Grating fine = disc(100);
    fine.period_nm = 100.0;
    Grating plane = disc(100);
    plane.depth_nm = 0.0;
    Grating beside = disc(100);
    beside.azimuth_deg = 10.0;  // with endless grooves
    for (const double u : {0.01, 0.3, 2.0}) {
        EXPECT_EQ(GratingColour(fine, daylight()).at(u), Xyz{});
        EXPECT_EQ(GratingColour(plane, daylight()).at(u), Xyz{});
        EXPECT_EQ(GratingColour(beside, daylight()).at(u), Xyz{});
    }
    EXPECT_EQ(GratingColour(fine, daylight()).samples(), 0U);
    // Straight back, every order but 0 is dark: N grooves leave zeros there.
    EXPECT_EQ(GratingColour(disc(100), daylight()).at(0.0), Xyz{});
}

TEST(GratingColour, StraightBackIsOrderZeroAtItsHeight) {
    Grating grating = disc(100);
    grating.orders = {0};
    grating.profile = GratingProfile::given;
    grating.efficiency = {0.25};
    const double height = 0.5 * 100.0 * 1600.0;  // efficiency * N d / wavelength
    const Xyz expected = integral(
        [&](double nm) {
            const Xyz weight = weight_at(daylight().weights, nm);
            return Xyz{height / nm * weight.x, height / nm * weight.y, height / nm * weight.z};
        },
        360.0, 830.0, 470);
    const GratingColour colour(grating, daylight());
    for (const double u : {0.0, 5e-324, 1e-300, 1e-160, 1e-12})
        EXPECT_LT(difference(colour.at(u), expected), 1e-9) << u;
}

TEST(GratingColour, WithItsOwnWavelengthsALightIsSummedOverThem) {
    const Light light = light_of("D65", 48);
    for (const double azimuth_deg : {0.0, 30.0}) {
        Grating grating = disc(70);
        grating.orders = {0, 1, 2, 3};
        grating.azimuth_deg = azimuth_deg;
        grating.groove_length_um = 2.0;
        const GratingColour colour(grating, light);
        EXPECT_EQ(colour.samples(), 48U * 7U);
        // 0.3125: where 500 nm, a node, is exactly order 1.
        for (const double u : {0.0, 1e-9, 0.3125, 0.31250001, 0.7, 2.0}) {
            Spectrum spectrum{light.grid, {}};
            for (int node = 0; node < light.grid.count; ++node) {
                spectrum.value.push_back(grating_density(grating, grating.orders, u, light.grid.wavelength_nm(node)));
            }
            EXPECT_LT(difference(colour.at(u), to_xyz(light.grid_weights, spectrum)), 1e-10) << u;
        }
    }
}

TEST(GratingColour, InThePlaneAcrossGroovesTheirLengthChangesNoBit) {
    Grating grating = disc(100);
    const GratingColour endless(grating, daylight());
    for (const double groove_length_um : {1e-6, 1.0, 1e9}) {
        grating.groove_length_um = groove_length_um;
        const GratingColour colour(grating, daylight());
        for (const double u : {0.0, 0.31, 0.9, 2.0}) EXPECT_EQ(colour.at(u), endless.at(u)) << u;
    }
}

TEST(GratingColour, CountsItsIntegrals) {
    EXPECT_EQ(GratingColour(disc(100), daylight()).samples(), 470U * 16U);  // 2 * 1600 / 360 = 8.9
    Grating even = disc(100);
    even.land = 0.5;  // even orders are dark
    EXPECT_EQ(GratingColour(even, daylight()).samples(), 470U * 8U);
}

TEST(GratingColour, AnyGratingHasFiniteColoursThatAreNotBelowBlack) {
    reference::Uniform random(9);
    const Light few = light_of("A", 12);
    for (int i = 0; i < 120; ++i) {
        Grating grating;
        grating.period_nm = std::exp(random.between(std::log(10.0), std::log(3e4)));
        grating.grooves = static_cast<int>(std::exp(random.between(0.0, std::log(1e6))));
        grating.profile = static_cast<GratingProfile>(i % 3);
        grating.depth_nm = i % 7 == 0 ? 0.0 : std::exp(random.between(std::log(1e-3), std::log(3e3)));
        grating.land = random.between(0.0, 1.0);
        grating.efficiency = {0.2, 0.0, 1e-30, 0.1};
        if (i % 4 == 0) grating.orders = {0, 1, 2, 40};
        if (i % 5 == 0) grating.azimuth_deg = i % 10 == 0 ? 90.0 : random.between(0.0, 90.0);
        grating.groove_length_um = i % 6 == 0 ? 0.0 : std::exp(random.between(-7.0, 14.0));
        const GratingColour colour(grating, i % 11 == 0 ? few : daylight());
        for (const double u : {0.0, 1e-300, 1e-9, random.between(0.0, 2.0), random.between(0.0, 0.5), 2.0}) {
            const Xyz seen = colour.at(u);
            for (const double component : {seen.x, seen.y, seen.z})
                EXPECT_TRUE(component >= 0.0 && component < 1e10) << i << ' ' << u;  // at most N d / wavelength
        }
    }
}

TEST(GratingColour, TheLargestGratingsAreFiniteToo) {
    Grating grating = disc(1000000);
    grating.period_nm = 1e6;
    const Xyz wide = GratingColour(grating, daylight()).at(0.7);
    EXPECT_TRUE(wide.y > 0.0 && wide.y < 1e6);
    grating.period_nm = 1600.0;
    grating.depth_nm = 1e5;
    grating.profile = GratingProfile::sinusoidal;
    const Xyz deep = GratingColour(grating, daylight()).at(0.7);
    EXPECT_TRUE(deep.y > 0.0 && deep.y < 1e6);
}

}  // namespace
}  // namespace nacre
