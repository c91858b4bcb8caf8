#include "nacre/colour/xyz_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace nacre {
namespace {

// Degrees of polynomials, from the first that is tried to the last. Chosen: two panels of 32 take fewer colours than
// one of 64 where a colour does not bend alike everywhere.
constexpr std::size_t least_degree = 4;
constexpr std::size_t most_degree = 32;
// A polynomial that converges errs by far less with twice the points; where it errs by more than this part, halves of
// the interval will.
constexpr double least_gain = 0.2;
// Narrower intervals are accepted as they are: the colour has a kink there that is not among the borders.
constexpr double narrowest = 1e-4;
// So far from a border, in lengths of the interval, a colour is taken to be the one at the border on that side.
constexpr double beside_border = 1e-9;

Xyz plus(const Xyz& sum, double factor, const Xyz& term) {
    return {sum.x + factor * term.x, sum.y + factor * term.y, sum.z + factor * term.z};
}

// Clenshaw's recurrence. @param t  in [-1, 1]
Xyz value_at(const std::vector<Xyz>& coefficients, double t) {
    Xyz one;
    Xyz two;
    for (std::size_t n = coefficients.size() - 1; n > 0; --n) {
        const Xyz next = plus(plus(coefficients[n], 2.0 * t, one), -1.0, two);
        two = one;
        one = next;
    }
    return plus(plus(coefficients[0], t, one), -1.0, two);
}

// Chebyshev's points, from 1 down to -1. @param j  0 ... degree
double point(std::size_t j, std::size_t degree) {
    return std::cos(std::numbers::pi * static_cast<double>(j) / static_cast<double>(degree));
}

// Of the polynomial through values at these points: a discrete cosine transform.
std::vector<Xyz> coefficients_of(const std::vector<Xyz>& values) {
    const std::size_t degree = values.size() - 1;
    std::vector<double> cosines(2 * degree);
    for (std::size_t i = 0; i < cosines.size(); ++i) cosines[i] = point(i, degree);
    std::vector<Xyz> coefficients(values.size());
    for (std::size_t n = 0; n <= degree; ++n) {
        for (std::size_t j = 0; j <= degree; ++j) {
            const double share = (j == 0 || j == degree ? 0.5 : 1.0) * (n == 0 || n == degree ? 1.0 : 2.0);
            coefficients[n] =
                plus(coefficients[n], share / static_cast<double>(degree) * cosines[n * j % (2 * degree)], values[j]);
        }
    }
    return coefficients;
}

// The colours of one interval at Chebyshev's points, from its end to its beginning.
struct Interval {
    double from = 0.0;
    double to = 1.0;
    std::vector<Xyz> values;

    double x(double t) const { return std::lerp(from, to, 0.5 + 0.5 * t); }

    // Twice as many points. Returns the largest difference of the new ones from the polynomial of the old ones.
    double refine(const XyzCurve::Colour& colour, const XyzCurve::Difference& difference) {
        const std::vector<Xyz> coarse = coefficients_of(values);
        const std::size_t degree = 2 * (values.size() - 1);
        std::vector<Xyz> finer;
        double largest = 0.0;
        for (std::size_t j = 0; j <= degree; ++j) {
            if (j % 2 == 0) {
                finer.push_back(values[j / 2]);
                continue;
            }
            const double t = point(j, degree);
            finer.push_back(colour(x(t)));
            const double error = difference(value_at(coarse, t), finer.back());
            largest = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(largest, error);
        }
        values = std::move(finer);
        return largest;
    }
};

Interval interval_of(double from, double to, const Xyz& at_from, const Xyz& at_to, const XyzCurve::Colour& colour) {
    Interval interval{from, to, {at_to}};
    for (std::size_t j = 1; j < least_degree; ++j)
        interval.values.push_back(colour(interval.x(point(j, least_degree))));
    interval.values.push_back(at_from);
    return interval;
}

// Whether the interval's polynomial came to agree.
bool converge(Interval& interval, const XyzCurve::Colour& colour, const XyzCurve::Difference& difference) {
    double before = std::numeric_limits<double>::infinity();
    while (interval.values.size() <= most_degree) {
        const double error = interval.refine(colour, difference);
        if (error <= 1.0) return true;
        if (error > least_gain * before) return false;
        // The first few points say little of what more will do.
        if (interval.values.size() > 2 * least_degree + 1) before = error;
    }
    return false;
}

}  // namespace

