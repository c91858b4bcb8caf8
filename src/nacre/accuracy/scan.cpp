// The search for the point at which a LUT errs most.
//
// In: a trial, which tells the error at any points, a limit beyond which the answer does not matter, and points at
// which smaller LUTs erred. In this order:
//   1. The points given, and in 1D the middles of some cells. They leave no trace, so that a LUT is judged alike
//      wherever others failed.
//   2. An even grid over all cells, row by row, with the kinks of the model. Of each row of cells the worst point of
//      each cell is kept, if it is not far from the worst of all.
//   3. The worst cells again, finely, and around their worst points in ever smaller steps.
// As soon as an error exceeds the limit, the scan ends: a LUT that is too small costs next to nothing.
//
// The constants are empirical: tests/nacre/accuracy/scan_test.cpp compares scans with plain dense ones, which find no
// more than 1.5 % beyond.
#include "nacre/accuracy/scan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "nacre/accuracy/effort.h"
#include "nacre/lut/job.h"
#include "nacre/shade/kinks.h"

namespace nacre {
namespace {

// How many points a side a cell gets, so that each LUT is scanned finely enough however few cells it has.
constexpr int fewest_in_1d = 2;
constexpr int fewest_in_2d = 2;
constexpr int fewest_columns_in_1d = 512;
constexpr int fewest_columns_in_2d = 384;
constexpr int fewest_rows = 96;

constexpr std::size_t batch_size = 512;

// Cells whose middles are looked at first. Chosen: they cost little beside a whole scan, which most LUTs are too small
// for.
constexpr int most_middles = 128;

// Cells within this factor of the worst are looked at again, so many at most.
constexpr double worth_refining = 0.55;
constexpr std::size_t most_refined = 32;
constexpr int refined_in_1d = 16;
constexpr int refined_in_2d = 8;

// After that the worst point of such a cell is closed in on: so often, by so much each time. In 1D that ends when a
// step gains less than a share of the error: towards a smooth peak each gains a sixteenth of the one before, towards a
// kink a quarter.
constexpr int zooms = 5;
constexpr int zoom_steps = 4;
constexpr double hardly_a_gain = 1e-4;

int steps_per_cell(int texels, int fewest, int fewest_overall) {
    const int cells = std::max(texels - 1, 1);
    return std::max(fewest, (fewest_overall + cells - 1) / cells);
}

// A larger LUT is scanned on every n-th line only, so that scanning costs no more than baking; and one whose colours
// are expensive on fewer still, in reflectances of a film.
constexpr double most_points = 1 << 22;
constexpr double fewest_points = 1 << 14;
constexpr double most_scan_effort = 1e9;

struct Cell {
    double largest = 0.0;
    LutPoint at;
};

bool is_worse(const Cell& a, const Cell& b) {
    return a.largest > b.largest;
}

class Scanner {
public:
    Scanner(Trial& trial, double limit, bool unrounded)
        : trial_(trial),
          limit_(limit),
          unrounded_(unrounded),
          columns_(std::max(trial.job().width - 1, 1)),
          rows_(std::max(trial.job().height - 1, 1)),
          row_(static_cast<std::size_t>(columns_)) {}

    Scan scan(std::span<const LutPoint> first) {
        scan_at(first);
        if (!is_over() && !is_2d()) scan_at(some_middles());
        if (!is_over()) {
            // They leave no trace: a LUT is judged alike wherever others failed.
            result_ = {};
            points_ = 0;
            std::fill(row_.begin(), row_.end(), Cell{});
            scan_everywhere();
        }
        if (!is_over()) refine();
        result_.is_complete = !is_over();
        result_.points = points_;
        return std::move(result_);
    }

private:
    bool is_2d() const { return trial_.job().y.has_value(); }
    bool is_over() const { return result_.largest > limit_; }

    int column_of(LutPoint point) const { return std::min(static_cast<int>(point.x * columns_), columns_ - 1); }
    int row_of(LutPoint point) const { return std::min(static_cast<int>(point.y * rows_), rows_ - 1); }

