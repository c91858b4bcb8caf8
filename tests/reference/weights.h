#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "reference/csv.h"
#include "reference/number.h"

namespace nacre::reference {

struct XyzNumbers {
    Number x, y, z;
};

/// Observer x illuminant at whole nanometres from first_nm, in any scale; linear between them.
struct Weights {
    int first_nm = 0;
    std::vector<Number> x, y, z;

    int last_nm() const { return first_nm + static_cast<int>(y.size()) - 1; }
};

/// Integral of the piecewise linear function through values one nanometre apart.
inline Number integral_of(const std::vector<Number>& values) {
    Number sum = 0;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) sum += (values[i] + values[i + 1]) / 2;
    return sum;
}

/// What R = 1 gives; y is 1.
inline XyzNumbers white_of(const Weights& weights) {
    const Number y = integral_of(weights.y);
    return {integral_of(weights.x) / y, Number(1), integral_of(weights.z) / y};
}

/// Relative power of an illuminant of illuminants_5nm.csv, linear between the file's rows, 0 where it is blank.
inline Number illuminant_power(const Csv& illuminants, const std::string& name, int nm) {
    for (std::size_t row = 0; row < illuminants.rows.size(); ++row) {
        const double row_nm = *illuminants.number(row, "wavelength_nm");
        if (row_nm == nm) return Number(illuminants.number(row, name).value_or(0.0));
        const bool brackets = row_nm < nm && row + 1 < illuminants.rows.size() && nm < row_nm + 5;
        if (!brackets) continue;
        const std::optional<double> low = illuminants.number(row, name), high = illuminants.number(row + 1, name);
        if (!low || !high) return 0;
        return (Number(*low) * (Number(row_nm) + 5 - nm) + Number(*high) * (Number(nm) - row_nm)) / 5;
    }
    return 0;
}

/// @param observer_file  cmf_cie1931_2deg_1nm.csv or cmf_cie1964_10deg_1nm.csv: nanometre, x_bar, y_bar, z_bar
inline Weights weights_from_files(const std::string& observer_file, const std::string& illuminant, int first_nm,
                                  int last_nm) {
    const Csv observer = read_csv(observer_file);
    const Csv illuminants = read_csv("illuminants_5nm.csv");
    Weights weights;
    weights.first_nm = first_nm;
    for (std::size_t row = 0; row < observer.rows.size(); ++row) {
        const int nm = std::stoi(observer.rows[row].at(0));
        if (nm < first_nm || nm > last_nm) continue;
        const Number power = illuminant_power(illuminants, illuminant, nm);
        weights.x.push_back(power * *observer.number(row, observer.names.at(1)));
        weights.y.push_back(power * *observer.number(row, observer.names.at(2)));
        weights.z.push_back(power * *observer.number(row, observer.names.at(3)));
    }
    return weights;
}

}  // namespace nacre::reference
