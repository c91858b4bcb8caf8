// From a colour to a band that has it.
//
// What lies above `low` has to have the rest of the colour: a unit band, dimmed. A table says which half cosines have
// the rest's chromaticity (there may be several), and Newton's method ends the search. Where all are too dark, the
// plateau grows until one is bright enough: three equations, of XYZ, for peak, width and flatness. It starts between
// the half cosine and the flattest band of the chromaticity, which is where the solid of all colours ends.
#include "nacre/pick/band/exact_bands.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

// Grid of the tables, chosen so that Newton's method starts near enough (tests/nacre/pick/band/exact_bands_test.cpp).
constexpr std::size_t peaks = 96;
constexpr std::size_t spreads = 40;

// Newton's method. Columns of its matrix are per 100 nm, per unit of spread and per unit of flatness.
constexpr int most_steps = 12;
constexpr double nm_per_unit = 100.0;
constexpr double difference = 1e-4;    // of the units above, for slopes
constexpr double longest_step = 0.15;  // in the same units
constexpr double exact_enough = 1e-9;  // of u' + v', and of XYZ relative to the colour's own Y
constexpr double nearly_exact = 1e-6;  // of the same: CIEDE2000 0.003 at most, where the spectrum's ends count little
constexpr double invisible_de00 = 0.008;  // chosen: of a band from a colour in a dent of the spectral locus
constexpr double hardly_too_dark = 0.1;
constexpr double rounding = 2e-5;  // by which a level may exceed 1, before it is made 1
constexpr double damping = 1e-10;  // of the normal equations, where a number makes no difference

double level_of(const Xyz& target, const Xyz& unit) {
    return target.y / unit.y;
}

// The share of a band's area that a rectangle of its width would have.
double fullness(double flatness) {
    return flatness + (1.0 - flatness) * 2.0 / std::numbers::pi;
}

UnitBand moved(const UnitBand& band, const glm::dvec3& step) {
    return {band.peak_nm + nm_per_unit * step.x, band.spread + step.y, band.flatness + step.z};
}

double size_of(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Newton's method for a residual of a band; numbers whose column is 0 stay as they are. The shortest step is taken
// where several would do.
//
// @param free      how many of peak, spread and flatness may change
// @param residual  Xyz-like triple of a band, to become 0
template <typename Residual>
bool newton(const Light& light, int free, const Residual& residual, UnitBand& band) {
    glm::dvec3 here = residual(band);
    double error = size_of(here);
    for (int step = 0; step < most_steps && std::isfinite(error); ++step) {
        if (error < exact_enough) return true;
        glm::dmat3 slopes(0.0);
        for (int i = 0; i < free; ++i) {
            // Away from the end of a range.
            const bool at_end = (i == 1 && band.spread > 0.5) || (i == 2 && band.flatness > 0.5);
            const double by = at_end ? -difference : difference;
            // Clang 14 reads a zero from a vector whose i-th component was set, for WebAssembly with SIMD.
            const glm::dvec3 beside(i == 0 ? by : 0.0, i == 1 ? by : 0.0, i == 2 ? by : 0.0);
            slopes[i] = (residual(moved(band, beside)) - here) / by;
        }
        glm::dmat3 normal = slopes * glm::transpose(slopes);
        const double trace = normal[0][0] + normal[1][1] + normal[2][2];
        for (int i = 0; i < 3; ++i) normal[i][i] += damping * trace + 1e-300;
        glm::dvec3 change = -(glm::transpose(slopes) * (glm::inverse(normal) * here));
        if (!is_finite(change)) return false;
        const double length = std::max({std::abs(change.x), std::abs(change.y), std::abs(change.z)});
        if (length > longest_step) change *= longest_step / length;
        // Shorter steps, until one leads nearer.
        constexpr int halvings = 5;
        UnitBand next;
        glm::dvec3 there(0.0);
        for (int i = 0; i <= halvings; ++i, change *= 0.5) {
            next = within_limits(light, moved(band, change));
            there = residual(next);
            if (size_of(there) < error) break;
        }
        if (!(size_of(there) < error)) break;
        band = next;
        here = there;
        error = size_of(here);
    }
    return error < nearly_exact;
}

UnitBand half_cosine_at(const Light& light, const ChromaticityTable::Place& place) {
    const double first_nm = light.weights.first_nm;
    const double last_nm = light.weights.last_nm;
    return {std::lerp(first_nm, last_nm, place.p), std::max(place.q, UnitBand::narrowest_spread), 0.0};
}

ChromaticityTable half_cosine_table(const Light& light, BandKind kind) {
    return {peaks, spreads, [&](const ChromaticityTable::Place& place) {
                return unit_band_to_xyz(light, kind, half_cosine_at(light, place));
            }};
}

std::size_t index_of(BandKind kind) {
    return kind == BandKind::band ? 0 : 1;
}

bool has_chromaticity(const Xyz& colour) {
    return colour.y > 0.0 && colour.x + 15.0 * colour.y + 3.0 * colour.z > 0.0;
}

}  // namespace

