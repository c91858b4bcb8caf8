#pragma once

#include <string>
#include <vector>

#include "nacre/optics/incidence.h"
#include "nacre/optics/layered.h"
#include "nacre/paper/paper.h"

namespace nacre {

/// A stack of layers, solved exactly, with which the palette of a specimen is compared.
struct ExactStack {
    std::string name;   ///< as in column names: "perfect"
    std::string title;  ///< for legends, a few words
    std::string facts;  ///< its layers, with the source and the certainty of each number, in Markdown
    Stack stack;        ///< starts with a group, the period
};

/// The stack whose Bragg law is specimen.stack comes first.
std::vector<ExactStack> exact_stacks(const Specimen& specimen);

/// First-order Bragg wavelength of the stack's first group: twice the optical path through its layers, in nm.
/// It ignores absorption and multiple reflections.
double bragg_peak_nm(const Stack& stack, const Incidence& incidence);

}  // namespace nacre
