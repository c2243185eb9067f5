#include <fmt/format.h>

#include <memory>
#include <utility>

#include "atmosphere/make/levels.hpp"
#include "atmosphere/particles/haze_profile.hpp"
#include "core/constants.hpp"
#include "core/text.hpp"
#include "sim/files/band_tables.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/files/particle_tables.hpp"
#include "sim/files/sounding.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;
using atmosphere::Profile;
using atmosphere::ScaledProfile;
using spectral::Outside;

/// Notes the shipped files that a reader opened.
class Figures {
 public:
  Figures() : folder_{data_directory() / "library" / "atmosphere"} {}

  [[nodiscard]] const fs::path& folder() const { return folder_; }
  fs::path file(const char* name) {
    files_.push_back(folder_ / name);
    return files_.back();
  }
  [[nodiscard]] const std::vector<fs::path>& files() const { return files_; }

 private:
  fs::path folder_;
  std::vector<fs::path> files_;
};

/// What a scaling that saturation limits left undone.
void tell_of_cap(const ScaledProfile& scaled, const ColumnInput& wanted, Diagnostics& diagnostics) {
  if (scaled.capped_levels == 0) return;
  const bool short_of = wanted.amount && scaled.column < 0.995 * *wanted.amount;
  const std::string reached =
      short_of ? fmt::format(" and the column {:.2f} g cm^-2 where {} were asked for",
                             scaled.column, number_text(*wanted.amount))
               : std::string{};
  diagnostics.warn(
      fmt::format("the air is saturated at {} of its levels: water vapour there stays "
                  "at a relative humidity of 100 %{}",
                  scaled.capped_levels, reached));
}

Profile scaled(Profile profile, const LayeredAir& input, double ground_m,
               Diagnostics& diagnostics) {
  const ColumnInput& water = input.water_vapour;
  if (water.amount || water.factor != 1.0) {
    ScaledProfile result = water.amount ? scale_water_to(profile, *water.amount, ground_m)
                                        : scale_water(profile, water.factor, ground_m);
    tell_of_cap(result, water, diagnostics);
    profile = std::move(result.profile);
  }
  const ColumnInput& ozone = input.ozone;
  if (ozone.amount) profile = scale_ozone_to(profile, *ozone.amount, ground_m).profile;
  if (ozone.factor != 1.0) profile = scale_ozone(profile, ozone.factor, ground_m).profile;
  return profile;
}

Profile profile_of(const LayeredAir& input, const atmosphere::BandTables& gases, double ground_m,
                   InputFiles& files, Diagnostics& diagnostics) {
  Profile profile = atmosphere::standard_profile(gases, input.profile, input.co2_ppm);
  if (input.sounding) {
    profile = read_sounding(files.note(*input.sounding), profile, diagnostics);
  }
  profile = scaled(std::move(profile), input, ground_m, diagnostics);
  if (ground_m < profile.levels.front().height_m) {  // as far down as the profile may be continued
    profile.levels.insert(profile.levels.begin(), atmosphere::level_at(profile, ground_m));
  }
  return profile;
}

/// Light of the moonless night and of a town. Beyond the shipped spectra nothing is known of the
/// former that would show beside the air's own emission: there it is 0.
atmosphere::NightSky night_of(const LayeredAir& input, InputFiles& files) {
  const auto none = spectral::Curve::constant(0.0);
  atmosphere::NightSky night{none, none, none};
  const auto shipped = [&](const char* name) {
    return curve_of({data_directory() / "library" / "illumination" / name, {}},
                    SpectrumQuantity::radiance, Outside::zero, files);
  };
  if (input.night_sky) {
    night.airglow = shipped("night_airglow.csv");
    night.starlight = shipped("night_starlight.csv");
  }
  if (input.urban_glow) {
    night.urban_glow =
        curve_of(*input.urban_glow, SpectrumQuantity::radiance, Outside::zero, files);
  }
  return night;
}

atmosphere::AirSettings settings_of(const LayeredAir& input) {
  atmosphere::AirSettings settings;
  settings.mode = input.mode;
  settings.streams = input.streams;
  settings.term_tolerance = input.gas_tolerance;
  return settings;
}

