#pragma once

#include <filesystem>
#include <map>
#include <utility>

#include "sim/files/spectrum_file.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// The curve that a scenario's spectral quantity means: a constant, or a column of a file.
/// @throws InputError from the file's reader
[[nodiscard]] spectral::Curve curve_of(const SpectralInput& input, SpectrumQuantity quantity,
                                       spectral::Outside outside, InputFiles& files);

/// Does the same for many curves: a file from which many columns are taken is read once.
class CurveReader {
 public:
  explicit CurveReader(InputFiles& files) : files_{&files} {}

  /// @throws InputError from the file's reader
  [[nodiscard]] spectral::Curve read(const SpectralInput& input, SpectrumQuantity quantity,
                                     spectral::Outside outside);
  [[nodiscard]] InputFiles& files() noexcept { return *files_; }

 private:
  InputFiles* files_;
  std::map<std::pair<std::filesystem::path, SpectrumQuantity>, SpectrumFile> read_;
};

}  // namespace nadir::sim
