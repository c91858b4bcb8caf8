#include "nacre/swatch/swatch_preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "nacre/optics/base.h"
#include "nacre/optics/grating.h"
#include "nacre/optics/layered.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/swatch/lit_table.h"
#include "nacre/swatch/swatch.h"
#include "nacre/swatch/swatch_lit.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

PlannedSwatch preview_of(const Mechanism& mechanism) {
    PlannedSwatch preview;
    preview.kind = SwatchKind::preview;
    preview.title = "a title";
    preview.jobs = swatch_jobs(SwatchKind::preview, {"m", mechanism, {}}, test::light_of());
    return preview;
}

bool says(const Swatch& swatch, const std::string& what) {
    return std::any_of(swatch.overlays.begin(), swatch.overlays.end(), [&](const Overlay& overlay) {
        const auto* const text = std::get_if<Text>(&overlay);
        return text != nullptr && text->text == what;
    });
}

TEST(PreviewSwatch, IsAStripBesideAnObject) {
    const Swatch preview = draw_swatch(preview_of(test::beetle));
    ASSERT_EQ(preview.panels.size(), 2u);
    const Panel& strip = preview.panels[0];
    const Panel& object = preview.panels[1];
    EXPECT_LT(object.left + object.image.width(), strip.left);
    EXPECT_EQ(object.image.width(), object.image.height());
    for (const Panel& panel : preview.panels) {
        EXPECT_GT(panel.left, 0);
        EXPECT_LT(panel.left + panel.image.width(), preview.width);
        EXPECT_LT(panel.top + panel.image.height(), preview.height);
    }
    for (const char* text : {"a title", "angle", "90°", "texture coordinate (sqrt_cos_theta)"})
        EXPECT_TRUE(says(preview, text)) << text;
}

TEST(PreviewSwatch, HasTheColoursOfTheStripAndOfTheBall) {
    PlannedSwatch planned = preview_of(test::beetle);
    const Swatch preview = draw_swatch(planned);
    planned.kind = SwatchKind::strip;
    const Swatch strip = draw_swatch(planned);
    // 20 degrees.
    const Image<Xyz>& small = preview.panels[0].image;
    const Image<Xyz>& large = strip.panels[0].image;
    EXPECT_NEAR(small.at(small.width() * 2 / 9, 0).y, large.at(large.width() * 2 / 9, 0).y, 2e-3);
    planned.kind = SwatchKind::sphere;
    const Image<Xyz>& ball = preview.panels[1].image;
    EXPECT_NEAR(ball.at(180, 180).y, draw_swatch(planned).panels[0].image.at(450, 450).y, 5e-3);
}

TEST(PreviewSwatch, MarksWhatIsOutsideTheSpace) {
    const LutSpace nothing_fits{"none", [](const Image<Xyz>& image) {
                                    return Image<Rgb>(image.width(), image.height(), {-1.0, 0.0, 0.0});
                                }};
    const PlannedSwatch planned = preview_of(test::beetle);
    EXPECT_TRUE(says(draw_swatch(planned, nothing_fits), "outside none: 100 % of the strip"));
}

TEST(PreviewSwatch, OfTwoAxesIsAPlaneAndSaysWhereTheirEndsAreOnTheObject) {
    PlannedSwatch planned = preview_of(test::beetle);
    planned.jobs[0].y = parameter_axis(planned.jobs[0].material.mechanism, "width_nm", 20.0, 400.0);
    const Swatch preview = draw_swatch(planned);
    EXPECT_GT(preview.panels[0].image.height(), 200);
    EXPECT_TRUE(says(preview, "width of every pick (nm)"));
    EXPECT_TRUE(says(preview, "20 nm at the top, 400 nm at the bottom"));
}

TEST(PreviewSwatch, ShowsTheObjectThatSuitsTheMaterial) {
    const auto object = [](const Mechanism& mechanism) { return object_of({"m", mechanism, {}}); };
    EXPECT_EQ(object(test::beetle), SwatchKind::sphere);
    EXPECT_EQ(object(Grating{}), SwatchKind::disc);
    Film film{1.0, 1.5, 300.0, 1.333, 0.0};
    EXPECT_EQ(object(film), SwatchKind::puddle);
    Mechanism on_grey = film;
    on_grey.effects.base = GreyBase{0.5};
    EXPECT_EQ(object(on_grey), SwatchKind::sphere);
    film.substrate = 1.52;
    EXPECT_EQ(object(film), SwatchKind::sphere);
    film.substrate = film.incident;
    EXPECT_EQ(object(film), SwatchKind::bubble);
    Mechanism through = film;
    through.effects.observed = Observed::transmittance;
    EXPECT_EQ(object(through), SwatchKind::sphere);
}

// An azimuth says where light comes from, not what changes along a disc.
TEST(PreviewSwatch, AnObjectHasNoAzimuth) {
    Grating grating;
    grating.groove_length_um = 2.0;
    PlannedSwatch planned = preview_of(grating);
    planned.jobs[0].y = parameter_axis(planned.jobs[0].material.mechanism, "azimuth_deg", 0.0, 45.0);
    const LitTable table = lit_table(planned.jobs[0]);
    EXPECT_FALSE(table.second);
    EXPECT_EQ(table.mirrored.height(), 1);
}

}  // namespace
}  // namespace nacre
