#include "nacre/swatch/swatch.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/axis_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "nacre/shade/palette_colour.h"
#include "nacre/swatch/swatch_gamut.h"
#include "nacre/swatch/swatch_layout.h"

namespace nacre {
namespace {

const Material morpho{"morpho", Palette{{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 60.0, 0.7}}}}, {}};
const Material beetle{"beetle", Palette{{{10.0, {530.0, 110.0, 0.73}}, {60.0, {460.0, 110.0, 1.0}}}}, {}};
const Material steep{"steep", Palette{{{20.0, {600.0, 120.0, 0.9}}, {50.0, {540.0, 90.0, 0.4}}}}, {}};

const Palette& palette_of(const Material& material) {
    return std::get<Palette>(material.mechanism);
}

std::shared_ptr<const Light> daylight() {
    static const auto light = [] {
        LightSettings settings;
        settings.power = *illuminant_by_name("D65");
        return std::make_shared<const Light>(make_light(settings));
    }();
    return light;
}

PlannedSwatch planned(SwatchKind kind, const Material& material) {
    PlannedSwatch swatch;
    swatch.kind = kind;
    swatch.title = material.name;
    swatch.jobs = swatch_jobs(kind, material, daylight());
    swatch.labels.assign(swatch.jobs.size(), material.name);
    return swatch;
}

// Drawn once: with sanitizers a bake takes seconds.
const Swatch& picture(SwatchKind kind, const Material& material) {
    static std::map<std::pair<SwatchKind, std::string>, Swatch> pictures;
    const auto [entry, is_new] = pictures.try_emplace({kind, material.name});
    if (is_new) entry->second = draw_swatch(planned(kind, material));
    return entry->second;
}

template <typename Shape>
std::vector<Shape> all_of(const Swatch& swatch) {
    std::vector<Shape> shapes;
    for (const Overlay& overlay : swatch.overlays) {
        if (const auto* shape = std::get_if<Shape>(&overlay)) shapes.push_back(*shape);
    }
    return shapes;
}

// The white squares: what a person takes for the picks.
std::vector<Point> squares(const Swatch& swatch) {
    std::vector<Point> centres;
    for (const Rectangle& rectangle : all_of<Rectangle>(swatch)) {
        if (!rectangle.line_px || rectangle.ink.grey != 1.0) continue;
        const Box& box = rectangle.box;
        centres.push_back({0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom)});
    }
    return centres;
}

bool says(const Swatch& swatch, const std::string& what) {
    const auto texts = all_of<Text>(swatch);
    return std::any_of(texts.begin(), texts.end(), [&](const Text& text) { return text.text == what; });
}

// Where a reader of the axis would look for a value: between the labels of two others.
double between_labels(const Swatch& swatch, const std::string& a, const std::string& b, double fraction, bool on_x) {
    double at_a = 0.0, at_b = 0.0;
    for (const Text& text : all_of<Text>(swatch)) {
        const double place = on_x ? text.baseline.x : text.baseline.y - 0.36 * label_px;
        if (text.text == a) at_a = place;
        if (text.text == b) at_b = place;
    }
    return std::lerp(at_a, at_b, fraction);
}

TEST(PlaneSwatch, TheSquaresSitWhereTheAxesSayThatThePicksAre) {
    const Swatch& swatch = picture(SwatchKind::plane, beetle);
    const std::vector<Point> centres = squares(swatch);
    ASSERT_EQ(centres.size(), 2u);
    // Labels stand at whole pixels, hence the tolerance of one.
    EXPECT_NEAR(centres[0].x, between_labels(swatch, "500", "550", 0.6, true), 1.0);
    EXPECT_NEAR(centres[0].y, between_labels(swatch, "0°", "20°", 0.5, false), 1.0);
    EXPECT_NEAR(centres[1].x, between_labels(swatch, "450", "500", 0.2, true), 1.0);
    EXPECT_NEAR(centres[1].y, between_labels(swatch, "50°", "70°", 0.5, false), 1.0);
}

TEST(PlaneSwatch, TheCurvePassesThroughTheMiddleOfEverySquare) {
    const Swatch& swatch = picture(SwatchKind::plane, morpho);
    const auto lines = all_of<Polyline>(swatch);
    ASSERT_FALSE(lines.empty());
    for (const Polyline& line : lines) {
        for (const Point& centre : squares(swatch)) {
            double nearest = 1e9;
            for (const Point& point : line.points) {
                nearest = std::min(nearest, std::hypot(point.x - centre.x, point.y - centre.y));
            }
            EXPECT_LT(nearest, 1e-9);
        }
    }
}

