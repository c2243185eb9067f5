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

void check_cover(const Curve& curve, const Lanes& lanes, const std::string& what) {
  const Micrometres lo = lanes[0], hi = lanes[lanes.count() - 1];
  if (!curve.covers(lo, hi)) {
    throw InputError{what + " is tabulated from " + range_um(curve.first(), curve.last()) +
                     ", but the bands need it from " + range_um(lo, hi)};
  }
}

}  // namespace

Spectrum at_all(const Curve& curve, const Lanes& lanes, const std::string& what) {
  check_cover(curve, lanes, what);
  return curve.at(lanes);
}

double lane_mean(const Curve& curve, Micrometres wavelength, const AbsorptionLane& lane) {
  const Micrometres lo{lane.lo_um}, hi{lane.hi_um};
  return lo < hi && curve.covers(lo, hi) ? curve.mean(lo, hi) : curve.at(wavelength);
}

Spectrum mean_at_all(const Curve& curve, const Lanes& lanes, const std::string& what) {
  check_cover(curve, lanes, what);
  Spectrum values{lanes.count()};
  for (int lane = 0; lane < lanes.count(); ++lane) {
    values[lane] = static_cast<float>(lane_mean(curve, lanes[lane], lanes.absorption(lane)));
  }
  return values;
}

}  // namespace nadir::spectral
