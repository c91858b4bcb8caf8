#include "nacre/pick/fit_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/difference.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"

namespace nacre {
namespace {

// The last two count only where some pick has them.
constexpr std::array members{&Lobe::peak_nm, &Lobe::width_nm, &Lobe::height, &Lobe::floor, &Lobe::flatness};
constexpr std::size_t paper_members = 3;
using Vector = std::array<double, members.size()>;

// Lines are counted in these, so that all numbers are of one size.
constexpr Vector unit{100.0, 100.0, 1.0, 1.0, 1.0};

std::size_t count_members(const std::vector<Pick>& picks) {
    const bool are_the_papers = std::all_of(picks.begin(), picks.end(), [](const Pick& pick) {
        return pick.lobe.floor == 0.0 && pick.lobe.flatness == 0.0;
    });
    return are_the_papers ? paper_members : members.size();
}

// The weight of an error of one unit where it cannot be seen, such as the peak of black, so that the lines stay
// defined. It is in CIEDE2000 too, and its square is negligible beside visible errors.
constexpr double unseen = 1e-3;

// Offset and slope of each line, in turn.
using Unknowns = std::array<double, 2 * members.size()>;

Lab lab_of(const Xyz& colour) {
    return to_lab(colour, d65_white);
}

double y_of(double shape, const Incidence& at) {
    return shape_difference(shape, at, Incidence::from_degrees(90.0));
}

// Solves a symmetric positive definite system of the first unknowns by Cholesky's method.
Unknowns solved(std::array<Unknowns, 2 * members.size()> matrix, Unknowns right, std::size_t unknowns) {
    for (std::size_t i = 0; i < unknowns; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = matrix[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= matrix[i][k] * matrix[j][k];
            matrix[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / matrix[j][j];
        }
        for (std::size_t k = 0; k < i; ++k) right[i] -= matrix[i][k] * right[k];
        right[i] /= matrix[i][i];
    }
    for (std::size_t i = unknowns; i-- > 0;) {
        for (std::size_t k = i + 1; k < unknowns; ++k) right[i] -= matrix[k][i] * right[k];
        right[i] /= matrix[i][i];
    }
    return right;
}

// Straight lines for one shape, and what they miss. Heights may leave [0, 1] on the way.
class LineFit {
public:
    LineFit(const std::vector<Pick>& picks, const LobeColour& colour_of)
        : picks_(picks), colour_of_(colour_of), lines_count_(count_members(picks)) {
        for (const Pick& pick : picks) labs_.push_back(lab_of(colour_of(pick.lobe)));
    }

    /// Becomes the lines of a shape. @return the sum of the squared differences
    double fit(double shape);
    /// The lines' lobe at a pick.
    Lobe lobe(std::size_t pick) const { return lobe_of(lines_, pick); }
    /// CIEDE2000 between a lobe and a pick.
    double de00(std::size_t pick, const Lobe& lobe) const { return ciede2000(labs_[pick], lab_of(colour_of_(lobe))); }

private:
    // The residuals: parts of CIEDE2000, and a small weight of the difference of each number.
    using Differences = std::array<double, 3 + members.size()>;
    struct Normal {
        std::array<Unknowns, 2 * members.size()> matrix{};
        Unknowns gradient{};
    };

    Lobe lobe_of(const Unknowns& lines, std::size_t pick) const;
    Differences differences_of(const Lobe& lobe, std::size_t pick) const;
    double square_sum(const Unknowns& lines) const;
    void start_straight();
    Normal normal() const;

    const std::vector<Pick>& picks_;
    const LobeColour& colour_of_;
    std::vector<Lab> labs_;
    std::vector<double> y_;  // of the picks, from their mean
    std::size_t lines_count_;
    Unknowns lines_{};  // of each number in its units
};

Lobe LineFit::lobe_of(const Unknowns& lines, std::size_t pick) const {
    Lobe lobe;
    for (std::size_t i = 0; i < lines_count_; ++i)
        lobe.*members[i] = unit[i] * (lines[i] + lines[i + lines_count_] * y_[pick]);
    return lobe;
}

LineFit::Differences LineFit::differences_of(const Lobe& lobe, std::size_t pick) const {
    Lobe shown = lobe;
    shown.width_nm = std::max(shown.width_nm, 0.0);
    shown.flatness = std::clamp(shown.flatness, 0.0, largest_flatness);
    const auto seen = ciede2000_parts(labs_[pick], lab_of(colour_of_(shown)));
    Differences differences{seen[0], seen[1], seen[2]};
    for (std::size_t i = 0; i < lines_count_; ++i)
        differences[i + 3] = unseen * (lobe.*members[i] - picks_[pick].lobe.*members[i]) / unit[i];
    return differences;
}

double LineFit::square_sum(const Unknowns& lines) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < picks_.size(); ++i) {
        for (const double difference : differences_of(lobe_of(lines, i), i)) sum += difference * difference;
    }
    return sum;
}

// Least squares of each number by itself.
void LineFit::start_straight() {
    lines_ = {};
    double yy = 0.0;
    for (const double y : y_) yy += y * y;
    for (std::size_t i = 0; i < lines_count_; ++i) {
        for (std::size_t k = 0; k < picks_.size(); ++k) {
            const double value = picks_[k].lobe.*members[i] / unit[i];
            lines_[i] += value / static_cast<double>(picks_.size());
            lines_[i + lines_count_] += value * y_[k] / yy;
        }
    }
}

LineFit::Normal LineFit::normal() const {
    constexpr Vector step{0.1, 0.1, 1e-4, 1e-4, 1e-4};
    const std::size_t unknowns = 2 * lines_count_;
    Normal normal;
    for (std::size_t pick = 0; pick < picks_.size(); ++pick) {
        const Lobe here = lobe_of(lines_, pick);
        const Differences differences = differences_of(here, pick);
        std::array<Differences, 2 * members.size()> slopes{};
        for (std::size_t i = 0; i < lines_count_; ++i) {
            Lobe beside = here;
            beside.*members[i] += step[i];
            const Differences moved = differences_of(beside, pick);
            for (std::size_t k = 0; k < moved.size(); ++k) {
                slopes[i][k] = (moved[k] - differences[k]) * (unit[i] / step[i]);
                slopes[i + lines_count_][k] = slopes[i][k] * y_[pick];
            }
        }
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t k = 0; k < differences.size(); ++k) {
                normal.gradient[i] += slopes[i][k] * differences[k];
                for (std::size_t j = 0; j < unknowns; ++j) normal.matrix[i][j] += slopes[i][k] * slopes[j][k];
            }
        }
    }
    return normal;
}

