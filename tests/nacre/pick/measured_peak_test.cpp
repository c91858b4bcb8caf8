#include <gtest/gtest.h>

#include "nacre/pick/fit_palette.h"

namespace nacre {
namespace {

MeasuredSpectra parabola(double peak_nm, const std::vector<double>& wavelengths_nm) {
    MeasuredSpectra spectra;
    spectra.wavelength_nm = wavelengths_nm;
    spectra.angle_deg = {0.0, 30.0};
    // Of the first angle nothing counts here.
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) spectra.reflectance.push_back(0.5);
    for (const double nm : wavelengths_nm) spectra.reflectance.push_back(0.9 - (nm - peak_nm) * (nm - peak_nm) / 2e5);
    return spectra;
}

TEST(MeasuredPeak, IsTheVertexOfAParabola) {
    std::vector<double> even, uneven;
    for (int nm = 350; nm <= 800; nm += 10) even.push_back(nm);
    for (int i = 0; i < 60; ++i) uneven.push_back(350.0 + 2.0 * i + 0.1 * i * i);
    for (const double peak_nm : {400.0, 453.3, 455.0, 507.1, 633.0, 699.9}) {
        EXPECT_NEAR(measured_peak_nm(parabola(peak_nm, even), 1), peak_nm, 1e-9);
        EXPECT_NEAR(measured_peak_nm(parabola(peak_nm, uneven), 1), peak_nm, 1e-9);
    }
}

TEST(MeasuredPeak, IsLookedForWhereThereIsSight) {
    MeasuredSpectra spectra;
    spectra.angle_deg = {0.0};
    spectra.wavelength_nm = {300, 340, 450, 500, 550, 700, 850, 900};
    spectra.reflectance = {0.9, 0.95, 0.2, 0.3, 0.2, 0.1, 0.8, 0.9};
    EXPECT_NEAR(measured_peak_nm(spectra, 0), 500.0, 1e-9);
}

TEST(MeasuredPeak, IsAnEndWhereTheSpectrumHasIt) {
    MeasuredSpectra spectra;
    spectra.angle_deg = {0.0};
    spectra.wavelength_nm = {400, 500, 600};
    spectra.reflectance = {0.9, 0.5, 0.1};
    EXPECT_EQ(measured_peak_nm(spectra, 0), 400.0);
    spectra.reflectance = {0.1, 0.5, 0.9};
    EXPECT_EQ(measured_peak_nm(spectra, 0), 600.0);
    // Of equal ones the first.
    spectra.reflectance = {0.3, 0.3, 0.3};
    EXPECT_EQ(measured_peak_nm(spectra, 0), 400.0);
}

TEST(MeasuredPeak, StaysInSight) {
    MeasuredSpectra spectra;
    spectra.angle_deg = {0.0};
    // Rising beyond both ends of what is seen.
    spectra.wavelength_nm = {360, 370, 380, 390, 500, 770, 780, 790};
    spectra.reflectance = {0.9, 0.85, 0.8, 0.7, 0.1, 0.2, 0.3, 0.4};
    EXPECT_NEAR(measured_peak_nm(spectra, 0), 380.0, 10.0);
    // Nothing at all between 380 and 780 nm, but on either side.
    spectra.wavelength_nm = {300, 350, 800, 900};
    spectra.reflectance = {0.1, 0.2, 0.5, 0.3};
    const double peak_nm = measured_peak_nm(spectra, 0);
    EXPECT_GE(peak_nm, 300.0);
    EXPECT_LE(peak_nm, 900.0);
}

}  // namespace
}  // namespace nacre