// Pixels are integrated exactly; the rest is rounding.
constexpr double rounding = 1e-12;

TEST(PlaneSwatch, APixelIsTheColourOfTheLobeWithThatPeakAtThatAngle) {
    const Panel& panel = picture(SwatchKind::plane, beetle).panels.at(0);
    for (const auto& [column, row] :
         {std::pair{0, 0}, {333, 17}, {panel.image.width() - 1, panel.image.height() - 1}}) {
        const double peak_nm = 380.0 + 400.0 * column / (panel.image.width() - 1);
        const double angle_deg = 90.0 - 90.0 * row / (panel.image.height() - 1);
        Lobe lobe = palette_lobe(palette_of(beetle), Incidence::from_degrees(angle_deg));
        lobe.peak_nm = peak_nm;
        const Light& light = *daylight();
        const Xyz expected = adapt(light.adaptation, lobe_to_xyz(light, {lobe.peak_nm, lobe.width_nm, lobe.height}));
        const Xyz& pixel = panel.image.at(column, row);
        EXPECT_NEAR(pixel.x, expected.x, rounding);
        EXPECT_NEAR(pixel.y, expected.y, rounding);
        EXPECT_NEAR(pixel.z, expected.z, rounding);
    }
}

// Two picks whose height falls by 0.5 from 20 to 50 degrees: Y(theta) = p cos^2 + (1 - p) cos meets height 0 where it
// has fallen by 1.8 times Y(20) - Y(50). With p = 0.88: Y(20) = 0.88982, Y(50) = 0.44073, so Y = 0.08146, c = 0.24362.
TEST(PlaneSwatch, SaysWhereThePaletteIsClamped) {
    const Swatch& swatch = picture(SwatchKind::plane, steep);
    EXPECT_TRUE(says(swatch, "height reaches 0 at 75.9°"));
    EXPECT_TRUE(says(swatch, "height reaches 1 at 8.5°"));
    EXPECT_NEAR(std::acos(0.24362) * 180.0 / 3.141592653589793, 75.9, 0.05);
}

TEST(PaletteSwatch, HasAPanelForEveryPickWithItsSquareInIt) {
    const Swatch& swatch = picture(SwatchKind::palette, morpho);
    ASSERT_EQ(swatch.panels.size(), 2u);
    EXPECT_TRUE(says(swatch, "460 nm at 0°"));
    EXPECT_TRUE(says(swatch, "395 nm at 40°"));
    const std::vector<Point> centres = squares(swatch);
    ASSERT_EQ(centres.size(), 2u);
    const Panel& second = swatch.panels[1];
    const double side = second.image.width() - 1;
    EXPECT_NEAR(centres[1].x - second.left - 0.5, side * 60.0 / 200.0, 1e-9);
    EXPECT_NEAR(centres[1].y - second.top - 0.5, side * 0.3, 1e-9);
}

TEST(PaletteSwatch, HeightOneIsAtTheTopAndHeightZeroIsBlack) {
    const Panel& panel = picture(SwatchKind::palette, morpho).panels.at(0);
    const int last = panel.image.width() - 1;
    const Light& light = *daylight();
    const Xyz expected = adapt(light.adaptation, lobe_to_xyz(light, {460.0, 200.0, 1.0}));
    EXPECT_NEAR(panel.image.at(last, 0).y, expected.y, rounding);
    for (int column = 0; column <= last; ++column) ASSERT_EQ(panel.image.at(column, last).y, 0.0);
}

TEST(PaletteSwatch, SaysHowManyPicksItDoesNotShow) {
    Palette many;
    for (int i = 0; i < 40; ++i) many.picks.push_back({2.0 * i, {450.0 + i, 50.0, 0.5}});
    const Swatch swatch = draw_swatch(planned(SwatchKind::palette, {"many", many, {}}));
    EXPECT_EQ(swatch.panels.size(), most_palette_panels);
    EXPECT_TRUE(says(swatch, "the first 12 of 40 picks"));
}

