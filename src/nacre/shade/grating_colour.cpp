// Over a piece of wavelength, s from -1 to 1 linear in 1 / wavelength, so is t = N (x - m), x = u cos(azimuth) d /
// wavelength, and d nm = wavelength^2 k ds with k half the piece's length in 1 / nm. So
//
//   XYZ = N d sum over pieces of k * integral of [weight * wavelength * azimuth's factor] * sum over m of
//         efficiency * sinc^2(t) ds
//
// without a division by u. Orders far from the piece have 1 / t^2 for a parabola as well: all share sin^2(pi t), N m
// being whole, and are summed before they are integrated. What is near is integrated line by line.
#include "nacre/shade/grating_colour.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "nacre/colour/line_integral.h"
#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;

// A parabola over a piece is wrong by (change / 2)^3 / 15.6 of what goes with exp(change): 1e-6 of the factor that the
// azimuth has. Light that this dims far more than at the red end may be off by more, up to 1e-4 of itself.
constexpr double most_exponent_change = 0.05;
constexpr double most_exponent_change_if_dim = 0.23;
double allowed_exponent_change(double exponent, double least_exponent) {
    return std::min(most_exponent_change * std::exp((exponent - least_exponent) / 3.0), most_exponent_change_if_dim);
}
// An order so weak beside another is below 1e-7 of that one's tail, wherever both are looked at: tails are not below
// 1 / (2 (pi N m)^2) of a peak, N and m being at most 1e6 and 6e3.
constexpr double negligible_share = 1e-28;
// What a table of efficiencies may hold (64 MiB); a larger one is computed again for every colour.
constexpr std::size_t most_table_numbers = std::size_t{1} << 23U;
// Beyond, exp() leaves the range of doubles that have all their digits.
constexpr double darkest_exponent = 700.0;
// And so much beyond the red end nothing is left beside it, be it a line's peak beside tails.
constexpr double negligible_exponent = 70.0;

// How many pieces' lengths an order must be away for 1 / t^2 to be a parabola. All pieces further off together are then
// wrong by below 3e-7 of the line; where a piece holds much of the ripple, less light is left there to be wrong.
double far_lengths(double piece_length) {
    return std::abs(piece_length) < 0.25 ? 24.0 : 10.0;
}
// And so many if pieces are coarse: 1e-3.
constexpr double coarse_far_lengths = 3.0;
// An order as near as this (in t) is never summed: sin^2(pi t) / t^2 would be 0 / 0 at last.
constexpr double always_near = 1e-3;

double square(double x) {
    return x * x;
}

// Rounding may leave a colour a last bit below black.
Xyz not_below_black(const Xyz& colour) {
    return {std::max(colour.x, 0.0), std::max(colour.y, 0.0), std::max(colour.z, 0.0)};
}

}  // namespace

GratingColour::GratingColour(const Grating& grating, const Light& light, std::shared_ptr<const GratingPieces> coarse)
    : grating_(grating), has_nodes_(light.settings.wavelengths.has_value()), pieces_(std::move(coarse)) {
    const int step_nm = pieces_ ? pieces_->nm : 1;
    keep_orders(counted_orders(grating, light.settings.first_nm), light, step_nm);
    if (orders_.empty()) return;
    if (has_nodes_) {
        add_nodes(light);
    } else {
        if (!pieces_) {
            const double depth_nm = grating.profile == GratingProfile::given ? 0.0 : grating.depth_nm;
            pieces_ = std::make_shared<const GratingPieces>(grating_pieces(light.weights, 1, depth_nm));
        }
        per_nm_ = pieces_->per_nm;
    }
    fill_table();
}

// Of a sinusoidal profile most orders that can be seen have no light, and of a lamellar one perhaps every second.
void GratingColour::keep_orders(const std::vector<int>& counted, const Light& light, int step_nm) {
    std::vector<char> matters(counted.size(), 0);
    std::vector<double> efficiency(counted.size());
    const std::vector<double> shares = order_shares(grating_, counted);
    for (int nm = light.settings.first_nm; nm <= light.settings.last_nm; nm += step_nm) {
        grating_efficiencies(grating_, counted, shares, nm, efficiency);
        const double most = efficiency.empty() ? 0.0 : *std::max_element(efficiency.begin(), efficiency.end());
        for (std::size_t i = 0; i < counted.size(); ++i) {
            if (efficiency[i] > negligible_share * most) matters[i] = 1;
        }
    }
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (matters[i] != 0) orders_.push_back(counted[i]);
    }
    order_.assign(orders_.begin(), orders_.end());
    shares_ = order_shares(grating_, orders_);
}

void GratingColour::add_nodes(const Light& light) {
    for (int node = 0; node < light.grid.count; ++node) {
        const auto i = static_cast<std::size_t>(node);
        per_nm_.push_back(1.0 / light.grid.wavelength_nm(node));
        node_weights_.push_back(
            scaled({light.grid_weights.x[i], light.grid_weights.y[i], light.grid_weights.z[i]}, per_nm_.back()));
    }
}