    // Returns the worst of them, even if the limit cut it short.
    Cell scan_at(std::span<const LutPoint> points) {
        Cell worst;
        for (std::size_t begin = 0; begin < points.size() && !is_over(); begin += batch_size) {
            const auto batch = points.subspan(begin, std::min(batch_size, points.size() - begin));
            points_ += batch.size();
            const double floor = 0.5 * result_.largest;  // well below what is worth refining
            const std::vector<double> errors =
                unrounded_ ? trial_.unrounded_errors_at(batch, floor) : trial_.errors_at(batch, floor);
            for (std::size_t i = 0; i < batch.size(); ++i) {
                // Not a number counts as an error without bound.
                const Cell here{std::isnan(errors[i]) ? std::numeric_limits<double>::infinity() : errors[i], batch[i]};
                if (is_worse(here, worst)) worst = here;
                Cell& cell = row_[static_cast<std::size_t>(column_of(here.at))];
                if (is_worse(here, cell)) cell = here;
                if (here.largest > result_.largest) {
                    result_.largest = here.largest;
                    result_.at = here.at;
                }
            }
        }
        return worst;
    }

    // Keeps the bad cells of the row of cells that was looked at, and clears it for the next.
    void finish_row() {
        for (Cell& cell : row_) {
            if (cell.largest > 0.0 && cell.largest >= worth_refining * result_.largest) bad_cells_.push_back(cell);
            cell = {};
        }
        if (bad_cells_.size() < 4096) return;
        keep_worst(most_refined);
    }

    void keep_worst(std::size_t count) {
        std::erase_if(bad_cells_, [&](const Cell& cell) { return cell.largest < worth_refining * result_.largest; });
        count = std::min(count, bad_cells_.size());
        std::partial_sort(bad_cells_.begin(), bad_cells_.begin() + static_cast<std::ptrdiff_t>(count), bad_cells_.end(),
                          is_worse);
        bad_cells_.resize(count);
    }

    // Where a LUT that is too small errs: of some cells the middles, and beside the breakpoints.
    std::vector<LutPoint> some_middles() const {
        const int count = std::min(columns_, most_middles);
        std::vector<LutPoint> points;
        for (int i = 0; i < count; ++i) {
            const auto column = static_cast<int>(static_cast<std::int64_t>(i) * columns_ / count);
            points.push_back({(column + 0.5) / columns_, 0.0});
        }
        for (const double x : breakpoints(trial_.job(), 0.0)) {
            const int column = std::min(static_cast<int>(x * columns_), columns_ - 1);
            for (const int near : {column - 1, column, column + 1}) {
                if (near >= 0 && near < columns_) points.push_back({(near + 0.5) / columns_, 0.0});
            }
        }
        return points;
    }

    int columns_per_cell() const {
        const int width = trial_.job().width;
        return is_2d() ? steps_per_cell(width, fewest_in_2d, fewest_columns_in_2d)
                       : steps_per_cell(width, fewest_in_1d, fewest_columns_in_1d);
    }

    void scan_everywhere() {
        const Job& job = trial_.job();
        const int per_column = columns_per_cell();
        const int per_row = is_2d() ? steps_per_cell(job.height, fewest_in_2d, fewest_rows) : 1;
        const int last_line = is_2d() ? rows_ * per_row : 0;
        const int last_step = columns_ * per_column;
        const double points = (1.0 + last_step) * (1.0 + last_line);
        // Odd, so that lines through texels and lines between them have their turn.
        const double affordable =
            is_2d() ? std::clamp(most_scan_effort / effort_per_colour(job), fewest_points, most_points) : most_points;
        const int stride = static_cast<int>(std::ceil(points / affordable)) | 1;
        std::vector<LutPoint> line;
        for (int j = 0; j <= last_line && !is_over(); j += stride) {
            const double y = is_2d() ? static_cast<double>(j) / last_line : 0.0;
            line.clear();
            for (int i = 0; i <= last_step; ++i) line.push_back({static_cast<double>(i) / last_step, y});
            for (const double x : breakpoints(job, y)) line.push_back({x, y});
            if (j > 0 && j % per_row < stride) finish_row();
            scan_at(line);
        }
        finish_row();
    }

    // Once more, finely, the worst first.
    void refine() {
        keep_worst(most_refined);
        std::vector<Cell> worst;
        for (const Cell& cell : bad_cells_) {
            if (is_over()) return;
            worst.push_back(refine(cell));
        }
        std::sort(worst.begin(), worst.end(), is_worse);
        for (const Cell& cell : worst) result_.worst.push_back(cell.at);
    }

