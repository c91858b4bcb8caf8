// A palette: picks at angles, each a colour or a band, and the shape of the way between them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/colour/difference.h"
#include "nacre/scene/readers/mechanism_readers.h"
#include "nacre/scene/readers/pick_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_shape{0.0, 1.0};

Palette& palette_of(Mechanism& mechanism) {
    return std::get<Palette>(mechanism);
}

// Two picks at one angle must be equal.
void check_picks_differ(const Palette& palette, const Table& table, const Where& where) {
    const auto& picks = palette.picks;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        for (std::size_t j = i + 1; j < picks.size(); ++j) {
            const double distance_deg = std::abs(picks[i].angle_deg - picks[j].angle_deg);
            if (distance_deg >= smallest_pick_distance_deg || picks[i] == picks[j]) continue;
            table.fail(where, "picks[" + std::to_string(i) + "] and picks[" + std::to_string(j) +
                                  "] are different colours at one angle, " + number_text(picks[i].angle_deg) +
                                  " degrees; give angles at least " + number_text(smallest_pick_distance_deg) +
                                  " degrees apart");
        }
    }
}

// A pick of a palette: a band, or a colour whose band is found together with the others'.
struct PalettePick {
    Pick pick;
    std::optional<PickedColour> picked;
};

PalettePick read_pick(const Table& table, const PickReaders& readers) {
    PalettePick pick;
    pick.pick.angle_deg = table.number("angle_deg", allowed_pick_angle);
    pick.picked = read_picked_colour(table, readers.colour);
    if (!pick.picked) pick.pick.lobe = read_lobe(table);
    for (const Table::Entry& entry : table.entries()) {
        if (entry.key != "weight") continue;
        entry.read = true;
        table.note(entry.key_where,
                   "weight has no meaning for mechanism palette, whose picks are fitted one by one; "
                   "remove it");
    }
    table.expect_all_read();
    if (pick.picked) pick.picked->angle_deg = pick.pick.angle_deg;
    return pick;
}

// @return  what was asked for; empty, if no pick is a colour
std::vector<ColourOrBand> find_bands(std::vector<PalettePick>& picks, const PickReaders& readers) {
    std::vector<ColourOrBand> asked;
    for (PalettePick& pick : picks) {
        asked.push_back({pick.pick.angle_deg, {}, pick.pick.lobe});
        if (!pick.picked) continue;
        pick.picked->shown = readers.find.shown(pick.picked->colour);
        asked.back().colour = pick.picked->shown.colour;
    }
    const bool has_colours = std::any_of(picks.begin(), picks.end(), [](const auto& pick) { return !!pick.picked; });
    if (!has_colours) return {};
    const std::vector<Lobe> bands = readers.find.bands(asked);
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (!picks[i].picked) continue;
        PickedColour& picked = *picks[i].picked;
        picks[i].pick.lobe = bands[i];
        picked.lobe = bands[i];
        picked.reached = readers.lobe_colour(bands[i]);
        picked.de00 = ciede2000(to_lab(picked.colour, d65_white), to_lab(picked.reached, d65_white));
    }
    return asked;
}

// What the scene leaves open is fitted, where picks say anything about it.
std::optional<ShapeFit> fit_open_shape(const Table& table, const PickReaders& readers, const Palette& palette) {
    if (table.find("shape") != nullptr || !readers.lobe_colour) return {};
    return fit_shape(palette.picks, readers.lobe_colour);
}

// Notes mistakes; then some picks are missing.
std::vector<PalettePick> read_picks(const Table& table, const PickReaders& readers) {
    std::vector<PalettePick> picks;
    const Value* value = table.find("picks");
    if (value == nullptr) {
        table.note_missing("picks",
                           "give one or more, each { angle_deg, colour } or { angle_deg, peak_nm, width_nm, height }");
        return picks;
    }
    attempt(table, value->where, [&] {
        for (const Value& element : read_pick_list(table, *value)) {
            attempt(table, element.where,
                    [&] { picks.push_back(read_pick(table.checked_table("picks", element), readers)); });
        }
    });
    return picks;
}

