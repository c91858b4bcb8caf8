#pragma once

#include <string>
#include <string_view>

namespace nacre {

/// A place in what the user wrote. Line and column count from 1; 0 means unknown.
struct Where {
    std::string file;
    int line = 0;
    int column = 0;

    /// "file:line:column", or as much of it as is known.
    std::string text() const;
};

/// The numbers that a key may have.
struct Allowed {
    double low = 0.0;
    double high = 0.0;
    std::string_view unit = {};  ///< behind the interval in messages, e.g. "nm"

    friend bool operator==(const Allowed&, const Allowed&) = default;
};

}  // namespace nacre