void GratingColour::fill_table() {
    const std::size_t numbers = orders_.size() * per_nm_.size();
    if (numbers > most_table_numbers) return;
    std::vector<double> row(orders_.size());
    std::vector<double> table;
    table.reserve(numbers);
    for (std::size_t point = 0; point < per_nm_.size(); ++point) {
        efficiencies(point, row);
        table.insert(table.end(), row.begin(), row.end());
    }
    table_ = std::move(table);
}

const double* GratingColour::efficiencies(std::size_t point, std::vector<double>& scratch) const {
    if (!table_.empty()) return &table_[point * orders_.size()];
    scratch.resize(orders_.size());
    grating_efficiencies(grating_, orders_, shares_, 1.0 / per_nm_[point], scratch);
    // Every order is summed with both signs.
    if (orders_.front() == 0) scratch.front() *= 0.5;
    return scratch.data();
}

// Sum of efficiency / (x - m)^2 over both signs of m, for all orders but the near ones; of those, -m alone.
double GratingColour::far_sum(const Sample& sample, std::size_t first_near, std::size_t end_near) const {
    double sum = 0.0;
    const auto add_both_signs = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const double minus = square(sample.x - order_[i]);
            const double plus = square(sample.x + order_[i]);
            sum += sample.efficiency[i] * ((minus + plus) / (minus * plus));
        }
    };
    add_both_signs(0, first_near);
    for (std::size_t i = first_near; i < end_near; ++i) {
        if (orders_[i] != 0) sum += sample.efficiency[i] / square(sample.x + order_[i]);
    }
    add_both_signs(end_near, orders_.size());
    return sum;
}

// @param per_nm  half the piece's length
// @param shared  the far sum at the first sample, if the piece before left it; receives the last one's
void GratingColour::add_piece(const std::array<Sample, 3>& samples, double per_nm, Far& shared, Xyz& sum) const {
    const double grooves = grating_.grooves;
    const double length = samples[0].x - samples[2].x;
    const double lengths = pieces_->nm > 1 ? coarse_far_lengths : far_lengths(grooves * length);
    const double reach = std::max(lengths * length, always_near / grooves);
    const auto at_index = [&](auto place) { return static_cast<std::size_t>(place - order_.begin()); };
    const std::size_t first = at_index(std::lower_bound(order_.begin(), order_.end(), samples[2].x - reach));
    const std::size_t end = at_index(std::upper_bound(order_.begin(), order_.end(), samples[0].x + reach));

    const double remainder = samples[1].x - std::nearbyint(samples[1].x);
    const std::array<double, 3> ripple = parabola_weights(ripple_moments(grooves * remainder, -0.5 * grooves * length));
    const bool is_shared = shared.is_valid && shared.first_near == first && shared.end_near == end;
    const double last = far_sum(samples[2], first, end);
    const double per_square = 1.0 / square(pi * grooves);
    std::array<double, 3> total{ripple[0] * per_square * (is_shared ? shared.sum : far_sum(samples[0], first, end)),
                                ripple[1] * per_square * far_sum(samples[1], first, end),
                                ripple[2] * per_square * last};
    shared = {last, first, end, true};
    for (std::size_t i = first; i < end; ++i) {
        const double signs = orders_[i] == 0 ? 2.0 : 1.0;
        const std::array<double, 3> line =
            parabola_weights(line_moments(grooves * (samples[0].x - order_[i]), grooves * (samples[2].x - order_[i])));
        for (std::size_t j = 0; j < 3; ++j) total[j] += signs * samples[j].efficiency[i] * line[j];
    }
    const double scale = grooves * grating_.period_nm * per_nm;
    for (std::size_t j = 0; j < 3; ++j) add(sum, scale * total[j], samples[j].weight);
}

// Where the azimuth's factor changes too much the piece is cut, and all else taken from parabolas through its points.
// @param samples  of the piece, without the factor
// @param azimuth  the factor's exponent at 1 nm
void GratingColour::add_split_piece(const std::array<Sample, 3>& samples, std::size_t piece, double azimuth, int parts,
                                    Xyz& sum) const {
    const double middle_per_nm = per_nm_[2 * piece + 1];
    const double half_per_nm = 0.5 * (per_nm_[2 * piece + 2] - per_nm_[2 * piece]);
    std::array<std::vector<double>, 3> rows;
    const auto sample_at = [&](double s, std::vector<double>& row) {
        const std::array<double, 3> share{0.5 * s * (s - 1.0), (1.0 - s) * (1.0 + s), 0.5 * s * (s + 1.0)};
        const double factor = std::exp(-azimuth * square(middle_per_nm + s * half_per_nm));
        Sample sample{samples[1].x + 0.5 * s * (samples[2].x - samples[0].x), {}, nullptr};
        row.assign(orders_.size(), 0.0);
        for (std::size_t j = 0; j < 3; ++j) {
            add(sample.weight, factor * share[j], samples[j].weight);
            for (std::size_t i = 0; i < row.size(); ++i) row[i] += share[j] * samples[j].efficiency[i];
        }
        sample.efficiency = row.data();
        return sample;
    };
    Far shared;
    for (int part = 0; part < parts; ++part) {
        const double from = -1.0 + 2.0 * part / parts;
        const double to = -1.0 + 2.0 * (part + 1) / parts;
        add_piece({sample_at(from, rows[0]), sample_at(0.5 * (from + to), rows[1]), sample_at(to, rows[2])},
                  -half_per_nm / parts, shared, sum);
    }
}