// Levenberg and Marquardt's method.
double LineFit::fit(double shape) {
    y_.clear();
    double mean = 0.0;
    for (const Pick& pick : picks_) y_.push_back(y_of(shape, Incidence::from_degrees(pick.angle_deg)));
    for (const double y : y_) mean += y / static_cast<double>(y_.size());
    for (double& y : y_) y -= mean;
    start_straight();
    const std::size_t unknowns = 2 * lines_count_;
    double square = square_sum(lines_);
    double damping = 1e-3;
    constexpr int most_steps = 30;
    constexpr double nothing = 1e-10, hardly = 1e-5;
    for (int step = 0; step < most_steps && square > nothing; ++step) {
        const Normal at = normal();
        const double before = square;
        for (int attempt = 0; attempt < 6 && square == before; ++attempt) {
            auto damped = at.matrix;
            for (std::size_t i = 0; i < unknowns; ++i) damped[i][i] *= 1.0 + damping;
            const Unknowns move = solved(damped, at.gradient, unknowns);
            Unknowns there = lines_;
            for (std::size_t i = 0; i < unknowns; ++i) there[i] -= move[i];
            const double there_square = square_sum(there);
            if (there_square < square) {
                lines_ = there;
                square = there_square;
                damping *= 0.2;
            } else {
                damping *= 8.0;
            }
        }
        if (before - square < hardly * before) break;
    }
    return square;
}

// More decimals would be those of the search.
double rounded(double value) {
    constexpr double decimals = 1e4;
    return std::round(value * decimals) / decimals;
}

// The best of a scan, and the golden section about it; nothing, where all are alike.
std::optional<double> best_shape(LineFit& lines) {
    constexpr std::size_t steps = 20;
    std::array<double, steps + 1> misfit{};
    for (std::size_t i = 0; i <= steps; ++i) misfit[i] = lines.fit(static_cast<double>(i) / steps);
    const auto [least, most] = std::minmax_element(misfit.begin(), misfit.end());
    constexpr double nothing = 1e-4;  // CIEDE2000 0.01 in all
    if (*most - *least < nothing) return {};
    const double middle = static_cast<double>(least - misfit.begin()) / steps;
    double low = std::max(0.0, middle - 1.0 / steps), high = std::min(1.0, middle + 1.0 / steps);
    constexpr double golden = 0.6180339887498949, enough = 1e-5;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double at_a = lines.fit(a), at_b = lines.fit(b);
    while (high - low > enough) {
        if (at_a < at_b) {
            high = b;
            b = a;
            at_b = at_a;
            at_a = lines.fit(a = high - golden * (high - low));
        } else {
            low = a;
            a = b;
            at_a = at_b;
            at_b = lines.fit(b = low + golden * (high - low));
        }
    }
    return rounded(0.5 * (low + high));
}

}  // namespace

std::optional<ShapeFit> fit_shape(const std::vector<Pick>& picks, const LobeColour& colour_of) {
    std::set<double> angles_deg;
    for (const Pick& pick : picks) angles_deg.insert(pick.angle_deg);
    if (angles_deg.size() < 3) return {};  // a straight line passes through two, whatever the shape
    LineFit lines(picks, colour_of);
    const auto shape = best_shape(lines);
    if (!shape) return {};
    ShapeFit fit{*shape, {}};
    lines.fit(fit.shape);
    for (std::size_t i = 0; i < picks.size(); ++i) {
        Lobe lobe = lines.lobe(i);
        lobe.width_nm = std::max(lobe.width_nm, 0.0);
        lobe.height = std::clamp(lobe.height, 0.0, 1.0);
        lobe.floor = std::clamp(lobe.floor, 0.0, 1.0);
        fit.de00.push_back(rounded(lines.de00(i, lobe)));
    }
    return fit;
}

}  // namespace nacre
