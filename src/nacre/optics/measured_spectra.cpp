#include "nacre/optics/measured_spectra.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace nacre {
namespace {

// Where a number lies among ascending ones.
struct Place {
    std::size_t left;
    double t;  // from left to left + 1, in [0, 1); 0 at the last and beyond either end
};

Place place_of(double at, const std::vector<double>& nodes) {
    if (!(at > nodes.front())) return {0, 0.0};
    if (at >= nodes.back()) return {nodes.size() - 1, 0.0};
    const auto left = static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), at) - nodes.begin()) - 1;
    return {left, (at - nodes[left]) / (nodes[left + 1] - nodes[left])};
}

// The slope at a node between two intervals: Brodlie's harmonic mean of theirs (Fritsch & Butland 1984, SIAM J. Sci.
// Stat. Comput. 5, 300-304, equation 5), each interval weighted by a third to two thirds, the shorter one more.
double monotone_slope(double left_width, double left_slope, double right_width, double right_slope) {
    if (!(left_slope > 0.0 && right_slope > 0.0) && !(left_slope < 0.0 && right_slope < 0.0)) return 0.0;
    const double left_weight = (left_width + 2.0 * right_width) / (3.0 * (left_width + right_width));
    return 1.0 / (left_weight / left_slope + (1.0 - left_weight) / right_slope);
}

// At an end: of the parabola through three nodes, no steeper than monotone cubics may be, and not backwards.
// @param width, slope  of the interval at the end; next_*  of the one behind it
double end_slope(double width, double slope, double next_width, double next_slope) {
    const double parabola = slope + width * (slope - next_slope) / (width + next_width);
    const double steepest = 3.0 * slope;
    return slope > 0.0 ? std::clamp(parabola, 0.0, steepest) : std::clamp(parabola, steepest, 0.0);
}

// Per node. @param at(i)  value of node i
template <class At>
std::vector<double> slopes(const std::vector<double>& nodes, const At& at) {
    const std::size_t last = nodes.size() - 1;
    std::vector<double> slope(nodes.size(), 0.0);
    if (last == 0) return slope;
    std::vector<double> width, secant;
    for (std::size_t i = 0; i < last; ++i) {
        width.push_back(nodes[i + 1] - nodes[i]);
        secant.push_back((at(i + 1) - at(i)) / width[i]);
    }
    if (last == 1) return {secant[0], secant[0]};
    slope[0] = end_slope(width[0], secant[0], width[1], secant[1]);
    for (std::size_t i = 1; i < last; ++i) slope[i] = monotone_slope(width[i - 1], secant[i - 1], width[i], secant[i]);
    slope[last] = end_slope(width[last - 1], secant[last - 1], width[last - 2], secant[last - 2]);
    return slope;
}

}  // namespace

MeasuredCurve::MeasuredCurve(const MeasuredSpectra& spectra)
    : angle_deg_(spectra.angle_deg), value_(spectra.reflectance), slope_(spectra.reflectance.size()) {
    const std::size_t wavelengths = spectra.wavelength_nm.size();
    assert(!angle_deg_.empty() && value_.size() == angle_deg_.size() * wavelengths);
    for (std::size_t i = 0; i < wavelengths; ++i) {
        const std::vector<double> column =
            slopes(angle_deg_, [&](std::size_t angle) { return value_[angle * wavelengths + i]; });
        for (std::size_t angle = 0; angle < column.size(); ++angle) slope_[angle * wavelengths + i] = column[angle];
        // A surface looks alike from either side of its normal.
        if (angle_deg_.front() == 0.0) slope_[i] = 0.0;
    }
}

void MeasuredCurve::at(double theta_deg, std::vector<double>& out) const {
    const std::size_t wavelengths = value_.size() / angle_deg_.size();
    const auto [angle, t] = place_of(theta_deg, angle_deg_);
    const double* left = value_.data() + angle * wavelengths;
    if (t == 0.0) {
        out.assign(left, left + wavelengths);
        return;
    }
    const double* right = left + wavelengths;
    const double* left_slope = slope_.data() + angle * wavelengths;
    const double* right_slope = left_slope + wavelengths;
    const double width_deg = angle_deg_[angle + 1] - angle_deg_[angle];
    const double u = 1.0 - t;
    out.resize(wavelengths);
    for (std::size_t i = 0; i < wavelengths; ++i) {
        // Hermite's cubic, as a Bézier curve's mean of four points that lie between the two values.
        const double third_deg = width_deg / 3.0;
        const double first = left[i] + third_deg * left_slope[i];
        const double second = right[i] - third_deg * right_slope[i];
        const double cubic = u * u * (u * left[i] + 3.0 * t * first) + t * t * (3.0 * u * second + t * right[i]);
        const auto [least, most] = std::minmax(left[i], right[i]);
        out[i] = std::clamp(cubic, least, most);  // a rounding beyond, where it is flat
    }
}

double measured_reflectance(const MeasuredSpectra& spectra, double theta_deg, double wavelength_nm) {
    const auto [first, t] = place_of(wavelength_nm, spectra.wavelength_nm);
    const std::size_t last = t == 0.0 ? first : first + 1;
    MeasuredSpectra around{{}, {}, spectra.angle_deg, {}};
    for (std::size_t i = first; i <= last; ++i) around.wavelength_nm.push_back(spectra.wavelength_nm[i]);
    for (std::size_t angle = 0; angle < spectra.angle_deg.size(); ++angle) {
        for (std::size_t i = first; i <= last; ++i)
            around.reflectance.push_back(spectra.reflectance[angle * spectra.wavelength_nm.size() + i]);
    }
    std::vector<double> value;
    MeasuredCurve(around).at(theta_deg, value);
    return (1.0 - t) * value.front() + t * value.back();
}

}  // namespace nacre
