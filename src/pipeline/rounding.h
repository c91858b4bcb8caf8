#pragma once

namespace nacre {

/// Three digits, upwards: more digits would differ between machines (their sines do), fewer would promise too much.
double rounded_up(double error);

/// To a millionth of a degree: the bits beyond depend on the machine's sine.
double rounded_angle(double angle_deg);

}  // namespace nacre
