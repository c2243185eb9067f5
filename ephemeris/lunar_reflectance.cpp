#include "ephemeris/lunar_reflectance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "ephemeris/curve_product.hpp"
#include "ephemeris/number_text.hpp"

namespace nadir::ephemeris {
namespace {

using spectral::Curve;
using spectral::Outside;

double krisciunas_schaefer(double phase_deg) {
  const double magnitude = 0.026 * phase_deg + 4e-9 * std::pow(phase_deg, 4.0);
  return std::pow(10.0, -0.4 * magnitude);
}

// 0 at pi, where the product of a pole and a zero would be NaN.
double lommel_seeliger(double phase) {
  if (!(phase < std::numbers::pi)) return 0.0;
  const double product = std::sin(phase / 2.0) * std::tan(phase / 2.0);
  return std::max(0.0, 1.0 + product * std::log(std::tan(phase / 4.0)));
}

// What the exponent of the model has besides the phase angle's own terms.
double longitude_and_libration(const LunarBand& band, const LunarGeometry& geometry,
                               double shortened) {
  const double sun = geometry.sun.longitude.value * shortened;
  const double latitude_deg = to_degrees(geometry.observer.latitude);
  const double longitude_deg = to_degrees(geometry.observer.longitude);
  const double squared = sun * sun;
  return sun * (band.b[0] + squared * (band.b[1] + squared * band.b[2])) +
         LunarModel::c[0] * latitude_deg + LunarModel::c[1] * longitude_deg +
         LunarModel::c[2] * sun * latitude_deg + LunarModel::c[3] * sun * longitude_deg;
}

std::vector<std::string> notes_on(const LunarModel& model, const LunarGeometry& geometry) {
  const double phase_deg = to_degrees(geometry.phase);
  const std::string first = number_text(model.bands.front().wavelength.value);
  const std::string last = number_text(model.bands.back().wavelength.value);
  std::vector<std::string> notes{
      "the moon's reflectance is modelled from " + first + " to " + last +
      " um: below, it falls to 0.63 of that at 0.25 um; beyond, it is held"};
  if (phase_deg < rolo_first_phase_deg) {
    notes.emplace_back("the moon's phase angle is " + number_text(phase_deg) +
                       " deg, below the model's 1.55: its reflectance is that at 1.55 deg");
  } else if (phase_deg > rolo_last_phase_deg) {
    notes.emplace_back("the moon's phase angle is " + number_text(phase_deg) +
                       " deg, above the model's 97: its light falls off as a crescent's");
  }
  return notes;
}

std::string mistake_in(const LunarModel& model) {
  if (model.bands.size() < 2) return "has fewer than two bands";
  for (std::size_t i = 1; i < model.bands.size(); ++i) {
    if (!(model.bands[i].wavelength > model.bands[i - 1].wavelength)) {
      return "has bands whose wavelengths do not ascend, at " +
             number_text(model.bands[i].wavelength.value) + " um";
    }
  }
  if (!(model.bands.front().wavelength.value > ultraviolet_end_um)) {
    return "has a band at or below 0.25 um";
  }
  return "";
}

}  // namespace

LunarModel checked(LunarModel model) {
  const std::string mistake = mistake_in(model);
  if (!mistake.empty()) throw InputError{"the model of the moon's reflectance " + mistake};
  return model;
}

double crescent(Angle phase) noexcept {
  constexpr double joint_deg = 150.0;
  const double deg = to_degrees(phase);
  const double share =
      krisciunas_schaefer(std::min(deg, joint_deg)) / krisciunas_schaefer(rolo_last_phase_deg);
  if (deg <= joint_deg) return share;
  return share * lommel_seeliger(phase.value) / lommel_seeliger(degrees(joint_deg).value);
}

double disc_reflectance(const LunarBand& band, const LunarGeometry& geometry) noexcept {
  const double true_deg = to_degrees(geometry.phase);
  const double deg = std::clamp(true_deg, rolo_first_phase_deg, rolo_last_phase_deg);
  const double g = degrees(deg).value;
  const double shortened = true_deg > rolo_last_phase_deg ? rolo_last_phase_deg / true_deg : 1.0;
  const double exponent = band.a[0] + g * (band.a[1] + g * (band.a[2] + g * band.a[3])) +
                          longitude_and_libration(band, geometry, shortened) +
                          band.d[0] * std::exp(-deg / LunarModel::p_deg[0]) +
                          band.d[1] * std::exp(-deg / LunarModel::p_deg[1]) +
                          band.d[2] * std::cos((deg - LunarModel::p_deg[2]) / LunarModel::p_deg[3]);
  const double reflectance = std::exp(exponent);
  return true_deg > rolo_last_phase_deg ? reflectance * crescent(geometry.phase) : reflectance;
}

Curve disc_reflectance(const LunarModel& model, const LunarGeometry& geometry) {
  std::vector<double> um{ultraviolet_end_um}, reflectance{0.0};
  for (const LunarBand& band : model.bands) {
    um.push_back(band.wavelength.value);
    reflectance.push_back(disc_reflectance(band, geometry) * band.smoothing);
  }
  reflectance[0] = reflectance[1] * ultraviolet_share;
  return {std::move(um), std::move(reflectance), Outside::hold};
}

LunarIrradiance lunar_irradiance(const LunarModel& model, const LunarGeometry& geometry,
                                 const Curve& solar_1au) {
  const Curve reflectance = disc_reflectance(model, geometry);
  const double sun_au = geometry.sun_distance.value / astro::astronomical_unit_m;
  const double nearness = LunarModel::mean_distance_m / geometry.observer_distance.value;
  const double scale =
      LunarModel::solid_angle_sr / std::numbers::pi * nearness * nearness / (sun_au * sun_au);
  return {product(solar_1au, reflectance.wavelengths_um(),
                  [&](Micrometres wavelength) { return scale * reflectance.at(wavelength); }),
          notes_on(model, geometry)};
}

}  // namespace nadir::ephemeris