Xyz GratingColour::at(double u) const {
    assert(u >= 0.0 && u <= 2.0);
    const double azimuth = azimuth_exponent(grating_, u, 1.0);
    if (orders_.empty() || !std::isfinite(azimuth)) return {};
    if (has_nodes_) return at_nodes(u);
    const double across_nm = u * share_across(grating_) * grating_.period_nm;
    std::array<std::vector<double>, 3> rows;
    std::array<Sample, 3> samples;
    std::array<double, 3> factor{};
    const double least_exponent = azimuth * square(per_nm_.back());
    Far shared;
    Xyz sum;
    const auto factor_at = [&](std::size_t point) {
        return azimuth == 0.0 ? 1.0 : std::exp(-azimuth * square(per_nm_[point]));
    };
    factor[2] = factor_at(0);
    for (std::size_t piece = 0; piece < pieces_->weights.size(); ++piece) {
        factor = {factor[2], factor_at(2 * piece + 1), factor_at(2 * piece + 2)};
        for (std::size_t j = 0; j < 3; ++j) {
            samples[j].x = across_nm * per_nm_[2 * piece + j];
            samples[j].weight = pieces_->weights[piece][j];
            samples[j].efficiency = efficiencies(2 * piece + j, rows[j]);
        }
        const double to_exponent = azimuth * square(per_nm_[2 * piece + 2]);
        const double change = azimuth * square(per_nm_[2 * piece]) - to_exponent;
        const double allowed_change = allowed_exponent_change(to_exponent, least_exponent);
        if (to_exponent > std::min(darkest_exponent, least_exponent + negligible_exponent)) {
            shared.is_valid = false;
        } else if (change > allowed_change) {
            add_split_piece(samples, piece, azimuth, static_cast<int>(std::ceil(change / allowed_change)), sum);
            shared.is_valid = false;
        } else {
            for (std::size_t j = 0; j < 3; ++j) samples[j].weight = scaled(samples[j].weight, factor[j]);
            const double per_nm = 0.5 * (per_nm_[2 * piece] - per_nm_[2 * piece + 2]);
            add_piece(samples, per_nm, shared, sum);
        }
    }
    return not_below_black(sum);
}

Xyz GratingColour::at_nodes(double u) const {
    const double grooves = grating_.grooves;
    const double azimuth = azimuth_exponent(grating_, u, 1.0);
    const double across_nm = u * share_across(grating_) * grating_.period_nm;
    std::vector<double> row;
    Xyz sum;
    for (std::size_t node = 0; node < per_nm_.size(); ++node) {
        const double per_nm = per_nm_[node];
        const Sample sample{across_nm * per_nm, node_weights_[node], efficiencies(node, row)};
        const double reach = always_near / grooves;
        const double remainder = grooves * (sample.x - std::nearbyint(sample.x));
        const double ripple = square(std::sin(pi * (remainder - std::nearbyint(remainder))) / (pi * grooves));
        const auto place = std::lower_bound(order_.begin(), order_.end(), sample.x - reach);
        const auto first = static_cast<std::size_t>(place - order_.begin());
        const bool is_near = place != order_.end() && *place <= sample.x + reach;
        double power = ripple * far_sum(sample, first, is_near ? first + 1 : first);
        if (is_near) {
            // The top of the line, 1 - (pi t)^2 / 3; the next term is below 1e-11.
            const double top = 1.0 - square(pi * grooves * (sample.x - order_[first])) / 3.0;
            power += (orders_[first] == 0 ? 2.0 : 1.0) * sample.efficiency[first] * top;
        }
        add(sum, power * grooves * grating_.period_nm * std::exp(-azimuth * square(per_nm)), sample.weight);
    }
    return not_below_black(sum);
}

std::uint64_t GratingColour::samples() const {
    if (orders_.empty()) return 0;
    const std::size_t pieces = has_nodes_ ? node_weights_.size() : pieces_->weights.size();
    const bool has_mirror_order = orders_.front() == 0;
    return pieces * (2 * orders_.size() - (has_mirror_order ? 1 : 0));
}

}  // namespace nacre
