#include "nacre/colour/adaptation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"
#include "reference/csv.h"

namespace nacre {
namespace {

/// The whites that adaptation_matrices.csv names, with the numbers of its first line.
const std::map<std::string, Xyz>& published_whites() {
    static const std::map<std::string, Xyz> whites{
        {"D65_xy4", xyz_from_chromaticity({0.3127, 0.3290})},
        {"D50_xy4", xyz_from_chromaticity({0.3457, 0.3585})},
        {"D50_ICC_PCS", {0.9642, 1.0, 0.8249}},
        {"D65_ASTM", {0.95047, 1.0, 1.08883}},
        {"D50_ASTM", {0.96422, 1.0, 0.82521}},
        {"ACES_white", xyz_from_chromaticity({0.32168, 0.33767})},
        {"E", {1.0, 1.0, 1.0}},
    };
    return whites;
}

/// Rows of the matrices that were derived in exact rational arithmetic from the published cone matrices.
void expect_published_matrices(Adaptation method, const std::string& method_name) {
    const reference::Csv published = reference::read_csv("adaptation_matrices.csv");
    int found = 0;
    for (std::size_t row = 0; row < published.rows.size(); ++row) {
        if (published.text(row, "cat") != method_name) continue;
        ++found;
        const std::string from = published.text(row, "from"), to = published.text(row, "to");
        const glm::dmat3 matrix = adaptation_matrix(method, published_whites().at(from), published_whites().at(to));
        for (int element = 0; element < 9; ++element) {
            const std::string& name = published.names.at(3 + static_cast<std::size_t>(element));  // m00, m01, ... m22
            // Nine products of numbers below 2, each rounded to 1.1e-16 of itself; glm counts columns first.
            EXPECT_NEAR(matrix[element % 3][element / 3], *published.number(row, name), 9 * 2 * 1.2e-16)
                << from << " to " << to << ", " << name;
        }
    }
    EXPECT_EQ(found, 9);
}

TEST(Adaptation, BradfordMatricesAreThoseDerivedInExactArithmetic) {
    expect_published_matrices(Adaptation::bradford, "Bradford");
}

TEST(Adaptation, Cat16MatricesAreThoseDerivedInExactArithmetic) {
    expect_published_matrices(Adaptation::cat16, "CAT16");
}

TEST(Adaptation, NoneLeavesEveryColourAsItIs) {
    const glm::dmat3 matrix = adaptation_matrix(Adaptation::none, {1.1, 1.0, 0.35}, d65_white);
    const Xyz colour{0.3, 0.2, 0.7};
    EXPECT_EQ(adapt(matrix, colour), colour);
}

TEST(Adaptation, WhiteOfEveryIlluminantAndObserverBecomesTheOtherWhite) {
    for (const Adaptation method : {Adaptation::bradford, Adaptation::cat16}) {
        for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg}) {
            for (const std::string_view name : illuminant_names()) {
                const Xyz white = make_tristimulus_weights(observer, *illuminant_by_name(name)).white;
                const Xyz adapted = adapt(adaptation_matrix(method, white, d65_white), white);
                // A few dozen roundings of numbers near 1; 1e-12 is what RGB = (1, 1, 1) is promised to.
                EXPECT_NEAR(adapted.x, d65_white.x, 1e-12) << name;
                EXPECT_NEAR(adapted.y, 1.0, 1e-12) << name;
                EXPECT_NEAR(adapted.z, d65_white.z, 1e-12) << name;
            }
        }
    }
}

TEST(Adaptation, ThereAndBackIsTheSameColour) {
    const Xyz a_white{1.0985, 1.0, 0.3558}, colour{0.21, 0.34, 0.11};
    for (const Adaptation method : {Adaptation::bradford, Adaptation::cat16}) {
        const Xyz there = adapt(adaptation_matrix(method, a_white, d65_white), colour);
        const Xyz back = adapt(adaptation_matrix(method, d65_white, a_white), there);
        EXPECT_GT(std::abs(there.z - colour.z), 0.1);  // it did go somewhere
        // The blue response grows threefold and shrinks again: a few roundings of numbers near 1.
        EXPECT_NEAR(back.x, colour.x, 1e-14);
        EXPECT_NEAR(back.y, colour.y, 1e-14);
        EXPECT_NEAR(back.z, colour.z, 1e-14);
    }
}

TEST(Adaptation, ToTheSameWhiteChangesNothing) {
    for (const Adaptation method : {Adaptation::bradford, Adaptation::cat16}) {
        const Xyz colour{0.21, 0.34, 0.11};
        const Xyz adapted = adapt(adaptation_matrix(method, d65_white, d65_white), colour);
        EXPECT_NEAR(adapted.x, colour.x, 1e-15);
        EXPECT_NEAR(adapted.y, colour.y, 1e-15);
        EXPECT_NEAR(adapted.z, colour.z, 1e-15);
    }
}

}  // namespace
}  // namespace nacre
