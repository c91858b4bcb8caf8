// What an OpenColorIO is too old for is refused by name, and a newer one is left to read it. The versions are those of
// OpenColorIO's release notes.
#include "io/ocio/config_version.h"

#include <gtest/gtest.h>

#include "nacre/base/error.h"

namespace nacre {
namespace {

constexpr OcioVersion debian_12{2, 1};
constexpr OcioVersion newer{2, 4};

std::string message_of(const std::string& path, const std::string& text, OcioVersion linked) {
    try {
        check_config_version(path, text, linked, "--ocio");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string with_profile(const std::string& version) {
    return "# ocio_profile_version: 9.9\n\nocio_profile_version: " + version + "\nname: test\n";
}

TEST(ConfigVersion, AProfileIsReadByTheOpenColorIoOfThatVersion) {
    EXPECT_EQ(
        message_of("a/config.ocio", with_profile("2.4"), debian_12),
        "--ocio: OCIO config \"a/config.ocio\" is of profile version 2.4, which OpenColorIO reads from version 2.4 "
        "on; give a config that OpenColorIO 2.1, which this nacre is linked with, can read, of profile version "
        "2.1 or older");
    EXPECT_EQ(message_of("a", with_profile("2.4"), newer), "");
    EXPECT_NE(message_of("a", with_profile("2.5"), newer).find("of profile version 2.5, "), std::string::npos);
    EXPECT_NE(message_of("a", with_profile("\"2.2\""), debian_12).find("of profile version 2.2, "), std::string::npos);
    EXPECT_NE(message_of("a", with_profile("3"), newer).find("of profile version 3.0, "), std::string::npos);
    for (const char* old : {"1", "2", "2.0", "2.1"})
        EXPECT_EQ(message_of("a", with_profile(old), debian_12), "") << old;
}

TEST(ConfigVersion, TextWithoutAVersionIsLeftToOpenColorIo) {
    for (const std::string text :
         {"", "garbage", "ocio_profile_version:", "ocio_profile_version: new", "ocio_profile_version: 2."})
        EXPECT_EQ(message_of("a", text, debian_12), "") << text;
}

TEST(ConfigVersion, AnArchiveIsKnownByItsNameOrItsContent) {
    const std::string message =
        "is an archive (.ocioz), which OpenColorIO reads from version 2.2 on; give a config that OpenColorIO 2.1, "
        "which "
        "this nacre is linked with, can read, such as the unpacked config.ocio of the archive";
    EXPECT_EQ(message_of("a.ocioz", "?", debian_12), "--ocio: OCIO config \"a.ocioz\" " + message);
    EXPECT_EQ(message_of("a.ocio", "PK\x03\x04", debian_12), "--ocio: OCIO config \"a.ocio\" " + message);
    EXPECT_EQ(message_of("a.ocioz", "PK\x03\x04", newer), "");
    EXPECT_EQ(message_of("a.ocioz", "PK\x03\x04", {2, 2}), "");
}

TEST(ConfigVersion, ConfigsInsideOpenColorIoCameWithDifferentVersions) {
    EXPECT_TRUE(is_inside_ocio("ocio://default"));
    EXPECT_FALSE(is_inside_ocio("ocio/config.ocio"));
    EXPECT_EQ(
        message_of("ocio://default", "", debian_12),
        "--ocio: OCIO config \"ocio://default\" is one that OpenColorIO contains from version 2.2 on; give a config "
        "that OpenColorIO 2.1, which this nacre is linked with, can read, such as a config.ocio");
    EXPECT_EQ(message_of("ocio://default", "", {2, 2}), "");
    const auto from = [](const std::string& name, OcioVersion linked) {
        const std::string message = message_of("ocio://" + name, "", linked);
        const auto at = message.find("from version ");
        return at == std::string::npos ? message : message.substr(at + 13, 3);
    };
    EXPECT_EQ(from("cg-config-v1.0.0_aces-v1.3_ocio-v2.1", debian_12), "2.2");
    EXPECT_EQ(from("cg-config-v1.0.0_aces-v1.3_ocio-v2.1", {2, 2}), "");
    EXPECT_EQ(from("studio-config-v2.1.0_aces-v1.3_ocio-v2.3", {2, 2}), "2.3");
    EXPECT_EQ(from("studio-config-latest", {2, 2}), "2.3");
    EXPECT_EQ(from("cg-config-v2.2.0_aces-v1.3_ocio-v2.4", {2, 3}), "2.4");
    EXPECT_EQ(from("cg-config-v2.2.0_aces-v1.3_ocio-v2.4", newer), "");
}

}  // namespace
}  // namespace nacre
