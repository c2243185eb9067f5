#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/scene_data.hpp"
#include "geometry/scene_gather.hpp"

namespace nadir::geometry {
namespace {

using embree::GeometryHandle;
using embree::SceneHandle;

// Rays in a prototype's axes carry the rounding of the scene's coordinates and of the transform.
constexpr double padding_steps = 16.0;

#ifdef NADIR_ONE_THREAD_OF_EMBREE  // the thread sanitizer cannot see what keeps its threads in
                                   // order
constexpr const char* device_settings = "threads=1,set_affinity=0";
#else
constexpr const char* device_settings = "threads=0,set_affinity=0";
#endif

void check(RTCDevice device, const char* what) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  const char* why = error == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "error ";
  throw std::runtime_error{std::string{"Embree, "} + what + ": " + why +
                           (error == RTC_ERROR_OUT_OF_MEMORY ? "" : std::to_string(error))};
}

SceneHandle new_scene(RTCDevice device) {
  SceneHandle scene{rtcNewScene(device)};
  check(device, "new scene");
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST | embree::filter_from_caller);
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  return scene;
}

/// Which geometry of its Embree scene something is, and when rays see it.
struct Attached {
  std::size_t number;
  std::uint32_t epochs;
};

void attach(RTCScene scene, const GeometryHandle& geometry, Attached as) {
  rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_MEDIUM);
  rtcSetGeometryMask(geometry.get(), as.epochs);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(scene, geometry.get(), static_cast<unsigned>(as.number));
}

template <class T>
T* new_buffer(RTCDevice device, const GeometryHandle& geometry, RTCBufferType type,
              RTCFormat format, std::size_t count) {
  auto* data = static_cast<T*>(
      rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, 3 * sizeof(T), count));
  if (!data) check(device, "buffer of a mesh");
  return data;
}

void attach_mesh(RTCDevice device, RTCScene scene, std::size_t number, const GatheredItem& from,
                 Vec3 centre, Item& item) {
  const GeometryHandle geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)};
  auto* vertices = new_buffer<float>(device, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                     from.positions.size());
  auto* triangles = new_buffer<std::uint32_t>(device, geometry, RTC_BUFFER_TYPE_INDEX,
                                              RTC_FORMAT_UINT3, from.triangles.size());
  item.vertices = vertices;
  item.triangles = triangles;
  for (const Vec3& position : from.positions) {
    const Vec3 p = position - centre;
    *vertices++ = static_cast<float>(p.x);
    *vertices++ = static_cast<float>(p.y);
    *vertices++ = static_cast<float>(p.z);
  }
  for (const auto& triangle : from.triangles) {
    triangles = std::copy(triangle.begin(), triangle.end(), triangles);
  }
  attach(scene, geometry, {number, from.epochs});
}

void attach_shape(RTCDevice device, RTCScene scene, std::size_t number, const GatheredItem& from,
                  Vec3 centre, double padding, Item& item) {
  const GeometryHandle geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER)};
  const Affine to_scene{from.placement.linear, from.placement.origin - centre};
  const Vec3 room{padding, padding, padding};
  item.shape = PlacedShape{*from.shape,
                           to_scene,
                           to_scene.inverse(),
                           {from.bounds.lo - centre - room, from.bounds.hi - centre + room}};
  attach_shape_callbacks(geometry.get(), &item);
  attach(scene, geometry, {number, from.epochs});
}

/// Fills `items`, whose addresses Embree keeps, and attaches them as geometries 0, 1, ...
void attach_items(RTCDevice device, RTCScene scene, const std::vector<GatheredItem>& from,
                  Vec3 centre, double padding, std::vector<Item>& items) {
  items.resize(from.size());
  std::uint64_t facets = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    items[i].triangle_materials = from[i].triangle_materials;
    items[i].texture = from[i].texture;
    items[i].vertex_values = from[i].vertex_values;
    items[i].first_facet = facets;
    facets += from[i].facets();
    items[i].material = from[i].material;
    items[i].object = from[i].object;
    items[i].mirrored = from[i].mirrored;
    if (from[i].shape) {
      attach_shape(device, scene, i, from[i], centre, padding, items[i]);
    } else {
      attach_mesh(device, scene, i, from[i], centre, items[i]);
    }
  }
}

/// The most that a placement's inverse stretches (Frobenius norm, an upper bound).
double stretch_back(const std::vector<Affine>& placements) {
  double largest_squared = 0.0;
  for (const Affine& placement : placements) {
    const Mat3 m = placement.linear.inverse();
    largest_squared = std::max(largest_squared, dot(m.x, m.x) + dot(m.y, m.y) + dot(m.z, m.z));
  }
  return std::sqrt(largest_squared);
}

/// Columns of the transform from the prototype's axes about its centre to the scene's about its
/// own, as Embree gets them.
std::array<float, 12> columns_of(const Affine& placement, Vec3 prototype_centre,
                                 Vec3 scene_centre) {
  const Mat3& m = placement.linear;
  const Vec3 origin = placement.point(prototype_centre) - scene_centre;
  std::array<float, 12> columns{};
  auto* out = columns.data();
  for (const Vec3& column : {m.x, m.y, m.z, origin}) {
    *out++ = static_cast<float>(column.x);
    *out++ = static_cast<float>(column.y);
    *out++ = static_cast<float>(column.z);
  }
  return columns;
}

