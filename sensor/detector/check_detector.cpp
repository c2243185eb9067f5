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

constexpr double no_limit = 1e300;
constexpr Range at_least_zero{0.0, no_limit};
constexpr Range positive{0.0, no_limit, false};
constexpr Range from_0_to_1{0.0, 1.0};
constexpr Range up_to_1{0.0, 1.0, false};
constexpr Range below_1{0.0, 1.0, true, false};

std::string range_text(const Range& range) {
  if (range.hi == no_limit) return range.with_lo ? "at least 0" : "above 0";
  return std::string{range.with_lo ? "in [" : "in ("} + number_text(range.lo) + ", " +
         number_text(range.hi) + (range.with_hi ? "]" : ")");
}

void require_in_range(const char* what, double value, const Range& range) {
  const bool above = range.with_lo ? value >= range.lo : value > range.lo;
  const bool below = range.with_hi ? value <= range.hi : value < range.hi;
  if (above && below) return;  // NaN fails both
  throw InputError{std::string{"expected "} + what + " " + range_text(range) + ", found " +
                   number_text(value)};
}

void check_optics(const Optics& optics) {
  require_in_range("an f-number", optics.f_number, positive);
  require_in_range("an obscuration", optics.obscuration, below_1);
  require_in_range("a transmittance", optics.transmittance, up_to_1);
  require_in_range("a power of the fall-off", optics.falloff_power, at_least_zero);
  require_in_range("a temperature of the optics, K,", optics.temperature_k, at_least_zero);
  require_in_range("an emissivity of the optics", optics.emissivity, from_0_to_1);
  require_in_range("a temperature of the shield, K,", optics.shield_temperature_k, at_least_zero);
  constexpr double rounding = 1e-9;  // 1 - 0.9 is not 0.1 in binary
  if (optics.temperature_k > 0.0 && optics.emissivity + optics.transmittance > 1.0 + rounding) {
    throw InputError{
        "expected emissivity and transmittance of warm optics to sum to at most 1, "
        "found " +
        number_text(optics.emissivity) + " and " + number_text(optics.transmittance)};
  }
}

void check_element(const PhotonDetector& element) {
  require_in_range("an efficiency", element.efficiency, up_to_1);
  require_in_range("a detector's area, m^2,", element.area_m2, positive);
  require_in_range("a dark current, electrons per s,", element.dark_e_s, at_least_zero);
  require_in_range("a detector's temperature, K,", element.temperature_k, positive);
  require_in_range("a reference temperature of the dark current, K,", element.dark_reference_k,
                   positive);
  require_in_range("a doubling of the dark current, K,", element.dark_doubling_k, positive);
  require_in_range("a read noise, electrons,", element.read_noise_e, at_least_zero);
  require_in_range("a line noise, electrons,", element.line_noise_e, at_least_zero);
  require_in_range("a flicker noise, electrons,", element.flicker_noise_e, at_least_zero);
  require_in_range("a correlation from line to line", element.line_correlation, below_1);
  require_in_range("a photo-response non-uniformity", element.prnu, below_1);
  require_in_range("a dark-signal non-uniformity, electrons,", element.dsnu_e, at_least_zero);
  require_in_range("a full well, electrons,", element.full_well_e, positive);
}

void check_element(const PublishedNoise& element) {
  require_in_range("alpha of the published noise", element.alpha, at_least_zero);
  require_in_range("beta of the published noise", element.beta, at_least_zero);
}

}  // namespace

void check(const Detector& detector) {
  const Digitiser& digitiser = detector.digitiser;
  if (digitiser.bits < 1 || digitiser.bits > 16) {
    throw InputError{"expected 1 to 16 bits, found " + std::to_string(digitiser.bits)};
  }
  const double top = static_cast<double>((1U << static_cast<unsigned>(digitiser.bits)) - 1U);
  require_in_range("a black level, DN,", digitiser.black_level_dn, {0.0, top, true, false});
  require_in_range("a share of dead detectors", detector.dead_share, below_1);
  if (std::holds_alternative<PhotonDetector>(detector.element)) {
    check_optics(detector.optics);
    if (digitiser.gain_dn_e)
      require_in_range("a gain, DN per electron,", *digitiser.gain_dn_e, positive);
  } else {
    require_in_range("a saturation radiance", digitiser.saturation, positive);
  }
  std::visit([](const auto& element) { check_element(element); }, detector.element);
}

}  // namespace nadir::sensor
