#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/refractive_index.h"
#include "nacre/pick/tolerance.h"

namespace nacre {

struct Light;

/// The distribution of the values of a free number over its range.
enum class FreeScale {
    even,   ///< by difference
    ratio,  ///< by ratio; the range is above 0
    whole,  ///< whole numbers, by ratio; the range begins at 1 or above
};

/// A number of a mechanism that the search finds.
struct FreeNumber {
    std::string name;  ///< the key of the scene: "thickness_nm"
    double low = 0.0;
    double high = 1.0;  ///< >= low
    FreeScale scale = FreeScale::even;
    std::function<void(Mechanism&, double)> set;
    std::function<void(Mechanism&, const Index&)> set_index{};  ///< of an index: set to the index of a material
    bool is_thickness = false;                                  ///< of a layer, in nm

    /// The number at a place of the range, u in [0, 1].
    double at(double u) const;
    /// The other way. @pre value is in the range
    double place_of(double value) const;
};

/// A colour that a mechanism should show.
struct WantedColour {
    Geometry geometry;
    Xyz colour;           ///< relative to D65, Y = 1 for the perfect reflector
    double weight = 1.0;  ///< >= 0; of the square of its difference
};

/// Free numbers, by their indices, that are exchanged together with two parts of a mechanism: the films and the gaps of
/// a stack.
using FreeExchange = std::vector<std::pair<std::size_t, std::size_t>>;

/// A search for the free numbers of a mechanism.
struct MechanismSearch {
    Mechanism start;  ///< with all fixed numbers; free numbers may have any value
    std::vector<FreeNumber> free;
    std::vector<WantedColour> wanted;
    std::vector<FreeExchange> exchanges{};  ///< to try
    double tolerance_nm = 0.0;              ///< standard deviation of free thicknesses as they are made; 0: unknown
};

/// A shipped material that is near to a free index.
struct NearMaterial {
    std::string key;        ///< of the free number: "index"
    std::string material;   ///< "water"
    double distance = 0.0;  ///< root of the mean square of the difference, over the visible; absorption counts too
};

/// An answer.
struct FoundMechanism {
    Mechanism mechanism;
    std::vector<double> values;  ///< of the free numbers
    std::vector<Xyz> reached;    ///< per wanted colour, relative to D65
    std::vector<double> de00;    ///< CIEDE2000 between the two
    double error = 0.0;          ///< root of the weighted mean of its squares

    std::vector<NearMaterial> near;    ///< per free index
    std::optional<double> near_error;  ///< `error` with those materials, after all other numbers were found again

    std::optional<Tolerance> tolerance;  ///< where the search has a `tolerance_nm`
};

/// The search for a material of the scene, and its answers, best first.
struct MaterialSearch {
    std::string material;
    MechanismSearch search;
    std::vector<FoundMechanism> found;
};

/// "index = 1.33, thickness_nm = 402.1, substrate = 4 (end of its range)"
std::string found_text(const MechanismSearch& search, const FoundMechanism& found);

}  // namespace nacre
