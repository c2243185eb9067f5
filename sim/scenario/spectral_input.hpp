#pragma once

#include <filesystem>
#include <string>
#include <variant>

namespace nadir::sim {

/// A spectral quantity: one number for all wavelengths, or a column of a spectrum file.
struct SpectralInput {
  std::variant<double, std::filesystem::path> source = 0.0;
  std::string column;  ///< of the file; empty where it has only one
};

}  // namespace nadir::sim
