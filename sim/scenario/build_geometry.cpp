#include <fmt/format.h>

#include <set>

#include "sim/scenario/build_context.hpp"
#include "sim/scenario/build_temperature.hpp"
#include "sim/scenario/material_variants.hpp"

namespace nadir::sim {
namespace {

namespace geo = nadir::geometry;

/// Only PLY files carry temperatures of vertices.
bool may_have_vertices(const CheckedElement& mesh) {
  const std::string suffix = mesh.value<std::filesystem::path>("file").extension().string();
  return suffix.size() == 4 && (suffix[1] == 'p' || suffix[1] == 'P');
}

class GeometryBuilder {
 public:
  GeometryBuilder(const BuildContext& context, const CheckedElement& geometry,
                  MaterialNames& materials, Scenario& scenario)
      : context_{context},
        scenario_{scenario},
        materials_{context, geometry, materials, scenario},
        has_terrain_{geometry.child("terrain") != nullptr} {}

  TerrainInput terrain(const CheckedElement& element) {
    return {name_of(element), element.value<std::filesystem::path>("raster"),
            element.number("height_offset_m"), material_of(element, false)};
  }

  ObjectInput object(const CheckedElement& element) {
    return {name_of(element), form(element), build_placement(context_, element, has_terrain_),
            presence(element)};
  }

  InstancesInput instances(const CheckedElement& element) {
    InstancesInput list{name_of(element),
                        element.value<std::filesystem::path>("list"),
                        build_on_terrain(context_, element, has_terrain_),
                        {},
                        {},
                        presence(element)};
    for (const CheckedElement& child : element.children) {
      if (child.type->name == "instances") {
        list.nested.push_back(instances(child));
      } else {
        list.objects.push_back(object(child));
      }
    }
    return list;
  }

 private:
  static std::string name_of(const CheckedElement& element) {
    return element.find<std::string>("name").value_or(element.type->name);
  }

  int material_of(const CheckedElement& element, bool vertices) {
    const int material = materials_.resolve(element);
    if (!vertices) refuse_vertices(context_, element, material, scenario_);
    return material;
  }

  [[nodiscard]] PresenceInput presence(const CheckedElement& element) {
    const PresenceInput there{element.find<ephemeris::Instant>("present_from"),
                              element.find<ephemeris::Instant>("present_until")};
    if (there.from && there.until && (*there.until - *there.from).value <= 0.0) {
      context_.mistake(
          element.where("present_until"),
          fmt::format("present_until of <{}> must be later than present_from", element.type->name));
    } else if (there.from && (*there.from - scenario_.time).value > 0.0) {
      context_.warn(element.where("present_from"),
                    fmt::format("<{}> comes after the moment of the image: it is never there",
                                element.type->name));
    }
    count_times(element, there);
    return there;
  }

  /// Rays tell so many spans of time apart (geometry::Ray::epochs): one begins at each of these.
  void count_times(const CheckedElement& element, const PresenceInput& there) {
    constexpr std::size_t most = 31;
    for (const auto& [attribute, time] :
         {std::pair{"present_from", there.from}, std::pair{"present_until", there.until}}) {
      if (!time || (*time - scenario_.time).value > 0.0) continue;
      const bool is_new = times_.insert(time->to_string()).second;
      if (!is_new || times_.size() != most + 1) continue;
      context_.mistake(element.where(attribute),
                       fmt::format("objects come and go at more than {} different times up to the "
                                   "image",
                                   most));
    }
  }

  FormInput form(const CheckedElement& element) {
    if (element.type->name == "mesh") return mesh(element);
    const int material = material_of(element, false);
    return ShapeInput{shape(element), material};
  }

  MeshInput mesh(const CheckedElement& element) {
    MeshInput mesh{element.value<std::filesystem::path>("file"), {}};
    const bool vertices = may_have_vertices(element);
    std::vector<const CheckedElement*> parts;
    for (const CheckedElement& part : element.children) {
      parts.push_back(&part);
      mesh.parts.push_back({part.value<std::string>("name"), material_of(part, vertices)});
    }
    context_.check_unique(parts, "part");
    if (element.gives("material")) {
      mesh.parts.push_back({{}, material_of(element, vertices)});
    } else if (parts.empty()) {
      context_.mistake(element.offset, "<mesh> has neither a material nor a <part>",
                       "write material=\"name\" for the whole mesh");
    }
    return mesh;
  }

