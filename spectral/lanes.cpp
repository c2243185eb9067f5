#include "spectral/lanes.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::spectral {
namespace {

std::string um(Micrometres wavelength) { return number_text(wavelength.value) + " um"; }

void check_count(std::size_t count) {
  if (count > 0 && count <= static_cast<std::size_t>(lane_capacity)) return;
  throw InputError{"expected 1 to " + std::to_string(lane_capacity) + " wavelengths, found " +
                   std::to_string(count)};
}

}  // namespace

Lanes::Lanes(std::vector<Micrometres> wavelengths) : wavelengths_{std::move(wavelengths)} {
  check_count(wavelengths_.size());
  Micrometres previous{0.0};
  for (const Micrometres wavelength : wavelengths_) {
    if (!std::isfinite(wavelength.value) || wavelength.value <= 0.0) {
      throw InputError{"expected a positive wavelength, found " + um(wavelength)};
    }
    if (wavelength <= previous) {
      throw InputError{"expected ascending wavelengths, found " + um(wavelength) + " after " +
                       um(previous)};
    }
    previous = wavelength;
  }
}

}  // namespace nadir::spectral
