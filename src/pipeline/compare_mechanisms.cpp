#include "pipeline/compare_mechanisms.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/pick/shown_colours.h"

namespace nacre {
namespace {

// Where an eye sees a pick: light falls onto a grating along its normal.
Geometry place_at(double angle_deg, Quantity quantity) {
    if (quantity == Quantity::grating_u)
        return Geometry::from_grating_u(std::sin(angle_deg * std::numbers::pi / 180.0));
    return Incidence::from_degrees(angle_deg);
}

// Places on the way from each pick to the next, one way after the other.
std::vector<Geometry> places_between(const std::vector<PickedColour>& picks, Quantity quantity) {
    std::vector<double> angles;
    for (const PickedColour& pick : picks) angles.push_back(pick.angle_deg);
    std::sort(angles.begin(), angles.end());
    std::vector<Geometry> places;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        for (std::size_t j = 0; j < colours_of_path; ++j) {
            const double share = static_cast<double>(j) / (colours_of_path - 1);
            places.push_back(place_at(std::lerp(angles[i], angles[i + 1], share), quantity));
        }
    }
    return places;
}

ColourPath path_of(const Mechanism& mechanism, ShownColours& shown) {
    std::vector<Xyz> colours(shown.count());
    shown.at(mechanism, shown.sampling_for(mechanism, SearchDetail::refinement), colours);
    std::vector<ColourPath> paths;
    for (std::size_t begin = 0; begin < colours.size(); begin += colours_of_path)
        paths.push_back(colour_path(std::span(colours).subspan(begin, colours_of_path)));
    return joined(paths);
}

MechanismAnswer palette_answer(const SceneMaterial& material, ShownColours& shown) {
    MechanismAnswer answer;
    double squares = 0.0;
    for (const PickedColour& picked : material.picked) {
        answer.de00.push_back(picked.de00);
        squares += picked.de00 * picked.de00;
    }
    answer.error = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(material.picked.size(), 1)));
    answer.numbers = 1;  // the shape
    for (const Pick& pick : std::get<Palette>(material.mechanism).picks)
        answer.numbers += 3U + (pick.lobe.floor != 0.0 ? 1U : 0U) + (pick.lobe.flatness != 0.0 ? 1U : 0U);
    answer.path = path_of(material.mechanism, shown);
    return answer;
}

}  // namespace

std::vector<MechanismAnswer> mechanism_answers(const Plan& plan, const std::string& mechanism) {
    const SceneMaterial& material = plan.materials.front();
    ShownColours shown(*plan.light, places_between(material.picked, quantity_of(material.mechanism)));
    std::vector<MechanismAnswer> answers;
    if (plan.searches.empty()) {
        answers.push_back(palette_answer(material, shown));
    } else {
        const MaterialSearch& search = plan.searches.front();
        for (std::size_t i = 0; i < search.found.size(); ++i) {
            const FoundMechanism& found = search.found[i];
            answers.push_back({{},
                               i,
                               found_text(search.search, found),
                               found.de00,
                               found.error,
                               search.search.free.size(),
                               path_of(found.mechanism, shown)});
        }
    }
    for (MechanismAnswer& answer : answers) answer.mechanism = mechanism;
    return answers;
}

const MechanismAnswer* answer_beside(const MechanismAnswer& palette, const std::vector<MechanismAnswer>& others) {
    const auto comes_within = [&](const MechanismAnswer& answer, double de00) {
        for (std::size_t i = 0; i < answer.de00.size(); ++i) {
            if (answer.de00[i] > std::max(de00, palette.de00[i])) return false;
        }
        return true;
    };
    const auto is_natural = [&](const MechanismAnswer& answer) {
        return palette.path.is_pale() && !answer.path.is_pale() && comes_within(answer, near_de00);
    };
    const auto is_as_good = [&](const MechanismAnswer& answer) { return comes_within(answer, met_de00); };
    auto named = std::find_if(others.begin(), others.end(), is_natural);
    if (named == others.end()) named = std::find_if(others.begin(), others.end(), is_as_good);
    return named == others.end() ? nullptr : &*named;
}

void rank(std::vector<MechanismAnswer>& answers) {
    std::stable_sort(answers.begin(), answers.end(), [](const MechanismAnswer& a, const MechanismAnswer& b) {
        const double error_a = std::max(a.error, as_good_as_met), error_b = std::max(b.error, as_good_as_met);
        return error_a != error_b ? error_a < error_b : a.numbers < b.numbers;
    });
}

}  // namespace nacre