/// What no table could be made of is told before the scene is built: it costs a millisecond.
void check_layers(const atmosphere::Layered& air) {
  const auto levels =
      atmosphere::column_levels_m(air.profile, air.aerosol, air.clouds, air.ground_height_m);
  static_cast<void>(atmosphere::Particles{air.particles, air.aerosol, air.clouds, levels});
}

/// Haze through which no light comes is mostly a fog that was meant to be thin: all is black.
void warn_of_black_haze(const LayeredAir& input, const atmosphere::Layered& air,
                        Diagnostics& diagnostics) {
  constexpr double black_depth = 20.0;     // straight light of exp(-20) = 2e-9
  constexpr double above_haze_m = 4000.0;  // over the ground; the boundary layer ends at 2 to 3 km
  if (air.aerosol.type == atmosphere::AerosolType::none) return;
  const double ground_m = air.ground_height_m;
  const double visibility_km = air.aerosol.optical_depth_550
                                   ? visibility_of_depth(*air.particles, air.aerosol, ground_m)
                                   : air.aerosol.visibility_km;
  const atmosphere::HazeProfile haze{*air.particles, air.aerosol, visibility_km, ground_m};
  const double depth = haze.depth_below(0, ground_m + above_haze_m);
  if (!(depth > black_depth)) return;
  warn_at(
      input.aerosol_where,
      fmt::format("the haze of the lowest 2 km has an optical depth of {:.0f} at 0.55 um: "
                  "nothing shows through it (hint: fog is a <cloud> at the ground, base_m=\"0\", "
                  "of type fog_advection or fog_radiation)",
                  depth),
      diagnostics);
}

LayeredTask layered_task(const LayeredAir& input, double ground_m, InputFiles& files,
                         Diagnostics& diagnostics) {
  Figures figures;
  auto gases = std::make_shared<const atmosphere::BandTables>(read_band_tables(figures.folder()));
  for (const char* name :
       {"gas_sets.csv", "gas_bands.txt", "gas_continua.txt", "standard_profiles.csv"}) {
    figures.file(name);
  }
  auto particles = std::make_shared<const atmosphere::ParticleTables>(
      read_particle_tables(figures.file("particles.txt")));
  Profile profile = profile_of(input, *gases, ground_m, files, diagnostics);
  LayeredTask task{{std::move(gases), std::move(particles), std::move(profile), ground_m,
                    input.aerosol, input.clouds, night_of(input, files)},
                   settings_of(input),
                   input.refraction,
                   figures.files()};
  for (const fs::path& file : task.figures) files.note(file);
  check_layers(task.air);
  warn_of_black_haze(input, task.air, diagnostics);
  return task;
}

GroundAbout ground_about(const GroundAboutInput& input, InputFiles& files) {
  GroundAbout about;
  if (input.reflectance) {
    about.reflectance =
        curve_of(*input.reflectance, SpectrumQuantity::reflectance, Outside::reject, files);
  }
  if (input.temperature_k) about.temperature = Kelvin{*input.temperature_k};
  return about;
}

}  // namespace

std::optional<AirTask> load_air_task(const Scenario& scenario, InputFiles& files,
                                     Diagnostics& diagnostics) {
  if (const auto* table = std::get_if<TableAir>(&scenario.air)) {
    return AirTask{table->where, ground_about(table->ground, files), {}};
  }
  const auto* input = std::get_if<LayeredAir>(&scenario.air);
  if (input == nullptr) return std::nullopt;
  return at_element(input->where, [&] {
    AirTask task{input->where, ground_about(input->ground, files),
                 layered_task(*input, scenario.origin.height_m, files, diagnostics)};
    return std::optional{std::move(task)};
  });
}

ephemeris::AirAtSite air_at_site(const atmosphere::Layered& air) {
  const atmosphere::Level level = atmosphere::level_at(air.profile, air.ground_height_m);
  return {level.pressure_hpa, level.temperature_k - si::zero_celsius};
}

}  // namespace nadir::sim
