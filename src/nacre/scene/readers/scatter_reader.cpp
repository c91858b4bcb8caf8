// A layer of particles that scatter light: three models of one set of keys.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/cie_tables.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/index_keys.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_radius{0.1, 1e7, "nm"};
constexpr Allowed allowed_radius_spread{0.0, 0.5};
constexpr Allowed allowed_fraction{1e-9, 0.6};
constexpr Allowed allowed_layer{1e-6, 1e6, "um"};
constexpr double default_quasi_ordered_fraction = 0.4;

constexpr std::array model_words{
    Word<ScatterModel>{"rayleigh", ScatterModel::rayleigh, "particles far smaller than the wavelength"},
    Word<ScatterModel>{"mie", ScatterModel::mie, "spheres of any size, far from each other"},
    Word<ScatterModel>{"quasi_ordered", ScatterModel::quasi_ordered, "spheres that keep a distance"},
};

// The radius whose size parameter, 2 pi n radius / wavelength, is 1 where it is largest.
double unit_radius_nm(const Index& medium, double first_nm, double last_nm) {
    double wave_number = medium.at(last_nm).real() / last_nm;
    for (double nm = first_nm; nm < last_nm; nm += 1.0) wave_number = std::max(wave_number, medium.at(nm).real() / nm);
    return 1.0 / (2.0 * std::numbers::pi * wave_number);
}

// Of the mean radius for dipoles, of all spheres that are computed for Mie.
double largest_size_parameter(ScatterModel model) {
    return model == ScatterModel::rayleigh ? 1.0 : 1e4;
}

// The largest sphere of a spread that counts, over the mean one: with the variance v of ln r, its mean weighted by
// volume is 2.5 v above that of the mean radius, and beyond 7.4 standard deviations lie 1e-13 of the volume.
constexpr double mean_of_volume = 2.5;
constexpr double deviations = 7.4;
double largest_over_mean(ScatterModel model, double radius_spread) {
    if (model == ScatterModel::rayleigh) return 1.0;
    const double variance = std::log1p(radius_spread * radius_spread);
    return std::exp(mean_of_volume * variance + deviations * std::sqrt(variance));
}
// Its inverse.
double spread_of_largest(double largest_over_mean) {
    const double deviation =
        (std::sqrt(deviations * deviations + 4.0 * mean_of_volume * std::log(largest_over_mean)) - deviations) /
        (2.0 * mean_of_volume);
    return std::sqrt(std::expm1(deviation * deviation));
}

double largest_radius_nm(const Scatter& scatter, double first_nm, double last_nm) {
    return unit_radius_nm(scatter.medium, first_nm, last_nm) * largest_size_parameter(scatter.model) /
           largest_over_mean(scatter.model, scatter.radius_spread);
}

void check_radius(const Table& table, const Scatter& scatter, const IndexReader& reader) {
    const double largest_nm = largest_radius_nm(scatter, reader.first_nm, reader.last_nm);
    if (scatter.radius_nm <= largest_nm) return;
    const std::string radius = "radius_nm = " + number_text(scatter.radius_nm);
    const std::string limit = number_text(std::floor(100.0 * largest_nm) / 100.0) + " nm";
    if (scatter.model == ScatterModel::rayleigh) {
        table.note_at("radius_nm", radius +
                                       " is not small compared with the wavelength; use model = \"mie\", or a radius "
                                       "up to " +
                                       limit);
        return;
    }
    table.note_at("radius_nm", radius + " makes spheres of size parameters above " +
                                   limit_text(largest_size_parameter(scatter.model)) + "; give a radius up to " +
                                   limit + (scatter.radius_spread > 0.0 ? " with this radius_spread" : ""));
}

double hard_fraction(const Scatter& scatter) {
    if (scatter.hard_radius_nm == 0.0) return scatter.volume_fraction;
    return scatter.volume_fraction * std::pow(scatter.hard_radius_nm / scatter.radius_nm, 3.0);
}

void read_hard_radius(const Table& table, Scatter& scatter) {
    const Value* value = table.find("hard_radius_nm");
    if (value == nullptr) return;
    if (scatter.model != ScatterModel::quasi_ordered) {
        table.note(value->where, "hard_radius_nm has no meaning for model " +
                                     std::string(name_of(model_words, scatter.model)) + "; allowed for quasi_ordered");
        return;
    }
    scatter.hard_radius_nm = table.checked_number("hard_radius_nm", *value, allowed_radius);
    if (!table.is_good()) return;
    if (scatter.hard_radius_nm < scatter.radius_nm) {
        table.note(value->where, "hard_radius_nm = " + value->text() +
                                     " is inside the particle; give at least radius_nm, " +
                                     number_text(scatter.radius_nm) + " nm");
        return;
    }
    if (hard_fraction(scatter) > allowed_fraction.high) {
        const double largest_nm = scatter.radius_nm * std::cbrt(allowed_fraction.high / scatter.volume_fraction);
        table.note(value->where,
                   "hard spheres of " + value->text() + " nm fill " + significant_text(hard_fraction(scatter), 4) +
                       " of the volume, volume_fraction * (hard_radius_nm / radius_nm)^3; at most " +
                       number_text(allowed_fraction.high) + " is allowed, which is a hard_radius_nm up to " +
                       number_text(std::floor(100.0 * largest_nm) / 100.0) + " nm");
    }
}

