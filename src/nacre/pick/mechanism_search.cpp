#include "nacre/pick/mechanism_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/base/text.h"

namespace nacre {

double FreeNumber::at(double u) const {
    switch (scale) {
        case FreeScale::even:
            return std::lerp(low, high, u);
        case FreeScale::ratio:
            return std::clamp(low * std::pow(high / low, u), low, high);
        case FreeScale::whole:
            // Every whole number has a share of its own, the ends too.
            return std::clamp(std::round((low - 0.5) * std::pow((high + 0.5) / (low - 0.5), u)), low, high);
    }
    return low;
}

double FreeNumber::place_of(double value) const {
    if (!(high > low)) return 0.0;
    switch (scale) {
        case FreeScale::even:
            return std::clamp((value - low) / (high - low), 0.0, 1.0);
        case FreeScale::ratio:
            return std::clamp(std::log(value / low) / std::log(high / low), 0.0, 1.0);
        case FreeScale::whole:
            return std::clamp(std::log(value / (low - 0.5)) / std::log((high + 0.5) / (low - 0.5)), 0.0, 1.0);
    }
    return 0.0;
}

std::string found_text(const MechanismSearch& search, const FoundMechanism& found) {
    constexpr double end = 1e-6;  // of the range
    std::string text;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        const FreeNumber& number = search.free[i];
        const double value = found.values[i];
        text += (text.empty() ? "" : ", ") + number.name + " = " + significant_text(value, 5);
        const bool is_at_end = std::min(value - number.low, number.high - value) <= end * (number.high - number.low);
        if (is_at_end && number.scale != FreeScale::whole) text += " (end of its range)";
    }
    return text.empty() ? "nothing was free" : text;
}

}  // namespace nacre
