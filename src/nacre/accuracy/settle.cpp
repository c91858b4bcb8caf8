#include "nacre/accuracy/settle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "nacre/accuracy/candidates.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/effort.h"
#include "nacre/accuracy/obstacle.h"
#include "nacre/accuracy/scan.h"
#include "nacre/base/error.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/shade/integral.h"

namespace nacre {
namespace {

// What is left of the bound once a scan's own blur is taken off: see scan_errors().
constexpr double of_bound_in_1d = 0.995;
constexpr double of_bound_in_2d = 0.98;
// What `fast` may use of it: so little that it never costs a larger LUT.
constexpr double share_of_fast = 0.02;

// And what the nodes of a film's or stack's spectrum may: they err by less with every one more.
constexpr double share_of_nodes = 0.08;
// The model is looked up on a curve, texels and what they are held against; each may be off by this.
constexpr double share_of_curve = 0.005;
// And the mean of an irregular stack, which converges slowly.
constexpr double share_of_spread = 0.3;
// And each of the other sums: of directions below a base, of facets, of radii, of a crystal's slices.
constexpr double share_of_quadrature = 0.04;

// Points at which integrals are compared, and slices are laid through a 2D LUT.
constexpr int survey_columns = 65;
constexpr int survey_rows = 9;
constexpr std::array slices{0.0, 0.25, 0.5, 0.75, 1.0};

constexpr std::size_t most_seeds = 96;

class Settler {
public:
    Settler(const PlannedLut& lut, const Encoding& encoding, const AfterRow& after_step)
        : encoding_(encoding), after_step_(after_step), wish_(lut.wish) {
        result_.lut = lut;
    }

    SettledLut settle() {
        if (!encoding_.to_xyz) return settle_blindly();
        survey();
        list_candidates();
        bool is_found = find_smallest();
        if (may_still_be_exact() && !(is_found && fast_error_at(result_.worst) <= fast_share())) {
            job().integral = Integral::exact;
            result_.predicted.spectrum = 0.0;
            list_candidates();
            is_found = find_smallest();
        }
        if (!is_found) find_best();
        name_sources();
        return std::move(result_);
    }

private:
    Job& job() { return result_.lut.job; }
    bool is_palette() const { return std::holds_alternative<Palette>(result_.lut.job.material.mechanism); }
    bool samples() const { return result_.lut.job.light->settings.wavelengths.has_value(); }
    // A scene that insists on its wavelengths and gives no bound is only judged by what the LUT adds to their error.
    bool model_samples() const { return samples() && !wish_.has_bound; }
    // Whether the error of the spectrum is not in what a scan finds, because the model has it too.
    bool adds_spectrum() const { return model_samples() || (!is_palette() && !samples()); }
    // Whether sums whose error no LUT helps against are part of it.
    bool adds_means() const { return result_.predicted.spread > 0.0 || result_.predicted.quadrature > 0.0; }
    double fast_share() const { return share_of_fast * wish_.max_de00; }
    bool may_still_be_exact() const {
        return result_.lut.job.integral == Integral::fast && !wish_.integral && !samples() && is_palette();
    }

    SettledLut settle_blindly() {
        if (wish_.is_binding) {
            throw Error(
                "the colour space has no way back to XYZ, so errors in it cannot be known; give [accuracy] size "
                "instead of a bound");
        }
        const bool is_2d = job().y.has_value();
        take({wish_.width.value_or(256), is_2d ? wish_.height.value_or(64) : 1,
              wish_.format.value_or(PixelFormat::half_float)});
        job().integral = wish_.integral.value_or(Integral::exact);
        choose_nodes();
        result_.is_reached = false;
        return std::move(result_);
    }

    // How colours are sampled, and which effects are worth it.
    void choose_nodes() {
        job().without = wish_.without;
        const double bound = wish_.max_de00;
        const bool may_drop = wish_.may_drop_effects && wish_.has_bound && encoding_.to_xyz;
        const SamplingTolerance tolerance{share_of_nodes * bound, share_of_spread * bound, share_of_quadrature * bound,
                                          may_drop ? share_of_effects * bound : 0.0};
        ChosenSampling chosen = choose_sampling(
            job(), tolerance, {wish_.nodes.value_or(NodeCounts{}), wish_.realisations.value_or(0), wish_.points},
            after_step_);
        job().sampling = chosen.sampling;
        job().without = chosen.without;
        result_.effects = std::move(chosen.effects);
        result_.predicted.spectrum = chosen.error;
        result_.predicted.spread = chosen.spread_error;
        result_.predicted.quadrature = chosen.quadrature_error;
        result_.predicted.effects = chosen.effects_error;
        result_.work += chosen.work;
        effort_ = Effort(job());
    }

