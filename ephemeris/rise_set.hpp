#pragma once

#include <vector>

#include "core/quantity.hpp"
#include "ephemeris/instant.hpp"
#include "ephemeris/site.hpp"
#include "ephemeris/sun_moon.hpp"

namespace nadir::ephemeris {

enum class SkyBody { sun, moon };

/// A body passes a height: upwards or downwards.
struct Crossing {
  Instant time;
  bool rises = false;
  Angle azimuth;
};

/// What a day holds of them, in the order of time.
struct Crossings {
  bool above_at_start = false;
  std::vector<Crossing> events;

  [[nodiscard]] bool always_above() const noexcept { return events.empty() && above_at_start; }
  [[nodiscard]] bool always_below() const noexcept { return events.empty() && !above_at_start; }
};

/// A body passes the meridian at its highest.
struct Transit {
  Instant time;
  Angle elevation;  ///< of the centre, without refraction
};

inline constexpr double civil_twilight_deg = -6.0, nautical_twilight_deg = -12.0,
                        astronomical_twilight_deg = -18.0;

/// Sun and moon over a site for the 24 hours after an instant: rise, set, twilight, transit.
///
/// Works at the poles and on days without an event: a search over samples ten minutes apart and
/// over the extremes between them, not a formula for the hour angle. Events less than a second
/// apart, where a body just touches the height, may be missed. The pole of the earth is that of the
/// middle of the day; at the geographic poles the meridian is that of the site's longitude.
/// Accuracy: 0.01 s of the search; the positions' 1 arcsec (sun) and 12 arcsec (moon) are 0.1 and
/// 1 s at the equator, more where the body moves along the horizon. Real refraction: minutes.
class SkyDay {
 public:
  /// @throws InputError for a site outside its ranges or a day that leaves 1900 to 2100
  SkyDay(const Instant& start, const Site& site);

  /// Upper limb on a level horizon. Sun: centre 50 arcmin below it (34 of refraction, 16 of radius,
  /// the almanacs' convention); moon: 34 arcmin and its own radius. Topocentric.
  [[nodiscard]] Crossings rise_and_set(SkyBody body) const;
  /// Times when the sun's centre passes an elevation, without refraction: -6 degrees for civil
  /// twilight, and so on.
  [[nodiscard]] Crossings sun_through(Angle elevation) const;
  [[nodiscard]] std::vector<Transit> transits(SkyBody body) const;

 private:
  [[nodiscard]] SunAndMoon at(double second) const;
  template <class Height>
  [[nodiscard]] std::vector<double> roots(Height&& height) const;
  template <class Height>
  [[nodiscard]] Crossings crossings(SkyBody body, Height&& height) const;

  Instant start_;
  Site site_;
  CelestialPole pole_;
  std::vector<SunAndMoon> samples_;
};

}  // namespace nadir::ephemeris
