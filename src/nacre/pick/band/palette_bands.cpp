// Bands that belong together.
//
// A colour is shared by many bands: with more floor a band is narrower, and a notch may stand for it. Every pick gets a
// list of candidates, each of which has its colour exactly; then the cheapest way through the lists is found, from the
// smallest angle to the largest.
#include "nacre/pick/band/palette_bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/oklab.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/palette_colour.h"

namespace nacre {
namespace {

// The weights of the objective, in units of Oklab; chosen by looking at the strips of twenty pairs of colours.
constexpr double per_floor = 0.3;
constexpr double per_flatness = 0.05;
constexpr double per_notch = 0.03;
constexpr double per_nm_moved = 0.02 / 100.0;
constexpr double per_nm_risen = 0.08 / 100.0;

constexpr int path_steps = 6;  // chords of the path between two picks

// Floors of the candidates, as shares of the highest floor that the colour allows.
constexpr std::array floors{0.0, 0.4, 0.75, 0.95};

constexpr double black = 1e-7;            // Y of what has no chromaticity
constexpr double grey_difference = 3e-6;  // in u' + v': CIEDE2000 0.005 at most

struct Candidate {
    Lobe band;
    double cost = 0.0;
};

// A pick's candidates. A grey one has none of its own: height and floor are its luminance.
struct Candidates {
    std::vector<Candidate> list;
    std::optional<double> grey;
};

Lobe as_grey(Lobe band, double luminance) {
    band.height = band.floor = luminance;
    return band;
}

// What is beyond these digits cannot be seen, and it would depend on the compiler.
Lobe rounded(const Lobe& band) {
    const auto round_to = [](double value, double digits) { return std::round(value * digits) / digits; };
    constexpr double of_nm = 1e5;
    constexpr double of_one = 1e8;
    return {round_to(band.peak_nm, of_nm), round_to(band.width_nm, of_nm), round_to(band.height, of_one),
            round_to(band.floor, of_one), round_to(band.flatness, of_one)};
}

class Choice {
public:
    Choice(const ExactBands& bands, const Light& light)
        : bands_(bands), light_(light), to_light_(glm::inverse(light.adaptation)) {}

    Candidates candidates(const ColourOrBand& pick) const;
    double cost_between(const Lobe& from, const Lobe& to) const;
    Lobe only_band(const Xyz& colour) const;

private:
    std::optional<double> luminance_of_grey(const Xyz& colour) const;
    double highest_floor(const Xyz& colour, BandKind kind) const;
    Oklab seen(const Lobe& band) const { return xyz_to_oklab(adapt(light_.adaptation, lobe_to_xyz(light_, band))); }

    const ExactBands& bands_;
    const Light& light_;
    glm::dmat3 to_light_;
};

std::optional<double> Choice::luminance_of_grey(const Xyz& colour) const {
    if (!(colour.y > black)) return 0.0;
    const Uv uv = uv_of(colour);
    const Uv white = uv_of(light_.weights.white);
    if (std::abs(uv.u - white.u) + std::abs(uv.v - white.v) > grey_difference) return {};
    return std::min(colour.y, 1.0);
}

double Choice::highest_floor(const Xyz& colour, BandKind kind) const {
    double possible = 0.0;
    double too_high = std::min(colour.y, 1.0);
    constexpr int halvings = 6;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (possible + too_high);
        (bands_.find(colour, kind, middle) ? possible : too_high) = middle;
    }
    return possible;
}

Candidates Choice::candidates(const ColourOrBand& pick) const {
    if (!pick.colour) return {{{pick.band, 0.0}}, {}};
    const Xyz colour = adapt(to_light_, *pick.colour);
    if (const auto grey = luminance_of_grey(colour)) return {{}, grey};
    Candidates result;
    for (const BandKind kind : {BandKind::band, BandKind::notch}) {
        const double highest = highest_floor(colour, kind);
        for (const double share : floors) {
            const double low = share * highest;
            const auto match = bands_.find(colour, kind, low);
            if (!match) continue;
            const double cost =
                per_floor * low + per_flatness * match->band.flatness + (kind == BandKind::notch ? per_notch : 0.0);
            result.list.push_back({match->lobe(), cost});
        }
    }
    if (result.list.empty()) result.list.push_back({only_band(*pick.colour), 0.0});
    return result;
}

Lobe Choice::only_band(const Xyz& d65_colour) const {
    const Xyz colour = adapt(to_light_, d65_colour);
    if (const auto grey = luminance_of_grey(colour)) {
        const double middle_nm = 0.5 * (light_.weights.first_nm + light_.weights.last_nm);
        return {middle_nm, 0.0, *grey, *grey, 0.0};
    }
    for (const BandKind kind : {BandKind::band, BandKind::notch}) {
        if (const auto match = bands_.find(colour, kind, 0.0)) return match->lobe();
    }
    return {};
}

double Choice::cost_between(const Lobe& from, const Lobe& to) const {
    double length = 0.0;
    Oklab before = seen(from);
    for (int step = 1; step <= path_steps; ++step) {
        const double t = static_cast<double>(step) / path_steps;
        const Lobe band{std::lerp(from.peak_nm, to.peak_nm, t), std::lerp(from.width_nm, to.width_nm, t),
                        std::lerp(from.height, to.height, t), std::lerp(from.floor, to.floor, t),
                        std::lerp(from.flatness, to.flatness, t)};
        const Oklab here = seen(band);
        length += std::hypot(here.lightness - before.lightness, here.a - before.a, here.b - before.b);
        before = here;
    }
    const double rise_nm = to.peak_nm - from.peak_nm;
    return length + per_nm_moved * std::abs(rise_nm) + per_nm_risen * std::max(rise_nm, 0.0);
}

// The way through the lists: for every candidate the least cost up to it, and which one came before.
class Way {
public:
    explicit Way(const Choice& choice) : choice_(choice) {}

