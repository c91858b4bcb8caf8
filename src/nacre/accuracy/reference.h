#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "nacre/base/gauss_points.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/xyz_curve.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

/// What a bake is checked against: the true colour of a job at one point, by an independent method.
///
/// Reflectances at even steps of wavelength, twice as many until the colour of every second one agrees, straight into
/// the integral of light and colour matching functions as their tables have them (of a lamp with fine lines between its
/// own nodes). It shares a mechanism's formulas with the bake, but nothing of how spectra become XYZ: no closed form,
/// no moments, no nodes, no grid. Every effect of the scene is there, whatever the bake leaves out. Layers are solved
/// by the bake's fast solver at these other wavelengths, which the scalar one has to confirm (ConfirmedLayers); uneven
/// ones have the bake's samples, whose number is part of the model. Where a grating's lines are many, they are walked
/// through wave by wave. A base's directions and a surface's facets are summed in other variables.
class Reference {
public:
    /// @param job  has to outlive the reference
    /// @param tolerance_de00  CIEDE2000 by which each sum of a colour may err, shown as bright as white: half as many
    /// points may change it by twice as much
    explicit Reference(const Job& job, double tolerance_de00 = 1e-3);

    /// XYZ relative to D65, Y = 1 for the perfect reflector. `wavelengths` of the scene do not count: the truth has no
    /// nodes. Not to be asked by two threads at once: what the last material took is kept.
    /// Accuracy: 1e-9 for bands of 4 nm and more, 1e-7 for narrower ones; of measurements 1e-12; of the rest CIEDE2000
    /// 2 * tolerance_de00, shown as bright as white.
    Xyz at(double x, double y = 0.0) const;

private:
    /// Wavelengths at even steps, and what turns the values of a spectrum there into XYZ.
    struct Samples {
        std::vector<double> nm;
        std::vector<double> added;  // those that half as many cells lack
        std::vector<Xyz> weights;
    };
    /// @param nm  those of the fewest cells, or those that a number of cells adds: each number of them always means the
    /// same ones
    using Spectrum = std::function<std::vector<double>(const std::vector<double>& nm)>;
    struct Layers;
    struct Lines;
    struct Scattering;

    Xyz flat(const Mechanism& mechanism, const Geometry& geometry) const;
    Xyz mean_of_facets(const Mechanism& mechanism, const Incidence& incidence) const;
    Xyz tilted(double tilt_deg, const XyzCurve& facet, const Incidence& incidence) const;
    Xyz rough(double roughness, const XyzCurve& facet, const Incidence& incidence) const;
    Xyz band(const Lobe& lobe) const;
    Xyz layered(const Mechanism& mechanism, const Incidence& incidence) const;
    std::vector<double> base_factors(const Base& base, const LayerEnsemble& layers) const;
    Xyz lines(const Grating& grating, double u) const;
    Xyz wave_by_wave(const Grating& grating, const std::vector<int>& orders, double u) const;
    Xyz scattered(const Mechanism& mechanism, double cos_scatter) const;
    void weigh(const std::vector<double>& measured_nm) const;
    Xyz measured(const MeasuredSpectra& spectra, const Incidence& incidence) const;

    /// At twice as many wavelengths until the colour of half of them agrees. Each is asked for once.
    /// @param begin  with so many cells, if steps are to be shorter; receives where to begin the next time
    /// @param most_cells  eight per fringe of the thickest layers that a scene may have
    /// @param taken  receives the values of the spectrum; null: nobody asks
    Xyz integral(double longest_step_nm, int& begin, const Spectrum& spectrum, int most_cells = 1 << 18,
                 std::vector<double>* taken = nullptr) const;
    std::vector<double> values_at(int cells, int fewest, const Spectrum& spectrum) const;
    const Samples& samples(int cells) const;
    /// What half as many points change, over what they may.
    double doubt(const Xyz& of_all, const Xyz& of_half) const;
    Xyz weight_at(double nm) const;
    double next_kink(double nm) const;

    const Job& job_;
    double tolerance_de00_;
    std::vector<GaussPoint> rule_;  // exact up to the fifth degree
    std::vector<Xyz> weights_;      // per whole nanometre; of a lamp with fine lines without its power
    std::vector<double> kinks_nm_;  // ascending: between them the weights are smooth
    bool has_fine_lines_;
    glm::dmat3 adaptation_;
    mutable std::map<int, Samples> samples_;  // by the number of cells
    mutable Samples measured_;                // of the last spectra's wavelengths

    // Of the last material, kept for the next angle.
    mutable std::optional<std::pair<Mechanism, XyzCurve>> facets_;
    mutable std::shared_ptr<Layers> layers_;
    mutable std::shared_ptr<Lines> lines_;
    mutable std::shared_ptr<Scattering> scattering_;
};

}  // namespace nacre
