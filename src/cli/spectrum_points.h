#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// Which rows a command line asks `nacre spectrum` for.
struct SpectrumRequest {
    std::vector<std::string> materials;  ///< empty: all of the scene
    std::vector<std::string> angles;     ///< numbers and ranges, in degrees
    std::vector<std::string> grating_us;
    std::string points;                ///< a CSV file instead; empty: none
    bool wants_colour = false;         ///< rows have no wavelength
    bool wants_transmittance = false;  ///< of layers without a base, the only ones that let light through
};

/// A material at a geometry, and at a wavelength if a file of points asks for one.
struct SpectrumPoint {
    const Material* material = nullptr;
    Geometry geometry;
    double wavelength_nm = 0.0;
    std::vector<std::optional<double>> parameters;  ///< of SpectrumTable::parameters; nothing: as in the scene
    std::vector<std::string> texts;                 ///< of the columns: the user's own, so that he can join tables
};

struct SpectrumTable {
    std::vector<std::string> columns;     ///< "material" first
    std::vector<std::string> parameters;  ///< those of them that are numbers of a material
    std::vector<SpectrumPoint> points;
};

/// All rows, checked.
/// @param plan  has all materials and outlives the table
/// @throws Error for the first row that means nothing
SpectrumTable spectrum_table(const Plan& plan, const SpectrumRequest& request);

/// The mechanism of a row. @param changed  keeps it, if it is not the material's own
const Mechanism& mechanism_of(const SpectrumTable& table, const SpectrumPoint& point, Mechanism& changed);

}  // namespace nacre
