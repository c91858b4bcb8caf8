#include "nacre/scene/lists.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/scene/key_names.h"

namespace nacre {
namespace {

TEST(NameLists, EveryNameHasHalfALineOfWords) {
    EXPECT_EQ(name_lists().size(), 10u);
    for (const NameList& list : name_lists()) {
        const std::vector<ListedName> names = list.names();
        EXPECT_GE(names.size(), 2u) << list.name;
        for (const ListedName& name : names) {
            EXPECT_FALSE(name.name.empty()) << list.name;
            EXPECT_FALSE(name.description.empty()) << name.name;
            EXPECT_LE(name.description.size(), 90u) << name.name;
        }
    }
}

TEST(NameLists, IlluminantsAreDescribedByTheirOwnWords) {
    const std::vector<std::string_view> known = illuminant_names();
    for (const NameList& list : name_lists()) {
        if (list.name != "illuminants") continue;
        const std::vector<ListedName> names = list.names();
        ASSERT_EQ(names.size(), known.size());
        EXPECT_EQ(names[0].name, "D65");
        EXPECT_EQ(names[0].description, "average daylight, 6504 K");
        EXPECT_EQ(names[4].name, "A");
        EXPECT_EQ(names[4].description, "incandescent lamp, 2856 K");
        EXPECT_EQ(names.back().name, "FL11");
        EXPECT_EQ(names.back().description, "fluorescent lamp, three narrow bands, 4000 K");
    }
}

struct Meant {
    std::string wrong;
    std::vector<std::string> known;
    std::string key;
};

TEST(MeantKey, IsASynonymFirstAndThenTheNearestName) {
    const std::vector<std::string> film{"mechanism", "incident", "index", "thickness_nm", "substrate", "roughness"};
    const std::vector<std::string> pick{"angle_deg", "colour", "space", "peak_nm", "width_nm", "height"};
    const std::vector<std::string> top{"nacre", "accuracy", "light", "colour", "material", "lut", "swatch"};
    for (const Meant& one :
         {Meant{"ior", film, "index"}, Meant{"IOR", film, "index"}, Meant{"thickness", film, "thickness_nm"},
          Meant{"perceptual_roughness", film, "roughness"}, Meant{"type", film, "mechanism"},
          Meant{"colr", pick, "colour"}, Meant{"Colour", pick, "colour"}, Meant{"hex", pick, "colour"},
          Meant{"color_space", pick, "space"}, Meant{"wavelength", pick, "peak_nm"}, Meant{"FWHM", pick, "width_nm"},
          Meant{"texture", top, "lut"}, Meant{"materials", top, "material"}, Meant{"preview", top, "swatch"},
          Meant{"frobnicate", top, ""}}) {
        EXPECT_EQ(meant_key(one.wrong, one.known), one.key) << one.wrong;
    }
}

TEST(MeantKey, OffersOnlyKeysThatAreKnown) {
    EXPECT_EQ(meant_key("ior", std::vector<std::string>{"period_nm", "grooves"}), "");
}

TEST(Spelling, OfAKeyIsBritishOrAmerican) {
    EXPECT_EQ(american_spelling("colour"), "color");
    EXPECT_EQ(american_spelling("index"), "");
    EXPECT_TRUE(is_same_key("color", "colour"));
    EXPECT_TRUE(is_same_key("colour", "color"));
    EXPECT_FALSE(is_same_key("index", ""));
}

}  // namespace
}  // namespace nacre
