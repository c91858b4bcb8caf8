#pragma once

#include "nacre/optics/polarisation.h"

namespace nacre {

/// Reflected and transmitted light at one wavelength, per polarisation: fractions of the incident power, each in [0,
/// 1], and R + T <= 1. The rest is absorbed.
struct Response {
    double reflectance_s = 0.0;
    double reflectance_p = 0.0;
    double transmittance_s = 0.0;  ///< into the substrate: the power that enters it just below the layers
    double transmittance_p = 0.0;

    /// Of unpolarised light.
    double reflectance() const { return 0.5 * (reflectance_s + reflectance_p); }
    double transmittance() const { return 0.5 * (transmittance_s + transmittance_p); }
};

inline void add(Response& sum, double share, const Response& one) {
    sum.reflectance_s += share * one.reflectance_s;
    sum.reflectance_p += share * one.reflectance_p;
    sum.transmittance_s += share * one.transmittance_s;
    sum.transmittance_p += share * one.transmittance_p;
}

/// What of the light is looked at.
enum class Observed { reflectance, transmittance };

inline double reflectance_of(const Response& response, Polarisation polarisation) {
    return polarisation == Polarisation::mean ? response.reflectance()
           : polarisation == Polarisation::s  ? response.reflectance_s
                                              : response.reflectance_p;
}

inline double transmittance_of(const Response& response, Polarisation polarisation) {
    return polarisation == Polarisation::mean ? response.transmittance()
           : polarisation == Polarisation::s  ? response.transmittance_s
                                              : response.transmittance_p;
}

inline double observed_of(const Response& response, Observed observed, Polarisation polarisation) {
    return observed == Observed::reflectance ? reflectance_of(response, polarisation)
                                             : transmittance_of(response, polarisation);
}

}  // namespace nacre
