#include "materials/scattering/brdf_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace nadir::materials {
namespace {

constexpr double tolerance = 1e-9;  // of angles converted from degrees

void check_axis(const std::vector<double>& axis, std::size_t least, const std::string& name) {
  if (axis.size() < least) {
    throw InputError{"the measured reflectance needs at least " + std::to_string(least) + " " +
                     name};
  }
  for (std::size_t i = 1; i < axis.size(); ++i) {
    if (!(axis[i] > axis[i - 1])) {
      throw InputError{"the " + name + " of the measured reflectance do not ascend"};
    }
  }
}

void check_zenith(const std::vector<double>& axis, const std::string& name) {
  check_axis(axis, 2, name);
  if (std::abs(axis.front()) > tolerance || axis.back() > 0.5 * std::numbers::pi + tolerance) {
    throw InputError{"the " + name +
                     " of the measured reflectance must run from 0 to at most 90 degrees"};
  }
}

}  // namespace

void check(const BrdfTable& table) {
  check_zenith(table.incidence_rad, "angles of incidence");
  check_zenith(table.view_rad, "view angles");
  check_axis(table.azimuth_rad, 2, "relative azimuths");
  if (std::abs(table.azimuth_rad.front()) > tolerance ||
      std::abs(table.azimuth_rad.back() - std::numbers::pi) > tolerance) {
    throw InputError{
        "the relative azimuths of the measured reflectance must run from 0 to 180 degrees"};
  }
  check_axis(table.wavelength_um, 1, "wavelengths");
  const std::size_t expected = table.incidence_rad.size() * table.view_rad.size() *
                               table.azimuth_rad.size() * table.wavelength_um.size();
  if (table.value.size() != expected) {
    throw InputError{"the measured reflectance has " + std::to_string(table.value.size()) +
                     " values; its axes need " + std::to_string(expected)};
  }
  for (const float value : table.value) {
    if (!std::isfinite(value) || value < 0.0F) {
      throw InputError{"the measured reflectance holds a value that is negative or not finite"};
    }
  }
}

}  // namespace nadir::materials