  [[nodiscard]] geo::Shape shape(const CheckedElement& element) const {
    const std::string& kind = element.type->name;
    if (kind == "sphere") return geo::Sphere{{}, element.number("radius_m")};
    if (kind == "disc") return disc(element);
    if (kind == "box") return build_box(context_, element);
    if (kind == "cylinder") return build_cylinder(context_, element);
    return geo::Plane{{}, element.number("size_x_m"), element.number("size_y_m")};
  }

  [[nodiscard]] geo::Disc disc(const CheckedElement& element) const {
    const auto normal = element.find<Vec3>("normal");
    if (normal && length(*normal) == 0.0) {
      context_.mistake(element.where("normal"), "the normal of <disc> has no length");
    }
    return {{},
            normal && length(*normal) > 0.0 ? normalised(*normal) : Vec3{0.0, 0.0, 1.0},
            element.number("radius_m")};
  }

  const BuildContext& context_;
  Scenario& scenario_;
  MaterialVariants materials_;
  bool has_terrain_;
  std::set<std::string> times_;  // at which something comes or goes
};

}  // namespace

bool build_on_terrain(const BuildContext& context, const CheckedElement& element,
                      bool has_terrain) {
  const bool on = element.flag("on_terrain");
  if (on && !has_terrain) {
    context.mistake(element.where("on_terrain"),
                    fmt::format("<{}> stands on the terrain, but <geometry> has no <terrain>",
                                element.type->name));
  }
  return on;
}

PlacementInput build_placement(const BuildContext& context, const CheckedElement& element,
                               bool has_terrain) {
  return {{element.number("east_m"), element.number("north_m"), element.number("up_m")},
          element.number("yaw_deg"),
          element.number("pitch_deg"),
          element.number("roll_deg"),
          element.find<Vec3>("scale").value_or(Vec3{1.0, 1.0, 1.0}),
          build_on_terrain(context, element, has_terrain)};
}

geo::Box build_box(const BuildContext& context, const CheckedElement& element) {
  const auto lo = element.find<Vec3>("lo_m"), hi = element.find<Vec3>("hi_m");
  if (lo && hi && !(lo->x < hi->x && lo->y < hi->y && lo->z < hi->z)) {
    context.mistake(element.where("hi_m"), "each number of hi_m must be greater than that of lo_m");
  }
  return {lo.value_or(Vec3{}), hi.value_or(Vec3{})};
}

geo::Cylinder build_cylinder(const BuildContext& context, const CheckedElement& element) {
  const auto base = element.find<Vec3>("base_m"), top = element.find<Vec3>("top_m");
  if (base && top && *base == *top) {
    context.mistake(element.where("top_m"), "base_m and top_m of <cylinder> are the same place");
  }
  return {base.value_or(Vec3{}), top.value_or(Vec3{}), element.number("radius_m"),
          element.flag("capped")};
}

void build_geometry(const BuildContext& context, const CheckedElement& element,
                    MaterialNames& materials, Scenario& scenario) {
  const CheckedElement* terrain = element.child("terrain");
  GeometryBuilder builder{context, element, materials, scenario};
  for (const CheckedElement& child : element.children) {
    const std::string& kind = child.type->name;
    if (kind == "terrain") {
      if (&child != terrain) {
        context.mistake(child.offset, fmt::format("a second <terrain>; the first is in line {}",
                                                  context.source.locate(terrain->offset).line));
      }
      scenario.geometry.emplace_back(builder.terrain(child));
    } else if (kind == "instances") {
      scenario.geometry.emplace_back(builder.instances(child));
    } else {
      scenario.geometry.emplace_back(builder.object(child));
    }
  }
}

}  // namespace nadir::sim
