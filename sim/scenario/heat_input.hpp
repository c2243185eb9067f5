#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "ephemeris/instant.hpp"
#include "sim/scenario/map_place_input.hpp"
#include "sim/scenario/spectral_input.hpp"
#include "thermal/solve/heat_model.hpp"

// Where temperatures come from, as a scenario or a library describes it.

namespace nadir::sim {

// ---- sources of temperature ---------------------------------------------------------------------

struct ConstantTemperatureInput {
  double kelvin = 0.0;
};
/// kelvin = gain x value + offset, of one band of a raster, or of several taken at several times.
struct TemperatureRasterInput {
  struct Slice {
    std::filesystem::path file;
    int band = 1;
    std::optional<ephemeris::Instant> time;  ///< needed where there are several
  };
  std::vector<Slice> slices;
  double gain = 1.0, offset_k = 0.0;
  MapPlaceInput place;
  SourceLocation where;
};
/// A CSV over time: utc, and temperature_k or temperature_c (or a column of that name).
struct TemperatureTableInput {
  std::filesystem::path file;
  std::string column;  ///< empty: the first of temperature_k, temperature_c
  SourceLocation where;
};
/// What a PLY file gives vertex by vertex (property temperature_k, temperature_c or temperature).
struct VertexTemperatureInput {
  double gain = 1.0, offset_k = 0.0;
  SourceLocation where;
};
/// The weather's air temperature at the picture, plus an offset.
struct AirTemperatureInput {
  double offset_k = 0.0;
};
struct LayerInput {
  std::string substance;              ///< of the table of substances; empty: the figures are given
  thermal::Layer layer;               ///< its substance filled in when the table is read
  std::optional<double> thickness_m;  ///< none, of the last layer: as deep as the day's wave goes
  SourceLocation where;
};
struct HeatBalanceInput {
  std::vector<LayerInput> layers;
  thermal::Back back = thermal::AdiabaticBack{};
  std::optional<double> solar_absorptance;  ///< none: from the material's spectra
  std::optional<double> emissivity;         ///< none: from the material's spectra
  thermal::Convection convection = thermal::Tarp{};
  double wind_factor = 1.0;
  double wetness = 0.0;
  SourceLocation where;
};
using TemperatureInput =
    std::variant<ConstantTemperatureInput, TemperatureRasterInput, TemperatureTableInput,
                 VertexTemperatureInput, AirTemperatureInput, HeatBalanceInput>;

// ---- weather and settings -----------------------------------------------------------------------

enum class WeatherFormat { automatic, csv, tmy3, epw, surfrad };

/// Long-wave radiation of the sky where the weather does not bring its own.
enum class SkyLongWave { from_air, prata, brutsaert, idso, swinbank };

struct WeatherFileInput {
  std::filesystem::path file;
  WeatherFormat format = WeatherFormat::automatic;
  std::optional<bool> any_year;  ///< the file's year does not count; none: true of TMY3 and EPW
  SkyLongWave long_wave = SkyLongWave::prata;
  SourceLocation where;
};
/// No file: sunlight from the ephemeris and the scenario's air, and a stated day of the air.
struct ClearSkyInput {
  double air_low_k = 288.15;   ///< at sunrise
  double air_high_k = 300.15;  ///< some two hours after noon
  double dew_point_k = 285.15;
  double wind_m_s = 2.0;
  SourceLocation where;
};
struct HeatInput {
  std::variant<WeatherFileInput, ClearSkyInput> weather = ClearSkyInput{};
  thermal::HeatSettings settings;
  std::optional<double> history_h;   ///< none: from the layers' own time scales
  double shadow_interval_s = 600.0;  ///< between the places of the sun that are looked at
  double shadow_days = 1.0;          ///< days before the picture with shadows of their own
  std::optional<std::filesystem::path> substances;  ///< none: the library's thermal.csv
  std::optional<double> ground_reflectance;         ///< of sunlight, beyond the scene; none: 0.2
  SourceLocation where;
};

}  // namespace nadir::sim
