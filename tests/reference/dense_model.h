#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/weights.h"

namespace nacre::reference {

/// One palette choice, as a scene says it.
struct ModelPick {
    double angle_deg = 0.0, peak_nm = 0.0, width_nm = 0.0, height = 0.0;
};

enum class ModelAxis { sqrt_cos_theta, cos_theta, theta_deg };

/// The second axis: `shape`, or `peak_nm`, `width_nm`, `height` of every pick.
struct ModelParameter {
    std::string name;
    double from = 0.0, to = 0.0;
};

/// A LUT of a palette material, typed in and not read from a scene. Light from 360 to 830 nm, Bradford to D65.
struct SceneModel {
    std::string name;
    std::vector<ModelPick> picks;  ///< 2 to 8, in any order, no two at one angle
    double shape = 0.0;
    std::string illuminant = "D65";  ///< a column of illuminants_5nm.csv
    int observer_deg = 2;            ///< 2 or 10
    ModelAxis x = ModelAxis::sqrt_cos_theta;
    std::optional<ModelParameter> y;
};

/// Relative to D65, Y = 1 for the perfect reflector.
struct ModelXyz {
    double x = 0.0, y = 0.0, z = 0.0;
};
/// CIE 1976 L*, a*, b*.
struct ModelLab {
    double l = 0.0, a = 0.0, b = 0.0;
};
/// Linear R, G, B of Rec.709: (1, 1, 1) is D65 at Y = 1. Negative outside its gamut.
using ModelRgb = std::array<double, 3>;

ModelRgb to_rec709(const ModelXyz& colour);
ModelXyz from_rec709(const ModelRgb& rgb);

/// White (0.3127, 0.3290) at Y = 1. The straight part of the curve goes on below 0.
ModelLab lab_of(const ModelXyz& colour);

/// CIEDE2000 with kL = kC = kH = 1: Sharma, Wu, Dalal 2005, Color Res. Appl. 30(1), equations 2 to 22.
double ciede2000(const ModelLab& one, const ModelLab& two);

/// The exact colour of a scene, asked at any coordinate.
///
/// Every nanometre is integrated by Gauss-Legendre, pieces cut at the ends of the lobe.
/// Accuracy: 1e-12 of Y = 1 (the test holds it against twin_xyz()). Speed: about a microsecond.
class DenseModel {
public:
    explicit DenseModel(const SceneModel& scene);

    /// @param x,y  LUT coordinates in [0, 1]; y does not matter without a second axis
    ModelXyz at(double x, double y = 0.0) const;

    const SceneModel& scene() const { return scene_; }

private:
    struct Light;
    static std::shared_ptr<const Light> light_of(const SceneModel& scene);

    SceneModel scene_;
    std::vector<double> pick_cosines_;
    std::shared_ptr<const Light> light_;
};

/// The same colour in 50 digits, with adaptive Gauss-Kronrod quadrature: up to seconds for a wide lobe.
XyzNumbers twin_xyz(const SceneModel& scene, double x, double y = 0.0);

/// A LUT as it is stored, row-major, first row = smallest y.
struct Pixels {
    int width = 0, height = 0;
    std::vector<ModelRgb> rgb;

    const ModelRgb& at(int column, int row) const {
        return rgb[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }
};

enum class StoredAs { half_float, single_float };

/// The nearest half, ties to even; any finite double below 65520.
double as_half(double value);

/// The LUT that the dense model itself would store.
/// @param height  1 without a second axis
Pixels make_lut(const DenseModel& model, int width, int height, StoredAs format);

/// How much of a LUT dense_error() looks at.
struct Density {
    int oversample = 10;  ///< points per cell and axis, the cell's own texel among them
    /// Where it takes more: half of them for texels and middles, the rest for the worst cells. About a microsecond
    /// each.
    std::size_t most_points = std::numeric_limits<std::size_t>::max();
    double enough = std::numeric_limits<double>::infinity();  ///< returns as soon as an error exceeds it
};

/// The largest CIEDE2000 between what a shader fetches from a LUT (linear or bilinear, clamped) and the exact colour,
/// both scaled so that the LUT's brightest texel has Y = 1; a LUT without light is taken as it is.
double dense_error(const Pixels& stored, const DenseModel& model, const Density& density);
double dense_error(const Pixels& stored, const SceneModel& scene, int oversample);

}  // namespace nacre::reference
