#pragma once

#include "sensor/detector/detector.hpp"

namespace nadir::sensor {

/// @throws InputError naming the first figure that is out of its range; those that a detector of
///         its kind does not use are not looked at
void check(const Detector& detector);

}  // namespace nadir::sensor
