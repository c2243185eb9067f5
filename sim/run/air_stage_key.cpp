#include <fmt/format.h>

#include <array>
#include <iterator>
#include <variant>

#include "sim/files/air_table_file.hpp"
#include "sim/run/air_stage.hpp"

namespace nadir::sim {
namespace {

/// What the solver computes from given inputs: to be raised whenever its results change between
/// two releases of the program.
constexpr int physics_version = 3;

/// A text that grows line by line; doubles in the shortest form that reads back the same.
class KeyText {
 public:
  template <class... Parts>
  void line(fmt::format_string<Parts...> form, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Parts>(parts)...);
    text_ += '\n';
  }
  void curve(const char* name, const spectral::Curve& curve) {
    line("{} {}", name, curve.is_constant() ? curve.max_value() : 0.0);
    for (std::size_t i = 0; i < curve.values().size() && !curve.is_constant(); ++i) {
      line(" {} {}", curve.wavelengths_um()[i], curve.values()[i]);
    }
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void add_profile(const atmosphere::Profile& profile, KeyText& key) {
  key.line("profile {}", profile.levels.size());
  for (const atmosphere::Level& level : profile.levels) {
    key.line("level {} {} {}", level.height_m, level.pressure_hpa, level.temperature_k);
    for (const double share : level.ppmv) key.line(" {}", share);
  }
}

void add_particles(const atmosphere::Layered& air, KeyText& key) {
  const atmosphere::Aerosol& aerosol = air.aerosol;
  key.line("aerosol {} {} {} {} {} {}", static_cast<int>(aerosol.type), aerosol.visibility_km,
           aerosol.optical_depth_550.value_or(-1.0), aerosol.relative_humidity,
           static_cast<int>(aerosol.season), static_cast<int>(aerosol.volcanic));
  for (const atmosphere::Cloud& cloud : air.clouds) {
    key.line("cloud {} {} {} {}", cloud.type, cloud.base_m, cloud.top_m, cloud.optical_depth_550);
  }
}

void add_settings(const atmosphere::AirSettings& s, KeyText& key) {
  key.line("settings {} {} {} {} {} {} {} {} {}", static_cast<int>(s.mode), s.streams,
           s.term_tolerance, s.zenith_nodes, s.azimuth_nodes, s.share_nodes, s.observer_height_m,
           s.paths, s.dark_below);
}

/// A letter for each part that is solved for; nothing where that is everything.
std::string letters(const atmosphere::AirParts& parts) {
  if (parts == atmosphere::AirParts{}) return {};
  std::string text = " ";
  text += parts.sky_scattering ? "s" : "-";
  text += parts.sky_emission ? "e" : "-";
  text += parts.path_scattering ? "S" : "-";
  text += parts.path_emission ? "E" : "-";
  text += parts.path_transmittance ? "T" : "-";
  return text;
}

void add_bodies(const ephemeris::Illumination& bodies, const AirLanes& lanes, KeyText& key) {
  for (const ephemeris::LightSource& body : bodies) {
    const Vec3 towards = body.direction_enu;
    key.line("body {} {} {} {} {}", body.name, towards.x, towards.y, towards.z,
             body.angular_radius.value);
    for (std::size_t i = 0; i < lanes.wavelengths.size(); ++i) {  // at the node and about it
      const Micrometres lo{lanes.intervals[i].lo_um}, hi{lanes.intervals[i].hi_um};
      key.line(" {} {}", body.irradiance.at(lanes.wavelengths[i]), body.irradiance.mean(lo, hi));
    }
  }
}

}  // namespace

std::string air_key(const atmosphere::Layered& air, const atmosphere::AirSettings& settings,
                    const AirLanes& nodes, const ephemeris::Illumination& bodies,
                    const std::string& figures, std::span<const atmosphere::AirParts> wanted) {
  KeyText key;
  key.line("nadir {} air {} {} {}", NADIR_VERSION, physics_version, air_table_version, figures);
  add_profile(air.profile, key);
  key.line("ground {}", air.ground_height_m);
  add_particles(air, key);
  key.curve("airglow", air.night.airglow);
  key.curve("starlight", air.night.starlight);
  key.curve("urban glow", air.night.urban_glow);
  add_settings(settings, key);
  for (std::size_t i = 0; i < nodes.wavelengths.size(); ++i) {
    key.line("node {} {} {}{}", nodes.wavelengths[i].value, nodes.intervals[i].lo_um,
             nodes.intervals[i].hi_um, wanted.empty() ? "" : letters(wanted[i]));
  }
  add_bodies(bodies, nodes, key);
  return key.take();
}

}  // namespace nadir::sim
