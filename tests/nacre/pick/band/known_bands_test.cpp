#include "nacre/pick/band/known_bands.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "nacre/colour/illuminant.h"

namespace nacre {
namespace {

std::shared_ptr<const Light> light_of(const std::string& illuminant, Adaptation adaptation, int last_nm = 830) {
    LightSettings settings;
    settings.power = *illuminant_by_name(illuminant);
    settings.adaptation = adaptation;
    settings.last_nm = last_nm;
    return std::make_shared<const Light>(make_light(settings));
}

Lobe lobe_of(const ExactBands& bands) {
    const auto match = bands.find({0.2, 0.3, 0.25}, BandKind::band, 0.0);
    return match ? match->lobe() : Lobe{};
}

TEST(KnownBands, AreThoseOfTheLightThatIsAskedFor) {
    KnownBands known;
    for (const auto& light : {light_of("D65", Adaptation::bradford), light_of("A", Adaptation::bradford),
                              light_of("A", Adaptation::bradford, 780), light_of("D65", Adaptation::bradford)})
        EXPECT_EQ(lobe_of(known.under(light)), lobe_of(ExactBands(*light)));
}

// What no band has exactly is judged by what an eye sees, and so by the adaptation too.
TEST(KnownBands, AreMadeAgainForAnotherAdaptation) {
    KnownBands known;
    const auto light = light_of("A", Adaptation::bradford), other = light_of("A", Adaptation::cat16);
    known.under(light);
    known.under(other);
    EXPECT_EQ(light.use_count(), 1) << "the bands of the light before are still there";
    EXPECT_EQ(other.use_count(), 2);
    known.under(light_of("A", Adaptation::cat16));
    EXPECT_EQ(other.use_count(), 2) << "an equal light needs no other bands";
}

}  // namespace
}  // namespace nacre