    // The worst point of a cell of which a bad one is known.
    Cell refine(const Cell& known) {
        const int column = column_of(known.at);
        const int row = row_of(known.at);
        const int steps = is_2d() ? refined_in_2d : refined_in_1d;
        // Of few cells, each was looked at as finely as this already.
        if (!is_2d() && columns_per_cell() >= steps) return zoom_in(known, column, row);
        std::vector<LutPoint> points;
        for (int j = 0; j <= (is_2d() ? steps : 0); ++j) {
            const double y = is_2d() ? (row + static_cast<double>(j) / steps) / rows_ : 0.0;
            for (int i = 0; i <= steps; ++i)
                points.push_back({(column + static_cast<double>(i) / steps) / columns_, y});
        }
        const Cell found = scan_at(points);
        return zoom_in(is_worse(found, known) ? found : known, column, row);
    }

    // Closes in on the worst point of a cell: kinks need not lie on any grid.
    Cell zoom_in(Cell worst, int column, int row) {
        const int steps = is_2d() ? refined_in_2d : refined_in_1d;
        double reach = 1.0 / steps;  // in cells
        for (int zoom = 0; zoom < zooms && !is_over(); ++zoom, reach /= zoom_steps) {
            const auto beside = [&](double coordinate, int cell, int cells, int step) {
                const double in_cells = coordinate * cells + step * reach / zoom_steps;
                return std::clamp(in_cells, static_cast<double>(cell), cell + 1.0) / cells;
            };
            std::vector<LutPoint> points;
            for (int j = is_2d() ? -zoom_steps : 0; j <= (is_2d() ? zoom_steps : 0); ++j) {
                const double y = is_2d() ? beside(worst.at.y, row, rows_, j) : 0.0;
                for (int i = -zoom_steps; i <= zoom_steps; ++i)
                    points.push_back({beside(worst.at.x, column, columns_, i), y});
            }
            const Cell found = scan_at(points);
            const double gain = found.largest - worst.largest;
            if (gain > 0.0) worst = found;
            if (!is_2d() && gain < hardly_a_gain * worst.largest) break;
        }
        return worst;
    }

    Trial& trial_;
    double limit_;
    bool unrounded_;
    int columns_;
    int rows_;
    std::vector<Cell> row_;  // of cells, one per column
    std::vector<Cell> bad_cells_;
    std::size_t points_ = 0;
    Scan result_;
};

// Where kinks lie so near each other that an even grid might step over what is between them and just beyond, that is
// looked at too: evenly between them, and at growing distances on either side.
//
// @param kinks  ascending
std::vector<double> with_steep_stretches(std::vector<double> kinks) {
    constexpr double near = 1.0 / 128.0;
    constexpr int between = 32;
    constexpr double growth = 1.25;
    std::vector<double> all = kinks;
    for (std::size_t i = 1; i < kinks.size(); ++i) {
        const double from = kinks[i - 1];
        const double gap = kinks[i] - from;
        if (gap > near) continue;
        for (int step = 1; step < between; ++step) all.push_back(from + gap * step / between);
        for (double distance = gap / between; distance < 1.0; distance *= growth) {
            if (from - distance >= 0.0) all.push_back(from - distance);
            if (kinks[i] + distance <= 1.0) all.push_back(kinks[i] + distance);
        }
    }
    return all;
}

}  // namespace

std::vector<double> breakpoints(const Job& job, double y) {
    if (!job.x.is_angle()) return {};
    const Mechanism mechanism = mechanism_at(job, 0.0, y);
    std::vector<double> kinks;
    for (const double angle_deg : kinks_deg(mechanism))
        kinks.push_back(std::clamp(job.x.kind->coordinate(Incidence::from_degrees(angle_deg).cos_theta), 0.0, 1.0));
    std::sort(kinks.begin(), kinks.end());
    // A clamp that begins at a pick is found beside it by the last bits.
    constexpr double same = 1e-13;
    kinks.erase(std::unique(kinks.begin(), kinks.end(), [](double a, double b) { return b - a < same; }), kinks.end());
    return with_steep_stretches(std::move(kinks));
}

double share_found_by_scan(const Job& job) {
    // Empirical; tests/nacre/accuracy/scan_test.cpp compares scans with plain dense ones.
    constexpr double in_1d = 0.995;
    constexpr double in_2d = 0.98;
    return job.y ? in_2d : in_1d;
}

Scan scan_errors(Trial& trial, double limit, std::span<const LutPoint> first, bool unrounded) {
    return Scanner(trial, limit, unrounded).scan(first);
}

}  // namespace nacre
