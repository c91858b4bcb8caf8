#pragma once

#include <stdexcept>
#include <string>

namespace nacre {

/// The user's mistake, in one line: `<where>: <what is wrong>; <what is allowed>`.
///
/// Thrown while reading and planning only; optics and colour never throw. A front end catches it once
/// (exit code 2: nothing was written).
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The disk's or the operating system's refusal (exit code 3: no partial file is left).
class IoError : public Error {
public:
    using Error::Error;
};

}  // namespace nacre
