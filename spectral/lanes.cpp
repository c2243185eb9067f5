#include "spectral/lanes.hpp"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "spectral/wavelength_text.hpp"

namespace nadir::spectral {
namespace {

void check_count(std::size_t count) {
  if (count > 0 && count <= static_cast<std::size_t>(lane_capacity)) return;
  throw InputError{"expected 1 to " + std::to_string(lane_capacity) + " wavelengths, found " +
                   std::to_string(count)};
}

}  // namespace

Lanes::Lanes(std::vector<Micrometres> wavelengths, std::vector<AbsorptionLane> absorption)
    : wavelengths_{std::move(wavelengths)}, absorption_{std::move(absorption)} {
  check_count(wavelengths_.size());
  if (!absorption_.empty() && absorption_.size() != wavelengths_.size()) {
    throw InputError{"expected one absorption term a wavelength"};
  }
  const auto after = [this](int lane) {
    const AbsorptionLane a = this->absorption(lane - 1), b = this->absorption(lane);
    return std::tie(a.lo_um, a.hi_um, a.term) < std::tie(b.lo_um, b.hi_um, b.term);
  };
  Micrometres previous{0.0};
  for (int lane = 0; lane < count(); ++lane) {
    const Micrometres wavelength = (*this)[lane];
    if (!std::isfinite(wavelength.value) || wavelength.value <= 0.0) {
      throw InputError{"expected a positive wavelength, found " + wavelength_text(wavelength)};
    }
    if (wavelength < previous || (wavelength == previous && !after(lane))) {
      throw InputError{"expected ascending wavelengths, found " + wavelength_text(wavelength) +
                       " after " + wavelength_text(previous)};
    }
    previous = wavelength;
  }
}

}  // namespace nadir::spectral
