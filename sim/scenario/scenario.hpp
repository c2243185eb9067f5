#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "ephemeris/instant.hpp"
#include "geometry/earth.hpp"
#include "geometry/shapes.hpp"
#include "materials/solver_settings.hpp"
#include "radiometry/method.hpp"
#include "sim/scenario/air_input.hpp"
#include "sim/scenario/camera_input.hpp"
#include "sim/scenario/effects_input.hpp"
#include "sim/scenario/heat_input.hpp"
#include "sim/scenario/lamp_input.hpp"
#include "sim/scenario/material_input.hpp"
#include "sim/scenario/placement_input.hpp"
#include "sim/scenario/platform_input.hpp"
#include "sim/scenario/results_input.hpp"
#include "sim/scenario/spectral_input.hpp"
#include "sim/scenario/volume_input.hpp"

// What a scenario file says, as plain data: checked for form, units and ranges, names resolved to
// indices, files named by absolute path but not yet read. Units are in the names.

namespace nadir::sim {

// ---- light ------------------------------------------------------------------------------------

/// Sun and moon where an ephemeris puts them for the scenario's instant and site.
struct ComputedSky {
  std::optional<SpectralInput> solar_irradiance;  ///< W m^-2 um^-1 at 1 AU; none: the library's
  std::optional<SpectralInput> lunar_irradiance;  ///< W m^-2 um^-1 as it arrives; none: modelled
  // What no effect needs is not read (drop_effects); the bodies' places are always known.
  bool sun_shines = true, moon_shines = true, eclipses = true;
};
/// A body at given angles.
struct FixedBody {
  std::string name;
  double azimuth_deg = 0.0;  ///< clockwise from north
  double elevation_deg = 0.0;
  double angular_radius_deg = 0.2666;
  SpectralInput irradiance;  ///< W m^-2 um^-1 on a plane normal to the direction
};
struct FixedSky {
  std::vector<FixedBody> bodies;
};
using IlluminationInput = std::variant<ComputedSky, FixedSky>;

// ---- materials and geometry -------------------------------------------------------------------

/// A part of a mesh (as named in its file) and its material. An empty part means all others.
struct PartMaterial {
  std::string part;
  int material = 0;  ///< index into Scenario::materials; beyond them, into Scenario::maps
};

struct MeshInput {
  std::filesystem::path file;  ///< .obj or .ply
  std::vector<PartMaterial> parts;
};
struct ShapeInput {
  geometry::Shape shape;
  int material = 0;
};
using FormInput = std::variant<MeshInput, ShapeInput>;

/// When an object is there: [from, until). Without either it always is.
struct PresenceInput {
  std::optional<ephemeris::Instant> from, until;
};

struct TerrainInput {
  std::string name;
  std::filesystem::path raster;
  double height_offset_m = 0.0;  ///< added to the raster's values: its datum above the ellipsoid
  int material = 0;
};
struct ObjectInput {
  std::string name;
  FormInput form;
  PlacementInput placement;
  PresenceInput presence{};
};
/// A prototype placed by a list. Lists may nest: a prototype may itself be placed by lists.
struct InstancesInput {
  std::string name;
  std::filesystem::path list;  ///< CSV of placements
  bool on_terrain = false;     ///< up in the list counts from the terrain
  std::vector<ObjectInput> objects;
  std::vector<InstancesInput> nested;
  PresenceInput presence{};
};
using GeometryInput = std::variant<TerrainInput, ObjectInput, InstancesInput>;

struct Scenario {
  std::filesystem::path file;
  std::string name;
  std::string title;
  ephemeris::Instant time = ephemeris::Instant::parse_utc("2000-01-01T12:00:00Z");
  geometry::Geodetic origin;  ///< of the scene's axes
  IlluminationInput illumination;
  AirInput air;
  std::optional<HeatInput> heat;     ///< weather, and how the heat balance is solved
  materials::SolverSettings solver;  ///< of the generic solver
  radiometry::Method method = radiometry::Method::generic;
  int path_max_bounces = 0;                      ///< of the path solver; 0: no limit
  std::vector<std::filesystem::path> libraries;  ///< of materials, which were read
  std::vector<MaterialInput> materials;  ///< after those of the file those that contrast maps add,
                                         ///< then those that geometry sets apart by temperature
  std::vector<MaterialMapInput> maps;
  std::vector<GeometryInput> geometry;
  std::vector<VolumeInput> volumes;
  std::vector<LampInput> lamps;
  PlatformInput platform;
  CameraInput camera;
  EffectsInput effects;
  AccuracyInput accuracy;
  SamplingInput sampling;
  ProductsInput products;
};

}  // namespace nadir::sim
