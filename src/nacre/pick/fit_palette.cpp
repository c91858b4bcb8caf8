#include "nacre/pick/fit_palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/optics/incidence.h"
#include "nacre/shade/measured_colour.h"
#include "nacre/shade/palette_colour.h"

namespace nacre {
namespace {

constexpr double first_seen_nm = 380.0;
constexpr double last_seen_nm = 780.0;
// Peaks count where spectra have them: a peak that far off is as bad as CIEDE2000 1.
constexpr double nm_per_de00 = 10.0;

struct Range {
    double low;
    double high;
    double at(double angle) const { return std::lerp(low, high, std::sin(angle) * std::sin(angle)); }
    double angle_of(double value) const {
        const double place = std::clamp((value - low) / (high - low), 1e-3, 1.0 - 1e-3);
        return std::asin(std::sqrt(place));
    }
};
constexpr Range peak_range{300.0, 850.0};
constexpr Range width_range{1.0, 1000.0};
constexpr Range height_range{0.0, 1.0};
constexpr Range shape_range{0.0, 1.0};
constexpr std::size_t numbers_per_pick = 3;

// Measured angles, evenly spread in Y(theta) between the first and the last.
std::vector<std::size_t> spread_angles(const std::vector<double>& angles_deg, std::size_t count) {
    const auto y_of = [](double angle_deg) {
        return shape_difference(Palette::default_shape, Incidence::from_degrees(angle_deg), Incidence());
    };
    const double first = y_of(angles_deg.front());
    const double last = y_of(angles_deg.back());
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted =
            count == 1 ? first : std::lerp(first, last, static_cast<double>(i) / (static_cast<double>(count) - 1.0));
        // As many have to be left for those that follow.
        std::size_t best = chosen.empty() ? 0 : chosen.back() + 1;
        for (std::size_t angle = best; angle + (count - i) <= angles_deg.size(); ++angle) {
            if (std::abs(y_of(angles_deg[angle]) - wanted) < std::abs(y_of(angles_deg[best]) - wanted)) best = angle;
        }
        chosen.push_back(best);
    }
    return chosen;
}

class PaletteFitter {
public:
    PaletteFitter(const MeasuredSpectra& spectra, std::size_t picks, const Light& light)
        : spectra_(spectra), light_(light) {
        const MeasuredColour colour(spectra, light);
        for (std::size_t angle = 0; angle < spectra.angle_deg.size(); ++angle) {
            places_.push_back(Incidence::from_degrees(spectra.angle_deg[angle]));
            colours_.push_back(adapt(light.adaptation, colour.at(places_.back())));
            labs_.push_back(to_lab(colours_.back(), d65_white));
            peaks_nm_.push_back(measured_peak_nm(spectra, angle));
        }
        start(picks);
    }

    PaletteFit fit(const LeastSquaresSolver& solve) {
        LeastSquares problem;
        problem.parameters = static_cast<int>(parameters().size());
        problem.residuals = static_cast<int>(residuals_per_angle * places_.size());
        problem.evaluate = [&](std::span<const double> parameters, std::span<double> residuals) {
            take(parameters);
            fill(residuals);
        };
        std::vector<double> best = parameters();
        constexpr int steps = 100;
        solve(problem, best, steps);
        take(best);
        return judged();
    }

private:
    static constexpr std::size_t residuals_per_angle = 4;

    // The half cosine that has the spectrum's peak and its area.
    Lobe band_of(std::size_t angle) const {
        const auto& nm = spectra_.wavelength_nm;
        const double* values = &spectra_.reflectance[angle * nm.size()];
        double area = 0.0;
        double height = 0.0;
        for (std::size_t i = 0; i + 1 < nm.size(); ++i) {
            area += 0.5 * (values[i] + values[i + 1]) * (nm[i + 1] - nm[i]);
            height = std::max(height, values[i]);
        }
        constexpr double black = 1e-6;
        const double width_nm = 0.5 * std::numbers::pi * area / std::max(height, black);
        return {peaks_nm_[angle], std::clamp(width_nm, width_range.low, width_range.high), std::min(height, 1.0)};
    }

    void start(std::size_t picks) {
        for (const std::size_t angle : spread_angles(spectra_.angle_deg, picks))
            palette_.picks.push_back({spectra_.angle_deg[angle], band_of(angle)});
        fits_shape_ = places_.size() > picks && picks > 1;
    }

