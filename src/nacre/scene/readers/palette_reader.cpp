#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/scene/readers/mechanism_readers.h"
#include "nacre/scene/readers/pick_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_angle{0.0, 90.0, "degrees"};
constexpr Allowed allowed_peak{100.0, 2000.0, "nm"};
constexpr Allowed allowed_width{0.0, 1000.0, "nm"};
constexpr Allowed allowed_height{0.0, 1.0};
constexpr Allowed allowed_shape{0.0, 1.0};
constexpr std::size_t most_picks = 100;

struct PickParameter {
    std::string_view key;
    std::string_view description;
    Allowed allowed;
    double Lobe::*member;
};
constexpr std::array pick_parameters{
    PickParameter{"peak_nm", "peak wavelength", allowed_peak, &Lobe::peak_nm},
    PickParameter{"width_nm", "width", allowed_width, &Lobe::width_nm},
    PickParameter{"height", "height", allowed_height, &Lobe::height},
};

Palette& palette_of(Mechanism& mechanism) {
    return std::get<Palette>(mechanism);
}

// Throws Error if two picks lie at one angle and differ.
void check_picks_differ(const Palette& palette, const Table& table, const Where& where) {
    const auto& picks = palette.picks;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        for (std::size_t j = i + 1; j < picks.size(); ++j) {
            const double distance_deg = std::abs(picks[i].angle_deg - picks[j].angle_deg);
            if (distance_deg >= smallest_pick_distance_deg || picks[i] == picks[j]) continue;
            table.fail(where, "picks[" + std::to_string(i) + "] and picks[" + std::to_string(j) +
                                  "] are different colours at one angle, " + number_text(picks[i].angle_deg) +
                                  " degrees; allowed are angles at least " + number_text(smallest_pick_distance_deg) +
                                  " degrees apart");
        }
    }
}

// Black says nothing about peak and width: they are those of the nearest pick that is not black, so that the band fades
// where it is.
// @param black  picks that were given as the colour black
void take_shape_of_neighbours(const std::vector<std::size_t>& black, Palette& palette) {
    const auto is_black = [&](const Pick& pick) {
        const auto index = static_cast<std::size_t>(&pick - palette.picks.data());
        return std::find(black.begin(), black.end(), index) != black.end();
    };
    for (const std::size_t index : black) {
        Pick& pick = palette.picks[index];
        double least_deg = 180.0;
        for (const Pick& other : palette.picks) {
            const double distance_deg = std::abs(other.angle_deg - pick.angle_deg);
            if (is_black(other) || distance_deg >= least_deg) continue;
            least_deg = distance_deg;
            pick.lobe = {other.lobe.peak_nm, other.lobe.width_nm, 0.0};
        }
    }
}

// What the scene leaves open is fitted, where picks say anything about it.
void read_shape(const Table& table, const SceneContext& context, Palette& palette) {
    palette.shape = table.number_or("shape", allowed_shape, Palette::default_shape);
    if (table.find("shape") != nullptr || !context.picks.lobe_colour) return;
    const auto fit = fit_shape(palette.picks, context.picks.lobe_colour);
    if (!fit) return;
    palette.shape = fit->shape;
    context.note_shape(*fit);
}

}  // namespace

std::vector<Parameter> palette_parameters(const Palette& palette) {
    std::vector<Parameter> parameters;
    parameters.push_back({"shape", "shape", allowed_shape,
                          [](Mechanism& mechanism, double value) { palette_of(mechanism).shape = value; }});
    for (const PickParameter& parameter : pick_parameters) {
        const auto member = parameter.member;
        parameters.push_back({std::string(parameter.key), std::string(parameter.description) + " of every pick",
                              parameter.allowed, [member](Mechanism& mechanism, double value) {
                                  for (Pick& pick : palette_of(mechanism).picks) pick.lobe.*member = value;
                              }});
    }
    for (std::size_t i = 0; i < palette.picks.size(); ++i) {
        const std::string prefix = "picks[" + std::to_string(i) + "].";
        const std::string of_pick = " of pick " + std::to_string(i);
        parameters.push_back(
            {prefix + "angle_deg", "angle" + of_pick, allowed_angle,
             [i](Mechanism& mechanism, double value) { palette_of(mechanism).picks[i].angle_deg = value; }});
        for (const PickParameter& parameter : pick_parameters) {
            const auto member = parameter.member;
            parameters.push_back({prefix + std::string(parameter.key), std::string(parameter.description) + of_pick,
                                  parameter.allowed, [i, member](Mechanism& mechanism, double value) {
                                      palette_of(mechanism).picks[i].lobe.*member = value;
                                  }});
        }
    }
    return parameters;
}

Lobe read_lobe(const Table& pick) {
    return {pick.number("peak_nm", allowed_peak), pick.number("width_nm", allowed_width),
            pick.number("height", allowed_height)};
}

Palette read_palette(const Table& table, const SceneContext& context) {
    Palette palette;
    const Value* picks = table.find("picks");
    if (picks == nullptr) {
        table.fail_missing("picks",
                           "give one or more, each { angle_deg, colour } or { angle_deg, peak_nm, width_nm, height }");
    }
    const Value::Array& list = table.checked_array("picks", *picks);
    if (list.empty() || list.size() > most_picks) {
        table.fail(picks->where,
                   "picks has " + std::to_string(list.size()) + " entries; allowed 1 to " + std::to_string(most_picks));
    }
    std::vector<PickedColour> picked_colours;
    std::vector<std::size_t> black;
    for (const Value& element : list) {
        const Table& pick = table.checked_table("picks", element);
        const double angle_deg = pick.number("angle_deg", allowed_angle);
        if (auto picked = read_picked_colour(pick, context.picks.colour)) {
            picked->pick = palette.picks.size();
            picked->angle_deg = angle_deg;
            find_band(context.picks, *picked);
            const LobeMatch& lobe = *picked->lobe;
            if (lobe.height == 0.0) black.push_back(picked->pick);
            palette.picks.push_back({angle_deg, {lobe.peak_nm, lobe.width_nm, lobe.height}});
            picked_colours.push_back(std::move(*picked));
        } else {
            palette.picks.push_back({angle_deg, read_lobe(pick)});
        }
        pick.expect_all_read();
    }
    take_shape_of_neighbours(black, palette);
    for (PickedColour& picked : picked_colours) {
        const Lobe& lobe = palette.picks[picked.pick].lobe;
        picked.lobe->peak_nm = lobe.peak_nm;
        picked.lobe->width_nm = lobe.width_nm;
        context.note_picked(picked);
    }
    check_picks_differ(palette, table, picks->where);
    read_shape(table, context, palette);
    return palette;
}

std::string palette_toml(const Palette& palette) {
    std::string text = "mechanism = \"palette\"\nshape = " + number_text(palette.shape) + "\npicks = [\n";
    for (const Pick& pick : palette.picks) {
        text += "    { angle_deg = " + number_text(pick.angle_deg) + ", peak_nm = " + number_text(pick.lobe.peak_nm) +
                ", width_nm = " + number_text(pick.lobe.width_nm) + ", height = " + number_text(pick.lobe.height) +
                " },\n";
    }
    return text + "]\n";
}

}  // namespace nacre
