#pragma once

namespace nacre {

/// The ratio of the scattering of equal hard spheres that keep a distance to that of spheres far from each other, > 0:
/// the structure factor of Percus & Yevick 1958 (Physical Review 110, 1-13), solved by Wertheim 1963 (Physical Review
/// Letters 10, 321-323), as the square that Baxter 1968 (Australian Journal of Physics 21, 563-569) found it to be.
///
/// 1 for spheres that are few or for long q; (1 - f)^4 / (1 + 2 f)^2 at q = 0, f being the volume fraction; its first
/// and highest peak is near q diameter = 7. Relative accuracy: 1e-13.
///
/// @param volume_fraction  of the spheres, in [0, 0.6]; real hard spheres freeze from 0.494 on, which the formula
/// ignores
/// @param q_diameter  length of the scattering vector, 2 k sin(angle / 2), times the diameter, >= 0
class HardSpheres {
public:
    explicit HardSpheres(double volume_fraction);
    double structure_factor(double q_diameter) const;

private:
    double of_square_, of_line_;
};

/// The same, asked for once.
double hard_sphere_structure_factor(double volume_fraction, double q_diameter);

}  // namespace nacre
