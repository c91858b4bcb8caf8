#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace nacre::reference {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every compiler and library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    /// In [0, 1).
    double unit() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
    }
    double between(double low, double high) { return low + unit() * (high - low); }
    /// A multiple of 1 / per_unit, so that it is a short decimal.
    double between(double low, double high, double per_unit) {
        return std::round(between(low, high) * per_unit) / per_unit;
    }
    /// Even in the logarithm.
    double of_any_size(double low, double high) { return low * std::pow(high / low, unit()); }
    int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
    bool chance(double probability) { return unit() < probability; }
    template <typename T, std::size_t count>
    const T& one_of(const std::array<T, count>& things) {
        return things[static_cast<std::size_t>(unit() * static_cast<double>(count))];
    }

private:
    std::uint64_t state_;
};

}  // namespace nacre::reference