    // How bright a material is that is no palette, and what its nodes cost.
    void survey_spectra() {
        Job sample = job();
        sample.width = survey_columns;
        sample.height = sample.y ? survey_rows : 1;
        const Image<Xyz> colours = bake(sample, {}, &result_.work);
        scale_ = display_scale(colours);
        if (!samples()) make_curve();
        if (!samples()) return;
        sample.light = without_wavelengths(sample.light);
        const SpectralSampling& had = sample.sampling;
        const double bound = wish_.max_de00;
        sample.sampling = choose_sampling(sample, {share_of_nodes * bound, 0.0, share_of_quadrature * bound, 0.0},
                                          {{}, had.realisations, {had.hemisphere, had.sizes, had.slices}})
                              .sampling;
        const Image<Xyz> truth = bake(sample, {}, &result_.work);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            result_.predicted.spectrum =
                std::max(result_.predicted.spectrum, difference_at(truth.data()[i], colours.data()[i], scale_));
        }
    }

    // How bright the LUT is, and what each way to integrate a spectrum costs.
    void survey() {
        choose_nodes();
        if (!is_palette()) return survey_spectra();
        Job exact = job();
        exact.integral = Integral::exact;
        exact.light = without_wavelengths(exact.light);
        Job cheap = job();
        cheap.integral = wish_.integral.value_or(Integral::fast);
        exact.width = cheap.width = survey_columns;
        exact.height = cheap.height = job().y ? survey_rows : 1;
        const Image<Xyz> truth = bake(exact, {}, &result_.work);
        const Image<Xyz> approximation = bake(cheap, {}, &result_.work);
        scale_ = display_scale(truth);
        double error = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i)
            error = std::max(error, difference_at(truth.data()[i], approximation.data()[i], scale_));
        const bool takes_cheap = samples() || wish_.integral || error <= fast_share();
        job().integral = takes_cheap ? cheap.integral : Integral::exact;
        result_.predicted.spectrum = takes_cheap ? error : 0.0;
        // Facets make every colour dear.
        const bool has_facets = !job().without.has(Effect::tilt) && effects_in(job()).has(Effect::tilt);
        if (has_facets && !samples()) make_curve();
    }

    void make_curve() {
        if (job().y) return;
        Job model = job();
        model.integral = Integral::exact;
        struct TooDear {};
        double colours = 0.0;
        const auto after_step = [&] {
            constexpr double per_step = 15.0;
            if (after_step_) after_step_();
            if ((colours += per_step) > effort_.most_curve_colours()) throw TooDear();
        };
        try {
            curve_.emplace(model, share_of_curve * wish_.max_de00, scale_, after_step);
            result_.work += curve_->work();
        } catch (const TooDear&) {
            curve_.reset();  // texels are computed one by one, as far as there is time
        }
    }

    // What the fast integral errs by where the survey did not look.
    double fast_error_at(const std::vector<LutPoint>& points) {
        Job exact = job();
        exact.integral = Integral::exact;
        Sampler truth(exact);
        Sampler approximation(job());
        double error = 0.0;
        for (const LutPoint& point : points) {
            error =
                std::max(error, difference_at(truth.at(point.x, point.y), approximation.at(point.x, point.y), scale_));
        }
        result_.work += truth.work();
        result_.work += approximation.work();
        return error;
    }

    // The error that a scan of a candidate may find. The model is the true integral, so the spectrum's error is in it.
    double limit() const {
        const double bound = (result_.lut.job.y ? of_bound_in_2d : of_bound_in_1d) * wish_.max_de00;
        const ErrorSplit& split = result_.predicted;
        const double rest = bound - (curve_ ? 2.0 * share_of_curve * wish_.max_de00 : 0.0) - split.effects -
                            std::min(split.quadrature, 0.25 * bound);
        if (is_palette() || !adds_spectrum()) return rest;
        // A larger LUT would not help against a mean that is too rough: what it leaves is not taken beyond a half.
        return rest - split.spectrum - std::min(split.spread, 0.5 * bound);
    }