ReadMechanism read_palette(const Table& table, const SceneContext& context) {
    std::vector<PalettePick> picks = read_picks(table, context.picks);
    Palette palette;
    palette.shape = table.number_or("shape", allowed_shape, Palette::default_shape);
    if (!table.is_good()) return {std::move(palette)};
    const std::vector<ColourOrBand> asked = find_bands(picks, context.picks);
    for (const PalettePick& pick : picks) palette.picks.push_back(pick.pick);
    check_picks_differ(palette, table, table.find("picks")->where);
    const std::optional<ShapeFit> fit = fit_open_shape(table, context.picks, palette);
    if (fit) palette.shape = fit->shape;
    std::vector<PalePath> pale;
    if (context.picks.wants_pale_paths && !asked.empty())
        pale = pale_paths_with_advice(palette, asked, context.picks.lobe_colour, context.picks.find.bands);
    ReadMechanism read{std::move(palette), {}, fit, std::move(pale), {}};
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (!picks[i].picked) continue;
        picks[i].picked->pick = i;
        read.picked.push_back(std::move(*picks[i].picked));
    }
    return read;
}

std::vector<Parameter> palette_parameters(const Mechanism& mechanism) {
    std::vector<Parameter> parameters;
    parameters.push_back(
        {"shape", "shape", allowed_shape, [](Mechanism& m, double value) { palette_of(m).shape = value; }});
    for (const LobeKey& key : lobe_keys) {
        const auto member = key.member;
        parameters.push_back({std::string(key.key), std::string(key.description) + " of every pick", key.allowed,
                              [member](Mechanism& m, double value) {
                                  for (Pick& pick : palette_of(m).picks) pick.lobe.*member = value;
                              }});
    }
    for (std::size_t i = 0; i < std::get<Palette>(mechanism).picks.size(); ++i) {
        const std::string prefix = "picks[" + std::to_string(i) + "].";
        const std::string of_pick = " of pick " + std::to_string(i);
        parameters.push_back({prefix + "angle_deg", "angle" + of_pick, allowed_pick_angle,
                              [i](Mechanism& m, double value) { palette_of(m).picks[i].angle_deg = value; }});
        for (const LobeKey& key : lobe_keys) {
            const auto member = key.member;
            parameters.push_back(
                {prefix + std::string(key.key), std::string(key.description) + of_pick, key.allowed,
                 [i, member](Mechanism& m, double value) { palette_of(m).picks[i].lobe.*member = value; }});
        }
    }
    return parameters;
}

std::string palette_toml(const Mechanism& mechanism) {
    const auto& palette = std::get<Palette>(mechanism);
    std::string text = "mechanism = \"palette\"\nshape = " + number_text(palette.shape) + "\npicks = [\n";
    for (const Pick& pick : palette.picks) {
        text += "    { angle_deg = " + number_text(pick.angle_deg) + ", peak_nm = " + number_text(pick.lobe.peak_nm) +
                ", width_nm = " + number_text(pick.lobe.width_nm) + ", height = " + number_text(pick.lobe.height);
        if (pick.lobe.floor != 0.0) text += ", floor = " + number_text(pick.lobe.floor);
        if (pick.lobe.flatness != 0.0) text += ", flatness = " + number_text(pick.lobe.flatness);
        text += " },\n";
    }
    return text + "]\n";
}

std::string palette_warning(const Mechanism& mechanism, const LightSettings&) {
    if (std::get<Palette>(mechanism).picks.size() != 1) return "";
    return "one pick gives the same colour at every angle; add a pick at another angle";
}

// A palette whose picks differ must not pass through a state in which two of them share an angle.
void check_angles_stay_apart(const Axis& axis, const Mechanism& mechanism, const Table& table, const Where& where) {
    const auto& picks = std::get<Palette>(mechanism).picks;
    if (!axis.parameter.name.ends_with("].angle_deg")) return;
    const auto [low, high] = std::minmax(axis.from, axis.to);
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if ("picks[" + std::to_string(i) + "].angle_deg" == axis.parameter.name) continue;
        const double angle_deg = picks[i].angle_deg;
        if (angle_deg <= low - smallest_pick_distance_deg || angle_deg >= high + smallest_pick_distance_deg) continue;
        table.fail(where, axis.parameter.name + " from " + number_text(axis.from) + " to " + number_text(axis.to) +
                              " passes picks[" + std::to_string(i) + "] at " + number_text(angle_deg) +
                              " degrees; two picks at one angle have no colour between them");
    }
}

}  // namespace

const MechanismReader palette_reader{
    .read = read_palette,
    .search = nullptr,
    .parameters = palette_parameters,
    .toml = palette_toml,
    .substrate = nullptr,
    .warning = palette_warning,
    .check_axis = check_angles_stay_apart,
    .refusals = {.base = no_transmission,
                 .facets = not_refused,
                 .polarisation = "which describes unpolarised light",
                 .thickness_spread_nm = "which has no layers",
                 .orders = no_orders},
};

}  // namespace nacre
