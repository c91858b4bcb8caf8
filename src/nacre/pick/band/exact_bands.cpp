// From a colour to a band that has it.
//
// What lies above `low` has to have the rest of the colour: a unit band, dimmed. A table says which half cosines have
// the rest's chromaticity (there may be several), and Newton's method ends the search. Where all are too dark, the
// plateau grows until one is bright enough: three equations, of XYZ, for peak, width and flatness. It starts between
// the half cosine and the flattest band of the chromaticity, which a second table leads to.
#include "nacre/pick/band/exact_bands.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace nacre {
namespace {

// Grids of the tables, chosen so that Newton's method starts near enough (tests/nacre/pick/band/exact_bands_test.cpp).
constexpr std::size_t peaks = 96;
constexpr std::size_t spreads = 40;
constexpr std::size_t box_places = 64;
constexpr std::size_t box_lengths = 40;

// Newton's method. Columns of its matrix are per 100 nm, per unit of spread and per unit of flatness.
constexpr int most_steps = 12;
constexpr double nm_per_unit = 100.0;
constexpr double difference = 1e-4;    // of the units above, for slopes
constexpr double longest_step = 0.15;  // in the same units
constexpr double exact_enough = 1e-9;  // of u' + v', and of XYZ relative to the colour's own Y
constexpr double nearly_exact = 1e-6;  // of the same: CIEDE2000 0.003 at most, where the spectrum's ends count little
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
            glm::dvec3 beside(0.0);
            // Away from the end of a range.
            const bool at_end = (i == 1 && band.spread > 0.5) || (i == 2 && band.flatness > 0.5);
            beside[i] = at_end ? -difference : difference;
            slopes[i] = (residual(moved(band, beside)) - here) / beside[i];
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

std::vector<double> make_edges_nm(const TristimulusWeights& weights) {
    constexpr int count = 256;
    std::vector<double> edges;
    const double whole = weights.white.x + weights.white.y + weights.white.z;
    const auto reached = [&](int cell) {  // half by power, half by wavelength
        const Xyz& c = weights.cumulative[static_cast<std::size_t>(cell)];
        return 0.5 * (c.x + c.y + c.z) / whole + 0.5 * cell / (weights.count() - 1.0);
    };
    int cell = 0;
    for (int i = 0; i <= count; ++i) {
        const double wanted = static_cast<double>(i) / count;
        while (cell + 2 < weights.count() && reached(cell + 1) < wanted) ++cell;
        const double t = (wanted - reached(cell)) / (reached(cell + 1) - reached(cell));
        edges.push_back(weights.first_nm + cell + std::clamp(t, 0.0, 1.0));
    }
    return edges;
}

double edge_nm(const std::vector<double>& edges, double t) {
    const double position = t * static_cast<double>(edges.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(position), edges.size() - 2);
    return std::lerp(edges[i], edges[i + 1], position - static_cast<double>(i));
}

struct Box {
    double from_nm, to_nm;
};
Box box_at(const std::vector<double>& edges, const ChromaticityTable::Place& place) {
    const double length = std::max(place.q * place.q, 1e-4);
    const double from = place.p * (1.0 - length);
    return {edge_nm(edges, from), edge_nm(edges, from + length)};
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

Xyz box_to_xyz(const Light& light, BandKind kind, const Box& box) {
    const Xyz up = plateau_to_xyz(light.weights, box.from_nm, box.to_nm);
    if (kind == BandKind::band) return up;
    const Xyz& white = light.weights.white;
    return {white.x - up.x, white.y - up.y, white.z - up.z};
}

ChromaticityTable box_table(const Light& light, BandKind kind, const std::vector<double>& edges) {
    return {box_places, box_lengths,
            [&](const ChromaticityTable::Place& place) { return box_to_xyz(light, kind, box_at(edges, place)); }};
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
      edges_nm_(make_edges_nm(light.weights)),
      half_cosines_{half_cosine_table(light, BandKind::band), half_cosine_table(light, BandKind::notch)},
      boxes_{box_table(light, BandKind::band, edges_nm_), box_table(light, BandKind::notch, edges_nm_)} {}

// @param colour_at  of a unit band
template <typename ColourAt>
bool ExactBands::solve_chromaticity(Uv target, const ColourAt& colour_at, UnitBand& band) const {
    return newton(
        light_, 2,
        [&](const UnitBand& b) -> glm::dvec3 {
            const Uv uv = uv_of(colour_at(b));
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
template <typename BandAt, typename ColourAt>
ExactBands::Roots ExactBands::roots_from(const ChromaticityTable& table, const Xyz& target, const BandAt& band_at,
                                         const ColourAt& colour_at) const {
    Roots roots;
    const Uv uv = uv_of(target);
    for (const ChromaticityTable::Place& start : table.starts(uv)) {
        UnitBand band = band_at(start);
        if (roots.has(band, 1.0, 6e-3)) continue;
        if (!solve_chromaticity(uv, colour_at, band)) continue;
        if (!roots.has(band, 0.05, 5e-4)) roots.band[roots.count++] = band;
    }
    return roots;
}

ExactBands::Roots ExactBands::half_cosine_roots(BandKind kind, const Xyz& target) const {
    return roots_from(
        half_cosines_[index_of(kind)], target,
        [&](const ChromaticityTable::Place& start) { return half_cosine_at(light_, start); },
        [&](const UnitBand& band) { return colour_of(kind, band); });
}

// First among rectangles, whose colours are differences of running integrals.
std::optional<UnitBand> ExactBands::flattest(BandKind kind, const Xyz& target) const {
    const double rectangle = fullness(largest_flatness);  // its share of the width
    const auto box_colour = [&](const UnitBand& band) {
        const double half_nm = 0.5 * rectangle * band.width_nm();
        return box_to_xyz(light_, kind, {band.peak_nm - half_nm, band.peak_nm + half_nm});
    };
    const Roots roots = roots_from(
        boxes_[index_of(kind)], target,
        [&](const ChromaticityTable::Place& start) -> UnitBand {
            const Box box = box_at(edges_nm_, start);
            return within_limits(
                light_, {0.5 * (box.from_nm + box.to_nm),
                         std::sqrt((box.to_nm - box.from_nm) / rectangle / UnitBand::widest_nm), largest_flatness});
        },
        box_colour);
    std::optional<UnitBand> brightest;
    for (std::size_t i = 0; i < roots.count; ++i) {
        if (!brightest || box_colour(roots.band[i]).y > box_colour(*brightest).y) brightest = roots.band[i];
    }
    const auto colour_at = [&](const UnitBand& band) { return colour_of(kind, band); };
    if (brightest && !solve_chromaticity(uv_of(target), colour_at, *brightest)) return {};
    return brightest;
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
        const bool is_there = solve_chromaticity(
            uv, [&](const UnitBand& band) { return colour_of(kind, band); }, middle);
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
    const bool is_bright_enough = level_of_flat <= 1.0 + rounding;
    if (is_bright_enough && level_of_flat > 1.0 - rounding) return flat;
    std::optional<UnitBand> best;
    for (std::size_t i = 0; i < roots.count; ++i) {
        const UnitBand& root = roots.band[i];
        const double too_dark = level_of(target, colour_of(kind, root)) - 1.0;
        UnitBand band = root;
        if (is_bright_enough) {
            const double t = std::clamp(too_dark / (too_dark + 1.0 - level_of_flat), 0.05, 0.95);
            band = {std::lerp(root.peak_nm, flat->peak_nm, t), std::lerp(root.spread, flat->spread, t),
                    t * largest_flatness};
        } else if (too_dark > hardly_too_dark) {
            continue;  // nearly white, a band may lose light again as it gets flatter; it is no more than this
        }
        if (solve_colour(kind, target, band) && (!best || band.flatness < best->flatness)) best = band;
    }
    if (best || !is_bright_enough) return best;
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
    double share = 0.0;
    if (!has_chromaticity(colour)) return share;
    for (const BandKind kind : {BandKind::band, BandKind::notch}) {
        if (const auto band = flattest(kind, colour)) share = std::max(share, colour_of(kind, *band).y / colour.y);
    }
    return share;
}

}  // namespace nacre
