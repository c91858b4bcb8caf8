// Metals, opaque layers alone and in products, surface plasmons, and indices near zero.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

const RefractiveIndex silver{0.05, 3.9}, aluminium{1.0, 6.7}, gold{0.3, 2.9};

TEST(Metals, FilmsOfAnyThicknessAreExact) {
    // T down to 1e-300 by its digits; below, a double knows 0 only.
    Family family(Measure::relative_in_transmittance);
    for (const RefractiveIndex metal : {silver, aluminium, gold}) {
        for (const double thickness_nm : {0.1, 10.0, 50.0, 300.0, 2e3, 5e3, 1e6}) {
            for (const double theta_deg : angles_to_grazing()) {
                family.expect_exact({"on glass", Stack(1.0, 1.52).layer(metal, thickness_nm), theta_deg, 550.0});
                family.expect_exact({"under glass", Stack(1.52, 1.0).layer(metal, thickness_nm), theta_deg, 550.0});
            }
        }
    }
}

TEST(OpaqueLayers, InProductsAreExact) {
    Family family(Measure::relative_in_transmittance);
    for (const int repeat : {1, 3, 100, 10000}) {
        for (const double theta_deg : {0.0, 45.0, 85.0, 90.0}) {
            family.expect_exact(
                {"metal and glass",
                 Stack(1.0, 1.52).begin_group(repeat).layer(silver, 200.0).layer(1.46, 100.0).end_group(), theta_deg});
            family.expect_exact({"three metals",
                                 Stack(1.0, 1.52)
                                     .begin_group(repeat)
                                     .layer(silver, 500.0)
                                     .layer(aluminium, 500.0)
                                     .layer(gold, 500.0)
                                     .end_group(),
                                 theta_deg});
            family.expect_exact({"thin metal",
                                 Stack(1.0, 1.52).begin_group(repeat).layer(gold, 5.0).layer(1.46, 100.0).end_group(),
                                 theta_deg});
        }
    }
}

TEST(OpaqueLayers, WrittenOutOneByOneAreExact) {
    Family family(Measure::relative_in_transmittance);
    Stack layers(1.0, 1.52);
    for (int i = 0; i < 300; ++i) layers.layer(i % 2 == 0 ? silver : aluminium, 100.0 + i);
    Stack beneath(1.0, silver);
    beneath.layer(1.46, 100.0);
    for (int i = 0; i < 50; ++i) beneath.layer({1.5, 0.2}, 5e4);
    for (const double theta_deg : {0.0, 60.0, 89.9999}) {
        family.expect_exact({"three hundred", layers, theta_deg});
        family.expect_exact({"under a film", beneath, theta_deg});
    }
}

TEST(SurfacePlasmons, KretschmannsDipIsExact) {
    Family family;
    double least = 1.0, most = 0.0;
    for (double theta_deg = 40.0; theta_deg < 46.0; theta_deg += 0.0731) {
        const HardCase prism{"Kretschmann", Stack(1.515, 1.0).layer({0.0561, 4.2755}, 50.0), theta_deg, 632.8};
        family.expect_exact(prism);
        least = std::min(least, scalar_response(prism)[1]);
        most = std::max(most, scalar_response(prism)[1]);
    }
    // The dip has been among the angles (Raether 1988, Surface Plasmons, section 2.5: nearly all is absorbed).
    EXPECT_LT(least, 0.2);
    EXPECT_GT(most, 0.9);
}

TEST(SurfacePlasmons, OttosDipIsExact) {
    Family family;
    double least = 1.0;
    for (const double gap_nm : {300.0, 700.0, 1100.0, 5000.0}) {
        for (double theta_deg = 41.0; theta_deg < 46.0; theta_deg += 0.0917) {
            const HardCase prism{"Otto", Stack(1.515, {0.0561, 4.2755}).layer(1.0, gap_nm), theta_deg, 632.8};
            family.expect_exact(prism);
            least = std::min(least, scalar_response(prism)[1]);
        }
    }
    EXPECT_LT(least, 0.3);
}

TEST(SurfacePlasmons, ALineOfHardlyAnyLossIsExact) {
    // Long-range plasmons of a symmetric film.
    Family family;
    const RefractiveIndex ideal{1e-5, 4.2755};
    for (double theta_deg = 66.0; theta_deg < 68.0; theta_deg += 0.0371) {
        family.expect_exact({"long range", Stack(1.6, 1.46).layer(1.46, 2000.0).layer(ideal, 20.0), theta_deg, 632.8});
    }
}

TEST(NearZeroIndex, IsExact) {
    Family family;
    for (const RefractiveIndex index :
         {RefractiveIndex{1e-3, 1e-6}, RefractiveIndex{1e-3, 0.0}, RefractiveIndex{0, 1e-3},
          RefractiveIndex{1e-6, 1e-3}, RefractiveIndex{0.3, 0.3}, RefractiveIndex{1e-6, 1e-6}}) {
        for (const double theta_deg : {0.0, 1e-9, 0.01, 0.0573, 1.0, 30.0, 89.9999, 90.0}) {
            for (const double thickness_nm : {1.0, 100.0, 1e4}) {
                family.expect_exact({"film", Stack(1.0, 1.52).layer(index, thickness_nm), theta_deg});
                family.expect_exact(
                    {"in a group",
                     Stack(1.0, 1.52).begin_group(20).layer(index, thickness_nm).layer(1.46, 80.0).end_group(),
                     theta_deg});
            }
            family.expect_exact({"substrate", Stack(1.0, index).layer(1.46, 80.0), theta_deg});
        }
    }
}

TEST(NearZeroIndex, AWaveAlongALayerOfIndexOneThousandthIsExact) {
    // sin(theta) = 1e-3 exactly where q = 0, and p sees an admittance n^2 / q of nothing over nothing.
    Family family;
    const double critical_deg = std::asin(1e-3) * 180.0 / std::numbers::pi;
    for (const double relative : {0.0, 1e-15, -1e-15, 1e-9, -1e-9, 1e-3, -1e-3}) {
        for (const double thickness_nm : {1.0, 100.0, 1e4}) {
            family.expect_exact({"film", Stack(1.0, 1.52).layer(1e-3, thickness_nm), critical_deg * (1.0 + relative)});
        }
    }
}

}  // namespace
}  // namespace nacre::hard_cases
