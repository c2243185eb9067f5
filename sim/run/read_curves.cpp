#include "sim/run/read_curves.hpp"

namespace nadir::sim {

spectral::Curve curve_of(const SpectralInput& input, SpectrumQuantity quantity,
                         spectral::Outside outside, InputFiles& files) {
  return CurveReader{files}.read(input, quantity, outside);
}

spectral::Curve CurveReader::read(const SpectralInput& input, SpectrumQuantity quantity,
                                  spectral::Outside outside) {
  if (const auto* value = std::get_if<double>(&input.source)) {
    return spectral::Curve::constant(*value);
  }
  const auto& path = files_->note(std::get<std::filesystem::path>(input.source));
  const auto key = std::pair{path, quantity};
  auto found = read_.find(key);
  if (found == read_.end()) {
    found = read_.emplace(key, read_spectrum_file(path, quantity)).first;
  }
  return curve_in(found->second, input.column, quantity, outside);
}

}  // namespace nadir::sim
