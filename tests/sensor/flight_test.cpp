#include "sensor/platform/flight.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/quantity.hpp"
#include "support/catch.hpp"

using namespace nadir;
using geometry::Geodetic;
using geometry::LocalFrame;
using sensor::CirclingFlight;
using sensor::StraightFlight;
using sensor::Track;

namespace {

template <class Flight>
sensor::PositionLaw law_of(const Flight& flight) {
  // A frame's own origin is where ECEF coordinates come from.
  const LocalFrame frame{{0.0, 0.0, 0.0}};
  return [=](double t) { return frame.ecef(frame.enu(place_at(flight, t))); };
}

template <class Action>
std::string message_from(const Action& action) {
  try {
    (void)action();
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

template <class Flight>
std::string message_of(const Flight& flight) {
  return message_from([&] { return place_at(flight, 0.0); });
}

}  // namespace

// Along the equator the radius of curvature is the semi-major axis: the arc is v t / (a + h).
TEST_CASE("a straight flight along the equator turns by v t / (a + h)", "[sensor][flight]") {
  const StraightFlight flight{{0.0, 10.0, 8000.0}, 90.0, 250.0, 0.0};
  for (const double t : {-100.0, 0.0, 3600.0}) {
    const Geodetic place = place_at(flight, t);
    const double arc_deg = to_degrees(Angle{250.0 * t / (6378137.0 + 8000.0)});
    CHECK(place.latitude_deg == Approx(0.0).margin(1e-12));
    CHECK(place.longitude_deg == Approx(10.0 + arc_deg).epsilon(1e-13));
    CHECK(place.height_m == 8000.0);
  }
}

// Numerically: the derivative of the place in space, central differences over 2 s. Their error is
// v^3 dt^2 / (6 R^2) = 1e-7 m/s; the rest is the change of R on the way, 1e-5 at the most.
TEST_CASE("speed and climb of a straight flight are those of its description", "[sensor][flight]") {
  for (const double azimuth_deg : {0.0, 35.0, 90.0, 200.0}) {
    const StraightFlight flight{{47.0, 8.0, 3000.0}, azimuth_deg, 200.0, 10.0};
    const auto law = law_of(flight);
    for (const double t : {0.0, 500.0}) {
      const Vec3 velocity = (law(t + 1.0) - law(t - 1.0)) / 2.0;
      const LocalFrame there{place_at(flight, t)};
      const Vec3 local = there.enu_from_ecef(there.ecef({}) + velocity);
      CAPTURE(azimuth_deg, t);
      CHECK(std::hypot(local.x, local.y) == Approx(200.0).epsilon(t > 0.0 ? 5e-6 : 1e-8));
      CHECK(local.z == Approx(10.0).epsilon(1e-4));
      if (t == 0.0) {
        // At a height azimuths differ from those on the ellipsoid: h e^2 / (2 R), 9e-5 degrees.
        const double found_deg = to_degrees(Angle{std::atan2(local.x, local.y)});
        CHECK(std::remainder(found_deg - azimuth_deg, 360.0) == Approx(0.0).margin(1e-4));
      }
    }
    CHECK(place_at(flight, 60.0).height_m == 3600.0);
  }
}

TEST_CASE("a circle is one in its centre's horizontal plane", "[sensor][flight]") {
  const LocalFrame centre{{47.0, 8.0, 1500.0}};
  CirclingFlight flight{centre.origin(), 800.0, 40.0, 90.0, true};
  const double period_s = 2.0 * std::acos(-1.0) * 800.0 / 40.0;
  // Nanometres: there and back through geodetic coordinates.
  CHECK(length(centre.enu(place_at(flight, 0.0)) - Vec3{800, 0, 0}) < 1e-7);
  CHECK(length(centre.enu(place_at(flight, period_s / 4)) - Vec3{0, -800, 0}) < 1e-7);
  CHECK(length(centre.enu(place_at(flight, period_s)) - Vec3{800, 0, 0}) < 1e-7);
  flight.clockwise = false;
  CHECK(length(centre.enu(place_at(flight, period_s / 4)) - Vec3{0, 800, 0}) < 1e-7);
  // r^2 / 2 R = 0.0501 m; R between 6335 and 6400 km.
  CHECK(place_at(flight, 3.0).height_m == Approx(1500.0 + 0.0501).margin(5e-4));
}

TEST_CASE("a table of a law is as near to it as was asked, with a margin", "[sensor][flight]") {
  const LocalFrame scene{{47.0, 8.0, 500.0}};
  const auto law = law_of(CirclingFlight{{47.01, 8.0, 1500.0}, 20.0, 30.0, 0.0, true});
  // The second span is 20 periods long: the first table has two of them in every step, and would
  // stand still at its nodes and midway.
  for (const double span_s : {7.0, 20.0 * 2.0 * std::acos(-1.0) * 20.0 / 30.0, 0.0}) {
    for (const double tolerance_m : {1e-2, 1e-5}) {
      const Track track = sensor::tabulated(law, scene, 3.0, 3.0 + span_s, tolerance_m);
      double worst_m = 0.0;
      for (double t = 3.0; t <= 3.0 + span_s; t += 0.0713) {
        worst_m = std::max(worst_m, length(track.position(t) - scene.enu_from_ecef(law(t))));
      }
      CAPTURE(span_s, tolerance_m);
      CHECK(worst_m <= 1.05 * tolerance_m);  // looked at in two places of each step
      const double step_s = track.times_s()[1] - track.times_s()[0];
      CHECK(track.first_s() == Approx(3.0 - 8.0 * step_s).epsilon(1e-9));
      CHECK(track.last_s() >= 3.0 + span_s + 8.0 * step_s - 1e-9);
      CHECK(track.times_s().size() < 2000);
    }
  }
}

TEST_CASE("flights that are none are refused", "[sensor][flight]") {
  CHECK(message_of(StraightFlight{{0, 0, 0}, 0.0, 0.0, 0.0}) ==
        "the speed of a flight must be above 0, not 0 m/s");
  CHECK(message_of(StraightFlight{{95, 0, 0}, 0.0, 1.0, 0.0}) ==
        "the place, the azimuth and the rates of a flight must be finite");
  CHECK(message_of(CirclingFlight{{0, 0, 0}, 0.0, 1.0, 0.0, true}) ==
        "the radius of a circle must be above 0, not 0 m");
  const LocalFrame scene{{0.0, 0.0, 0.0}};
  const sensor::PositionLaw jumps = [](double t) { return Vec3{6.4e6, t < 0.3 ? 0.0 : 1.0, 0}; };
  CHECK(message_from([&] { return sensor::tabulated(jumps, scene, 0.0, 1.0); }) ==
        "the platform moves too restlessly: 1000000 places are not enough for its track");
  CHECK(message_from([&] { return sensor::tabulated(jumps, scene, 1.0, 0.0); }) ==
        "the span of a track must be finite and not end before it begins");
}
