#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/schema.hpp"

// Short forms for the lines of the table, and its parts by family of elements.

namespace nadir::sim {

inline Attribute required(std::string name, AttributeType type, std::string unit, std::string doc) {
  return {std::move(name), std::move(type), std::move(unit), Presence::required, {},
          std::move(doc)};
}
inline Attribute defaulted(std::string name, AttributeType type, std::string unit,
                           std::string value, std::string doc) {
  return {std::move(name),     std::move(type),  std::move(unit),
          Presence::defaulted, std::move(value), std::move(doc)};
}
/// @param without  what holds where the attribute is not given
inline Attribute optional(std::string name, AttributeType type, std::string unit,
                          std::string without, std::string doc) {
  return {std::move(name),    std::move(type),    std::move(unit),
          Presence::optional, std::move(without), std::move(doc)};
}

inline NumberType from_to(double min, double max) { return {min, max, false, false}; }
inline NumberType above_to(double min, double max) { return {min, max, true, false}; }
/// Coordinates in metres: a thousand times the distance of a geostationary satellite would not
/// make sense in axes that stand on one place of the earth.
inline NumberType coordinate() { return from_to(-1e8, 1e8); }
/// From 0 K to the hottest black body for which the Planck function is tested.
inline NumberType temperature() { return from_to(0.0, 6000.0); }
/// The same in degrees Celsius.
inline NumberType celsius() { return from_to(-273.15, 5726.85); }
/// Of a raster; as many as the formats know.
inline IntegerType band_number() { return {1, 65535}; }
/// A reflectance, an albedo: a number or a spectrum.
inline SpectralType fraction() { return {from_to(0.0, 1.0)}; }
inline NumberType latitude() { return from_to(-90.0, 90.0); }
inline NumberType longitude() { return from_to(-180.0, 360.0); }
inline NumberType full_turn() { return from_to(-360.0, 360.0); }

[[nodiscard]] std::vector<ElementType> schema_of_root();
[[nodiscard]] std::vector<ElementType> schema_of_light();
[[nodiscard]] std::vector<ElementType> schema_of_air();
[[nodiscard]] std::vector<ElementType> schema_of_heat();
[[nodiscard]] std::vector<ElementType> schema_of_solver();
[[nodiscard]] std::vector<ElementType> schema_of_materials();
[[nodiscard]] std::vector<ElementType> schema_of_scattering();
/// Sources of temperature, as children of a material.
[[nodiscard]] std::vector<ElementType> schema_of_temperature();
[[nodiscard]] std::vector<Child> temperature_children();
/// A temperature as two attributes, in K and in deg C, of which the file gives one.
[[nodiscard]] std::vector<Attribute> temperature_pair(const std::string& name,
                                                      const std::string& without,
                                                      const std::string& doc);
/// What objects and parts of meshes may say in place of their material's temperature.
[[nodiscard]] std::vector<Attribute> own_temperature();
[[nodiscard]] std::vector<ElementType> schema_of_maps();
/// What a map has of its own, then where it lies.
[[nodiscard]] std::vector<Attribute> map_placement(std::vector<Attribute> own);
/// The scattering models, as children of a material.
[[nodiscard]] std::vector<Child> scattering_children();
[[nodiscard]] std::vector<ElementType> schema_of_geometry();
/// Where something stands in the scene and how it is turned.
[[nodiscard]] std::vector<Attribute> scene_placement();
[[nodiscard]] std::vector<ElementType> schema_of_volumes();
[[nodiscard]] std::vector<ElementType> schema_of_lamps();
[[nodiscard]] std::vector<ElementType> schema_of_platform();
[[nodiscard]] std::vector<ElementType> schema_of_camera();
/// What stands in a camera's arrays.
[[nodiscard]] std::vector<ElementType> schema_of_camera_parts();
[[nodiscard]] std::vector<ElementType> schema_of_effects();
[[nodiscard]] std::vector<ElementType> schema_of_results();

}  // namespace nadir::sim
