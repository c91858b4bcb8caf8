#include "io/scene/toml_tree.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "nacre/base/error.h"

namespace nacre {
namespace {

const Where where{"--set \"x\""};

template <typename Type>
Type parsed(const std::string& text) {
    const Value value = parse_value(text, "material.hero", where);
    EXPECT_EQ(value.where.text(), where.text());
    return std::get<Type>(value.data);
}

TEST(ParsedValue, IsWhatTomlSays) {
    EXPECT_EQ(parsed<std::int64_t>("12"), 12);
    EXPECT_EQ(parsed<double>("0.5"), 0.5);
    EXPECT_EQ(parsed<double>("1e-3"), 1e-3);
    EXPECT_EQ(parsed<bool>("true"), true);
    EXPECT_EQ(parsed<std::string>("\"12\""), "12");
    const auto array = parsed<Value::Array>("[1, \"a\"]");
    ASSERT_EQ(array.size(), 2u);
    EXPECT_EQ(array[1].where.text(), where.text()) << "columns of the value mean nothing to the user";
    const auto table = parsed<std::shared_ptr<Table>>("{ angle_deg = 0, colour = \"#fff\" }");
    EXPECT_EQ(table->entries()[1].key_where.text(), where.text());
    EXPECT_EQ(table->path(), "material.hero");
}

TEST(ParsedValue, IsAStringIfItIsNoToml) {
    for (const std::string text :
         {"#aa2244", "lin_p3d65", "", "12 Monkeys", "a = 1", "1\n[other]", "lamps/a.csv", "auto"})
        EXPECT_EQ(parsed<std::string>(text), text);
}

TEST(ParsedValue, ThatBeginsLikeTomlHasToBeToml) {
    for (const std::string text : {"[1, 2", "{ a = 1", "\"open", "'open"})
        EXPECT_THROW(parse_value(text, "", where), Error) << text;
    EXPECT_THROW(parse_value(std::string(1000, '['), "", where), Error);
    std::string deep = "{ a";
    for (int i = 0; i < 100000; ++i) deep += ".a";
    EXPECT_THROW(parse_value(deep + " = 1 }", "", where), Error);
}

}  // namespace
}  // namespace nacre
