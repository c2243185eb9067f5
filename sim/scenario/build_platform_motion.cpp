#include <fmt/format.h>

#include "sim/scenario/build_platform.hpp"

namespace nadir::sim {
namespace {

constexpr double m_per_km = 1e3;
constexpr double equatorial_radius_km = 6378.137;  // WGS84

sensor::Overpass overpass_of(const CheckedElement& element) {
  return {element.number("latitude_deg"), element.number("longitude_deg"),
          element.number("height_m"), element.number("inclination_deg"),
          element.value<std::string>("direction") == "ascending"};
}

std::optional<PositionInput> kepler_of(const BuildContext& context, const CheckedElement& element) {
  const auto epoch = element.find<ephemeris::Instant>("epoch");
  const auto axis_km = element.find<double>("semi_major_axis_km");
  const auto eccentricity = element.find<double>("eccentricity");
  if (!epoch || !axis_km || !eccentricity) return std::nullopt;  // told already
  const double perigee_km = *axis_km * (1.0 - *eccentricity) - equatorial_radius_km;
  if (perigee_km < 0.0) {
    context.mistake(
        element.where("eccentricity"),
        fmt::format("the orbit's perigee lies {:.0f} km below the ground", -perigee_km));
  }
  return sensor::KeplerElements{*epoch,
                                *axis_km * m_per_km,
                                *eccentricity,
                                element.number("inclination_deg"),
                                element.number("ascending_node_deg"),
                                element.number("argument_of_perigee_deg"),
                                element.number("mean_anomaly_deg")};
}

std::optional<PositionInput> flight_of(const PlatformBuilder& builder,
                                       const CheckedElement& element) {
  const auto place = builder.build_place(element);
  if (!place) return std::nullopt;
  if (element.type->name == "straight") {
    return StraightInput{*place, element.number("azimuth_deg"), element.number("speed_m_s"),
                         element.number("climb_m_s")};
  }
  return CircleInput{*place, element.number("radius_m"), element.number("speed_m_s"),
                     element.number("azimuth_deg"),
                     element.value<std::string>("turn") == "clockwise"};
}

std::optional<PositionInput> way_of(const PlatformBuilder& builder, const CheckedElement& element) {
  const std::string& kind = element.type->name;
  const auto file = [&] { return element.value<std::filesystem::path>("file"); };
  if (kind == "straight" || kind == "circle") return flight_of(builder, element);
  if (kind == "waypoints") {
    return WaypointsInput{file(), element.value<std::string>("interpolation") == "straight",
                          element.find<double>("max_gap_s")};
  }
  if (kind == "circular_orbit") return overpass_of(element);
  if (kind == "kepler_orbit") return kepler_of(builder.context, element);
  if (kind == "tle") return TwoLineInput{file(), element.value<std::string>("satellite")};
  return EphemerisInput{file(), element.find<double>("max_gap_s")};
}

}  // namespace

void PlatformBuilder::build_position(const CheckedElement& position,
                                     PlatformInput& platform) const {
  const CheckedElement* element = only_child(position);
  if (element == nullptr) return;
  platform.position_where = context.source.locate(element->offset);
  if (element->type->name != "geodetic" && element->type->name != "local") {
    if (auto way = way_of(*this, *element)) platform.position = std::move(*way);
    return;
  }
  const auto place = build_place(position);
  if (!place) return;
  std::visit([&](const auto& where) { platform.position = where; }, place->where);
  platform.on_terrain = place->on_terrain;
}

}  // namespace nadir::sim
