// Metals that are given by a renderer's F0 and edge tint: the index against the definition of a reflectance, the colour
// against the reference model's light.
#include "nacre/pick/coloured_metal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/shade/spectra.h"
#include "reference/colour.h"
#include "reference/dice.h"
#include "reference/light.h"

namespace nacre {
namespace {

using Complex = std::complex<double>;
using Rec709 = std::array<double, 3>;

// Between vacuum and a half-space, at normal incidence.
double reflectance_of(const RefractiveIndex& index) {
    return std::norm((index - 1.0) / (index + 1.0));
}

// ---- One wavelength

TEST(MetalIndex, ReflectsWhatItWasMadeFor) {
    for (const double reflectance : {0.0, 1e-9, 0.04, 0.2, 0.5, 0.9, 0.99, 0.999999}) {
        EXPECT_NEAR(reflectance_of(metal_index(reflectance)), reflectance, 1e-12) << reflectance;
        for (const double tint : {0.0, 1e-6, 0.3, 0.9, 0.999, 1.0}) {
            const RefractiveIndex index = metal_index(reflectance, tint);
            EXPECT_NEAR(reflectance_of(index), reflectance, 1e-12) << reflectance << " " << tint;
            EXPECT_GE(index.imag(), 0.0);
            EXPECT_GT(index.real(), 0.0);
        }
    }
}

// As the article prints it: equations for n from r and g, and for k^2 from r and n.
TEST(MetalIndex, IsGulbrandsens) {
    for (const double r : {0.04, 0.3, 0.7, 0.95}) {
        for (const double g : {0.0, 0.2, 0.8, 0.99, 1.0}) {
            const double n = g * (1 - r) / (1 + r) + (1 - g) * (1 + std::sqrt(r)) / (1 - std::sqrt(r));
            const double square = (r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r);
            const RefractiveIndex index = metal_index(r, g);
            EXPECT_NEAR(index.real(), n, 1e-13 * n);
            EXPECT_NEAR(index.imag() * index.imag(), square, 1e-11 * (1 + square + n * n)) << r << " " << g;
        }
    }
}

// Silver, gold and chromium at 550 nm (Johnson and Christy): from the index to R and g, and back.
TEST(MetalIndex, ComesBackFromReflectanceAndTint) {
    for (const RefractiveIndex& metal : {Complex(0.06, 3.6), Complex(0.42, 2.47), Complex(3.18, 3.33)}) {
        const double r = reflectance_of(metal);
        const double least = (1 - r) / (1 + r), most = (1 + std::sqrt(r)) / (1 - std::sqrt(r));
        const RefractiveIndex index = metal_index(r, (most - metal.real()) / (most - least));
        EXPECT_NEAR(index.real(), metal.real(), 1e-11);
        EXPECT_NEAR(index.imag(), metal.imag(), 1e-11);
    }
}

TEST(MetalIndex, WithoutTintHasTheTintOfAnIndexOf1) {
    for (const double r : {0.0, 0.04, 0.5, 0.9, 0.999}) {
        const RefractiveIndex index = metal_index(r, (1 + r) / (1 + std::sqrt(r)));
        EXPECT_EQ(metal_index(r).real(), 1.0);
        EXPECT_NEAR(index.real(), 1.0, 1e-12 / (1 - r));
        EXPECT_NEAR(index.imag(), metal_index(r).imag(), 1e-12 / (1 - r));
    }
}

TEST(MetalIndex, WithoutAnyTintIsADielectric) {
    EXPECT_EQ(metal_index(0.04, 0.0), Complex(1.5, 0.0));
    EXPECT_EQ(metal_index(0.0, 0.0), Complex(1.0, 0.0));
    EXPECT_EQ(metal_index(0.0), Complex(1.0, 0.0));
}

// ---- Colours

// Of a bare surface at normal incidence, by the trapezium rule over whole nanometres.
Rec709 colour_of(const IndexCurve& metal) {
    const auto& light = reference::ModelLight::of("D65", 2);
    reference::Triple seen{};
    for (std::size_t i = 0; i < light.weights().size(); ++i) {
        const bool is_end = i == 0 || i + 1 == light.weights().size();
        const double reflectance = reflectance_of(metal.at(reference::light_begins_nm + static_cast<double>(i)));
        for (std::size_t c = 0; c < 3; ++c) seen[c] += (is_end ? 0.5 : 1.0) * reflectance * light.weights()[i][c];
    }
    return reference::to_rec709(light.adapted(seen));
}

double largest_error(const Rec709& one, const Rec709& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(one[i] - other[i]));
    return largest;
}

// The reflectance is between 0 and 1, and has one hill or valley at most.
void expect_smooth(const IndexCurve& metal) {
    int turns = 0;
    double before = 0.0, last = reflectance_of(metal.at(360.0));
    for (double nm = 361.0; nm <= 830.0; nm += 1.0) {
        const double here = reflectance_of(metal.at(nm));
        ASSERT_GE(here, 0.0) << nm;
        ASSERT_LT(here, 1.0) << nm;
        const double step = here - last;
        last = here;
        if (std::abs(step) < 1e-11) continue;  // rounding, of n + ik as well
        if (before * step < 0.0) ++turns;
        before = step;
    }
    EXPECT_LE(turns, 1);
}

Rec709 thrown(reference::Dice& dice, double most) {
    return {dice.between(0.0, most), dice.between(0.0, most), dice.between(0.0, most)};
}

TEST(ColouredMetal, HasTheColourThatItWasMadeFor) {
    reference::Dice dice(20141);
    double worst = 0.0;
    for (int i = 0; i < 10000; ++i) {
        MetalColour colour{thrown(dice, most_f0)};
        if (dice.chance(0.5)) colour.edge_tint = thrown(dice, 1.0);
        const auto metal = coloured_metal(colour);
        SCOPED_TRACE(testing::PrintToString(colour.f0));
        expect_smooth(*metal);
        worst = std::max(worst, largest_error(colour_of(*metal), colour.f0));
    }
    EXPECT_LT(worst, 1e-9);
}

// Faces, edges and corners of the cube, and what is nearly on them.
TEST(ColouredMetal, HasPureColoursToo) {
    const std::array values{0.0, 1e-4, 0.04, 0.5, 0.999, most_f0};
    for (const double r : values) {
        for (const double g : values) {
            for (const double b : values) {
                const auto metal = coloured_metal({{r, g, b}, {}});
                SCOPED_TRACE(testing::PrintToString(Rec709{r, g, b}));
                expect_smooth(*metal);
                EXPECT_LT(largest_error(colour_of(*metal), {r, g, b}), 1e-9);
            }
        }
    }
}

TEST(ColouredMetal, OfBlackIsAir) {
    const auto metal = coloured_metal({});
    EXPECT_TRUE(metal->is_lossless());
    for (const double nm : {360.0, 555.5, 830.0}) EXPECT_EQ(metal->at(nm), Complex(1.0, 0.0));
}

TEST(ColouredMetal, OfGreyDoesNotDependOnTheWavelength) {
    const auto metal = coloured_metal({{most_f0, most_f0, most_f0}, Rec709{0.5, 0.5, 0.5}});
    EXPECT_FALSE(metal->is_dispersive());
    EXPECT_NEAR(reflectance_of(metal->at(500.0)), most_f0, 1e-12);
}

TEST(ColouredMetal, ThatIsScaledKeepsItsProportions) {
    const MetalColour gold{{0.8, 0.6, 0.2}, Rec709{1.0, 0.9, 0.8}};
    EXPECT_EQ(with_f0(gold, 0.8), gold);
    const MetalColour dark = with_f0(gold, 0.4);
    EXPECT_LT(largest_error(dark.f0, {0.4, 0.3, 0.1}), 1e-15);
    EXPECT_EQ(dark.edge_tint, gold.edge_tint);
    EXPECT_EQ(with_f0({}, 0.3).f0, (Rec709{0.3, 0.3, 0.3}));
}

// ---- Under a film

// Born and Wolf, section 1.6: r = (r1 + r2 e) / (1 + r1 r2 e), e = exp(2 i phase); s and p from n cos and n / cos.
double film_over(const RefractiveIndex& substrate, double n, double thickness_nm, double nm, double cosine) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const auto inside = [&](const Complex& index) { return std::sqrt(1.0 - sine * sine / (index * index)); };
    const Complex film_cosine = inside(n), metal_cosine = inside(substrate);
    const Complex bounce = std::exp(Complex(0.0, 4.0 * std::numbers::pi * thickness_nm / nm) * n * film_cosine);
    const auto reflectance = [&](const Complex& air, const Complex& film, const Complex& metal) {
        const Complex top = (air - film) / (air + film), bottom = (film - metal) / (film + metal);
        return std::norm((top + bottom * bounce) / (1.0 + top * bottom * bounce));
    };
    return 0.5 * (reflectance(cosine, n * film_cosine, substrate * metal_cosine) +
                  reflectance(1.0 / cosine, n / film_cosine, substrate / metal_cosine));
}

TEST(ColouredMetal, UnderAFilmReflectsAsTheTextbookSays) {
    for (const auto& tint : {std::optional<Rec709>(), std::optional<Rec709>(Rec709{0.2, 0.95, 0.99})}) {
        for (const Rec709& f0 : {Rec709{0.95, 0.7, 0.2}, {0.04, 0.04, 0.04}, {most_f0, 0.5, 0.0}}) {
            const auto metal = coloured_metal({f0, tint});
            const Film film{1.0, 1.5, 400.0, Index(metal)};
            for (const double cosine : {1.0, 0.8, 0.3, 0.05}) {
                const Spectrum spectrum = observed_spectrum(film, Incidence::from_cos(cosine), WavelengthGrid{});
                for (const int node : {0, 100, 195, 333, 470}) {
                    const double nm = 360.0 + node;
                    EXPECT_NEAR(spectrum.value[static_cast<std::size_t>(node)],
                                film_over(metal->at(nm), 1.5, 400.0, nm, cosine), 1e-11)
                        << nm << " " << cosine;
                }
            }
        }
    }
}

}  // namespace
}  // namespace nacre