    void add(const Candidates& next) {
        std::vector<Stop> stops;
        // A grey pick repeats the peaks and widths of the one before it.
        const std::size_t count = next.grey && !stops_.empty() ? stops_.back().size() : next.list.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (stops_.empty()) {
                stops.push_back({next.list[i].band, next.list[i].cost, 0});
                continue;
            }
            const auto& before = stops_.back();
            Stop stop{{}, std::numeric_limits<double>::infinity(), 0};
            if (next.grey) {
                stop = {as_grey(before[i].band, *next.grey), before[i].cost, i};
                stop.cost += choice_.cost_between(before[i].band, stop.band);
            } else {
                stop.band = next.list[i].band;
                for (std::size_t j = 0; j < before.size(); ++j) {
                    const double cost =
                        before[j].cost + next.list[i].cost + choice_.cost_between(before[j].band, stop.band);
                    if (cost < stop.cost) stop = {stop.band, cost, j};
                }
            }
            stops.push_back(stop);
        }
        stops_.push_back(std::move(stops));
    }

    std::vector<Lobe> best() const {
        std::vector<Lobe> bands(stops_.size());
        const auto& last = stops_.back();
        auto i = static_cast<std::size_t>(
            std::min_element(last.begin(), last.end(), [](const Stop& a, const Stop& b) { return a.cost < b.cost; }) -
            last.begin());
        for (std::size_t pick = stops_.size(); pick-- > 0;) {
            bands[pick] = stops_[pick][i].band;
            i = stops_[pick][i].before;
        }
        return bands;
    }

private:
    struct Stop {
        Lobe band;
        double cost;
        std::size_t before;
    };
    const Choice& choice_;
    std::vector<std::vector<Stop>> stops_;
};

}  // namespace

std::vector<Lobe> palette_bands(const ExactBands& bands, const Light& light, const std::vector<ColourOrBand>& picks) {
    const Choice choice(bands, light);
    if (picks.size() == 1) return {picks[0].colour ? rounded(choice.only_band(*picks[0].colour)) : picks[0].band};
    std::vector<std::size_t> order(picks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return picks[a].angle_deg < picks[b].angle_deg; });
    std::vector<Candidates> lists;
    for (const std::size_t i : order) lists.push_back(choice.candidates(picks[i]));
    // Grey picks before the first coloured one take its peak and width.
    const auto coloured = std::find_if(lists.begin(), lists.end(), [](const Candidates& c) { return !c.grey; });
    Way way(choice);
    std::vector<Lobe> found;
    if (coloured == lists.end()) {
        for (const std::size_t i : order) found.push_back(choice.only_band(*picks[i].colour));
    } else {
        for (auto list = coloured; list != lists.end(); ++list) way.add(*list);
        found = way.best();
        for (auto list = coloured; list != lists.begin(); --list)
            found.insert(found.begin(), as_grey(found.front(), *std::prev(list)->grey));
    }
    std::vector<Lobe> result(picks.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        result[order[i]] = picks[order[i]].colour ? rounded(found[i]) : picks[order[i]].band;
    return result;
}

}  // namespace nacre
