#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

UniformAir build_uniform(const CheckedElement& element) {
  return {element.value<SpectralInput>("sky_radiance"),
          element.number("sky_temperature_k"),
          element.value<SpectralInput>("solar_transmittance"),
          element.value<SpectralInput>("transmittance"),
          element.value<SpectralInput>("path_radiance"),
          element.number("air_temperature_k"),
          element.value<std::string>("sky_shape") == "overcast"};
}

GroundAboutInput build_ground(const CheckedElement& element) {
  return {element.find<SpectralInput>("ground_reflectance"),
          element.find<double>("ground_temperature_k")};
}

/// Two attributes that say the same thing in two ways.
void check_either(const BuildContext& context, const CheckedElement& element,
                  const std::string& first, const std::string& second) {
  if (!element.gives(first) || !element.gives(second)) return;
  context.mistake(element.where(second),
                  fmt::format("give either {} or {}, not both", first, second));
}

/// The children of that name; those that must be alone are mistakes from the second on.
std::vector<const CheckedElement*> children_of(const BuildContext& context,
                                               const CheckedElement& element,
                                               const std::string& name, bool one) {
  std::vector<const CheckedElement*> found;
  for (const CheckedElement& child : element.children) {
    if (child.type->name != name) continue;
    if (one && !found.empty()) {
      context.mistake(
          child.offset,
          fmt::format("<{}> holds only one <{}>; one stands in line {} already", element.type->name,
                      name, context.source.locate(found.front()->offset).line));
    } else {
      found.push_back(&child);
    }
  }
  return found;
}

/// The alternative of an enumeration whose names the table lists in the enumeration's order.
template <class Enum, std::size_t Count>
Enum chosen(const CheckedElement& element, const std::string& attribute,
            const std::array<const char*, Count>& names) {
  const auto text = element.value<std::string>(attribute);
  const auto found = std::find(names.begin(), names.end(), text);
  return static_cast<Enum>(found == names.end() ? 0 : found - names.begin());
}

atmosphere::Aerosol build_aerosol(const BuildContext& context, const CheckedElement& element) {
  using atmosphere::AerosolType;
  constexpr std::array types{"none",         "rural",         "urban",        "maritime",
                             "tropospheric", "fog_advection", "fog_radiation"};
  constexpr std::array seasons{"spring_summer", "autumn_winter"};
  constexpr std::array states{"background", "moderate", "high", "extreme"};
  atmosphere::Aerosol aerosol;
  aerosol.type = chosen<AerosolType>(element, "type", types);
  aerosol.visibility_km = element.find<double>("visibility_km").value_or(aerosol.visibility_km);
  aerosol.optical_depth_550 = element.find<double>("optical_depth_550");
  aerosol.relative_humidity = element.number("relative_humidity_percent") / 100.0;
  aerosol.season = chosen<atmosphere::Season>(element, "season", seasons);
  aerosol.volcanic = chosen<atmosphere::Volcanic>(element, "volcanic", states);
  check_either(context, element, "visibility_km", "optical_depth_550");
  if (aerosol.type != AerosolType::none) return aerosol;
  for (const auto& [name, offset] : element.attribute_offset) {
    if (name == "type") continue;
    context.mistake(offset, fmt::format("<aerosol type=\"none\"> holds no particles: {} would do "
                                        "nothing",
                                        name));
  }
  return aerosol;
}

atmosphere::Cloud build_cloud(const BuildContext& context, const CheckedElement& element) {
  atmosphere::Cloud cloud;
  cloud.type = element.value<std::string>("type");
  cloud.optical_depth_550 = element.number("optical_depth_550");
  const auto base = element.find<double>("base_m"), top = element.find<double>("top_m");
  if (!base || !top) return cloud;
  cloud.base_m = *base;
  cloud.top_m = *top;
  if (*base >= *top) {
    context.mistake(element.where("top_m"),
                    fmt::format("the top of the cloud at {} m does not lie above its base at {} m",
                                *top, *base));
  }
  return cloud;
}

ColumnInput build_column(const BuildContext& context, const CheckedElement& element,
                         const std::string& amount, const std::string& factor) {
  check_either(context, element, amount, factor);
  return {element.find<double>(amount), element.find<double>(factor).value_or(1.0)};
}

LayeredAir build_layered(const BuildContext& context, const CheckedElement& element) {
  LayeredAir air;
  air.where = context.source.locate(element.offset);
  air.profile = element.value<std::string>("profile");
  air.sounding = element.find<std::filesystem::path>("sounding");
  const bool fast = element.value<std::string>("mode") == "fast";
  air.mode = fast ? atmosphere::AirMode::fast : atmosphere::AirMode::accurate;
  constexpr int clear_streams = 8, cloudy_streams = 16;  // as the schema says
  air.streams = element.find<int>("streams").value_or(element.child("cloud") ? cloudy_streams
                                                                             : clear_streams);
  air.gas_tolerance = element.number("gas_tolerance");
  if (air.streams % 2 != 0) {
    context.mistake(element.where("streams"),
                    fmt::format("streams is {}, expected an even number", air.streams));
  }
  if (fast && element.gives("streams")) {
    context.mistake(element.where("streams"),
                    "the fast mode has two streams: streams would do "
                    "nothing");
  }
  air.water_vapour = build_column(context, element, "water_vapour_g_cm2", "water_vapour_factor");
  air.ozone = build_column(context, element, "ozone_du", "ozone_factor");
  air.co2_ppm = element.number("co2_ppm");
  air.ground = build_ground(element);
  air.refraction = element.flag("refraction");
  air.night_sky = element.flag("night_sky");
  for (const auto* aerosol : children_of(context, element, "aerosol", true)) {
    air.aerosol = build_aerosol(context, *aerosol);
    air.aerosol_where = context.source.locate(aerosol->offset);
  }
  for (const auto* cloud : children_of(context, element, "cloud", false)) {
    air.clouds.push_back(build_cloud(context, *cloud));
  }
  for (const auto* glow : children_of(context, element, "urban_glow", true)) {
    air.urban_glow = glow->find<SpectralInput>("radiance");
  }
  return air;
}

}  // namespace

AirInput build_air(const BuildContext& context, const CheckedElement& element) {
  if (const CheckedElement* uniform = element.child("uniform")) return build_uniform(*uniform);
  if (const CheckedElement* layered = element.child("layered")) {
    return build_layered(context, *layered);
  }
  if (const CheckedElement* table = element.child("table")) {
    return TableAir{context.source.locate(table->offset),
                    table->value<std::filesystem::path>("file"), build_ground(*table)};
  }
  return NoAir{};
}

}  // namespace nadir::sim