// cos 60 = 1/2.
TEST(StripSwatch, TicksSitWhereTheAxisPutsTheirAngles) {
    const std::map<std::string_view, double> expected{
        {"sqrt_cos_theta", std::sqrt(0.5)}, {"cos_theta", 0.5}, {"theta_deg", 60.0 / 90.0}};
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.quantity != Quantity::incidence) continue;
        PlannedSwatch plan = planned(SwatchKind::strip, morpho);
        plan.shown_axis = &kind;
        const Swatch swatch = draw_swatch(plan);
        const Panel& panel = swatch.panels.at(0);
        const double place = between_labels(swatch, "60°", "60°", 0.0, true);
        EXPECT_NEAR((place - panel.left - 0.5) / (panel.image.width() - 1), expected.at(kind.name), 0.001) << kind.name;
    }
}

TEST(StripSwatch, ABracketReachesFromTheClampToTheEndOfTheAxis) {
    const Swatch& swatch = picture(SwatchKind::strip, steep);
    const Panel& panel = swatch.panels.at(0);
    const double bound = panel.left + 0.5 + 75.9 / 90.0 * (panel.image.width() - 1);
    const auto rectangles = all_of<Rectangle>(swatch);
    EXPECT_TRUE(std::any_of(rectangles.begin(), rectangles.end(), [&](const Rectangle& bar) {
        return std::abs(bar.box.left - bound) < 1.0 && bar.box.right == panel.left + panel.image.width() &&
               bar.box.bottom < panel.top;
    }));
    EXPECT_TRUE(says(swatch, "height reaches 0 at 75.9°"));
}

TEST(StripSwatch, AMaterialThatIsNeverClampedHasNoSuchNote) {
    for (const Text& text : all_of<Text>(picture(SwatchKind::strip, morpho))) {
        EXPECT_EQ(text.text.find("reaches"), std::string::npos) << text.text;
    }
}

TEST(StripSwatch, ATwoDimensionalLutHasItsSmallestYAtTheBottom) {
    PlannedSwatch plan = planned(SwatchKind::strip, beetle);
    plan.jobs[0].y = parameter_axis(beetle.mechanism, "height", 0.0, 1.0);
    const Panel panel = draw_swatch(plan).panels.at(0);
    EXPECT_EQ(panel.image.at(100, panel.image.height() - 1).y, 0.0);
    EXPECT_GT(panel.image.at(100, 0).y, 0.05);
}

// Of glass from one side: 4 % comes back from its face.
TEST(StripSwatch, ATransmittanceLiesOverACheckerboard) {
    Mechanism glass = Film{1.0, 1.5, 0.0, 1.5, 0.0};
    glass.effects.observed = Observed::transmittance;
    const Panel panel = draw_swatch(planned(SwatchKind::strip, {"glass", glass, {}})).panels.at(0);
    const int side = panel.image.height() / 5;
    EXPECT_NEAR(panel.image.at(side - 1, side - 1).y, 0.96, 1e-6);
    EXPECT_NEAR(panel.image.at(side, side - 1).y, 0.48, 1e-3);
    EXPECT_NEAR(panel.image.at(side - 1, side).y, 0.48, 1e-6);
    EXPECT_NEAR(panel.image.at(side, side).y, 0.96, 1e-3);
}

// cos 60 = 1/2: the texels of the default axis are even in the square root.
TEST(StripSwatch, ASecondScaleSaysWhereTheTexelsAre) {
    const Swatch& swatch = picture(SwatchKind::strip, morpho);
    EXPECT_TRUE(says(swatch, "angle"));
    EXPECT_TRUE(says(swatch, "texture coordinate (sqrt_cos_theta)"));
    const AxisKind& shown = even_degrees();
    const AxisKind& texels = default_axis_kind(Quantity::incidence);
    const std::vector<Tick> ticks = texel_ticks(shown, texels, 1100);
    ASSERT_EQ(ticks.size(), 11u);
    EXPECT_EQ(ticks[0].coordinate, 1.0);
    EXPECT_EQ(ticks[10].coordinate, 0.0);
    EXPECT_NEAR(ticks[5].coordinate, std::acos(0.25) * 180.0 / 3.141592653589793 / 90.0, 1e-12);
    EXPECT_EQ(ticks[5].label, "0.5");
}