    Trial trial_of(const Job& at_size, const Candidate& candidate, double scale = 0.0) const {
        Job sized = at_size;
        sized.width = candidate.width;
        sized.height = candidate.height;
        const ModelCurve* curve = curve_ && &at_size == &result_.lut.job ? &*curve_ : nullptr;
        return Trial(sized, candidate.format, encoding_, model_samples(), scale, scale_, after_step_, curve);
    }

    void take(const Candidate& candidate) {
        job().width = candidate.width;
        job().height = candidate.height;
        result_.lut.format = candidate.format;
    }

    void take(const Candidate& candidate, const Trial& trial, Scan scan) {
        take(candidate);
        result_.predicted.total = scan.largest + (adds_spectrum() ? result_.predicted.spectrum : 0.0);
        result_.predicted.total += result_.predicted.spread + result_.predicted.quadrature + result_.predicted.effects;
        result_.worst = std::move(scan.worst);
        storage_error_ = trial.storage_error();
    }

    // Where other candidates failed, the last first.
    void remember(LutPoint point) {
        seeds_.insert(seeds_.begin(), point);
        if (seeds_.size() > most_seeds) seeds_.pop_back();
    }

    // What is worth trying with the integral as it is.
    void list_candidates() {
        const bool is_2d = job().y.has_value();
        const int narrowest = is_2d && !wish_.width ? smallest_side(true) : 2;
        const int lowest = is_2d && !wish_.height ? smallest_side(false) : 2;
        const std::int64_t most = effort_.most_texels();
        candidates_ = candidates_from(wish_, is_2d, narrowest, lowest, 0, most);
        is_hopeless_ = candidates_.empty() || is_tired();
        if (!is_hopeless_) return;
        if (is_tired()) {
            candidates_ = candidates_from(wish_, is_2d, 2, 2, 1 << 11, 1 << 13);
            return;
        }
        // Not even the least is little enough: one of the large ones, whatever its shape, is the best there is.
        candidates_ = candidates_from(wish_, is_2d, 2, 2, most / 4, most);
    }

    // The least size of one side that fits along slices through a 2D LUT: what the other side cannot help.
    int smallest_side(bool is_x) {
        int smallest = 2;
        for (const double at : slices) {
            Job slice = job();
            slice.material.mechanism = is_x ? mechanism_at(job(), 0.0, at) : mechanism_at(job(), at, 0.0);
            slice.fixed = is_x ? geometry_at(job(), 0.0, at) : geometry_at(job(), at, 0.0);
            if (!is_x) slice.x = *job().y;
            slice.y.reset();
            smallest = smallest_1d(slice, smallest);
        }
        return smallest;
    }

    int smallest_1d(const Job& slice, int from) {
        std::vector<LutPoint> failed;
        for (int size = from; size < largest_lut_size && !is_tired(); size *= 2) {
            Trial trial = trial_of(slice, {size, 1, PixelFormat::single_float}, scale_);
            const Scan scan = scan_errors(trial, limit(), failed);
            result_.work += trial.work();
            if (scan.is_complete) return size;
            failed.insert(failed.begin(), scan.at);
        }
        return largest_lut_size;
    }

    bool find_smallest() {
        if (is_hopeless_) return false;
        const bool judges = wish_.has_bound || candidates_.size() > 1;
        for (const Candidate& candidate : candidates_) {
            if (is_tired()) return false;
            Trial trial = trial_of(job(), candidate);
            Scan scan = scan_errors(trial, judges ? limit() : std::numeric_limits<double>::infinity(), seeds_);
            result_.work += trial.work();
            if (scan.is_complete) {
                const bool fits = scan.largest <= limit();
                take(candidate, trial, std::move(scan));
                // The mean of an irregular stack may be too rough for any LUT.
                result_.is_reached = fits && (!adds_means() || result_.predicted.total <= wish_.max_de00);
                return true;
            }
            remember(scan.at);
        }
        return false;
    }

    // A larger one takes seconds, which is too long for an answer that nobody wanted.
    bool is_quickly_judged(const Candidate& candidate) const {
        constexpr std::int64_t most_texels = 1 << 20;
        constexpr std::int64_t most_texels_when_tired = 1 << 13;
        return candidate.texels() <= (is_tired() ? most_texels_when_tired : most_texels);
    }

    bool is_tired() const { return effort_.is_spent(result_.work); }

