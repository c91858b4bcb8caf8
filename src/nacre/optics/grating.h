#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nacre/optics/refractive_index.h"

namespace nacre {

/// The shape of a ruled surface over one period, which says how much light goes into each order.
enum class GratingProfile { given, lamellar, sinusoidal };

/// A ruled reflection grating: d (sin theta_i + sin theta_o) = m wavelength, of a finite number of coherent grooves.
struct Grating {
    double period_nm = 1600.0;  ///< d, > 0
    int grooves = 100;          ///< N, that light meets in phase, >= 1
    GratingProfile profile = GratingProfile::lamellar;
    double depth_nm = 0.0;           ///< of a profile that is not given, from top to bottom, >= 0
    double land = 0.5;               ///< of lamellar: the share of the period that is up, in [0, 1]
    std::vector<double> efficiency;  ///< of given: fraction of the light that goes into order +m, and as much into -m,
                                     ///< m = 1, 2, ...; each >= 0, their sum is at most 1/2; order 0 has the rest
    std::optional<Index> coat;       ///< metal on it, whose reflectance at normal incidence counts; none: 1
    std::vector<int> orders;         ///< |m| that count, ascending, each once; empty: all from 1 on that can be seen
    double groove_length_um = 0.0;   ///< l, over which a groove is straight; 0: endless
    double azimuth_deg =
        0.0;  ///< of the plane in which light comes and goes, from the plane across the grooves, in [0, 90]

    friend bool operator==(const Grating&, const Grating&) = default;
};

/// The largest |m| that can be seen anywhere (|sin theta_i + sin theta_o| <= 2, in the plane across the grooves) at
/// wavelengths from `least_nm` on; 0: none.
/// @pre least_nm > 0, and 2 period / least_nm is below 2^31
int largest_visible_order(const Grating& grating, double least_nm);

/// The |m| that count for wavelengths from `least_nm` on: those asked for, or all from 1, that can be seen (0 always
/// can). Ascending.
std::vector<int> counted_orders(const Grating& grating, double least_nm);

/// Fraction of the light that goes into order `order` (that sign alone; +m and -m are alike), coat included, in [0, 1].
///
/// Scalar theory at near-normal light: lamellar 4 sin^2(phi / 2) (sin(pi m D) / (pi m))^2 with phi = 4 pi depth /
/// wavelength and D the land's share (m = 0: 1 - 4 D (1 - D) sin^2(phi / 2)); sinusoidal J_m(phi / 2)^2. Over all
/// orders, evanescent ones too, either sums to 1.
/// Source: Goodman, Introduction to Fourier Optics, 3rd ed., section 4.4: the far field is the Fourier series of
/// exp(i phase) over one period.
/// @pre the coat is known at the wavelength
double grating_efficiency(const Grating& grating, int order, double wavelength_nm);

/// The factors of the efficiencies that depend on the order alone, for callers with many wavelengths; empty if every
/// factor depends on both (sinusoidal). @param orders  >= 0
std::vector<double> order_shares(const Grating& grating, std::span<const int> orders);

/// The same for many orders at once, in about the time of the largest.
/// @param orders      ascending, >= 0
/// @param shares      order_shares() of them
/// @param efficiency  as many as orders; receives the fractions
void grating_efficiencies(const Grating& grating, std::span<const int> orders, std::span<const double> shares,
                          double wavelength_nm, std::span<double> efficiency);
void grating_efficiencies(const Grating& grating, std::span<const int> orders, double wavelength_nm,
                          std::span<double> efficiency);

/// Fraction of light that the coat reflects at normal incidence, |(n - 1) / (n + 1)|^2; 1 without one.
double coat_reflectance(const Grating& grating, double wavelength_nm);

/// cos(azimuth), exact at 90 degrees: the share of u that is across the grooves.
double share_across(const Grating& grating);

/// pi (l u sin(azimuth) / wavelength)^2 in [0, infinity]: grooves that are straight over a length l, in a Gaussian
/// manner, send exp(-this) of the light into a plane beside the one across them. Endless ones: 0 in that plane,
/// infinity beside it.
double azimuth_exponent(const Grating& grating, double u, double wavelength_nm);

/// Power per unit of u = |sin theta_i + sin theta_o| at one wavelength, u in [0, 2]: the sum over counted orders m (and
/// -m) of efficiency * N (d / wavelength) sinc^2(N (u cos(azimuth) d / wavelength - m)), sinc(x) = sin(pi x) / (pi x),
/// times exp(-azimuth_exponent()). For equal efficiencies the sum over all orders is the array factor of N grooves.
/// In the plane across the grooves, over all u of both signs, every order integrates to its efficiency.
/// @param orders  counted_orders()
double grating_density(const Grating& grating, const std::vector<int>& orders, double u, double wavelength_nm);

}  // namespace nacre
