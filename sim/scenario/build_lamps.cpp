#include <fmt/format.h>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

namespace geo = nadir::geometry;

class LampBuilder {
 public:
  LampBuilder(const BuildContext& context, MaterialNames& materials, bool has_terrain)
      : context_{context}, materials_{materials}, has_terrain_{has_terrain} {}

  LampInput lamp(const CheckedElement& element) {
    LampInput input = common(element);
    input.position_m = {element.number("east_m"), element.number("north_m"),
                        element.number("up_m")};
    input.on_terrain = on_terrain(element);
    direct(element, input);
    input.form = form(element);
    check_side_matters(element, input);
    return input;
  }

  /// @return none where the list holds no lamp: told already
  std::optional<LampInput> list(const CheckedElement& element) {
    if (element.children.empty()) return std::nullopt;
    const CheckedElement& prototype = element.children.front();
    LampInput input = lamp(prototype);
    (void)check_one_light(prototype, input);
    if (input.on_terrain) {
      context_.mistake(prototype.where("on_terrain"),
                       fmt::format("a <{}> in a list stands where its row says: give on_terrain to "
                                   "<lamps_list>",
                                   prototype.type->name));
    }
    input.on_terrain = on_terrain(element);
    input.list = element.value<std::filesystem::path>("file");
    if (const auto name = element.find<std::string>("name")) input.name = *name;
    return input;
  }

  /// Of a lamp that no list completes: one way to say how bright it is, in full.
  void check_light(const CheckedElement& element, const LampInput& input) const {
    if (!check_one_light(element, input)) return;
    const std::string& kind = element.type->name;
    if (element.gives("flux_w_per_um")) return;
    const bool lumens = element.gives("lumens") || element.gives("ies");
    const bool colour = element.gives("colour_temperature_k");
    if (lumens && !colour) {
      context_.mistake(element.offset,
                       fmt::format("<{}> lacks colour_temperature_k, which says how its lumens are "
                                   "spread over wavelengths",
                                   kind));
    } else if (!lumens) {
      context_.mistake(
          element.offset,
          fmt::format("<{}> needs {}", kind,
                      colour ? "lumens" : "flux_w_per_um, or lumens and colour_temperature_k"));
    }
  }

 private:
  LampInput common(const CheckedElement& element) {
    LampInput input;
    input.name = element.find<std::string>("name").value_or(element.type->name);
    input.where = context_.source.locate(element.offset);
    input.yaw_deg = element.number("yaw_deg");
    input.flux = element.find<SpectralInput>("flux_w_per_um");
    input.lumens = element.find<double>("lumens");
    input.colour_temperature_k = element.find<double>("colour_temperature_k");
    return input;
  }

  [[nodiscard]] bool on_terrain(const CheckedElement& element) const {
    const bool on = element.flag("on_terrain");
    if (on && !has_terrain_) {
      context_.mistake(element.where("on_terrain"),
                       fmt::format("<{}> stands on the terrain, but <geometry> has no <terrain>",
                                   element.type->name));
    }
    return on;
  }

  void direct(const CheckedElement& element, LampInput& input) const {
    const auto axis = element.find<Vec3>("axis");
    input.aim_m = element.find<Vec3>("aim_m");
    if (element.gives("axis") && element.gives("aim_m")) {
      context_.mistake(element.where("aim_m"), "give either axis or aim_m, not both");
    }
    if (axis && length(*axis) == 0.0) {
      context_.mistake(element.where("axis"),
                       fmt::format("the axis of <{}> has no length", element.type->name));
    } else if (axis) {
      input.axis = normalised(*axis);
    }
    if (input.aim_m && !input.on_terrain && *input.aim_m == input.position_m) {
      context_.mistake(element.where("aim_m"),
                       fmt::format("<{}> is aimed at its own place", element.type->name));
    }
  }

  std::variant<PointLampInput, SpotLampInput, AreaLampInput> form(const CheckedElement& element) {
    const std::string& kind = element.type->name;
    if (kind == "point_lamp") return PointLampInput{element.find<std::filesystem::path>("ies")};
    if (kind == "spot_lamp") {
      return SpotLampInput{element.number("half_angle_deg"), element.number("cosine_power")};
    }
    AreaLampInput area;
    if (const auto material = materials_.resolve_material(context_, element)) {
      area.material = *material;
    }
    if (element.children.empty()) return area;
    const CheckedElement& shape = element.children.front();
    if (shape.type->name == "disc") {
      area.surface = geo::Disc{{}, {0.0, 0.0, 1.0}, shape.number("radius_m")};
    } else if (shape.type->name == "plane") {
      area.surface = geo::Plane{{}, shape.number("size_x_m"), shape.number("size_y_m")};
    } else {
      area.surface = geo::Sphere{{}, shape.number("radius_m")};
    }
    return area;
  }

  /// An axis on a lamp that is alike in all directions is a slip: a missing file, most likely.
  void check_side_matters(const CheckedElement& element, const LampInput& input) const {
    const auto* point = std::get_if<PointLampInput>(&input.form);
    if (point == nullptr || element.gives("ies")) return;
    for (const char* attribute : {"axis", "aim_m", "yaw_deg"}) {
      if (!element.gives(attribute)) continue;
      context_.mistake(element.where(attribute),
                       fmt::format("<point_lamp> without ies shines alike in all directions: {} "
                                   "would do nothing",
                                   attribute));
    }
  }

  [[nodiscard]] bool check_one_light(const CheckedElement& element, const LampInput& input) const {
    if (!element.gives("flux_w_per_um")) return true;
    if (!input.lumens && !input.colour_temperature_k) return true;
    context_.mistake(element.where("flux_w_per_um"),
                     "give either flux_w_per_um, or lumens and colour_temperature_k, not both");
    return false;
  }

  const BuildContext& context_;
  MaterialNames& materials_;
  bool has_terrain_;
};

}  // namespace

void build_lamps(const BuildContext& context, const CheckedElement& root, MaterialNames& materials,
                 Scenario& scenario) {
  const CheckedElement* lamps = root.child("lamps");
  const CheckedElement* geometry = root.child("geometry");
  if (lamps == nullptr) return;
  LampBuilder builder{context, materials,
                      geometry != nullptr && geometry->child("terrain") != nullptr};
  for (const CheckedElement& child : lamps->children) {
    if (child.type->name == "lamps_list") {
      if (auto list = builder.list(child)) scenario.lamps.push_back(std::move(*list));
    } else {
      scenario.lamps.push_back(builder.lamp(child));
      builder.check_light(child, scenario.lamps.back());
    }
  }
}

}  // namespace nadir::sim
