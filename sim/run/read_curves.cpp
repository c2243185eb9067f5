#include "sim/run/read_curves.hpp"

namespace nadir::sim {

spectral::Curve curve_of(const SpectralInput& input, SpectrumQuantity quantity,
                         spectral::Outside outside, InputFiles& files) {
  if (const auto* value = std::get_if<double>(&input.source)) {
    return spectral::Curve::constant(*value);
  }
  const auto& file = files.note(std::get<std::filesystem::path>(input.source));
  return read_curve(file, input.column, quantity, outside);
}

}  // namespace nadir::sim
