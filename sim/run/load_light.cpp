#include "sim/run/load_light.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "ephemeris/bodies.hpp"
#include "ephemeris/lunar_reflectance.hpp"
#include "ephemeris/rise_set.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/files/lunar_table.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

using ephemeris::SunAndMoon;
using spectral::Curve;
using spectral::Outside;

// Astronomical twilight ends here, seen from sea level.
constexpr Angle last_twilight = degrees(ephemeris::astronomical_twilight_deg);
// The full moon is 2.8e-6 of the sun outside the air; the direct sun is 0.05 of that on level
// ground at this height (sin 5 degrees, transmittance 0.5), its sky more.
constexpr Angle moon_drowned = degrees(5.0);

/// What lights the site: a body far below the horizon does not.
struct Lit {
  bool sun, moon;  ///< moon: if its light is to be modelled
};

bool is_dark(const std::optional<SpectralInput>& irradiance) {
  if (!irradiance) return false;
  const double* value = std::get_if<double>(&irradiance->source);
  return value != nullptr && *value == 0.0;
}

Lit what_lights(const SunAndMoon& seen, double height_m, bool dark_sun) {
  constexpr double earth_radius_m = 6'371'000.0;
  const Angle dip{std::acos(earth_radius_m / (earth_radius_m + std::max(0.0, height_m)))};
  const Angle lowest = last_twilight - dip;
  return {seen.sun.elevation > lowest,
          seen.moon.elevation > lowest && (dark_sun || seen.sun.elevation < moon_drowned)};
}

/// One computed sky on its way to light sources.
class SkyLoader {
 public:
  SkyLoader(const ComputedSky& sky, const Scenario& scenario, InputFiles& files,
            Diagnostics& diagnostics)
      : sky_{sky},
        time_{scenario.time},
        seen_{ephemeris::sun_and_moon(scenario.time,
                                      {scenario.origin.latitude_deg, scenario.origin.longitude_deg,
                                       scenario.origin.height_m})},
        lit_{what_lights(seen_, scenario.origin.height_m,
                         !sky.sun_shines || is_dark(sky.solar_irradiance))},
        files_{files},
        diagnostics_{diagnostics} {}

  [[nodiscard]] ephemeris::Illumination load() {
    ephemeris::Illumination bodies{sun()};
    if (!sky_.moon_shines) return bodies;
    if (sky_.lunar_irradiance) {
      bodies.push_back(ephemeris::moon_light(seen_.moon, irradiance(*sky_.lunar_irradiance)));
    } else if (lit_.moon) {
      bodies.push_back(modelled_moon());
    }
    return bodies;
  }

 private:
  [[nodiscard]] Curve irradiance(const SpectralInput& input) {
    return curve_of(input, SpectrumQuantity::irradiance, Outside::reject, files_);
  }

  [[nodiscard]] std::filesystem::path library_file(const char* name) {
    return files_.note(data_directory() / "library" / "illumination" / name);
  }

  [[nodiscard]] Curve library_sun() {
    return read_curve(library_file("solar.csv"), "", SpectrumQuantity::irradiance, Outside::reject);
  }

  [[nodiscard]] Curve sunlight() {
    if (!sky_.sun_shines) return Curve::constant(0.0);
    if (sky_.solar_irradiance) return irradiance(*sky_.solar_irradiance);
    return lit_.sun ? library_sun() : Curve::constant(0.0);
  }

  // A sun that does not light is dark, but the truth planes still tell where it stands.
  [[nodiscard]] ephemeris::LightSource sun() {
    const Curve at_1au = sunlight();
    const auto eclipse = sky_.eclipses ? ephemeris::solar_eclipse(seen_) : ephemeris::Eclipse{};
    if (eclipse.any() && lit_.sun && sky_.sun_shines) {
      diagnostics_.warn(fmt::format("a solar eclipse: the moon covers {:.1f} % of the sun's disc",
                                    100.0 * (1.0 - eclipse.sunlight.area)));
    }
    return ephemeris::sun_light(seen_.sun, at_1au, eclipse);
  }

  [[nodiscard]] ephemeris::LightSource modelled_moon() {
    const auto modelled = ephemeris::lunar_irradiance(read_lunar_model(library_file("moon.csv")),
                                                      seen_.lunar, library_sun());
    const auto eclipse = sky_.eclipses ? ephemeris::lunar_eclipse(ephemeris::earth_shadow(time_))
                                       : ephemeris::Eclipse{};
    if (eclipse.any()) {
      diagnostics_.warn(fmt::format("a lunar eclipse: the moon has {:.3g} of its light at 0.55 um",
                                    eclipse.factor(Micrometres{0.55})));
    }
    // With the sun up, the moon does not matter enough to speak of its model's limits.
    if (seen_.sun.elevation < -seen_.sun.angular_radius) {
      for (const std::string& note : modelled.notes) diagnostics_.warn(note);
    }
    return ephemeris::moon_light(seen_.moon, modelled.irradiance, eclipse);
  }

  const ComputedSky& sky_;
  ephemeris::Instant time_;
  SunAndMoon seen_;
  Lit lit_;
  InputFiles& files_;
  Diagnostics& diagnostics_;
};

ephemeris::Illumination light_from(const ComputedSky& sky, const Scenario& scenario,
                                   InputFiles& files, Diagnostics& diagnostics) {
  return SkyLoader{sky, scenario, files, diagnostics}.load();
}

ephemeris::Illumination light_from(const FixedSky& sky, const Scenario& /*scenario*/,
                                   InputFiles& files, Diagnostics& /*diagnostics*/) {
  ephemeris::Illumination bodies;
  ErrorList errors;
  for (const FixedBody& body : sky.bodies) {
    errors.attempt([&] {
      bodies.push_back(ephemeris::fixed_light(
          {body.name, degrees(body.azimuth_deg), degrees(body.elevation_deg),
           degrees(body.angular_radius_deg)},
          curve_of(body.irradiance, SpectrumQuantity::irradiance, Outside::reject, files)));
    });
  }
  errors.throw_if_any();
  return bodies;
}

}  // namespace

ephemeris::Illumination load_illumination(const Scenario& scenario, InputFiles& files,
                                          Diagnostics& diagnostics) {
  return std::visit([&](const auto& sky) { return light_from(sky, scenario, files, diagnostics); },
                    scenario.illumination);
}

}  // namespace nadir::sim
