#pragma once

#include <optional>
#include <vector>

#include "sim/files/raster_write.hpp"
#include "sim/products/geo_task.hpp"
#include "sim/products/rpc_fit.hpp"

namespace nadir::sim {

/// How an image lies on the earth, in the ways that GDAL knows: a map (geotransform), or ground
/// control points and, if they fit, rational polynomials.
struct Georeference {
  std::optional<MapPlacement> map;
  int epsg = 0;                  ///< of the map, where it has a number
  double map_residual_px = 0.0;  ///< the largest, at the scene's mean height
  std::vector<ControlPoint> control;
  std::optional<RpcFit> rpc;
};

// What the map may be off by, and the polynomials before they are left out.
inline constexpr double most_map_residual_px = 0.01;
inline constexpr double most_rpc_residual_px = 0.5;

/// A map where the camera is orthographic and looks straight down: UTM if a geotransform is good
/// for it, else the orthographic projection about the scene's site. Everything else gets control
/// points and polynomials, but for arrays whose modules are staggered: those get a warning.
[[nodiscard]] Georeference georeference(const GeoTask& task);
/// The same without points and polynomials.
[[nodiscard]] Georeference map_of(const GeoTask& task);

/// Radiance, and digital numbers where there are.
[[nodiscard]] std::vector<ProductFile> write_geotiffs(const GeoTask& task,
                                                      const Georeference& georeference);

/// Coefficients in GDAL's names: its offsets count from the first pixel's centre.
[[nodiscard]] TextItems gdal_rpc(const Rpc& rpc);

}  // namespace nadir::sim
