#include "spectral/coverage.hpp"

#include <cstdio>

#include "core/error.hpp"

namespace nadir::spectral {
namespace {

std::string range_um(Micrometres lo, Micrometres hi) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g to %.4g um", lo.value, hi.value);
  return text;
}

}  // namespace

Spectrum at_all(const Curve& curve, const Lanes& lanes, const std::string& what) {
  const Micrometres lo = lanes[0], hi = lanes[lanes.count() - 1];
  if (!curve.covers(lo, hi)) {
    throw InputError{what + " is tabulated from " + range_um(curve.first(), curve.last()) +
                     ", but the bands need it from " + range_um(lo, hi)};
  }
  return curve.at(lanes);
}

}  // namespace nadir::spectral
