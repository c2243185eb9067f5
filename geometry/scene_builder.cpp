#include "geometry/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "geometry/scene_gather.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

/// Beyond this the squares of Embree's float arithmetic come near to overflow.
constexpr double farthest_m = 1e15;

/// Beyond this a float no longer tells the pixels of a map apart.
constexpr double farthest_texture = 1e6;

/// Beyond this Embree's float transforms overflow when they are inverted.
constexpr double smallest_scale = 1e-6;

void check_placement(const Affine& placement) {
  const Mat3& m = placement.linear;
  const double size = length(m.x) * length(m.y) * length(m.z);
  // 1e-12: a parallelepiped this flat has lost its inverse to rounding.
  const bool regular = std::isfinite(size) && std::abs(m.determinant()) > 1e-12 * size;
  if (!regular || !is_finite(placement.origin)) {
    throw InputError{"the placement is singular or not finite: every scale must differ from zero"};
  }
  for (const Vec3& column : {m.x, m.y, m.z}) {
    if (length(column) >= smallest_scale && length(column) <= 1.0 / smallest_scale) continue;
    throw InputError{"the placement scales by " + std::to_string(length(column)) +
                     ", allowed are factors from 1e-6 to 1e6"};
  }
}

void check_indices(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InputError{"the mesh has no triangles"};
  if (!mesh.parts.empty() && mesh.parts.size() != mesh.triangles.size()) {
    throw InputError{"the mesh names parts for " + std::to_string(mesh.parts.size()) + " of its " +
                     std::to_string(mesh.triangles.size()) + " triangles"};
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex < mesh.positions.size()) continue;
      throw InputError{"triangle " + std::to_string(i) + " names vertex " + std::to_string(vertex) +
                       ", but there are " + std::to_string(mesh.positions.size())};
    }
  }
}

void set_materials(GatheredItem& item, const TriangleMesh& mesh,
                   const std::vector<std::uint32_t>& part_materials) {
  const auto material_of = [&](std::uint32_t part) {
    if (part < part_materials.size()) return part_materials[part];
    const std::string name =
        part < mesh.part_names.size() ? " (" + mesh.part_names[part] + ")" : "";
    throw InputError{"part " + std::to_string(part) + name + " of the mesh has no material"};
  };
  item.material = material_of(mesh.parts.empty() ? 0 : mesh.parts.front());
  for (const std::uint32_t part : mesh.parts) item.triangle_materials.push_back(material_of(part));
  const auto same = [&](std::uint32_t m) { return m == item.material; };
  if (std::all_of(item.triangle_materials.begin(), item.triangle_materials.end(), same)) {
    item.triangle_materials = {};
  }
}

void set_texture(GatheredItem& item, const TriangleMesh& mesh) {
  if (!mesh.texture.empty() && mesh.texture.size() != mesh.positions.size()) {
    throw InputError{"the mesh has texture coordinates for " + std::to_string(mesh.texture.size()) +
                     " of its " + std::to_string(mesh.positions.size()) + " vertices"};
  }
  item.texture.reserve(mesh.texture.size());
  for (const Vec2& at : mesh.texture) {
    if (!(std::abs(at.x) <= farthest_texture && std::abs(at.y) <= farthest_texture)) {
      throw InputError{"the texture coordinates of vertex " + std::to_string(item.texture.size()) +
                       " are not finite or beyond 1e6"};
    }
    item.texture.push_back({static_cast<float>(at.x), static_cast<float>(at.y)});
  }
}

void set_vertex_values(GatheredItem& item, const TriangleMesh& mesh) {
  if (!mesh.vertex_values.empty() && mesh.vertex_values.size() != mesh.positions.size()) {
    throw InputError{"the mesh has values for " + std::to_string(mesh.vertex_values.size()) +
                     " of its " + std::to_string(mesh.positions.size()) + " vertices"};
  }
  const auto& values = mesh.vertex_values;
  const auto bad =
      std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
  if (bad != values.end()) {
    throw InputError{"the value of vertex " + std::to_string(bad - values.begin()) +
                     " is not finite"};
  }
  item.vertex_values = values;
}

void gather_mesh(GatheredItem& item, const TriangleMesh& mesh, const Affine& placement) {
  check_indices(mesh);
  item.triangles = mesh.triangles;
  item.positions.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    // Infinity less infinity would be what the placement makes of it: looked at before.
    const bool finite = is_finite(mesh.positions[i]);
    const Vec3 position = finite ? placement.point(mesh.positions[i]) : mesh.positions[i];
    if (!is_finite(position) || largest(position) > farthest_m) {
      throw InputError{"vertex " + std::to_string(i) + " is not finite or beyond 1e15 m"};
    }
    item.positions.push_back(position);
    item.bounds = merged(item.bounds, position);
  }
}

void gather_shape(GatheredItem& item, const Shape& shape, const Affine& placement) {
  validate(shape);
  item.shape = shape;
  item.placement = placement;
  item.bounds = bounds_of(shape, placement);
  if (!is_finite(item.bounds.lo) || !is_finite(item.bounds.hi) ||
      std::max(largest(item.bounds.lo), largest(item.bounds.hi)) > farthest_m) {
    throw InputError{"the shape reaches beyond 1e15 m"};
  }
}

}  // namespace

GatheredItem gather(const Surface& surface, const Affine& placement, std::uint32_t object) {
  check_placement(placement);
  GatheredItem item;
  item.object = object;
  item.epochs = surface.epochs;
  item.mirrored = placement.linear.determinant() < 0.0;
  if (const auto* mesh = std::get_if<TriangleMesh>(&surface.form)) {
    gather_mesh(item, *mesh, placement);
    set_texture(item, *mesh);
    set_vertex_values(item, *mesh);
    set_materials(item, *mesh, surface.part_materials);
  } else {
    gather_shape(item, std::get<Shape>(surface.form), placement);
    if (surface.part_materials.empty()) throw InputError{"the shape has no material"};
    item.material = surface.part_materials.front();
  }
  return item;
}

SceneBuilder::SceneBuilder() : state_{std::make_unique<State>()} {}
SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(SceneBuilder&&) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&&) noexcept = default;

void SceneBuilder::add(const Surface& surface, const Affine& placement, std::uint32_t object) {
  state_->items.push_back(gather(surface, placement, object));
}

void SceneBuilder::add_instances(const std::vector<Surface>& prototype,
                                 const std::vector<Affine>& placements, std::uint32_t object) {
  if (prototype.empty()) throw InputError{"the prototype has no surfaces"};
  GatheredPrototype gathered;
  gathered.object = object;
  gathered.placements = placements;
  for (const Surface& surface : prototype) {
    gathered.items.push_back(gather(surface, Affine{}, object));
    gathered.bounds = merged(gathered.bounds, gathered.items.back().bounds);
  }
  for (const Affine& placement : placements) {
    check_placement(placement);
    const Bounds placed = transformed(gathered.bounds, placement);
    if (!(std::max(largest(placed.lo), largest(placed.hi)) <= farthest_m)) {
      throw InputError{"a placement reaches beyond 1e15 m"};
    }
  }
  if (!placements.empty()) state_->prototypes.push_back(std::move(gathered));
}

Scene SceneBuilder::build() {
  const std::unique_ptr<State> gathered = std::exchange(state_, std::make_unique<State>());
  return assemble(*gathered);
}

}  // namespace nadir::geometry
