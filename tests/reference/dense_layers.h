#pragma once

#include <complex>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/dense_model.h"

namespace nacre::reference {

/// A refractive index as a scene gives it.
struct ModelIndex {
    std::string material;  ///< one of known_materials(); empty: the constant
    std::complex<double> constant{1.0, 0.0};
};

/// n + ik of a material that nacre ships, evaluated here from its published formula or table (rows that the light's
/// range needs, linear between them).
std::complex<double> material_index(const std::string& material, double wavelength_nm);

struct ModelLayer {
    ModelIndex index;
    double thickness_nm = 0.0;
};

/// Layers in the order in which light meets them, so many times.
struct ModelGroup {
    int repeat = 1;
    bool is_written_as_group = false;  ///< else one layer, written as such
    std::vector<std::size_t> layers;   ///< into LayersModel::layers
};

/// A LUT of a film or a stack, typed in and not read from a scene. Light from 360 to 830 nm, Bradford to D65.
struct LayersModel {
    std::string name;
    bool is_film = false;  ///< one layer, one group
    ModelIndex incident, substrate;
    std::vector<ModelLayer> layers;  ///< the different ones; every one is in exactly one group, once
    std::vector<ModelGroup> groups;
    std::string illuminant = "D65";  ///< a column of illuminants_5nm.csv
    int observer_deg = 2;            ///< 2 or 10
    ModelAxis x = ModelAxis::sqrt_cos_theta;
    std::optional<std::size_t> y_layer;  ///< whose thickness is the second axis
    double y_from_nm = 0.0, y_to_nm = 0.0;

    std::size_t expanded_layers() const;
};

/// The colour of a film or a stack by the textbook: Fresnel's coefficients of every face and all bounces summed from
/// the substrate up (Airy 1833, Rouard 1937), at midpoints of even parts of every nanometre, parts doubled until they
/// change nothing that counts. No line is shared with src/, and no idea either: no fields, no nodes.
class DenseLayers {
public:
    explicit DenseLayers(const LayersModel& model);

    /// @param x,y  LUT coordinates in [0, 1]
    /// @param tolerance  CIEDE2000 by which twice as many wavelengths may still change the colour, at `scale`
    ModelXyz at(double x, double y, double tolerance, double scale) const;

    /// Of unpolarised light, R of s and p averaged.
    double reflectance(double cos_theta, double wavelength_nm, double y = 0.0) const;

    /// Coordinates on x at which some medium begins to reflect totally, at 450, 550 and 650 nm: the colour bends there.
    std::vector<double> critical_coordinates() const;

    /// Faces times wavelengths that a colour takes at least: what points cost.
    double cost() const;

    /// Points at which doubling ended before the tolerance was met.
    std::size_t unsettled() const { return unsettled_; }

private:
    struct Grid;
    struct Light;
    const Grid& grid(int parts) const;
    ModelXyz sum(double cos_theta, double y, int parts) const;
    void set_thicknesses(double y) const;
    double reflectance_of(double cos_theta, double wavelength_nm, const std::complex<double>* indices) const;
    int fewest_parts(double cos_theta) const;

    LayersModel model_;
    std::vector<std::size_t> sequence_;         // layers after all repeats
    std::vector<std::size_t> media_of_layer_;   // of every different layer, into media_
    std::vector<ModelIndex> media_;             // incident, substrate, then the layers'
    mutable std::vector<double> thickness_nm_;  // as the second axis leaves them
    mutable std::map<int, std::shared_ptr<const Grid>> grids_;
    mutable std::size_t unsettled_ = 0;
    std::shared_ptr<const Light> light_;
};

}  // namespace nacre::reference
