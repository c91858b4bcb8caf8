#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "reference/colour.h"
#include "reference/matrix.h"
#include "reference/weights.h"

namespace nacre::reference {

inline constexpr int light_begins_nm = 360;  ///< where the light of every reference scene begins and ends
inline constexpr int light_ends_nm = 830;

/// The tables of an illuminant and an observer, in 50 digits. @param observer_deg  2 or 10
Weights weights_of(const std::string& illuminant, int observer_deg);

/// Wavelengths at even steps, and what a spectrum that is given there weighs. Between them it is a cubic through four
/// neighbours, which is integrated against observer times illuminant at four midpoints per nanometre or more.
struct WavelengthGrid {
    std::vector<double> nm;
    std::vector<Triple> weight;

    Triple sum(const std::vector<double>& spectrum) const;
};

/// An illuminant seen by an observer, Bradford to D65, Y of the perfect reflector 1.
class ModelLight {
public:
    ModelLight(const std::string& illuminant, int observer_deg);

    /// Made once. @param illuminant  a column of illuminants_5nm.csv
    static const ModelLight& of(const std::string& illuminant, int observer_deg);

    /// At whole nanometres from light_begins_nm to light_ends_nm.
    const std::vector<Triple>& weights() const { return weights_; }
    /// Linear between whole nanometres.
    Triple weight_at(double nm) const;
    const WavelengthGrid& grid(double step_nm) const;
    ModelXyz adapted(const Triple& seen) const;
    /// The other way: what has to be seen under the light so that it is adapted to a colour.
    Triple seen_as(const ModelXyz& adapted) const;

private:
    std::vector<Triple> weights_;
    Matrix<double> to_d65_{};
    mutable std::map<double, WavelengthGrid> grids_;
};

}  // namespace nacre::reference
