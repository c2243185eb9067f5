#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "materials/maps/relief_map.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/map_raster.hpp"

namespace nadir::sim {

/// Reads height rasters and normal maps. Materials that share a relief get the same one.
class ReliefReader {
 public:
  ReliefReader(const geometry::LocalFrame& frame, InputFiles& files, Diagnostics& diagnostics)
      : context_{&frame, &diagnostics}, files_{&files} {}

  /// @throws InputError for a raster with holes, normals that point inwards, or no place
  [[nodiscard]] std::shared_ptr<const materials::ReliefMap> read(const ReliefInput& input);

 private:
  MapContext context_;
  InputFiles* files_;
  std::map<std::tuple<std::string, int, int>, std::shared_ptr<const materials::ReliefMap>> known_;
};

}  // namespace nadir::sim