void attach_instances(Scene::Data& data, const GatheredPrototype& from, Vec3 prototype_centre) {
  const auto prototype = static_cast<std::uint32_t>(data.prototypes.size() - 1);
  std::uint32_t epochs = 0;  // its items have their own: the instance's spares rays the way to them
  for (const GatheredItem& item : from.items) epochs |= item.epochs;
  for (std::size_t i = 0; i < from.placements.size(); ++i) {
    const auto columns = columns_of(from.placements[i], prototype_centre, data.centre);
    const GeometryHandle geometry{rtcNewGeometry(data.device.get(), RTC_GEOMETRY_TYPE_INSTANCE)};
    rtcSetGeometryInstancedScene(geometry.get(), data.prototypes.back().scene.get());
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    attach(data.top.get(), geometry, {data.items.size() + data.instances.size(), epochs});
    data.instances.push_back({prototype, from.object, static_cast<std::uint32_t>(i), false});
    // Of the rounded transform: it is the one that surfaces are placed by.
    Instance& instance = data.instances.back();
    instance.mirrored = data.placement(instance).linear.determinant() < 0.0;
  }
}

void add_prototype(Scene::Data& data, const GatheredPrototype& from) {
  const Vec3 centre = centre_of(from.bounds);
  const double room =
      padding_steps * float_step *
      (largest(from.bounds.hi - centre) + data.extent * stretch_back(from.placements));
  Prototype& prototype = data.prototypes.emplace_back();
  prototype.scene = new_scene(data.device.get());
  attach_items(data.device.get(), prototype.scene.get(), from.items, centre, room, prototype.items);
  rtcCommitScene(prototype.scene.get());
  check(data.device.get(), "building a prototype");
  for (const GatheredItem& item : from.items) prototype.facets += item.facets();
  prototype.first_instance = data.instances.size();
  prototype.first_facet = data.facets;
  data.facets += prototype.facets * from.placements.size();
  attach_instances(data, from, centre);
}

void count(Scene::Data& data, const SceneBuilder::State& state) {
  for (const GatheredItem& item : state.items) {
    data.stored += item.primitives();
    data.represented += item.primitives();
    data.facets += item.facets();
  }
  for (const GatheredPrototype& prototype : state.prototypes) {
    std::uint64_t primitives = 0;
    for (const GatheredItem& item : prototype.items) primitives += item.primitives();
    data.stored += primitives;
    data.represented += primitives * prototype.placements.size();
  }
}

bool has_epochs(const std::vector<GatheredItem>& items) {
  return std::any_of(items.begin(), items.end(),
                     [](const GatheredItem& item) { return item.epochs != always; });
}

/// Without masks Embree would show everything at all times, and say nothing.
void check_masks(RTCDevice device, const SceneBuilder::State& state) {
  bool needed = has_epochs(state.items);
  for (const GatheredPrototype& prototype : state.prototypes) {
    needed = needed || has_epochs(prototype.items);
  }
  if (!needed || rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) != 0) return;
  throw std::runtime_error{
      "this Embree was built without ray masks (EMBREE_RAY_MASK): objects cannot be there at some "
      "times only"};
}

void set_bounds(Scene::Data& data, const SceneBuilder::State& state) {
  Bounds all = no_bounds;
  for (const GatheredItem& item : state.items) all = merged(all, item.bounds);
  for (const GatheredPrototype& prototype : state.prototypes) {
    for (const Affine& placement : prototype.placements) {
      all = merged(all, transformed(prototype.bounds, placement));
    }
  }
  if (data.stored == 0) all = {};
  data.bounds = all;
  data.centre = centre_of(all);
  data.extent = largest(all.hi - data.centre);
  const double padding = padding_steps * float_step * data.extent;
  const Vec3 room{padding, padding, padding};
  data.padded = {all.lo - data.centre - room, all.hi - data.centre + room};
}

}  // namespace

Scene assemble(const SceneBuilder::State& state) {
  auto data = std::make_shared<Scene::Data>();
  // Threads are TBB's affair. Without flush-to-zero: double arithmetic must not depend on callers.
  data->device = embree::Device{rtcNewDevice(device_settings)};
  if (!data->device) check(nullptr, "new device");
  check_masks(data->device.get(), state);
  data->top = new_scene(data->device.get());
  count(*data, state);
  set_bounds(*data, state);
  attach_items(data->device.get(), data->top.get(), state.items, data->centre,
               padding_steps * float_step * data->extent, data->items);
  std::size_t placements = 0;
  for (const GatheredPrototype& prototype : state.prototypes) {
    placements += prototype.placements.size();
  }
  data->instances.reserve(placements);  // grown by doubling it would waste a third
  data->prototypes.reserve(state.prototypes.size());
  for (const GatheredPrototype& prototype : state.prototypes) add_prototype(*data, prototype);
  rtcCommitScene(data->top.get());
  check(data->device.get(), "building the scene");
  return Scene{std::move(data)};
}

}  // namespace nadir::geometry
