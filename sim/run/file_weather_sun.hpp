#pragma once

#include <vector>

#include "core/diagnostics.hpp"
#include "ephemeris/instant.hpp"
#include "ephemeris/site.hpp"
#include "sim/files/weather_record.hpp"
#include "sim/run/file_weather_rows.hpp"

namespace nadir::sim {

/// The sun over a site for some days: positions every six hours from the ephemeris, declination and
/// equation of time linear between them (0.003 degrees).
class SunHeights {
 public:
  /// @param from_s, to_s  after the moment
  SunHeights(const ephemeris::Instant& moment, const ephemeris::Site& site, double from_s,
             double to_s);

  /// Angle since the sun's passage of the meridian, -pi to pi.
  [[nodiscard]] double hour_angle(double time_s) const noexcept;
  /// Sine of the elevation, without refraction.
  [[nodiscard]] double cos_zenith(double time_s) const noexcept;
  /// Days between midnights of the sun, counted from any.
  [[nodiscard]] long solar_day(double time_s) const noexcept;
  /// Mean of the cosine where it is positive, over a span.
  [[nodiscard]] double mean_cos_zenith(double from_s, double to_s) const noexcept;
  /// Outside the air, on a plane normal to the sun, W m^-2: 1361 at 1 au (Kopp & Lean, Geophys.
  /// Res. Lett. 38, L01706, 2011).
  [[nodiscard]] double extraterrestrial_w_m2(double time_s) const noexcept;

 private:
  struct Equatorial {
    double sin_declination;
    double hour_angle_offset;  ///< hour angle less the uniform turning
    double distance_au;
  };
  [[nodiscard]] Equatorial at(double time_s) const noexcept;

  double from_s_ = 0.0, sin_latitude_ = 0.0, cos_latitude_ = 1.0;
  std::vector<Equatorial> nodes_;
};

/// Where the weather was measured against where the scene lies.
/// @throws InputError for the other hemisphere; farther than 200 km or 500 m in height is told, and
///         that a file does not say its place
void check_place(const WeatherRecord& record, const ephemeris::Site& site,
                 Diagnostics& diagnostics);

/// Sunlight must come while the sun is up, and be centred on noon.
/// @param moment_utc_s  the moment that the sun's times count from, since 1970
/// @throws InputError that says by how many hours the times look shifted
void check_sunlight_times(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                          const SunHeights& sun, double moment_utc_s, Diagnostics& diagnostics);

/// Days within `needed` without any sunlight while the sun is well up for hours: no cloud is that
/// thick.
/// @throws InputError for two of them; one is told
void check_sunlight_is_there(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                             const SunHeights& sun, const UtcSpan& needed,
                             Diagnostics& diagnostics);

}  // namespace nadir::sim