ExactBands::ExactBands(const Light& light)
    : light_(light),
      solid_(light.weights),
      half_cosines_{half_cosine_table(light, BandKind::band), half_cosine_table(light, BandKind::notch)} {}

bool ExactBands::solve_chromaticity(BandKind kind, Uv target, UnitBand& band) const {
    return newton(
        light_, 2,
        [&](const UnitBand& b) -> glm::dvec3 {
            const Uv uv = uv_of(colour_of(kind, b));
            return {uv.u - target.u, uv.v - target.v, 0.0};
        },
        band);
}

bool ExactBands::solve_colour(BandKind kind, const Xyz& target, UnitBand& band) const {
    return newton(
        light_, 3,
        [&](const UnitBand& b) -> glm::dvec3 {
            const Xyz c = colour_of(kind, b);
            return glm::dvec3(c.x - target.x, c.y - target.y, c.z - target.z) / target.y;
        },
        band);
}

// Newton's method from every start. Triangles overlap by their slack: a start beside a root leads to it.
ExactBands::Roots ExactBands::half_cosine_roots(BandKind kind, const Xyz& target) const {
    Roots roots;
    const Uv uv = uv_of(target);
    for (const ChromaticityTable::Place& start : half_cosines_[index_of(kind)].starts(uv)) {
        UnitBand band = half_cosine_at(light_, start);
        if (roots.has(band, 1.0, 6e-3)) continue;
        if (!solve_chromaticity(kind, uv, band)) continue;
        if (!roots.has(band, 0.05, 5e-4)) roots.band[roots.count++] = band;
    }
    return roots;
}

UnitBand ExactBands::rectangle_of(const ColourSolid::Stretch& stretch) const {
    const double width_nm = (stretch.to_nm - stretch.from_nm) / fullness(largest_flatness);
    return within_limits(
        light_, {0.5 * (stretch.from_nm + stretch.to_nm), std::sqrt(width_nm / UnitBand::widest_nm), largest_flatness});
}

// The nearest band to a colour that a stretch leads to: a rectangle of exactly its chromaticity if that is bright
// enough, else the stretch as it is, or the half cosine of its place, whose colour is a mean over many stretches.
//
// @param share  by which the stretch is brighter than the target
ExactBands::Nearest ExactBands::nearest(const ColourSolid::Stretch& stretch, const Xyz& target, double share) const {
    const auto lab = [&](const Xyz& c) { return to_lab(adapt(light_.adaptation, c), d65_white); };
    Nearest best{stretch.kind, {}, std::numeric_limits<double>::infinity()};
    const auto consider = [&](const UnitBand& band) {
        const Xyz reached = colour_of(stretch.kind, band);
        const Xyz dimmed = scaled(reached, std::min(level_of(target, reached), 1.0));
        const double de00 = ciede2000(lab(target), lab(dimmed));
        if (de00 < best.de00) best = {stretch.kind, band, de00};
        return best.de00 < invisible_de00;
    };
    const UnitBand rectangle = rectangle_of(stretch);
    UnitBand band = rectangle;
    solve_chromaticity(stretch.kind, uv_of(target), band);
    if (consider(band) || consider(rectangle)) return best;
    const Lab bright = lab(scaled(target, share));
    for (const double flatness : {largest_flatness, 0.0}) {
        band = rectangle;
        band.spread = std::min(band.spread * std::sqrt(fullness(largest_flatness) / fullness(flatness)), 1.0);
        band.flatness = flatness;
        newton(
            light_, 2,
            [&](const UnitBand& b) -> glm::dvec3 {
                const auto parts = ciede2000_parts(bright, lab(colour_of(stretch.kind, b)));
                return {parts[0], parts[1], parts[2]};
            },
            band);
        consider(band);
    }
    return best;
}