    // The least error there is; of sizes that are equally good to 5 % the smallest.
    void find_best() {
        result_.is_reached = false;
        std::optional<double> least;
        const bool any_is_small = std::any_of(candidates_.begin(), candidates_.end(),
                                              [&](const Candidate& candidate) { return is_quickly_judged(candidate); });
        // Where there is no time for all, long and narrow ones are the first to go without.
        std::vector<Candidate> best_first(candidates_.rbegin(), candidates_.rend());
        if (is_tired() && job().y) {
            const auto squareness = [](const Candidate& candidate) {
                return -std::abs(std::log2(candidate.width) - std::log2(candidate.height) - 1.0);
            };
            std::stable_sort(best_first.begin(), best_first.end(), [&](const Candidate& left, const Candidate& right) {
                return squareness(left) > squareness(right);
            });
        }
        for (const Candidate& candidate : best_first) {
            if (any_is_small && !is_quickly_judged(candidate)) continue;
            const bool is_of_size_taken = candidate.width == job().width && candidate.height == job().height;
            if (least && effort_.is_far_beyond(result_.work) && !is_of_size_taken) break;
            Trial trial = trial_of(job(), candidate);
            const double enough = least ? 1.05 * *least : std::numeric_limits<double>::infinity();
            Scan scan =
                scan_errors(trial, enough, least ? std::span<const LutPoint>(seeds_) : std::span<const LutPoint>{});
            result_.work += trial.work();
            if (!scan.is_complete) {
                remember(scan.at);
                continue;
            }
            least = std::min(least.value_or(scan.largest), scan.largest);
            take(candidate, trial, std::move(scan));
        }
        // What is left for texels may be so little that no candidate was taken as good, and the sum still fits.
        const double bound = (job().y ? of_bound_in_2d : of_bound_in_1d) * wish_.max_de00;
        result_.is_reached = least && result_.predicted.total <= bound;
    }

    void name_sources() {
        ErrorSplit& split = result_.predicted;
        split.storage = storage_error_;
        Trial trial = trial_of(job(), {job().width, job().height, result_.lut.format});
        std::vector<LutPoint> points = cell_middles();
        points.insert(points.end(), result_.worst.begin(), result_.worst.end());
        for (const double error : trial.unrounded_errors_at(points))
            split.interpolation = std::max(split.interpolation, error);
        result_.work += trial.work();
        if (result_.is_reached) return;
        const auto most = job().y ? effort_.most_texels() : std::int64_t{largest_lut_size};
        result_.obstacle = obstacle(result_, {lost_by_space(), is_tired(), static_cast<int>(most)});
    }

    // Where a linear filter errs most if the curve is smooth; of large LUTs every n-th.
    std::vector<LutPoint> cell_middles() {
        constexpr int most_per_side = 64;
        const int columns = job().width - 1;
        const int rows = std::max(job().height - 1, 1);
        const int column_step = job().y ? (columns + most_per_side - 1) / most_per_side : 1;
        const int row_step = (rows + most_per_side - 1) / most_per_side;
        std::vector<LutPoint> points;
        for (int row = 0; row < rows; row += row_step) {
            for (int column = 0; column < columns; column += column_step)
                points.push_back({(column + 0.5) / columns, job().y ? (row + 0.5) / rows : 0.0});
        }
        return points;
    }

    // What becomes of colours that the space cannot hold, where no gamut rule takes care of them.
    double lost_by_space() {
        if (!encoding_.keeps_colours) return 0.0;
        Job sample = job();
        sample.width = survey_columns;
        sample.height = sample.y ? survey_rows : 1;
        const Image<Xyz> meant = bake(sample, after_step_, &result_.work);
        const Image<Xyz> held = encoding_.to_xyz(encoding_.to_rgb(meant));
        double lost = 0.0;
        for (std::size_t i = 0; i < meant.size(); ++i)
            lost = std::max(lost, difference_at(meant.data()[i], held.data()[i], scale_));
        return lost;
    }

    const Encoding& encoding_;
    const AfterRow& after_step_;
    const AccuracyWish wish_;
    SettledLut result_;
    double scale_ = 1.0;
    double storage_error_ = 0.0;
    std::optional<ModelCurve> curve_;  // of what is dear, in 1D
    Effort effort_;
    std::vector<Candidate> candidates_;
    bool is_hopeless_ = false;  // no candidate can keep the bound
    std::vector<LutPoint> seeds_;
};

}  // namespace

SettledLut settle(const PlannedLut& lut, const Encoding& encoding, const AfterRow& after_step) {
    return Settler(lut, encoding, after_step).settle();
}

}  // namespace nacre
