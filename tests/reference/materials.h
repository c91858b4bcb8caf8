#pragma once

#include <string>

#include "nacre/optics/layered.h"
#include "nacre/optics/refractive_index.h"
#include "reference/complex.h"

namespace nacre::reference {

/// n + ik of a material that nacre ships, evaluated here from its published formula or table (rows that the light's
/// range needs, linear between them): sio2, mgf2, al2o3, bk7, water, melanin, ag, au, al, cr.
Complex material_index(const std::string& material, double wavelength_nm);

/// The same as an index of a scene, which names the material.
Index named_index(const std::string& material);
bool is_named(const Index& index);
/// The same as a table of every ten nanometres.
Index tabulated_index(const std::string& material);

/// A table of n and k over micrometres that a file of refractiveindex.info holds, from 350 to 850 nm.
Index index_of_file(const std::string& material, const std::string& path);

/// What the model makes of an index of a scene.
/// @throw std::runtime_error  of a formula that it does not know, or outside a table
Complex index_at(const Index& index, double wavelength_nm);

/// Linear between a table's wavelengths. @param holds  whether its ends go on beyond them
double linear_at(const SampledCurve& table, double wavelength_nm, bool holds);

/// The same number, or the same table.
bool same(const Index& one, const Index& other);

/// One layer of a stack.
Layer layer_of(const Index& index, double thickness_nm);
/// So many pairs of layers.
Layer periods_of(int repeat, const Layer& first, const Layer& second);

}  // namespace nacre::reference
