#pragma once

#include <stdexcept>
#include <string>

namespace nacre {

/// A mistake of the user, in one line: `<where>: <what is wrong>; <what is allowed>`.
///
/// Thrown while reading and planning only; optics and colour never throw. A front end catches it once
/// (exit code 2: nothing was written).
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A refusal of the disk or the operating system (exit code 3: no partial file is left).
class IoError : public Error {
public:
    using Error::Error;
};

}  // namespace nacre
