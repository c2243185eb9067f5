#include "sim/run/check_air_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/run/load_air.hpp"
#include "spectral/coverage.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;
using ephemeris::LightSource;

// Half a degree of a sun at 30 degrees changes its light on level ground by 1.5 %.
constexpr double same_direction_deg = 0.5;
// The scene's irradiance makes the direct light, the table's the sky: apart by no more than what
// either is known to.
constexpr double same_irradiance = 0.01;

Vec3 direction_of(const AirTable::Body& body) {
  const double level = std::sin(body.zenith_rad);
  return {level * std::sin(body.azimuth_rad), level * std::cos(body.azimuth_rad),
          std::cos(body.zenith_rad)};
}

std::string place_text(Vec3 towards) {
  double azimuth = to_degrees(Angle{std::atan2(towards.x, towards.y)});
  if (azimuth < 0.0) azimuth += 360.0;
  return fmt::format("elevation {:.2f}, azimuth {:.2f} deg",
                     to_degrees(Angle{std::asin(std::clamp(towards.z, -1.0, 1.0))}), azimuth);
}

bool dark(const LightSource& body) { return !(body.irradiance.max_value() > 0.0); }

bool has_set(const LightSource& body) {
  return body.direction_enu.z <= -std::sin(body.angular_radius.value);
}

bool gives_light(const AirTable::Body& body) {
  const auto any = [](const std::vector<float>& values) {
    return std::any_of(values.begin(), values.end(), [](float v) { return v > 0.0F; });
  };
  return any(body.irradiance) || any(body.ground_irradiance);
}

bool same_place(Vec3 a, Vec3 b) { return dot(a, b) >= std::cos(degrees(same_direction_deg).value); }

const AirTable::Body* nearest(const AirTable& table, Vec3 towards) {
  const auto further = [&](const AirTable::Body& a, const AirTable::Body& b) {
    return dot(direction_of(a), towards) < dot(direction_of(b), towards);
  };
  const auto found = std::max_element(table.bodies.begin(), table.bodies.end(), further);
  return found == table.bodies.end() ? nullptr : &*found;
}

/// Whether the camera's light at any wavelength may come from this lane: of plain wavelengths the
/// next ones outside its bands count as well.
bool is_seen(const AirTable& table, std::size_t lane, const WavelengthRange& seen) {
  const auto& lanes = table.lanes;
  const bool short_of = lane + 1 < lanes.size() && lanes[lane + 1].wavelength_um < seen.lo.value;
  const bool beyond = lane > 0 && lanes[lane - 1].wavelength_um > seen.hi.value;
  return !short_of && !beyond;
}

void check_irradiance(const AirTable& table, const AirTable::Body& known, const LightSource& body,
                      const WavelengthRange& seen, const SourceLocation& where) {
  double worst = same_irradiance, at_um = 0.0, of_table = 0.0, of_scene = 0.0;
  for (std::size_t i = 0; i < table.lanes.size(); ++i) {
    const AirTable::Lane& lane = table.lanes[i];
    const double here =
        spectral::lane_mean(body.irradiance, Micrometres{lane.wavelength_um}, lane.absorption);
    if (!is_seen(table, i, seen) || !std::isfinite(here)) continue;
    const auto there = static_cast<double>(known.irradiance[i]);
    const double apart = std::abs(here - there);
    if (apart <= worst * std::max(here, there)) continue;
    worst = apart / std::max(here, there);
    at_um = lane.wavelength_um;
    of_table = there;
    of_scene = here;
  }
  if (at_um == 0.0) return;
  refuse_at(
      where,
      fmt::format("the table of the air was made for a {} of {:.4g} W m^-2 um^-1 at {:.4g} um "
                  "outside the air; the scene's {} has {:.4g}",
                  known.name, of_table, at_um, body.name, of_scene),
      "the scene's irradiance must be the one that the table was made with");
}

void check_body(const AirTable& table, const LightSource& body, const WavelengthRange& seen,
                const SourceLocation& where) {
  const AirTable::Body* const known = nearest(table, body.direction_enu);
  if (known != nullptr && same_place(direction_of(*known), body.direction_enu)) {
    check_irradiance(table, *known, body, seen, where);
    return;
  }
  if (has_set(body)) return;
  refuse_at(where,
            fmt::format("the table of the air does not cover the {}'s place in the sky, {}: {}",
                        body.name, place_text(body.direction_enu),
                        known == nullptr ? std::string{"it holds no body's light"}
                                         : "it was made for " + place_text(direction_of(*known))));
}

}  // namespace

void check_air_bodies(const AirTable& table, const ephemeris::Illumination& bodies,
                      const WavelengthRange& seen, const SourceLocation& where) {
  for (const LightSource& body : bodies) {
    if (!dark(body)) check_body(table, body, seen, where);
  }
  for (const AirTable::Body& known : table.bodies) {
    const Vec3 towards = direction_of(known);
    const bool there = std::any_of(bodies.begin(), bodies.end(), [&](const LightSource& body) {
      return !dark(body) && same_place(towards, body.direction_enu);
    });
    if (there || !gives_light(known)) continue;
    refuse_at(where,
              fmt::format("the table of the air holds the light of a {} at {}, where the scene "
                          "has no body that shines",
                          known.name, place_text(towards)));
  }
}

}  // namespace nadir::sim
