// A diffraction grating: the grooves, how the orders share the light, and which of them count.
#include <algorithm>
#include <array>
#include <cstddef>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_period{10.0, 1e6, "nm"};
constexpr Allowed allowed_grooves{1, 1000000};
constexpr Allowed allowed_depth{0.0, 1e5, "nm"};
constexpr Allowed allowed_share{0.0, 1.0};
constexpr Allowed allowed_order{0, 1000};
constexpr Allowed allowed_azimuth{0.0, 90.0, "degrees"};
constexpr Allowed allowed_groove_length{0.0, 1e6, "um"};
// Of an axis: 0 stands for endless grooves, which are no neighbours of short ones.
constexpr Allowed allowed_finite_length{1e-3, 1e6, "um"};
constexpr std::size_t most_efficiencies = 1000;  // as many as allowed_order has

// Where gratings are looked for: grooves whose first order is visible. A land of 1 - D has the orders of D.
constexpr FreeRange usual_period{400.0, 5000.0, FreeScale::ratio};
constexpr FreeRange usual_grooves{1.0, 200.0, FreeScale::whole};
constexpr FreeRange usual_depth{10.0, 400.0};
constexpr FreeRange usual_land{0.05, 0.5};

// Without GratingProfile::given, which a scene says by giving the efficiencies.
constexpr std::array profile_words{
    Word<GratingProfile>{"lamellar", GratingProfile::lamellar, "flat tops and flat bottoms"},
    Word<GratingProfile>{"sinusoidal", GratingProfile::sinusoidal, "a sine"},
};

std::vector<double> read_efficiency(const Table& table, const Value& value) {
    for (const std::string_view other : {"profile", "depth_nm", "land"}) {
        if (const Value* given = table.find(other)) {
            table.fail(given->where, std::string(other) + " and efficiency are both given; give the orders' " +
                                         "efficiency, or the profile that it follows from");
        }
    }
    std::vector<double> efficiency = table.checked_numbers("efficiency", value, allowed_share);
    if (efficiency.empty() || efficiency.size() > most_efficiencies) {
        table.fail(value.where, "efficiency has " + std::to_string(efficiency.size()) + " numbers; allowed 1 to " +
                                    std::to_string(most_efficiencies) + ", of orders 1, 2, ...");
    }
    double both_signs = 0.0;
    for (const double share : efficiency) both_signs += 2.0 * share;
    constexpr double rounding = 1e-12;  // of the sum: 0.1 + 0.2 + 0.2 is one half
    if (both_signs > 1.0 + rounding) {
        table.fail(value.where,
                   "the orders of both signs get " + significant_text(both_signs, 6) +
                       " of the light, which is more than all of it; give efficiencies whose sum is at most 0.5");
    }
    return efficiency;
}

void refuse_land(const Table& table) {
    if (const Value* land = table.find("land"))
        table.note(land->where, "land has no meaning for a sinusoidal profile; allowed for lamellar");
}

void read_profile(const Table& table, Grating& grating) {
    // So that a misspelling of one is not taken for another's.
    for (const std::string_view known : {"profile", "depth_nm", "land", "efficiency"}) table.know(known);
    if (const Value* efficiency = table.find("efficiency")) {
        attempt(table, efficiency->where, [&] { grating.efficiency = read_efficiency(table, *efficiency); });
        grating.profile = GratingProfile::given;
        return;
    }
    grating.profile = read_word(table, "profile", "profile", profile_words);
    const Value* depth = table.find("depth_nm");
    if (depth == nullptr) {
        table.note_missing("depth_nm", "give it, or the orders' efficiency");
    } else {
        grating.depth_nm = table.checked_number("depth_nm", *depth, allowed_depth);
    }
    if (grating.profile == GratingProfile::lamellar) {
        grating.land = table.number_or("land", allowed_share, grating.land);
    } else {
        refuse_land(table);
    }
}

std::vector<int> read_orders(const Table& table) {
    const Value* value = table.find("orders");
    if (value == nullptr) return {};
    std::vector<int> orders;
    for (const Value& element : table.checked_array("orders", *value))
        orders.push_back(table.checked_integer("orders", element, allowed_order));
    if (orders.empty()) {
        table.fail(value->where, "orders is empty; give those that count, such as [1, 2], or remove the key for all");
    }
    std::sort(orders.begin(), orders.end());
    const auto twice = std::adjacent_find(orders.begin(), orders.end());
    if (twice != orders.end()) {
        table.fail(value->where, "orders has " + std::to_string(*twice) +
                                     " twice; give every order once (its mirror image comes with it)");
    }
    return orders;
}

std::string efficiency_toml(const std::vector<double>& efficiency) {
    std::string text;
    for (const double share : efficiency) text += (text.empty() ? "" : ", ") + number_text(share);
    return "efficiency = [" + text + "]\n";
}

void read_setting(const Table& table, const IndexReader& index, Grating& grating) {
    if (const Value* coat = table.find("coat")) grating.coat = index.read(table, "coat", *coat);
    attempt(table, table.where(), [&] { grating.orders = read_orders(table); });
    grating.groove_length_um = table.number_or("groove_length_um", allowed_groove_length, 0.0);
    grating.azimuth_deg = table.number_or("azimuth_deg", allowed_azimuth, 0.0);
}

