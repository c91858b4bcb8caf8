#pragma once

#include <string>
#include <vector>

#include "nacre/optics/layered.h"
#include "nacre/paper/paper.h"

namespace nacre {

/// A stack of layers, solved exactly, that a specimen's palette is held against.
struct ExactStack {
    std::string name;   ///< as in column names: "perfect"
    std::string title;  ///< for legends, a few words
    std::string facts;  ///< what it is made of, and where each number comes from and how sure it is: Markdown
    Stack stack;        ///< starts with a group, the period
};

/// The stack whose Bragg law is specimen.stack comes first.
std::vector<ExactStack> exact_stacks(const Specimen& specimen);

/// First-order Bragg wavelength of the stack's first group: twice the optical path through its layers, in nm.
/// Absorption and the light that interfaces send back and forth are not in it.
double bragg_peak_nm(const Stack& stack, const Incidence& incidence);

}  // namespace nacre
