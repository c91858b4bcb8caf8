// Picks that lead to a film, stack, grating or crystal.
//
// What the material's other keys leave free is already in the search (FreeReader). Here its wanted colours are read,
// and the search runs. Picks stay with their colours, so that the plan can say how near the answer came to each.
#include "nacre/scene/readers/search_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/scene/readers/pick_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_u{0.0, 2.0};
constexpr Allowed allowed_weight{1e-6, 1e6};
constexpr Allowed allowed_tolerance{1e-6, 1e4, "nm"};  // up to allowed_spread
// Chosen: spectra change little between 16 angles, and the time of a search grows with every colour.
constexpr std::size_t most_measured = 16;

struct WantedPick {
    WantedColour wanted;
    PickedColour picked;
};

PickedColour read_band(const Table& pick, const PickReaders& readers) {
    const Lobe lobe = read_lobe(pick);
    PickedColour picked;
    picked.text = "a band of " + number_text(lobe.peak_nm) + " nm, " + number_text(lobe.width_nm) + " nm wide, " +
                  number_text(lobe.height) + " high";
    picked.where = pick.where();
    picked.colour = readers.lobe_colour(lobe);
    return picked;
}

Geometry read_place(const Table& pick, Quantity quantity, double& angle_deg) {
    if (quantity != Quantity::grating_u) {
        angle_deg = pick.number("angle_deg", allowed_pick_angle);
        return Incidence::from_degrees(angle_deg);
    }
    const Value* u = pick.find("grating_u");
    const Value* angle = pick.find("angle_deg");
    if (u != nullptr && angle != nullptr)
        pick.fail(u->where, "angle_deg and grating_u both say where the colour is seen; remove one of them");
    if (u == nullptr) {
        // Light along the normal.
        angle_deg = pick.number("angle_deg", allowed_pick_angle);
        return Geometry::from_grating_u(std::sin(angle_deg * std::numbers::pi / 180.0));
    }
    const double value = pick.checked_number("grating_u", *u, allowed_u);
    angle_deg = std::asin(std::min(value, 1.0)) * 180.0 / std::numbers::pi;
    return Geometry::from_grating_u(value);
}

// { measured = FILE }: the colours of spectra at their angles. Of many angles, 16 evenly spread ones.
std::vector<WantedPick> read_measured_colours(const Table& table, const SceneContext& context, const Mechanism& start) {
    const std::string file = table.text("measured");
    const CsvKeys keys = read_csv_keys(table, true);
    table.expect_all_read();
    const Where where = table.find("measured")->where;
    if (quantity_of(start) != Quantity::incidence)
        table.fail(where, "measured spectra describe mirror reflection, and a grating has none");
    const MeasuredSpectra spectra = context.read_spectra(file, where, keys);
    warn_of_bright_spectra(table, where, spectra, keys.is_percent);
    const std::size_t angles = spectra.angle_deg.size();
    const std::size_t taken = std::min(angles, most_measured);
    std::vector<WantedPick> picks(taken);
    for (std::size_t i = 0; i < taken; ++i) {
        const std::size_t angle = taken == 1 ? 0 : (i * (angles - 1) + (taken - 1) / 2) / (taken - 1);
        auto& [wanted, picked] = picks[i];
        picked.angle_deg = spectra.angle_deg[angle];
        picked.text = "measured";
        picked.where = where;
        picked.colour = context.picks.measured_colour(spectra, picked.angle_deg);
        wanted = {Incidence::from_degrees(picked.angle_deg), picked.colour, 1.0};
    }
    return picks;
}

WantedPick read_wanted_pick(const Table& pick, const PickReaders& readers, Quantity quantity) {
    double angle_deg = 0.0;
    const Geometry place = read_place(pick, quantity, angle_deg);
    const auto colour = read_picked_colour(pick, readers.colour);
    PickedColour picked = colour ? *colour : read_band(pick, readers);
    picked.angle_deg = angle_deg;
    picked.weight = pick.number_or("weight", allowed_weight, 1.0);
    pick.expect_all_read();
    return {{place, picked.colour, picked.weight}, std::move(picked)};
}

std::vector<WantedPick> read_wanted_picks(const Table& table, const SceneContext& context, const Mechanism& start) {
    const Value& picks = *table.find("picks");
    if (std::holds_alternative<std::shared_ptr<Table>>(picks.data))
        return read_measured_colours(table.checked_table("picks", picks), context, start);
    std::vector<WantedPick> wanted;
    for (const Value& element : read_pick_list(table, picks)) {
        attempt(table, element.where, [&] {
            const Table& pick = table.checked_table("picks", element);
            wanted.push_back(read_wanted_pick(pick, context.picks, quantity_of(start)));
        });
    }
    return wanted;
}

void refuse_what_picks_exclude(const Table& table, const Effects& effects) {
    const auto refuse = [&](std::string_view key, const std::string& why) {
        table.note_at(key, std::string(key) + " and picks: " + why + "; remove one of them");
    };
    constexpr const char* no_facets = "the search takes a surface without facets";
    if (effects.relief.tilt_deg > 0.0) refuse("tilt_deg", no_facets);
    if (effects.relief.roughness > 0.0) refuse("roughness", no_facets);
    if (effects.both_polarisations) refuse("polarisation", "a pick has one colour, and two polarisations have two");
}

// How inexactly what is found is made.
void read_tolerance(const Table& table, MechanismSearch& search) {
    const Table* tolerance = table.table("tolerance");
    if (tolerance == nullptr) return;
    search.tolerance_nm = tolerance->number("thickness_nm", allowed_tolerance);
    tolerance->expect_all_read();
    if (std::any_of(search.free.begin(), search.free.end(), [](const auto& number) { return number.is_thickness; }))
        return;
    table.note(tolerance->where(),
               "tolerance is of free thicknesses, of a film or of the layers of a stack, and here is "
               "none; leave one out, or bound it with from and to");
}

}  // namespace

ReadMechanism find_mechanism(const Table& table, const SceneContext& context, MechanismSearch search) {
    refuse_what_picks_exclude(table, search.start.effects);
    read_tolerance(table, search);
    std::vector<WantedPick> picks = read_wanted_picks(table, context, search.start);
    // A search takes seconds: it does not begin while there is a mistake.
    table.expect_all_read();
    if (!table.is_good()) return {std::move(search.start)};
    const std::string_view name = mechanism_name(search.start);
    if (!context.find_mechanisms) {
        throw Error(table.where().text() + ": picks of a " + std::string(name) +
                    " need a search, which is not available here");
    }
    for (const WantedPick& pick : picks) search.wanted.push_back(pick.wanted);
    std::vector<FoundMechanism> found = context.find_mechanisms(search);
    ReadMechanism read{found.front().mechanism};
    for (std::size_t i = 0; i < picks.size(); ++i) {
        PickedColour& picked = picks[i].picked;
        picked.pick = i;
        picked.mechanism = name;
        picked.reached = found.front().reached[i];
        picked.de00 = found.front().de00[i];
        picked.is_searched = !search.free.empty();
        if (found.front().tolerance) picked.tolerance = found.front().tolerance->per_colour[i];
        read.picked.push_back(std::move(picked));
    }
    read.search = MaterialSearch{"", std::move(search), std::move(found)};
    return read;
}

}  // namespace nacre
