#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "geometry/earth.hpp"
#include "materials/material.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/read_curves.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Reads what materials name. What several of them share is read once: a file of spectra, a part
/// of several mixtures, a measured table.
class MaterialReader {
 public:
  explicit MaterialReader(InputFiles& files) : curves_{files} {}

  /// Spectra and scattering, without relief. @throws InputError
  [[nodiscard]] materials::Material read(const MaterialInput& input);

 private:
  friend struct ScatteringReader;
  [[nodiscard]] std::shared_ptr<const materials::Material> part(
      const std::shared_ptr<const MaterialInput>& input);
  [[nodiscard]] std::shared_ptr<const materials::BrdfTable> table(
      const std::filesystem::path& file);

  CurveReader curves_;
  std::map<const MaterialInput*, std::shared_ptr<const materials::Material>> parts_;
  std::map<std::filesystem::path, std::shared_ptr<const materials::BrdfTable>> tables_;
};

/// A material with its spectra read, without its relief. @throws InputError
[[nodiscard]] materials::Material load_material(const MaterialInput& input, InputFiles& files);

/// All materials of a scenario, in its order, with their reliefs.
/// @param frame  of the scene, for reliefs that are draped over the ground
/// @throws InputError with the mistakes of all files
[[nodiscard]] std::vector<materials::Material> load_materials(const Scenario& scenario,
                                                              const geometry::LocalFrame& frame,
                                                              InputFiles& files,
                                                              Diagnostics& diagnostics);

}  // namespace nadir::sim