    std::vector<double> parameters() const {
        std::vector<double> angles;
        for (const Pick& pick : palette_.picks) {
            angles.push_back(peak_range.angle_of(pick.lobe.peak_nm));
            angles.push_back(width_range.angle_of(pick.lobe.width_nm));
            angles.push_back(height_range.angle_of(pick.lobe.height));
        }
        if (fits_shape_) angles.push_back(shape_range.angle_of(palette_.shape));
        return angles;
    }

    void take(std::span<const double> parameters) {
        for (std::size_t i = 0; i < palette_.picks.size(); ++i) {
            const double* numbers = &parameters[numbers_per_pick * i];
            palette_.picks[i].lobe = {peak_range.at(numbers[0]), width_range.at(numbers[1]),
                                      height_range.at(numbers[2])};
        }
        if (fits_shape_) palette_.shape = shape_range.at(parameters.back());
    }

    Lab shown(const Lobe& lobe) const { return to_lab(adapt(light_.adaptation, lobe_to_xyz(light_, lobe)), d65_white); }

    // Where the spectrum is nearly black, its peak is noise.
    double peak_weight(std::size_t angle) const { return std::min(1.0, labs_[angle].l / 20.0) / nm_per_de00; }

    void fill(std::span<double> residuals) const {
        const PaletteCurve curve(palette_);
        for (std::size_t angle = 0; angle < places_.size(); ++angle) {
            const Lobe lobe = curve.at(places_[angle]);
            const auto parts = ciede2000_parts(labs_[angle], shown(lobe));
            std::copy(parts.begin(), parts.end(), &residuals[residuals_per_angle * angle]);
            residuals[residuals_per_angle * angle + 3] = peak_weight(angle) * (lobe.peak_nm - peaks_nm_[angle]);
        }
    }

    PaletteFit judged() const {
        PaletteFit fit;
        fit.palette = palette_;
        const PaletteCurve curve(palette_);
        double sum = 0.0;
        for (std::size_t angle = 0; angle < places_.size(); ++angle) {
            const Lobe lobe = curve.at(places_[angle]);
            const double de00 = ciede2000(labs_[angle], shown(lobe));
            fit.angles.push_back({spectra_.angle_deg[angle], peaks_nm_[angle], lobe.peak_nm, de00});
            sum += de00 * de00;
        }
        fit.error = std::sqrt(sum / static_cast<double>(places_.size()));
        return fit;
    }

    const MeasuredSpectra& spectra_;
    const Light& light_;
    std::vector<Incidence> places_;
    std::vector<Xyz> colours_;
    std::vector<Lab> labs_;
    std::vector<double> peaks_nm_;
    Palette palette_;
    bool fits_shape_ = false;
};

}  // namespace

double measured_peak_nm(const MeasuredSpectra& spectra, std::size_t angle) {
    const auto& nm = spectra.wavelength_nm;
    const double* values = &spectra.reflectance[angle * nm.size()];
    std::size_t highest = 0;
    bool any = false;
    for (std::size_t i = 0; i < nm.size(); ++i) {
        if (nm[i] < first_seen_nm || nm[i] > last_seen_nm) continue;
        if (!any || values[i] > values[highest]) highest = i;
        any = true;
    }
    if (highest == 0 || highest + 1 == nm.size()) return nm[highest];
    // The parabola through three points, wherever they stand.
    const double left = nm[highest] - nm[highest - 1];
    const double right = nm[highest + 1] - nm[highest];
    const double rise = (values[highest] - values[highest - 1]) / left;
    const double fall = (values[highest + 1] - values[highest]) / right;
    if (!(rise - fall > 0.0)) return nm[highest];
    const double slope = (rise * right + fall * left) / (left + right);
    const double bend = (fall - rise) / (left + right);
    return std::clamp(nm[highest] - 0.5 * slope / bend, nm[highest - 1], nm[highest + 1]);
}

PaletteFit fit_palette(const MeasuredSpectra& spectra, std::size_t picks, const Light& light,
                       const LeastSquaresSolver& solve) {
    return PaletteFitter(spectra, picks, light).fit(solve);
}

}  // namespace nacre
