#pragma once

#include <string>
#include <vector>

namespace nacre {

/// Measured reflectance: spectra at some angles.
struct MeasuredSpectra {
    std::string file;                   ///< where it came from, as the scene names it; not part of what it is
    std::vector<double> wavelength_nm;  ///< ascending, >= 2
    std::vector<double> angle_deg;      ///< ascending, >= 1, in [0, 90]
    std::vector<double> reflectance;    ///< [angle * wavelengths + wavelength], >= 0

    friend bool operator==(const MeasuredSpectra&, const MeasuredSpectra&) = default;
};

/// Spectra at any angle: monotone cubic interpolation (Fritsch and Carlson 1980; Fritsch and Butland 1984) from angle
/// to angle at each wavelength, so that nothing overshoots what was measured; level at the normal, if that was
/// measured, for a surface looks alike from either side of it; beyond the first and last angle theirs are held.
class MeasuredCurve {
public:
    explicit MeasuredCurve(const MeasuredSpectra& spectra);

    /// Per wavelength of the spectra. @param out  as many as there are
    void at(double theta_deg, std::vector<double>& out) const;

private:
    std::vector<double> angle_deg_;
    std::vector<double> value_;  // as MeasuredSpectra::reflectance
    std::vector<double> slope_;  // per value, 1 / degree
};

/// Reflectance at one wavelength, straight between those measured and held beyond them.
double measured_reflectance(const MeasuredSpectra& spectra, double theta_deg, double wavelength_nm);

}  // namespace nacre
