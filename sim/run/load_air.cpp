#include "sim/run/load_air.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "sim/files/air_table_file.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

using spectral::Outside;

atmosphere::Atmosphere air_from(const NoAir& /*none*/, InputFiles& /*files*/) {
  return atmosphere::None{};
}

atmosphere::Atmosphere air_from(const UniformAir& air, InputFiles& files) {
  const auto curve = [&](const SpectralInput& input, SpectrumQuantity quantity) {
    return curve_of(input, quantity, Outside::reject, files);
  };
  return atmosphere::Uniform{
      curve(air.sky_radiance, SpectrumQuantity::radiance),
      Kelvin{air.sky_temperature_k},
      curve(air.solar_transmittance, SpectrumQuantity::transmittance),
      curve(air.transmittance, SpectrumQuantity::transmittance),
      curve(air.path_radiance, SpectrumQuantity::radiance),
      Kelvin{air.air_temperature_k},
      air.overcast ? atmosphere::SkyShape::overcast : atmosphere::SkyShape::even};
}

/// Its light is computed later, when the lanes are known.
atmosphere::Atmosphere air_from(const LayeredAir& /*air*/, InputFiles& /*files*/) {
  return atmosphere::None{};
}

atmosphere::Atmosphere air_from(const TableAir& air, InputFiles& files) {
  auto table =
      std::make_shared<const atmosphere::AirTable>(read_air_table(files.note(air.file)).table);
  const std::size_t lanes = table->lanes.size();
  return atmosphere::Tabulated{std::move(table),
                               {std::vector<float>(lanes), std::vector<float>(lanes)}};
}

}  // namespace

void refuse_at(const SourceLocation& where, std::string message, std::string hint) {
  throw InputError{InputIssue{where, std::move(message), std::move(hint), {}}};
}

void warn_at(const SourceLocation& where, const std::string& message, Diagnostics& diagnostics) {
  diagnostics.warn(fmt::format("{}:{}:{}: {}", where.file, where.line, where.column, message));
}

void warn_of_bright_night(const Scenario& scenario, const ephemeris::Illumination& bodies,
                          const atmosphere::Atmosphere& air, Diagnostics& diagnostics) {
  const auto* uniform = std::get_if<atmosphere::Uniform>(&air);
  if (uniform == nullptr || !std::holds_alternative<ComputedSky>(scenario.illumination)) return;
  // Skies that the moon or a city brightens are below 1e-3. Twilight is more from 6 degrees below
  // the horizon on: 2 to 3.5 lx there (AMS Glossary of Meteorology, "civil twilight") is some 0.01
  // where the 15,000 lx of a clear day's sky are 75.
  constexpr double brightest_night = 0.01;  // W m^-2 sr^-1 um^-1
  const Micrometres green{0.55};
  const auto bright = [&](const spectral::Curve& curve) {
    return curve.covers(green, green) && curve.at(green) > brightest_night;
  };
  const auto& sun = bodies.front();
  if (sun.direction_enu.z > -std::sin(sun.angular_radius.value)) return;
  if (!bright(uniform->sky_radiance) && !bright(uniform->path_radiance)) return;
  diagnostics.warn(
      "the sun is below the horizon, but the uniform atmosphere's sky or path is as bright in the "
      "visible as its figures say");
}

atmosphere::Atmosphere load_atmosphere(const Scenario& scenario, InputFiles& files) {
  return std::visit([&](const auto& air) { return air_from(air, files); }, scenario.air);
}

}  // namespace nadir::sim
