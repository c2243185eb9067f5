#pragma once

#include <filesystem>
#include <string>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "geometry/earth.hpp"
#include "materials/maps/map_frame.hpp"
#include "sim/files/raster.hpp"
#include "sim/scenario/material_input.hpp"

namespace nadir::sim {

/// What every reader of maps needs at hand.
struct MapContext {
  const geometry::LocalFrame* frame = nullptr;  ///< of the scene
  Diagnostics* diagnostics = nullptr;
};

/// Where the pixels of a raster lie.
///
/// A raster with a coordinate system of its own is put into the scene's plane by the affine map
/// that comes nearest to its projection (through WGS84, at the height of the site); a warning tells
/// if that is more than half a pixel off somewhere.
/// @throws InputError where the raster cannot be placed
[[nodiscard]] materials::MapFrame map_frame(const MapPlaceInput& place,
                                            const std::filesystem::path& file, const Raster& raster,
                                            const MapContext& context);

/// A mistake in the pixel of that row-major number.
[[nodiscard]] InputError pixel_error(const std::filesystem::path& file, const Raster& raster,
                                     std::size_t pixel, const std::string& what,
                                     std::string hint = {});

}  // namespace nadir::sim
