#pragma once

namespace nacre {

/// What becomes of the light at one wavelength, per polarisation: fractions of the incident power, each in [0, 1],
/// and R + T <= 1. What is missing to 1 is absorbed.
struct Response {
    double reflectance_s = 0.0;
    double reflectance_p = 0.0;
    double transmittance_s = 0.0;  ///< into the substrate
    double transmittance_p = 0.0;

    /// Of unpolarised light.
    double reflectance() const { return 0.5 * (reflectance_s + reflectance_p); }
    double transmittance() const { return 0.5 * (transmittance_s + transmittance_p); }
};

}  // namespace nacre
