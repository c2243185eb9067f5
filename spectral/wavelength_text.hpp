#pragma once
// Private to this folder.

#include <string>

#include "core/quantity.hpp"
#include "core/text.hpp"

namespace nadir::spectral {

[[nodiscard]] inline std::string wavelength_text(Micrometres wavelength) {
  return number_text(wavelength.value) + " um";
}

}  // namespace nadir::spectral
