#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "atmosphere/layered.hpp"
#include "core/error.hpp"
#include "sim/scenario/spectral_input.hpp"

namespace nadir::sim {

struct NoAir {};
/// The same air everywhere. See docs/atmosphere.md.
struct UniformAir {
  SpectralInput sky_radiance{0.0, {}};         ///< W m^-2 sr^-1 um^-1, added to the sky's emission
  double sky_temperature_k = 0.0;              ///< black sky at this temperature; 0: none
  SpectralInput solar_transmittance{1.0, {}};  ///< from sun or moon to the ground
  SpectralInput transmittance{1.0, {}};        ///< from the surface to the sensor
  SpectralInput path_radiance{0.0, {}};        ///< scattered into that path, W m^-2 sr^-1 um^-1
  double air_temperature_k = 0.0;              ///< of the path's own emission; 0: none
  bool overcast = false;                       ///< the sky follows the standard overcast sky
};
/// The ground about the scene; what is not given is taken from the scene itself.
struct GroundAboutInput {
  std::optional<SpectralInput> reflectance;
  std::optional<double> temperature_k;
};
/// A column of a gas: scaled to an amount, or by a factor.
struct ColumnInput {
  std::optional<double> amount;
  double factor = 1.0;
};
/// Air in layers, whose light is computed.
struct LayeredAir {
  SourceLocation where{};
  std::string profile = "us_standard_1976";
  std::optional<std::filesystem::path> sounding;  ///< the profile continues it
  atmosphere::AirMode mode = atmosphere::AirMode::accurate;
  int streams = 8;
  double gas_tolerance = 5e-4;  ///< of transmittance
  ColumnInput water_vapour;     ///< g cm^-2
  ColumnInput ozone;            ///< Dobson units
  double co2_ppm = 420.0;
  GroundAboutInput ground{};
  bool refraction = false;
  bool night_sky = true;
  atmosphere::Aerosol aerosol{};
  SourceLocation aerosol_where{};  ///< of its element, where there is one
  std::vector<atmosphere::Cloud> clouds{};
  std::optional<SpectralInput> urban_glow;  ///< W m^-2 sr^-1 um^-1 in the zenith
};
/// A table of the air from elsewhere.
struct TableAir {
  SourceLocation where{};
  std::filesystem::path file;
  GroundAboutInput ground{};
};
using AirInput = std::variant<NoAir, UniformAir, LayeredAir, TableAir>;

}  // namespace nadir::sim
