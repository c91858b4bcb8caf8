#include "nacre/scene/readers/mechanism_readers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/pick/search_rows.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/shading.h"

// The tables of the folders have one row per mechanism, and rows of one mechanism in different tables must agree.
namespace nacre {
namespace {

template <std::size_t... Index>
std::vector<Mechanism> one_of_each(std::index_sequence<Index...>) {
    return {Mechanism(std::variant_alternative_t<Index, MechanismModel>{})...};
}
std::vector<Mechanism> one_of_each() {
    return one_of_each(std::make_index_sequence<std::variant_size_v<MechanismModel>>());
}

std::string name(const Mechanism& mechanism) {
    return std::string(mechanism_name(mechanism));
}

TEST(MechanismRows, WriteTheNameThatTheyAreReadBy) {
    for (const Mechanism& one : one_of_each()) {
        const std::string first = "mechanism = \"" + name(one) + "\"\n";
        EXPECT_EQ(mechanism_toml(one).substr(0, first.size()), first) << "material/mechanism.cpp, " << name(one);
    }
}

TEST(MechanismRows, SayOfLayersTheSame) {
    for (const Mechanism& one : one_of_each())
        EXPECT_EQ(shading_of(one).layers != nullptr, is_layered(one)) << "shade/shading.cpp, " << name(one);
}

TEST(MechanismRows, SearchForWhatPicksCanLeadTo) {
    for (const Mechanism& one : one_of_each()) {
        EXPECT_EQ(search_row_of(one).complexity != nullptr, reader_of(one).search != nullptr)
            << "pick/search_rows.cpp, " << name(one);
    }
}

// A key that changes nothing would be accepted without a word.
TEST(MechanismRows, RefuseTheKeysThatChangeNothing) {
    for (Mechanism& one : one_of_each()) {
        const EffectRefusals& refusals = reader_of(one).refusals;
        SCOPED_TRACE("scene/readers/" + name(one) + "_reader.cpp");
        EXPECT_EQ(refusals.base.empty(), is_layered(one));
        EXPECT_EQ(refusals.polarisation.empty(), row_of(one).has_polarisations);
        EXPECT_EQ(refusals.thickness_spread_nm.empty(), row_of(one).thickness_spread_nm(one) != nullptr);
    }
}

}  // namespace
}  // namespace nacre
