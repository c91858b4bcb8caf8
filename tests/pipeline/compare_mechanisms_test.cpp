#include "pipeline/compare_mechanisms.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace nacre {
namespace {

MechanismAnswer answer(const std::string& mechanism, std::vector<double> de00, double error, double chroma = 1.0,
                       std::size_t numbers = 3) {
    MechanismAnswer made;
    made.mechanism = mechanism;
    made.de00 = std::move(de00);
    made.error = error;
    made.numbers = numbers;
    made.path.chroma = chroma;
    return made;
}

const MechanismAnswer clear_palette = answer("palette", {0.0, 0.0}, 0.0, 1.0, 7);
const MechanismAnswer pale_palette = answer("palette", {0.0, 0.0}, 0.0, 0.03, 8);

TEST(AnswerBeside, IsNamedIfItMeetsThePicks) {
    const std::vector<MechanismAnswer> met{answer("film", {0.4, 0.1}, 0.3)};
    EXPECT_EQ(answer_beside(clear_palette, met), &met[0]);
    const std::vector<MechanismAnswer> missed{answer("film", {0.4, 0.6}, 0.5)};
    EXPECT_EQ(answer_beside(clear_palette, missed), nullptr);
    EXPECT_EQ(answer_beside(clear_palette, {}), nullptr);
}

TEST(AnswerBeside, IsNamedIfItMissesNoMoreThanThePalette) {
    const MechanismAnswer dimmed = answer("palette", {0.0, 9.0}, 6.4);
    const std::vector<MechanismAnswer> other{answer("stack", {0.2, 8.5}, 6.0)};
    EXPECT_EQ(answer_beside(dimmed, other), &other[0]);
    const std::vector<MechanismAnswer> worse{answer("stack", {0.2, 9.5}, 6.7)};
    EXPECT_EQ(answer_beside(dimmed, worse), nullptr);
}

TEST(AnswerBeside, ThatHasColourWhereThePaletteIsGreyComesFirst) {
    const std::vector<MechanismAnswer> others{answer("stack", {0.1, 0.1}, 0.1, 0.1),
                                              answer("stack", {0.35, 1.0}, 0.76, 0.9)};
    EXPECT_EQ(answer_beside(pale_palette, others), &others[1]);
    EXPECT_EQ(answer_beside(clear_palette, others), &others[0]);
    const std::vector<MechanismAnswer> far{answer("film", {7.5, 15.0}, 12.0, 0.9)};
    EXPECT_EQ(answer_beside(pale_palette, far), nullptr);
}

TEST(Rank, GoesByErrorAndAmongThoseThatMeetByFewNumbers) {
    std::vector<MechanismAnswer> answers{answer("palette", {0.0}, 1e-6, 1.0, 7), answer("grating", {5.0}, 5.0, 1.0, 4),
                                         answer("stack", {0.09}, 0.09, 1.0, 6), answer("film", {0.2}, 0.2, 1.0, 3)};
    rank(answers);
    std::vector<std::string> order;
    for (const MechanismAnswer& one : answers) order.push_back(one.mechanism);
    EXPECT_EQ(order, (std::vector<std::string>{"stack", "palette", "film", "grating"}));
}

}  // namespace
}  // namespace nacre
