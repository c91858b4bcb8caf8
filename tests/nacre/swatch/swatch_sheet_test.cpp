#include "nacre/swatch/swatch_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "nacre/colour/illuminant.h"
#include "nacre/swatch/swatch.h"
#include "nacre/swatch/swatch_layout.h"

namespace nacre {
namespace {

Job job_of(double peak_nm) {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    static const auto light = std::make_shared<const Light>(make_light(settings));
    return swatch_jobs(SwatchKind::strip,
                       {"m", Palette{{{0.0, {peak_nm, 90.0, 0.9}}, {50.0, {peak_nm - 60.0, 90.0, 0.9}}}}, {}}, light)
        .front();
}

PlannedSwatch sheet_of(std::size_t count, SwatchKind panels) {
    PlannedSwatch sheet;
    sheet.kind = SwatchKind::contact_sheet;
    sheet.panels = panels;
    for (std::size_t i = 0; i < count; ++i) {
        sheet.jobs.push_back(job_of(450.0 + 2.0 * static_cast<double>(i)));
        sheet.labels.push_back("look " + std::to_string(i));
    }
    return sheet;
}

bool says(const Swatch& swatch, const std::string& what) {
    return std::any_of(swatch.overlays.begin(), swatch.overlays.end(), [&](const Overlay& overlay) {
        const auto* const text = std::get_if<Text>(&overlay);
        return text != nullptr && text->text == what;
    });
}

TEST(ContactSheet, ShowsEveryPictureWithItsLabelAndNoTwoOverlap) {
    for (const SwatchKind panels : {SwatchKind::strip, SwatchKind::sphere}) {
        const Swatch sheet = draw_swatch(sheet_of(5, panels));
        ASSERT_EQ(sheet.panels.size(), 5u);
        for (std::size_t i = 0; i < 5; ++i) {
            const Panel& panel = sheet.panels[i];
            EXPECT_TRUE(says(sheet, "look " + std::to_string(i)));
            EXPECT_GE(panel.left, 0);
            EXPECT_LE(panel.left + panel.image.width(), sheet.width);
            EXPECT_LT(panel.top + panel.image.height() + label_px, sheet.height) << "and its label";
            for (std::size_t j = 0; j < i; ++j) {
                const Panel& other = sheet.panels[j];
                EXPECT_TRUE(other.left + other.image.width() <= panel.left ||
                            other.top + other.image.height() < panel.top);
            }
        }
    }
}

TEST(ContactSheet, ShowsTheColoursOfTheSwatchOfItsKind) {
    for (const SwatchKind panels : {SwatchKind::strip, SwatchKind::sphere}) {
        const PlannedSwatch sheet = sheet_of(2, panels);
        PlannedSwatch alone;
        alone.kind = panels;
        alone.jobs = {sheet.jobs[1]};
        const Image<Xyz> large = draw_swatch(alone).panels.front().image;
        const Image<Xyz> small = draw_swatch(sheet).panels[1].image;
        const int factor = large.width() / small.width();
        ASSERT_GT(factor, 1);
        const int x = small.width() / 2, y = small.height() / 2;
        double sum = 0.0;
        for (int j = 0; j < factor; ++j) {
            for (int i = 0; i < factor; ++i) sum += large.at(factor * x + i, factor * y + j).y;
        }
        EXPECT_NEAR(small.at(x, y).y, sum / (factor * factor), 1e-12) << "the mean of its pixels";
    }
}

TEST(ContactSheet, SaysHowManyItDoesNotShow) {
    const Swatch sheet = draw_swatch(sheet_of(most_sheet_pictures + 2, SwatchKind::strip));
    EXPECT_EQ(sheet.panels.size(), most_sheet_pictures);
    EXPECT_TRUE(says(sheet, "the first 60 of 62 LUTs"));
    EXPECT_FALSE(says(sheet, "look 60"));
}

}  // namespace
}  // namespace nacre