TEST(StripSwatch, EvenInItsOwnAxisItHasOneScale) {
    PlannedSwatch plan = planned(SwatchKind::strip, morpho);
    plan.shown_axis = plan.jobs[0].x.kind;
    const Swatch swatch = draw_swatch(plan);
    EXPECT_FALSE(says(swatch, "texture coordinate (sqrt_cos_theta)"));
    EXPECT_EQ(swatch.height, picture(SwatchKind::strip, morpho).height - texel_scale_height);
}

TEST(StripSwatch, AFixedExposureMultipliesTheColoursAndIsSaid) {
    PlannedSwatch plan = planned(SwatchKind::strip, morpho);
    plan.exposure_ev = 1.0;
    const Swatch swatch = draw_swatch(plan);
    const Xyz& plain = picture(SwatchKind::strip, morpho).panels.at(0).image.at(0, 0);
    EXPECT_EQ(swatch.panels.at(0).image.at(0, 0).y, 2.0 * plain.y);
    EXPECT_TRUE(says(swatch, "exposure +1 EV"));
    EXPECT_FALSE(says(picture(SwatchKind::strip, morpho), "exposure 0 EV"));
}

// The Morpho's blue is no mixture of sRGB's primaries.
TEST(PicksSwatch, PatchesAndStripFollowOneGamutRuleAndMarkWhatIsOutside) {
    PlannedSwatch plan = planned(SwatchKind::picks, morpho);
    const Light& light = *daylight();
    PickedColour picked;
    picked.colour = {0.3, 0.25, 0.2};  // well inside sRGB
    picked.reached = adapt(light.adaptation, lobe_to_xyz(light, {460.0, 70.0, 1.0}));
    plan.picked = {picked};
    const LutSpace rec709{"lin_rec709", [](const Image<Xyz>& image) {
                              Image<Rgb> rgb(image.width(), image.height());
                              std::transform(image.begin(), image.end(), rgb.begin(), linear_rec709);
                              return rgb;
                          }};
    const Swatch swatch = draw_swatch(plan, rec709);
    ASSERT_EQ(swatch.panels.size(), 3u);
    for (const Panel& panel : swatch.panels) EXPECT_TRUE(panel.is_exact);
    const Panel& reached = swatch.panels[1];
    EXPECT_EQ(swatch.panels[2].image.at(0, 0), reached.image.at(0, 0));  // the pick at 0 degrees
    const auto marks_on = [&](const Panel& panel) {
        const auto lines = all_of<Polyline>(swatch);
        return std::count_if(lines.begin(), lines.end(), [&](const Polyline& line) {
            const Point& p = line.points.front();
            return p.x >= panel.left && p.x < panel.left + panel.image.width() && p.y >= panel.top &&
                   p.y < panel.top + panel.image.height();
        });
    };
    EXPECT_EQ(marks_on(swatch.panels[0]), 0);
    EXPECT_GT(marks_on(reached), 5);
    const auto texts = all_of<Text>(swatch);
    EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const Text& text) {
        return text.text.starts_with("outside lin_rec709: ") && text.text.ends_with("of the strip");
    }));
}

TEST(AxisTicks, LabelsKeepTheirDistanceAndTheEndsHaveOne) {
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.quantity != Quantity::incidence) continue;
        for (const int length_px : {300, 475, 1100, 2000}) {
            const std::vector<Tick> ticks = axis_ticks({&kind, {}, 0.0, 1.0}, length_px, true);
            ASSERT_EQ(ticks.size(), 10u);
            EXPECT_EQ(ticks.front().label, "0°");
            EXPECT_EQ(ticks.back().label, "90°");
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    if (ticks[i].label.empty() || ticks[j].label.empty()) continue;
                    // "90°" at 22 pixels is 39 pixels wide in DejaVu Sans.
                    EXPECT_GT(std::abs(ticks[i].coordinate - ticks[j].coordinate) * length_px, 39.0);
                }
            }
        }
    }
}

TEST(AxisTicks, OfAParameterAreRoundNumbersWithinItsRange) {
    Axis axis = parameter_axis(morpho.mechanism, "peak_nm", 403.0, 697.0);
    std::vector<std::string> labels;
    for (const Tick& tick : axis_ticks(axis, 1000, true)) {
        EXPECT_GE(tick.coordinate, 0.0);
        EXPECT_LE(tick.coordinate, 1.0);
        labels.push_back(tick.label);
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"450", "500", "550", "600", "650"}));
    std::swap(axis.from, axis.to);
    EXPECT_NEAR(axis_ticks(axis, 1000, true).front().coordinate, (697.0 - 450.0) / 294.0, 1e-12);
}

