#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <random>

namespace nacre::reference {

/// 50 decimal digits: what is lost to cancellation in a reference stays far below the last bit of a double.
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

inline Number pi() {
    return boost::math::constants::pi<Number>();
}
inline Number radians(const Number& degrees) {
    return degrees * pi() / 180;
}
inline Number degrees(const Number& radians) {
    return radians * 180 / pi();
}
/// Cosine of the very angle that the double holds.
inline Number cos_of_degrees(double theta_deg) {
    return cos(radians(Number(theta_deg)));
}

/// |number - exact| as a double.
inline double distance(double number, const Number& exact) {
    return static_cast<double>(abs(Number(number) - exact));
}
/// |number - exact| / |exact|; |number| where exact is 0.
inline double relative_distance(double number, const Number& exact) {
    return exact == 0 ? distance(number, exact) : static_cast<double>(abs(Number(number) - exact) / abs(exact));
}

/// Uniform numbers that do not depend on the standard library's distributions.
class Uniform {
public:
    explicit Uniform(std::uint64_t seed) : generator_(seed) {}
    /// In [low, high).
    double between(double low, double high) {
        const double unit = static_cast<double>(generator_() >> 11U) * 0x1p-53;
        return low + unit * (high - low);
    }

private:
    std::mt19937_64 generator_;
};

}  // namespace nacre::reference
