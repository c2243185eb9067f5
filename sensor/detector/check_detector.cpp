#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sensor/detector/checks.hpp"

namespace nadir::sensor {
namespace {

struct Range {
  double lo = 0.0, hi = 0.0;
  bool with_lo = true, with_hi = true;
};

constexpr double unbounded = 1e300;
constexpr Range not_negative{0.0, unbounded};
constexpr Range positive{0.0, unbounded, false};
constexpr Range share{0.0, 1.0};
constexpr Range positive_share{0.0, 1.0, false};
constexpr Range less_than_one{0.0, 1.0, true, false};

std::string range_text(const Range& range) {
  if (range.hi == unbounded) return range.with_lo ? "at least 0" : "above 0";
  return std::string{range.with_lo ? "in [" : "in ("} + number_text(range.lo) + ", " +
         number_text(range.hi) + (range.with_hi ? "]" : ")");
}

void require(const char* what, double value, const Range& range) {
  const bool above = range.with_lo ? value >= range.lo : value > range.lo;
  const bool below = range.with_hi ? value <= range.hi : value < range.hi;
  if (above && below) return;  // NaN fails both
  throw InputError{std::string{"expected "} + what + " " + range_text(range) + ", found " +
                   number_text(value)};
}

void check_optics(const Optics& optics) {
  require("an f-number", optics.f_number, positive);
  require("an obscuration", optics.obscuration, less_than_one);
  require("a transmittance", optics.transmittance, positive_share);
  require("a power of the fall-off", optics.falloff_power, not_negative);
  require("a temperature of the optics, K,", optics.temperature_k, not_negative);
  require("an emissivity of the optics", optics.emissivity, share);
  require("a temperature of the shield, K,", optics.shield_temperature_k, not_negative);
  constexpr double rounding = 1e-9;  // 1 - 0.9 is not 0.1 in binary
  if (optics.temperature_k > 0.0 && optics.emissivity + optics.transmittance > 1.0 + rounding) {
    throw InputError{
        "expected emissivity and transmittance of warm optics to sum to at most 1, "
        "found " +
        number_text(optics.emissivity) + " and " + number_text(optics.transmittance)};
  }
}

void check_element(const PhotonDetector& element) {
  require("an efficiency", element.efficiency, positive_share);
  require("a detector's area, m^2,", element.area_m2, positive);
  require("a dark current, electrons per s,", element.dark_e_s, not_negative);
  require("a detector's temperature, K,", element.temperature_k, positive);
  require("a reference temperature of the dark current, K,", element.dark_reference_k, positive);
  require("a doubling of the dark current, K,", element.dark_doubling_k, positive);
  require("a read noise, electrons,", element.read_noise_e, not_negative);
  require("a line noise, electrons,", element.line_noise_e, not_negative);
  require("a correlation from line to line", element.line_correlation, less_than_one);
  require("a photo-response non-uniformity", element.prnu, less_than_one);
  require("a dark-signal non-uniformity, electrons,", element.dsnu_e, not_negative);
  require("a full well, electrons,", element.full_well_e, positive);
}

void check_element(const PublishedNoise& element) {
  require("alpha of the published noise", element.alpha, not_negative);
  require("beta of the published noise", element.beta, not_negative);
}

}  // namespace

void check(const Detector& detector) {
  const Digitiser& digitiser = detector.digitiser;
  if (digitiser.bits < 1 || digitiser.bits > 16) {
    throw InputError{"expected 1 to 16 bits, found " + std::to_string(digitiser.bits)};
  }
  const double top = static_cast<double>((1U << static_cast<unsigned>(digitiser.bits)) - 1U);
  require("a black level, DN,", digitiser.black_level_dn, {0.0, top, true, false});
  require("a share of dead detectors", detector.dead_share, less_than_one);
  if (std::holds_alternative<PhotonDetector>(detector.element)) {
    check_optics(detector.optics);
    if (digitiser.gain_dn_e) require("a gain, DN per electron,", *digitiser.gain_dn_e, positive);
  } else {
    require("a saturation radiance", digitiser.saturation, positive);
  }
  std::visit([](const auto& element) { check_element(element); }, detector.element);
}

}  // namespace nadir::sensor