ReadMechanism read_grating(const Table& table, const SceneContext& context) {
    Grating grating;
    grating.period_nm = table.number("period_nm", allowed_period);
    grating.grooves = table.integer_or("grooves", allowed_grooves, grating.grooves);
    read_profile(table, grating);
    read_setting(table, context.index, grating);
    return {grating};
}

MechanismSearch grating_search(const Table& table, const IndexReader& index) {
    MechanismSearch search;
    Grating grating;
    read_setting(table, index, grating);
    const bool is_given = table.find("efficiency") != nullptr;
    if (is_given) {
        read_profile(table, grating);
    } else {
        grating.profile = read_word(table, "profile", "profile", profile_words);
    }
    search.start = grating;
    FreeReader reader(table, index, search);
    reader.number("period_nm", allowed_period, usual_period,
                  [](Mechanism& m, double value) { std::get<Grating>(m).period_nm = value; });
    reader.whole_number("grooves", allowed_grooves, usual_grooves,
                        [](Mechanism& m, int value) { std::get<Grating>(m).grooves = value; });
    if (is_given) return search;
    reader.number("depth_nm", allowed_depth, usual_depth,
                  [](Mechanism& m, double value) { std::get<Grating>(m).depth_nm = value; });
    if (grating.profile == GratingProfile::lamellar) {
        reader.number("land", allowed_share, usual_land,
                      [](Mechanism& m, double value) { std::get<Grating>(m).land = value; });
    } else {
        refuse_land(table);
    }
    return search;
}

std::vector<Parameter> grating_parameters(const Mechanism& mechanism) {
    const auto& grating = std::get<Grating>(mechanism);
    std::vector<Parameter> parameters;
    const auto add = [&](std::string_view name, std::string_view description, const Allowed& allowed,
                         double Grating::*member) {
        parameters.push_back({std::string(name), std::string(description), allowed,
                              [member](Mechanism& m, double value) { std::get<Grating>(m).*member = value; }});
    };
    add("period_nm", "period", allowed_period, &Grating::period_nm);
    if (grating.profile != GratingProfile::given) add("depth_nm", "depth", allowed_depth, &Grating::depth_nm);
    if (grating.profile == GratingProfile::lamellar)
        add("land", "share of the period that is up", allowed_share, &Grating::land);
    add("groove_length_um", "length of the grooves", allowed_finite_length, &Grating::groove_length_um);
    add("azimuth_deg", "azimuth", allowed_azimuth, &Grating::azimuth_deg);
    return parameters;
}

std::string grating_toml(const Mechanism& mechanism) {
    const auto& grating = std::get<Grating>(mechanism);
    std::string text = "mechanism = \"grating\"\nperiod_nm = " + number_text(grating.period_nm) +
                       "\ngrooves = " + std::to_string(grating.grooves) + "\n";
    if (grating.profile == GratingProfile::given) {
        text += efficiency_toml(grating.efficiency);
    } else {
        text += "profile = " + toml_string(name_of(profile_words, grating.profile)) +
                "\ndepth_nm = " + number_text(grating.depth_nm) + "\n";
    }
    if (grating.profile == GratingProfile::lamellar) text += "land = " + number_text(grating.land) + "\n";
    if (grating.coat) text += "coat = " + index_toml(*grating.coat) + "\n";
    if (!grating.orders.empty()) {
        std::string orders;
        for (const int order : grating.orders) orders += (orders.empty() ? "" : ", ") + std::to_string(order);
        text += "orders = [" + orders + "]\n";
    }
    if (grating.groove_length_um > 0.0) text += "groove_length_um = " + number_text(grating.groove_length_um) + "\n";
    if (grating.azimuth_deg > 0.0) text += "azimuth_deg = " + number_text(grating.azimuth_deg) + "\n";
    return text;
}

std::string grating_warning(const Mechanism& mechanism, const LightSettings& light) {
    const auto& grating = std::get<Grating>(mechanism);
    const std::vector<int> orders = counted_orders(grating, light.first_nm);
    if (orders.empty()) {
        return "the grating is black: its grooves are so close together that none of its orders is visible; increase "
               "period_nm";
    }
    if (2.0 * share_across(grating) * grating.period_nm < orders.front() * static_cast<double>(light.first_nm)) {
        return "the grating is black at its azimuth_deg: none of its orders is visible so far from the plane across "
               "the grooves; reduce azimuth_deg";
    }
    if (grating.azimuth_deg > 0.0 && grating.groove_length_um == 0.0) {
        return "the grating is black: endlessly long grooves send no light out of the plane across them (azimuth_deg > "
               "0); give groove_length_um";
    }
    return "";
}

}  // namespace

const MechanismReader grating_reader{
    .read = read_grating,
    .search = grating_search,
    .parameters = grating_parameters,
    .toml = grating_toml,
    .substrate = nullptr,
    .warning = grating_warning,
    .check_axis = nullptr,
    .refusals = {.base = "which transmits nothing",
                 .facets = "whose colour does not depend on the angle to the normal",
                 .polarisation = "whose theory is scalar",
                 .thickness_spread_nm = "which has no layers",
                 .orders = not_refused},
};

}  // namespace nacre