XyzCurve::XyzCurve(const Colour& colour, const std::vector<double>& borders, const Difference& difference,
                   const std::function<void()>& after_step) {
    *this = *within(std::numeric_limits<double>::infinity(), colour, borders, difference, after_step);
}

std::optional<XyzCurve> XyzCurve::within(double most_colours, const Colour& colour_at,
                                         const std::vector<double>& borders, const Difference& difference,
                                         const std::function<void()>& after_step) {
    XyzCurve curve;
    double colours = 0.0;
    const Colour colour = [&](double x) {
        ++curve.colours_;
        return colour_at(x);
    };
    for (std::size_t i = 1; i < borders.size(); ++i) {
        // The colour may jump at a border, and what it is there belongs to one side only.
        const double inside = beside_border * (borders[i] - borders[i - 1]);
        double from = borders[i - 1];
        Xyz at_from = colour(from + inside);
        std::vector<std::pair<double, Xyz>> ends{{borders[i], colour(borders[i] - inside)}};  // the next one last
        while (!ends.empty()) {
            if (colours > most_colours) return std::nullopt;
            const auto [to, at_to] = ends.back();
            Interval interval = interval_of(from, to, at_from, at_to, colour);
            const bool is_good = converge(interval, colour, difference);
            colours += static_cast<double>(interval.values.size());
            if (after_step) after_step();
            if (!is_good && to - from > narrowest) {
                ends.emplace_back(0.5 * (from + to), interval.values[interval.values.size() / 2]);
                continue;
            }
            curve.panels_.push_back({to, coefficients_of(interval.values)});
            from = to;
            at_from = at_to;
            ends.pop_back();
        }
    }
    return curve;
}

Xyz XyzCurve::at(double x) const {
    const auto panel = std::lower_bound(panels_.begin(), panels_.end() - 1, x,
                                        [](const Panel& candidate, double value) { return candidate.to < value; });
    const double from = panel == panels_.begin() ? 0.0 : (panel - 1)->to;
    return value_at(panel->coefficients, 2.0 * (x - from) / (panel->to - from) - 1.0);
}

std::vector<double> XyzCurve::borders() const {
    std::vector<double> borders{0.0};
    for (const Panel& panel : panels_) borders.push_back(panel.to);
    return borders;
}

XyzCurve XyzCurve::in_pieces(std::size_t degree) const {
    XyzCurve pieces;
    double from = 0.0;
    for (const Panel& panel : panels_) {
        const std::size_t count = (panel.coefficients.size() - 2 + degree) / degree;
        for (std::size_t i = 0; i < count; ++i) {
            // Within the panel, in its own variable.
            const double begin = 2.0 * static_cast<double>(i) / static_cast<double>(count) - 1.0;
            const double end = 2.0 * static_cast<double>(i + 1) / static_cast<double>(count) - 1.0;
            std::vector<Xyz> values;
            for (std::size_t j = 0; j <= degree; ++j)
                values.push_back(value_at(panel.coefficients, std::lerp(begin, end, 0.5 + 0.5 * point(j, degree))));
            const double to = std::lerp(from, panel.to, 0.5 + 0.5 * end);
            pieces.panels_.push_back({to, coefficients_of(values)});
        }
        from = panel.to;
    }
    return pieces;
}

std::vector<double> curve_borders(std::vector<double> borders) {
    borders.push_back(0.0);
    borders.push_back(1.0);
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end(), [](double a, double b) { return b - a < narrowest; }),
                  borders.end());
    borders.front() = 0.0;
    borders.back() = 1.0;
    return borders;
}

}  // namespace nacre