TEST(AxisTicks, OfOtherQuantitiesAreTheirNumbersFromEndToEnd) {
    // u = |sin + sin| is 2 at most, a cosine goes from -1 to 1; steps are 1, 2 or 5 times a power of ten.
    const std::map<Quantity, std::vector<std::string>> expected{
        {Quantity::grating_u, {"0", "0.2", "0.4", "0.6", "0.8", "1", "1.2", "1.4", "1.6", "1.8", "2"}},
        {Quantity::cos_scatter, {"-1", "-0.8", "-0.6", "-0.4", "-0.2", "0", "0.2", "0.4", "0.6", "0.8", "1"}}};
    for (const auto& [quantity, labels] : expected) {
        const std::vector<Tick> ticks = axis_ticks({&default_axis_kind(quantity), {}, 0.0, 1.0}, 1100, true);
        ASSERT_EQ(ticks.size(), labels.size());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            EXPECT_NEAR(ticks[i].coordinate, static_cast<double>(i) / 10.0, 1e-12);
            EXPECT_EQ(ticks[i].label, labels[i]);
        }
    }
}

TEST(AxisTicks, ComeToAnEndOnARangeThatIsNarrowerThanItsDigits) {
    const Axis axis = parameter_axis(morpho.mechanism, "peak_nm", 1000.0, std::nextafter(1000.0, 2000.0));
    EXPECT_LE(axis_ticks(axis, 1000, true).size(), 101u);
}

TEST(FitToSrgb, KeepsColoursThatAreWellInside) {
    for (const Xyz colour : {Xyz{0.9505, 1.0, 1.089}, Xyz{0.3, 0.25, 0.2}, Xyz{}})
        EXPECT_EQ(fit_to_srgb(colour), colour);
}

TEST(FitToSrgb, BringsEveryLobeInsideAndKeepsItsLargestComponent) {
    const Light& light = *daylight();
    for (double peak_nm = 380.0; peak_nm <= 720.0; peak_nm += 5.0) {
        const Xyz colour = lobe_to_xyz(light, {peak_nm, 20.0, 1.0});
        const Rgb before = linear_rec709(colour), after = linear_rec709(fit_to_srgb(colour));
        const double most = std::max({before.r, before.g, before.b});
        EXPECT_NEAR(std::max({after.r, after.g, after.b}), most, 1e-12 * most) << peak_nm;
        EXPECT_GE(std::min({after.r, after.g, after.b}), 0.0) << peak_nm;
    }
}

// IEC 61966-2-1 prints its matrix with four decimals.
TEST(FitToSrgb, TheMatrixIsTheStandards) {
    const Rgb x = linear_rec709({1.0, 0.0, 0.0}), y = linear_rec709({0.0, 1.0, 0.0}),
              z = linear_rec709({0.0, 0.0, 1.0});
    const double found[] = {x.r, y.r, z.r, x.g, y.g, z.g, x.b, y.b, z.b};
    const double printed[] = {3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570};
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(found[i], printed[i], 6e-4) << i;
}

TEST(Swatches, EverythingLiesOnThePicture) {
    for (const auto& word : swatch_words) {
        SCOPED_TRACE(word.name);
        const Swatch& swatch = picture(word.meaning, beetle);
        for (const Panel& panel : swatch.panels) {
            EXPECT_GE(std::min(panel.left, panel.top), 0);
            EXPECT_LE(panel.left + panel.image.width(), swatch.width);
            EXPECT_LE(panel.top + panel.image.height(), swatch.height);
        }
        for (const Rectangle& rectangle : all_of<Rectangle>(swatch)) {
            EXPECT_GE(std::min(rectangle.box.left, rectangle.box.top), 0.0);
            EXPECT_LE(rectangle.box.right, swatch.width);
            EXPECT_LE(rectangle.box.bottom, swatch.height);
        }
        for (const Text& text : all_of<Text>(swatch)) {
            EXPECT_GE(text.baseline.y, text.size_px);
            EXPECT_LE(text.baseline.y + 0.3 * text.size_px, swatch.height);
        }
    }
}

}  // namespace
}  // namespace nacre
