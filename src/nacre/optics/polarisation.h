#pragma once

namespace nacre {

/// Of which light a reflectance is: unpolarised, with the electric field across the plane of incidence (or scattering),
/// or in it.
enum class Polarisation { mean, s, p };

}  // namespace nacre
