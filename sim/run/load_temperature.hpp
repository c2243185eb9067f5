#pragma once

#include <memory>
#include <string>

#include "ephemeris/instant.hpp"
#include "geometry/mesh.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/map_raster.hpp"
#include "sim/scenario/heat_input.hpp"
#include "thermal/temperature.hpp"

namespace nadir::sim {

/// A raster as temperatures at a moment: kelvin = gain x value + offset. Of several slices the two
/// about the moment are read and mixed linearly in time. One slice alone holds at all times.
/// @throws InputError for pixels without a value or outside 0 to 6000 K, a moment that the slices
///         do not cover, slices of different size or place, slices without a time or of the same
[[nodiscard]] thermal::MappedTemperature load_temperature_raster(
    const TemperatureRasterInput& input, const ephemeris::Instant& moment,
    const MapContext& context, InputFiles& files);

/// A table's temperature at a moment.
/// @throws InputError as read_temperature_table and TemperatureTable::at do
[[nodiscard]] Kelvin load_temperature_table(const TemperatureTableInput& input,
                                            const ephemeris::Instant& moment, InputFiles& files);

[[nodiscard]] thermal::VertexTemperature vertex_temperature(
    const VertexTemperatureInput& input, std::shared_ptr<const geometry::Scene> scene);

/// Whether a mesh gives every vertex a value of its own.
[[nodiscard]] bool has_vertex_values(const geometry::TriangleMesh& mesh) noexcept;

/// What a material with temperatures by vertex asks of each mesh that wears it.
/// @param name  of the mesh's file, for messages
/// @throws InputError for a mesh without values, or with one that gives less than 0 or more than
///         6000 K
void check_vertex_temperature(const geometry::TriangleMesh& mesh,
                              const VertexTemperatureInput& input, const std::string& name);

}  // namespace nadir::sim
