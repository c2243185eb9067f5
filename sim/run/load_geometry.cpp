#include "sim/run/load_geometry.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "geometry/scene_builder.hpp"
#include "geometry/terrain.hpp"
#include "sim/files/instance_list.hpp"
#include "sim/files/raster.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/load_lamps.hpp"
#include "sim/run/load_temperature.hpp"
#include "sim/run/place.hpp"
#include "sim/run/read_surface.hpp"

namespace nadir::sim {
namespace {

std::string file_of(const ObjectInput& input) {
  const auto* mesh = std::get_if<MeshInput>(&input.form);
  return mesh != nullptr ? mesh->file.string() : input.name;
}

/// kelvin of the hottest vertex.
double hottest_of(const geometry::TriangleMesh& mesh, const VertexTemperatureInput& input) {
  double hottest_k = 0.0;
  for (const float value : mesh.vertex_values) {
    hottest_k = std::max(hottest_k, input.gain * static_cast<double>(value) + input.offset_k);
  }
  return hottest_k;
}

/// Gathers the scenario's geometry object by object; the terrain first, since others stand on it.
class GeometryReader {
 public:
  GeometryReader(const Scenario& scenario, const geometry::LocalFrame& frame, const Epochs& epochs,
                 InputFiles& files)
      : scenario_{&scenario}, frame_{&frame}, epochs_{&epochs}, files_{&files} {}

  void add_terrain(const TerrainInput& input, std::uint32_t object) {
    const auto grid = read_height_grid(files_->note(input.raster), input.height_offset_m);
    const geometry::Surface surface{geometry::terrain_mesh(grid, *frame_),
                                    {static_cast<std::uint32_t>(input.material)}};
    geometry::SceneBuilder alone;
    alone.add(surface, Affine{}, object);
    terrain_ = TerrainProbe{alone.build()};
    builder_.add(surface, Affine{}, object);
  }

  void add_object(const ObjectInput& input, std::uint32_t object) {
    builder_.add(surface_of(input, input.presence), placed(input.placement, terrain_), object);
  }

  void add_instances(const InstancesInput& input, std::uint32_t object) {
    add_nested(input, {Affine{}}, input.presence, object);
  }

  void add_lamps(const Scenario& scenario) {
    LoadedLamps loaded = load_lamps(scenario, terrain_,
                                    static_cast<std::uint32_t>(scenario.geometry.size()), *files_);
    for (const LampSurface& lamp : loaded.surfaces) {
      builder_.add(lamp.surface, lamp.placement, lamp.object);
    }
    lamps_ = std::move(loaded.lamps);
  }

  [[nodiscard]] LoadedGeometry finish() {
    return {builder_.build(), terrain_, std::move(lamps_), std::move(hottest_vertex_k_)};
  }

 private:
  [[nodiscard]] geometry::Surface surface_of(const ObjectInput& input,
                                             const PresenceInput& presence) {
    geometry::Surface surface = read_surface(input.form, *files_);
    surface.epochs = epochs_->of(presence);
    take_vertex_temperatures(surface, file_of(input));
    return surface;
  }

  /// A material that takes its temperature from the vertices needs a mesh that gives them.
  void take_vertex_temperatures(const geometry::Surface& surface, const std::string& name) {
    // A shape has no vertices: it is as a mesh that gives nothing.
    const auto* form = std::get_if<geometry::TriangleMesh>(&surface.form);
    const geometry::TriangleMesh& mesh = form != nullptr ? *form : no_mesh_;
    for (const std::uint32_t index : surface.part_materials) {
      if (index >= scenario_->materials.size()) continue;  // a map
      const auto* wanted =
          std::get_if<VertexTemperatureInput>(&scenario_->materials[index].temperature);
      if (wanted == nullptr) continue;
      check_vertex_temperature(mesh, *wanted, name);
      double& hottest_k = hottest_vertex_k_[index];
      hottest_k = std::max(hottest_k, hottest_of(mesh, *wanted));
    }
  }

  [[nodiscard]] std::vector<Affine> read_list(const InstancesInput& input) {
    std::vector<Affine> placements;
    ErrorList errors;
    for (Placement& placement : read_instance_list(files_->note(input.list))) {
      const std::string row = "line " + std::to_string(placement.line);
      errors.attempt(row, input.list.string(), [&] {
        if (input.on_terrain) placement.position = terrain_.lifted(placement.position);
        placements.push_back(affine(placement));
      });
    }
    errors.throw_if_any();
    return placements;
  }

  /// Distributions' Embree has one instance level, so lists within lists become one long list.
  void add_nested(const InstancesInput& input, const std::vector<Affine>& outer,
                  const PresenceInput& presence, std::uint32_t object) {
    const std::vector<Affine> placements = flatten(outer, read_list(input));
    for (const ObjectInput& part : input.objects) {
      const Affine own = placed(part.placement, terrain_);
      std::vector<Affine> of_part;
      std::transform(placements.begin(), placements.end(), std::back_inserter(of_part),
                     [&](const Affine& placement) { return placement * own; });
      builder_.add_instances({surface_of(part, presence)}, of_part, object);
    }
    for (const InstancesInput& nested : input.nested)
      add_nested(nested, placements, presence, object);
  }

  const Scenario* scenario_;
  const geometry::LocalFrame* frame_;
  const Epochs* epochs_;
  InputFiles* files_;
  geometry::SceneBuilder builder_;
  TerrainProbe terrain_;
  std::vector<radiometry::Lamp> lamps_;
  std::map<std::uint32_t, double> hottest_vertex_k_;
  geometry::TriangleMesh no_mesh_;
};

}  // namespace

LoadedGeometry load_geometry(const Scenario& scenario, const geometry::LocalFrame& frame,
                             const Epochs& epochs, InputFiles& files) {
  GeometryReader reader{scenario, frame, epochs, files};
  ErrorList errors;
  const auto number_of = [&](const GeometryInput& input) {
    return static_cast<std::uint32_t>(&input - scenario.geometry.data());
  };
  for (const GeometryInput& input : scenario.geometry) {
    if (const auto* terrain = std::get_if<TerrainInput>(&input)) {
      errors.attempt("terrain " + terrain->name, scenario.file.string(),
                     [&] { reader.add_terrain(*terrain, number_of(input)); });
    }
  }
  errors.throw_if_any();  // without its terrain every object on it would be a mistake of its own
  for (const GeometryInput& input : scenario.geometry) {
    const std::string name = std::visit([](const auto& named) { return named.name; }, input);
    errors.attempt("object " + name, scenario.file.string(), [&] {
      if (const auto* object = std::get_if<ObjectInput>(&input)) {
        reader.add_object(*object, number_of(input));
      } else if (const auto* instances = std::get_if<InstancesInput>(&input)) {
        reader.add_instances(*instances, number_of(input));
      }
    });
  }
  errors.attempt([&] { reader.add_lamps(scenario); });
  errors.throw_if_any();
  return reader.finish();
}

}  // namespace nadir::sim
