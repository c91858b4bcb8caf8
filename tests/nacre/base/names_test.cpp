#include "nacre/base/names.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

using Names = std::vector<std::string>;
const Names spaces{"srgb_rec709_display", "lin_rec709", "lin_p3d65", "lin_rec2020", "lin_ap0", "lin_ap1"};

TEST(Names, AMistypedLetterIsFoundFirst) {
    EXPECT_EQ(nearest_names("lin_rec719", spaces, 1), Names{"lin_rec709"});
}

TEST(Names, SwappedAndMissingLettersAreFound) {
    EXPECT_EQ(nearest_names("lni_ap1", spaces), (Names{"lin_ap1"}));
    EXPECT_EQ(nearest_names("lin_p365", spaces, 1), Names{"lin_p3d65"});
}

TEST(Names, EquallyNearNamesKeepTheirOrder) {
    EXPECT_EQ(nearest_names("lin_ap2", spaces), (Names{"lin_ap0", "lin_ap1"}));
}

TEST(Names, CaseDoesNotMatter) {
    EXPECT_EQ(nearest_names("LIN_AP1", spaces, 1), Names{"lin_ap1"});
}

TEST(Names, PartOfANameFindsItAndTheShorterNameComesFirst) {
    EXPECT_EQ(nearest_names("rec709", spaces), (Names{"lin_rec709", "srgb_rec709_display"}));
    EXPECT_EQ(nearest_names("my_lin_rec709_space", spaces, 1), Names{"lin_rec709"});
}

TEST(Names, NothingNearIsNothingOffered) {
    EXPECT_EQ(nearest_names("kodachrome", spaces), Names{});
    EXPECT_EQ(nearest_names("", spaces), Names{});
    EXPECT_EQ(nearest_names("lin_ap1", Names{}), Names{});
}

TEST(Names, AtMostTheWantedNumberIsOfferedAndNoneTwice) {
    const Names many{"aaaa1", "aaaa1", "aaaa2", "aaaa3", "aaaa4"};
    EXPECT_EQ(nearest_names("aaaa", many), (Names{"aaaa1", "aaaa2", "aaaa3"}));
    EXPECT_EQ(nearest_names("aaaa", many, 0), Names{});
}

TEST(Names, ANameOfAMegabyteIsNotCompared) {
    const std::string hostile(std::size_t{1} << 20U, 'a');
    EXPECT_EQ(nearest_names(hostile, Names{"aaa", hostile}), Names{});
    EXPECT_EQ(nearest_names("aaa", Names{hostile}), Names{});
}

TEST(Names, ListsAndQuotesAreWrittenAsMessagesShowThem) {
    EXPECT_EQ(comma_separated(spaces).substr(0, 31), "srgb_rec709_display, lin_rec709");
    EXPECT_EQ(comma_separated(Names{}), "");
    EXPECT_EQ(in_quotes("a b"), "\"a b\"");
}

}  // namespace
}  // namespace nacre
