#include "nacre/colour/cie_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/observer.h"
#include "reference/csv.h"

namespace nacre {
namespace {

using reference::Csv;
using reference::read_csv;

void expect_equal_to_the_bit(const std::array<std::array<double, 3>, cie_table_count>& table, Observer observer,
                             const Csv& published) {
    ASSERT_EQ(published.rows.size(), table.size());
    for (std::size_t row = 0; row < table.size(); ++row) {
        const int nm = cie_table_first_nm + static_cast<int>(row);
        ASSERT_EQ(std::stoi(published.rows[row].at(0)), nm);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(table[row][i], *published.number(row, published.names.at(i + 1))) << nm << " nm, column " << i;
        }
        EXPECT_EQ(colour_matching(observer, nm), table[row]) << nm << " nm";
    }
}

TEST(CieTables, Observer1931IsThePublishedTableToTheBit) {
    expect_equal_to_the_bit(cie1931_2deg_table, Observer::cie1931_2deg, read_csv("cmf_cie1931_2deg_1nm.csv"));
}

TEST(CieTables, Observer1964IsThePublishedTableToTheBit) {
    expect_equal_to_the_bit(cie1964_10deg_table, Observer::cie1964_10deg, read_csv("cmf_cie1964_10deg_1nm.csv"));
}

TEST(CieTables, TheNineIlluminantsAreThePublishedTablesToTheBit) {
    const Csv published = read_csv("illuminants_5nm.csv");
    ASSERT_EQ(published.names.size(), 1 + cie_illuminant_tables.size());
    for (const CieIlluminantTable& table : cie_illuminant_tables) {
        const std::string name(table.name);
        ASSERT_GT(table.step_nm, 0) << name;
        std::set<int> compiled_nm;
        for (std::size_t i = 0; i < table.power.size(); ++i) {
            compiled_nm.insert(table.first_nm + static_cast<int>(i) * table.step_nm);
        }
        std::size_t in_both = 0;
        for (std::size_t row = 0; row < published.rows.size(); ++row) {
            const int nm = static_cast<int>(*published.number(row, "wavelength_nm"));
            const auto power = published.number(row, name);
            if (name == "E" && compiled_nm.count(nm) == 0) continue;  // constant: its two ends say it all
            const bool observed = nm >= cie_table_first_nm && nm <= cie_table_last_nm;
            if (compiled_nm.count(nm) == 0) {
                EXPECT_FALSE(power && observed) << name << " lacks " << nm << " nm";
                continue;
            }
            ++in_both;
            ASSERT_TRUE(power) << name << " is not published at " << nm << " nm";
            EXPECT_EQ(table.power[static_cast<std::size_t>((nm - table.first_nm) / table.step_nm)], *power)
                << name << " at " << nm << " nm";
        }
        EXPECT_EQ(in_both, table.power.size()) << name << " has nodes that are not published";
    }
}

TEST(CieTables, IlluminantsAreReadByNameLinearBetweenNodesAndDarkOutside) {
    const Csv published = read_csv("illuminants_5nm.csv");
    for (const std::string_view name : illuminant_names()) {
        const auto curve = illuminant_by_name(name);
        ASSERT_TRUE(curve) << name;
        for (std::size_t row = 0; row + 1 < published.rows.size(); ++row) {
            const double nm = *published.number(row, "wavelength_nm");
            if (nm < cie_table_first_nm) continue;
            const auto here = published.number(row, std::string(name));
            const auto next = published.number(row + 1, std::string(name));
            // Four roundings of numbers of this size; at nodes none, but E has nodes at its ends only.
            EXPECT_NEAR(curve->at(nm), here.value_or(0.0), 1e-15 * here.value_or(0.0)) << name << " at " << nm;
            const double between = here && next ? 0.6 * *here + 0.4 * *next : 0.0;
            EXPECT_NEAR(curve->at(nm + 2.0), between, 1e-15 * between) << name << " at " << nm + 2.0;
        }
        EXPECT_EQ(curve->at(200.0), 0.0) << name;
        EXPECT_EQ(curve->at(2000.0), 0.0) << name;
    }
    EXPECT_FALSE(illuminant_by_name("D66"));
    EXPECT_FALSE(illuminant_by_name(""));
}

}  // namespace
}  // namespace nacre