// The brightest band of the chromaticity: a rectangle, with sides as steep as they get. In a dent of the spectral locus
// there may be none, or too dark a one; then the nearest that is as bright as can be, or just bright enough.
std::optional<UnitBand> ExactBands::flattest(BandKind kind, const Xyz& target) const {
    const ColourSolid::Boundary boundary = solid_.along(target);
    if (boundary.share < 1.0 - rounding) return {};
    Nearest best = nearest(boundary.stretch, target, boundary.share);
    for (const double share : {boundary.share, 1.0}) {
        if (best.de00 < invisible_de00) break;
        const Nearest other = nearest(solid_.nearest(scaled(target, share)), target, share);
        if (other.de00 < best.de00) best = other;
    }
    return best.kind == kind ? std::optional(best.band) : std::nullopt;
}

// From the flattest downwards, as far as there is a band of the chromaticity that is bright enough.
UnitBand ExactBands::less_flat(BandKind kind, const Xyz& target, UnitBand flat) const {
    const Uv uv = uv_of(target);
    double too_little = 0.0;
    constexpr int halvings = 14;
    for (int i = 0; i < halvings; ++i) {
        UnitBand middle = flat;
        middle.flatness = 0.5 * (too_little + flat.flatness);
        middle.spread *= std::sqrt(fullness(flat.flatness) / fullness(middle.flatness));
        const bool is_there = solve_chromaticity(kind, uv, middle);
        if (is_there && level_of(target, colour_of(kind, middle)) <= 1.0)
            flat = middle;
        else
            too_little = middle.flatness;
    }
    return flat;
}

// @param target  of a band between 0 and 1
std::optional<UnitBand> ExactBands::least_flat(BandKind kind, const Xyz& target, const Roots& roots) const {
    const auto flat = flattest(kind, target);
    const double level_of_flat = flat ? level_of(target, colour_of(kind, *flat)) : 2.0;
    if (flat && level_of_flat > 1.0 - rounding) return flat;
    std::optional<UnitBand> best;
    for (std::size_t i = 0; i < roots.count; ++i) {
        const UnitBand& root = roots.band[i];
        const double too_dark = level_of(target, colour_of(kind, root)) - 1.0;
        UnitBand band = root;
        if (flat) {
            const double t = std::clamp(too_dark / (too_dark + 1.0 - level_of_flat), 0.05, 0.95);
            band = {std::lerp(root.peak_nm, flat->peak_nm, t), std::lerp(root.spread, flat->spread, t),
                    t * largest_flatness};
        } else if (too_dark > hardly_too_dark) {
            continue;  // nearly white, a band may lose light again as it gets flatter; it is no more than this
        }
        if (solve_colour(kind, target, band) && (!best || band.flatness < best->flatness)) best = band;
    }
    if (best || !flat) return best;
    UnitBand band = *flat;
    band.flatness = 0.3;  // chosen: what most of them have
    band.spread = std::min(band.spread * std::sqrt(fullness(flat->flatness) / fullness(band.flatness)), 1.0);
    if (solve_colour(kind, target, band)) return band;
    return less_flat(kind, target, *flat);
}

std::optional<ExactBands::Match> ExactBands::find(const Xyz& colour, BandKind kind, double low) const {
    const Xyz& white = light_.weights.white;
    const double most = 1.0 - low;
    const Xyz target{(colour.x - low * white.x) / most, (colour.y - low * white.y) / most,
                     (colour.z - low * white.z) / most};
    if (!has_chromaticity(target)) return {};
    const Roots roots = half_cosine_roots(kind, target);
    std::optional<UnitBand> band;
    for (std::size_t i = 0; i < roots.count; ++i) {
        const UnitBand& root = roots.band[i];
        if (level_of(target, colour_of(kind, root)) > 1.0 + rounding) continue;
        if (!band || root.spread > band->spread) band = root;
    }
    if (!band) band = least_flat(kind, target, roots);
    if (!band) return {};
    const double level = std::min(level_of(target, colour_of(kind, *band)), 1.0);
    return Match{kind, *band, low, low + most * level};
}

double ExactBands::brightest(const Xyz& colour) const {
    return has_chromaticity(colour) ? solid_.along(colour).share : 0.0;
}

}  // namespace nacre