// The ranges of axes: any two may be at their ends at once, so each uses up no more than half of the room that a limit
// leaves, on a scale of ratios.
struct Ranges {
    Allowed radius = allowed_radius;
    Allowed spread = allowed_radius_spread;
    Allowed fraction = allowed_fraction;
    Allowed hard_radius = allowed_radius;
};
Ranges ranges_of(const Scatter& scatter) {
    Ranges ranges;
    double first_nm = cie_table_first_nm;  // parameters do not know the light; this is the shortest that it may have
    double last_nm = cie_table_last_nm;
    if (!scatter.medium.is_constant() && !scatter.medium.curve->holds_outside) {
        first_nm = std::clamp(first_nm, scatter.medium.curve->first_nm, scatter.medium.curve->last_nm);
        last_nm = std::clamp(last_nm, first_nm, scatter.medium.curve->last_nm);
    }
    const double room = std::sqrt(std::max(1.0, largest_radius_nm(scatter, first_nm, last_nm) / scatter.radius_nm));
    ranges.radius.high = std::min(ranges.radius.high, scatter.radius_nm * room);
    if (scatter.model != ScatterModel::rayleigh) {
        const double largest = largest_over_mean(scatter.model, scatter.radius_spread) * room;
        ranges.spread.high = std::min(ranges.spread.high, spread_of_largest(largest));
    }
    if (scatter.hard_radius_nm == 0.0) return ranges;
    const double fill = std::sqrt(std::max(1.0, allowed_fraction.high / hard_fraction(scatter)));
    const double middle_nm = std::sqrt(scatter.radius_nm * scatter.hard_radius_nm);
    ranges.radius.high = std::min(ranges.radius.high, middle_nm);
    ranges.radius.low = std::max(ranges.radius.low, scatter.radius_nm / std::cbrt(fill));
    ranges.fraction.high = std::min(ranges.fraction.high, scatter.volume_fraction * fill);
    ranges.hard_radius.low = std::max(ranges.hard_radius.low, middle_nm);
    ranges.hard_radius.high = std::min(ranges.hard_radius.high, scatter.hard_radius_nm * std::cbrt(fill));
    return ranges;
}

ReadMechanism read_scatter(const Table& table, const SceneContext& context) {
    const IndexReader& index = context.index;
    Scatter scatter;
    scatter.model = read_word(table, "model", "model", model_words);
    scatter.particle = read_required_index(table, "particle", index);
    scatter.medium = read_clear_medium(table, "medium", index, "no light reaches the particles");
    scatter.radius_nm = table.number("radius_nm", allowed_radius);
    scatter.radius_spread = table.number_or("radius_spread", allowed_radius_spread, 0.0);
    if (table.is_good()) check_radius(table, scatter, index);
    if (scatter.model == ScatterModel::quasi_ordered) scatter.volume_fraction = default_quasi_ordered_fraction;
    scatter.volume_fraction = table.number_or("volume_fraction", allowed_fraction, scatter.volume_fraction);
    read_hard_radius(table, scatter);
    scatter.thickness_um = table.number_or("thickness_um", allowed_layer, scatter.thickness_um);
    return {scatter};
}

std::vector<Parameter> scatter_parameters(const Mechanism& mechanism) {
    const auto& scatter = std::get<Scatter>(mechanism);
    std::vector<Parameter> parameters;
    const auto add = [&](std::string_view name, std::string_view description, const Allowed& allowed,
                         double Scatter::*member) {
        parameters.push_back({std::string(name), std::string(description), allowed,
                              [member](Mechanism& m, double value) { std::get<Scatter>(m).*member = value; }});
    };
    const Ranges ranges = ranges_of(scatter);
    add("radius_nm", "mean radius", ranges.radius, &Scatter::radius_nm);
    add("radius_spread", "spread of the radii", ranges.spread, &Scatter::radius_spread);
    add("volume_fraction", "volume fraction", ranges.fraction, &Scatter::volume_fraction);
    add("thickness_um", "thickness of the layer", allowed_layer, &Scatter::thickness_um);
    if (scatter.hard_radius_nm > 0.0)
        add("hard_radius_nm", "radius of the hard spheres", ranges.hard_radius, &Scatter::hard_radius_nm);
    add_index_parameters(
        "particle.", " of the particles", scatter.particle,
        [](Mechanism& m) -> Index& { return std::get<Scatter>(m).particle; }, parameters);
    return parameters;
}

std::string scatter_toml(const Mechanism& mechanism) {
    const auto& scatter = std::get<Scatter>(mechanism);
    std::string text = "mechanism = \"scatter\"\nmodel = " + toml_string(name_of(model_words, scatter.model)) +
                       "\nparticle = " + index_toml(scatter.particle) + "\nmedium = " + index_toml(scatter.medium) +
                       "\nradius_nm = " + number_text(scatter.radius_nm) + "\n";
    if (scatter.radius_spread > 0.0) text += "radius_spread = " + number_text(scatter.radius_spread) + "\n";
    text += "volume_fraction = " + number_text(scatter.volume_fraction) + "\n";
    if (scatter.hard_radius_nm > 0.0) text += "hard_radius_nm = " + number_text(scatter.hard_radius_nm) + "\n";
    return text + "thickness_um = " + number_text(scatter.thickness_um) + "\n";
}

}  // namespace

const MechanismReader scatter_reader{
    .read = read_scatter,
    .search = nullptr,
    .parameters = scatter_parameters,
    .toml = scatter_toml,
    .substrate = nullptr,
    .warning = nullptr,
    .check_axis = nullptr,
    .refusals = {.base = "which models only the light that its particles scatter",
                 .facets = "whose particles have no facets",
                 .polarisation = not_refused,
                 .thickness_spread_nm = "which has no layers (radius_spread is for its particles)",
                 .orders = no_orders},
};

}  // namespace nacre
