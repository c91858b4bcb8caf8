#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/xyz_curve.h"
#include "nacre/material/relief.h"
#include "nacre/optics/incidence.h"
#include "nacre/shade/facet.h"
#include "nacre/shade/roughness.h"

namespace nacre {

/// How finely the mean over facets is taken.
struct FacetPoints {
    int rings = 8;    ///< of tilted ones: angles between facet and surface, per interval
    int spokes = 16;  ///< of tilted ones: directions around, of a half turn
    int intervals =
        8;  ///< of rough ones: of the right angle, in each of which their colour is a polynomial of low degree
};

/// A surface of small mirrors (scales, grains, brush marks): the mean of a colour over their normals.
///
/// A facet's normal is off the surface's by tau with density exp(-tau^2 / (2 tilt^2)) per solid angle, tau < 90
/// degrees; what is seen of it goes with the cosine of the angle at which it is seen; facets that are turned away are
/// not seen. Shadows and light between facets are left out.
///
/// The integral is taken by Gauss-Legendre rules around the surface's normal, over the part of every ring that is
/// visible; the rings are split at the tilt at which parts of them turn away, so that no rule spans a kink.
///
/// @param tilt_deg  > 0
std::vector<Facet> tilted_facets(double tilt_deg, const Incidence& incidence, FacetPoints points = {});

/// The facets of either law. @pre !relief.is_plane()
std::vector<Facet> seen_facets(const Relief& relief, const Incidence& incidence, FacetPoints points = {});

/// The mean of a colour over sqrt(cos(theta)). @param points  what it took is added
Xyz mean_over_facets(const std::vector<Facet>& facets, const XyzCurve& colour, std::uint64_t& points);

/// The same mean at many angles and reliefs, much faster.
///
/// Of a rough surface it is a sum over few facets. Of a tilted one, what is seen times its cosine is a function of
/// direction that only depends on the angle to the eye, 0 behind the facets; the mean is that function blurred on the
/// sphere. Blurring multiplies the coefficients of its Legendre series (Funk and Hecke), and fine detail is gone after
/// a few terms per tilt. Below `least_blurred_deg` there would be too many of them: there facets are summed one by one.
class FacetColours {
public:
    FacetColours() = default;
    explicit FacetColours(XyzCurve colour) : colour_(std::move(colour)) {}
    bool is_made() const { return colour_.is_made(); }
    const XyzCurve& colour() const { return colour_; }

    /// @param points  terms and points that it took are added
    /// @pre !relief.is_plane()
    Xyz mean(const Relief& relief, const Incidence& incidence, std::uint64_t& points);

    static constexpr double least_blurred_deg = 0.3;

private:
    using Term = std::array<double, 4>;  // of X, Y, Z and of the facets themselves
    Xyz tilted_mean(double tilt_deg, const Incidence& incidence, std::uint64_t& points);
    void prepare_rough();
    void expand(int degree);
    void blur(double tilt_deg);

    XyzCurve colour_;
    RoughFacets rough_facets_;
    XyzCurve short_pieces_;           // the colour in polynomials of low degree, for rough facets
    std::vector<double> angles_rad_;  // between which these are
    std::vector<Term> series_;        // per degree, of colour times cosine
    std::vector<double> kept_after(double tilt, int degree);

    // P_l at Gauss's points between normal and right angles, all points of a degree in a row.
    struct Wide {
        std::vector<double> tau;
        std::vector<double> weight;  // sin(tau) included
        std::vector<double> legendre;
    };
    std::shared_ptr<const Wide> wide_;  // made when a tilt asks for it
    double blurred_deg_ = 0.0;          // the tilt that `blurred_` is for
    std::vector<Term> blurred_;
};

/// A colour over sqrt(cos(theta)), as facets ask for it: to CIEDE2000 `facet_curve_error` at the scale of its
/// brightest.
/// @param kinks_deg  where it bends
XyzCurve facet_curve(const std::function<Xyz(const Incidence&)>& colour, const std::vector<double>& kinks_deg,
                     const std::function<void()>& after_step = {});
inline constexpr double facet_curve_error = 1e-3;

}  // namespace nacre
