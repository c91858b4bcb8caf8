#include "pipeline/json.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace nacre::test {
namespace {

TEST(Json, KeepsTheOrderOfMembersAndTheKindOfEveryValue) {
    Json json{{"name", "morpho"}, {"width", 256}, {"reached", 0.1}, {"whole", 2.0}, {"unchanged", true}};
    json["files"] = std::vector<std::string>{"a.exr", "a.json"};
    json["nothing"] = Json();
    json["seconds"] = {{"deciding", 0.5}};
    json["range"] = Json::array({360, 830});
    EXPECT_EQ(json.text(),
              "{\n  \"name\": \"morpho\",\n  \"width\": 256,\n  \"reached\": 0.1,\n  \"whole\": 2.0,\n"
              "  \"unchanged\": true,\n  \"files\": [\n    \"a.exr\",\n    \"a.json\"\n  ],\n  \"nothing\": null,\n"
              "  \"seconds\": {\n    \"deciding\": 0.5\n  },\n  \"range\": [\n    360,\n    830\n  ]\n}");
}

TEST(Json, AnEmptyListAndAnEmptyObjectAreNotNull) {
    EXPECT_EQ(Json::array().text(), "[]");
    EXPECT_EQ(Json::object().text(), "{}");
    EXPECT_EQ(Json().text(), "null");
}

TEST(Json, ANullThatIsAddedToBecomesAListOrAnObject) {
    Json json;
    json["a"].push_back(1);
    json["a"].push_back(2);
    json["b"]["c"] = "d";
    EXPECT_EQ(json.text(), "{\n  \"a\": [\n    1,\n    2\n  ],\n  \"b\": {\n    \"c\": \"d\"\n  }\n}");
}

TEST(Json, WhatIsNotFiniteIsNullAndWhatIsNotUtf8IsReplaced) {
    EXPECT_EQ(Json(std::numeric_limits<double>::quiet_NaN()).text(), "null");
    EXPECT_EQ(Json("a\xff").text(), "\"a\xef\xbf\xbd\"");
}

}  // namespace
}  // namespace nacre::test
