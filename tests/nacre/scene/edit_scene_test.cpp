#include "nacre/scene/edit_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "io/scene/toml_tree.h"
#include "nacre/base/error.h"

namespace nacre {
namespace {

constexpr const char* hero =
    "[material.hero]\nshape = 0.5\n"
    "picks = [ { angle_deg = 0, colour = \"#22cc66\" }, { angle_deg = 40, color = \"#1fb5c9\" } ]\n"
    "[material.\"h.2\"]\nshape = 0.25\n";

SceneEdit edit(const std::string& key, const std::string& value) {
    const Where where{"--set"};
    return {key, parse_value(value, "", where), where};
}

// A scene as text, so that two can be compared.
std::string text_of(const Table& scene) {
    std::string text;
    for (const Table::Entry& entry : scene.entries()) text += edit_text({entry.key, entry.value, {}}) + "\n";
    return text;
}

std::string after(const std::vector<SceneEdit>& edits) {
    Table scene = parse_toml(hero, "s.toml");
    for (const SceneEdit& one : edits) set_key(scene, one);
    return text_of(scene);
}

TEST(SceneEdit, ReplacesAValueAddsAKeyAndKnowsBothSpellings) {
    const std::string start =
        "material = { hero = { shape = 0.5, picks = [{ angle_deg = 0, colour = \"#22cc66\" }, { angle_deg = 40, color "
        "= "
        "\"#1fb5c9\" }] }, \"h.2\" = { shape = 0.25 } }\n";
    ASSERT_EQ(after({}), start);
    const auto with = [&](const std::string& part, const std::string& other) {
        std::string text = start;
        return text.replace(text.find(part), part.size(), other);
    };
    EXPECT_EQ(after({edit("material.hero.picks[0].colour", "#aa2244")}), with("#22cc66", "#aa2244"));
    EXPECT_EQ(after({edit("material.hero.picks[0].color", "#aa2244")}), with("#22cc66", "#aa2244"));
    EXPECT_EQ(after({edit("material.hero.picks[1].colour", "#aa2244")}), with("#1fb5c9", "#aa2244"));
    EXPECT_EQ(after({edit("material.hero.picks[1]", "{ angle_deg = 9 }")}),
              with("{ angle_deg = 40, color = \"#1fb5c9\" }", "{ angle_deg = 9 }"));
    EXPECT_EQ(after({edit("material.hero.tilt_deg", "5")}), with("] }, \"h", "], tilt_deg = 5 }, \"h"));
    EXPECT_EQ(after({edit("material.\"h.2\".shape", "1")}), with("0.25", "1"));
    EXPECT_EQ(after({edit("material.hero.shape", "0.1"), edit("material.hero.shape", "0.2")}), with("0.5", "0.2"))
        << "the last counts";
}

TEST(SceneEdit, TablesThatASceneMayDoWithoutAreAdded) {
    const std::string more =
        after({edit("accuracy.max_de00", "0.5"), edit("accuracy.sampling.slices", "8"), edit("colour.space", "lin_ap1"),
               edit("color.gamut", "clip"), edit("light.illuminant", "A")});
    EXPECT_EQ(more.substr(more.find('\n') + 1),
              "accuracy = { max_de00 = 0.5, sampling = { slices = 8 } }\n"
              "colour = { space = \"lin_ap1\", gamut = \"clip\" }\n"
              "light = { illuminant = \"A\" }\n");
}

TEST(SceneEdit, OfACopyLeavesTheSceneAsItWas) {
    const Table scene = parse_toml(std::string("left_out = 1\n") + hero, "s.toml");
    const std::string before = text_of(scene);
    Table copy = copy_of(scene, "left_out");
    EXPECT_EQ("left_out = 1\n" + text_of(copy), before);
    set_key(copy, edit("material.hero.picks[0].colour", "#aa2244"));
    set_key(copy, edit("material.hero.shape", "0"));
    EXPECT_NE("left_out = 1\n" + text_of(copy), before);
    EXPECT_EQ(text_of(scene), before);
}

TEST(SceneEdit, ThatLeadsNowhereSaysWhatThereIs) {
    const auto message_of = [](const std::string& key) {
        try {
            after({edit(key, "1")});
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("was accepted");
    };
    EXPECT_EQ(message_of("materail.hero.shape"), "--set: s.toml has no materail; known: material");
    EXPECT_EQ(message_of("material.heor.shape"), "--set: s.toml has no material.heor; known in material: hero");
    EXPECT_EQ(message_of("material.hero.picks[2].colour"),
              "--set: material.hero.picks in s.toml has no [2]; it has 2 elements, counted from [0]");
    EXPECT_EQ(message_of("material.hero.picks.colour"),
              "--set: material.hero.picks in s.toml is an array, which has no keys");
    EXPECT_EQ(message_of("material.hero.shape[0]"),
              "--set: material.hero.shape in s.toml is a number, which has no [0]");
    EXPECT_EQ(message_of("lut.hero.size"),
              "--set: s.toml has no [lut.NAME]; add one to the scene, or set accuracy.max_de00, accuracy.size, "
              "colour.space or colour.gamut, which hold for all LUTs");
    EXPECT_EQ(message_of("include"), "--set: include cannot be set here; write it in the scene");
    for (const std::string key : {"", ".a", "a.", "a..b", "a[", "a[]", "a[x]", "a[-1]", "a[1", "a]", "\"a", "a b"}) {
        EXPECT_EQ(message_of(key), "--set: \"" + key +
                                       "\" is not a key of a scene; write it like material.NAME.picks[0].colour, and a "
                                       "name that has a dot in quotes");
    }
}

}  // namespace
}  // namespace nacre
