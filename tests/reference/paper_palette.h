#pragma once

#include "reference/number.h"

namespace nacre::reference {

struct LobeNumbers {
    Number peak_nm, width_nm, height;
};

struct PaperPick {
    double angle_deg, peak_nm, width_nm, height;
};

/// Y(theta), equation (3.2.5) of Park & Tsuruno, from the cosine of theta.
inline Number paper_shape(const Number& p, const Number& cos_theta) {
    return p * cos_theta * cos_theta + (1 - p) * cos_theta;
}

/// The lobe of two picks at the angle whose cosine is given, equations (3.2.8) to (3.2.13) as they are printed: the
/// peak from the angle, then width and height from the peak. Not clamped.
/// @pre the angles of the picks differ, and so do their peaks
inline LobeNumbers paper_lobe(const PaperPick& one, const PaperPick& two, double p, const Number& cos_theta) {
    const Number shape_1 = paper_shape(p, cos_of_degrees(one.angle_deg));
    const Number shape_2 = paper_shape(p, cos_of_degrees(two.angle_deg));
    const Number peak_1(one.peak_nm), peak_2(two.peak_nm);
    const Number width_1(one.width_nm), width_2(two.width_nm);
    const Number height_1(one.height), height_2(two.height);

    const Number peak = peak_1 + (peak_2 - peak_1) * (paper_shape(p, cos_theta) - shape_1) / (shape_2 - shape_1);
    const Number width = width_1 + (width_2 - width_1) * (peak - peak_1) / (peak_2 - peak_1);
    const Number height = height_1 + (height_2 - height_1) * (peak - peak_1) / (peak_2 - peak_1);
    return {peak, width, height};
}

}  // namespace nacre::reference
