#include "nacre/colour/illuminant.h"

#include <algorithm>
#include <cstddef>

#include "nacre/colour/cie_tables.h"

namespace nacre {

std::vector<std::string_view> illuminant_names() {
    std::vector<std::string_view> names;
    for (const CieIlluminantTable& table : cie_illuminant_tables) names.push_back(table.name);
    return names;
}

std::optional<SampledCurve> illuminant_by_name(std::string_view name) {
    const auto table = std::find_if(cie_illuminant_tables.begin(), cie_illuminant_tables.end(),
                                    [name](const CieIlluminantTable& candidate) { return candidate.name == name; });
    if (table == cie_illuminant_tables.end()) return std::nullopt;
    SampledCurve curve;
    for (std::size_t i = 0; i < table->power.size(); ++i) {
        curve.wavelength_nm.push_back(table->first_nm + table->step_nm * static_cast<double>(i));
        curve.value.push_back(table->power[i]);
    }
    return curve;
}

}  // namespace nacre
