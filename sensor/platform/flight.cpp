#include "sensor/platform/flight.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/frame.hpp"
#include "core/quantity.hpp"
#include "core/text.hpp"

namespace nadir::sensor {
namespace {

constexpr int margin_nodes = 8;
constexpr std::size_t most_places = 1'000'000;

void check_flight(const geometry::Geodetic& place, Vec3 numbers, double speed_m_s) {
  if (!(std::abs(place.latitude_deg) <= 90.0) || !std::isfinite(place.longitude_deg) ||
      !std::isfinite(place.height_m) || !is_finite(numbers)) {
    throw InputError{"the place, the azimuth and the rates of a flight must be finite"};
  }
  if (!(speed_m_s > 0.0 && std::isfinite(speed_m_s))) {
    throw InputError{"the speed of a flight must be above 0, not " + number_text(speed_m_s) +
                     " m/s"};
  }
}

/// Radius of curvature of the ellipsoid in a direction: 1 / R = cos^2 / M + sin^2 / N, with the
/// meridian's M and the prime vertical's N. Source: Euler; e.g. Torge, "Geodesy" (2001), 4.1.2.
double curvature_radius_m(double latitude_deg, double azimuth_deg) {
  const auto& ellipsoid = GeographicLib::Geodesic::WGS84();
  const double flattening = ellipsoid.Flattening();
  const double e2 = flattening * (2.0 - flattening);
  const double sine = std::sin(degrees(latitude_deg).value);
  const double w = std::sqrt(1.0 - e2 * sine * sine);
  const double across = ellipsoid.EquatorialRadius() / w;
  const double along = across * (1.0 - e2) / (w * w);
  const double c = std::cos(degrees(azimuth_deg).value), s = std::sin(degrees(azimuth_deg).value);
  return 1.0 / (c * c / along + s * s / across);
}

/// ln(1 + x) / x.
double log_share(double x) { return std::abs(x) < 1e-12 ? 1.0 - 0.5 * x : std::log1p(x) / x; }

struct EvenTimes {
  double first_s, step_s;
  std::size_t count;
};

Track even_track(const PositionLaw& law, const geometry::LocalFrame& frame, EvenTimes even) {
  std::vector<double> times_s(even.count);
  std::vector<Vec3> positions(even.count);
  for (std::size_t i = 0; i < even.count; ++i) {
    times_s[i] = even.first_s + even.step_s * static_cast<double>(i);
    positions[i] = frame.enu_from_ecef(law(times_s[i]));
  }
  return {std::move(times_s), std::move(positions)};
}

/// Whether the table agrees with the law in the steps between its margins.
bool follows_law(const Track& track, const PositionLaw& law, const geometry::LocalFrame& frame,
                 double tolerance_m) {
  const auto& times_s = track.times_s();
  for (std::size_t i = margin_nodes; i + margin_nodes + 1 < times_s.size(); ++i) {
    // The middle, where the polynomial is worst, and a place where a law that repeats itself in
    // the step does not look the same.
    for (const double share : {0.5, 0.29}) {
      const double time_s = times_s[i] + share * (times_s[i + 1] - times_s[i]);
      const Vec3 exact = frame.enu_from_ecef(law(time_s));
      if (!(length(track.position(time_s) - exact) <= tolerance_m)) return false;
    }
  }
  return true;
}

}  // namespace

geometry::Geodetic place_at(const StraightFlight& flight, double time_s) {
  check_flight(flight.start, {flight.azimuth_deg, flight.climb_m_s, time_s}, flight.speed_m_s);
  const double radius_m = curvature_radius_m(flight.start.latitude_deg, flight.azimuth_deg);
  // The integral of v R / (R + h0 + climb t).
  const double from_centre_m = radius_m + flight.start.height_m;
  const double climbed_m = flight.climb_m_s * time_s;
  const double arc_m =
      flight.speed_m_s * time_s * (radius_m / from_centre_m) * log_share(climbed_m / from_centre_m);
  geometry::Geodetic place;
  place.height_m = flight.start.height_m + climbed_m;
  GeographicLib::Geodesic::WGS84().Direct(flight.start.latitude_deg, flight.start.longitude_deg,
                                          flight.azimuth_deg, arc_m, place.latitude_deg,
                                          place.longitude_deg);
  return place;
}

geometry::Geodetic place_at(const CirclingFlight& flight, double time_s) {
  check_flight(flight.centre, {flight.azimuth_deg, flight.radius_m, time_s}, flight.speed_m_s);
  if (!(flight.radius_m > 0.0)) {
    throw InputError{"the radius of a circle must be above 0, not " + number_text(flight.radius_m) +
                     " m"};
  }
  const double turned_rad = flight.speed_m_s * time_s / flight.radius_m;
  const double azimuth_rad =
      degrees(flight.azimuth_deg).value + (flight.clockwise ? turned_rad : -turned_rad);
  const geometry::LocalFrame centre{flight.centre};
  return centre.geodetic(flight.radius_m * direction_enu(azimuth_rad, 0.0));
}

Track tabulated(const PositionLaw& law, const geometry::LocalFrame& frame, double first_s,
                double last_s, double tolerance_m) {
  if (!(std::isfinite(first_s) && std::isfinite(last_s) && first_s <= last_s)) {
    throw InputError{"the span of a track must be finite and not end before it begins"};
  }
  // A span of no length, an image of one moment, gets a track all the same; ten steps at first, so
  // that margins stay near the span.
  const double span_s = std::max(last_s - first_s, 0.1);
  for (std::size_t steps = 10; steps <= most_places; steps *= 2) {
    const double step_s = span_s / static_cast<double>(steps);
    Track track = even_track(
        law, frame,
        {first_s - step_s * margin_nodes, step_s, steps + 2 * std::size_t{margin_nodes} + 1});
    if (follows_law(track, law, frame, tolerance_m)) return track;
  }
  throw InputError{"the platform moves too restlessly: " + std::to_string(most_places) +
                   " places are not enough for its track"};
}

}  // namespace nadir::sensor
