#include "sim/scenario/schema_parts.hpp"
#include "sim/scenario/schema_platform.hpp"

namespace nadir::sim {
namespace {

// The fastest that stays near the earth: escape velocity at the ground is 11.2 km/s.
NumberType flight_speed() { return above_to(0.0, 2e4); }
NumberType flight_azimuth() { return from_to(-360.0, 360.0); }

std::vector<ElementType> flight_types() {
  return {
      {.id = "straight",
       .name = "straight",
       .doc =
           "Flight along a geodesic at constant speed; its place is that at the scenario's time.",
       .attributes = {required("azimuth_deg", flight_azimuth(), "deg",
                               "Of the way there, clockwise from north."),
                      required("speed_m_s", flight_speed(), "m/s",
                               "Along the ellipsoid at the flight's height."),
                      defaulted("climb_m_s", from_to(-2e4, 2e4), "m/s", "0", "Of the height.")},
       .content = Content::one_of,
       .children = {{"geodetic"}, {"local"}}},
      {.id = "circle",
       .name = "circle",
       .doc = "Flight round a place at constant height and speed; the place is the centre, at the "
              "height of the flight.",
       .attributes = {required("radius_m", above_to(0.0, 1e6), "m", "Of the circle."),
                      required("speed_m_s", flight_speed(), "m/s", "Along the circle."),
                      required("azimuth_deg", flight_azimuth(), "deg",
                               "From the centre to the platform at the scenario's time, clockwise "
                               "from north."),
                      defaulted("turn", EnumerationType{{"clockwise", "anticlockwise"}}, "",
                                "clockwise", "Seen from above.")},
       .content = Content::one_of,
       .children = {{"geodetic"}, {"local"}}},
      {.id = "waypoints",
       .name = "waypoints",
       .doc = "Places at moments, from a table; docs/formats.md.",
       .attributes =
           {required("file", PathType{{".csv"}}, "",
                     "Times as time_s or time_utc, and latitude_deg, longitude_deg, height_m; or "
                     "x_m, y_m, z_m (ECEF); or east_m, north_m, up_m."),
            defaulted("interpolation", EnumerationType{{"lagrange", "straight"}}, "", "lagrange",
                      "Between the places: the polynomial through the eight nearest, or straight "
                      "lines."),
            optional("max_gap_s", above_to(0.0, 1e9), "s",
                     "5 times the median step; any with straight lines or fewer than 8 places",
                     "The longest time between two places that are used while the camera "
                     "looks.")}},
  };
}

std::vector<ElementType> orbit_types() {
  return {
      {.id = "circular_orbit",
       .name = "circular_orbit",
       .doc = "A circular orbit that passes over a place at the scenario's time; the earth turns "
              "below it and its oblateness turns its plane.",
       .attributes =
           {required("latitude_deg", latitude(), "deg", "Geodetic, of the place passed over."),
            required("longitude_deg", longitude(), "deg", "East positive."),
            required("height_m", from_to(1e5, 1e8), "m", "Above the WGS84 ellipsoid there."),
            required("inclination_deg", from_to(0.0, 180.0), "deg",
                     "Of the orbit's plane against the equator; above 90 moves westwards."),
            required("direction", EnumerationType{{"descending", "ascending"}}, "",
                     "Southwards or northwards over the place.")}},
      {.id = "kepler_orbit",
       .name = "kepler_orbit",
       .doc = "An orbit by its elements in the axes of the true equator and mean equinox of date; "
              "the earth's oblateness (J2) drifts node, perigee and mean anomaly.",
       .attributes =
           {required("epoch", InstantType{}, "", "When the elements hold."),
            required("semi_major_axis_km", from_to(6400.0, 1e5), "km", "Of the ellipse."),
            required("eccentricity", NumberType{0.0, 1.0, false, true}, "", "Of the ellipse."),
            required("inclination_deg", from_to(0.0, 180.0), "deg", "Against the equator."),
            required("ascending_node_deg", full_turn(), "deg", "Its right ascension."),
            required("argument_of_perigee_deg", full_turn(), "deg", "From the ascending node."),
            required("mean_anomaly_deg", full_turn(), "deg", "At the epoch.")}},
      {.id = "tle",
       .name = "tle",
       .doc = "An orbit from two-line elements by SGP4.",
       .attributes = {required("file", PathType{}, "", "Sets of two or three lines."),
                      required("satellite", TextType{}, "",
                               "Its catalogue number or name in the file.")}},
      {.id = "oem",
       .name = "oem",
       .doc = "A way from a CCSDS orbit ephemeris message.",
       .attributes = {required("file", PathType{}, "", "OEM in key-value notation."),
                      optional("max_gap_s", above_to(0.0, 1e9), "s",
                               "5 times the median step; any with fewer than 8 places",
                               "The longest time between two places that are used while the "
                               "camera looks.")}},
  };
}

}  // namespace

std::vector<ElementType> schema_of_ways() {
  std::vector<ElementType> all = flight_types();
  for (ElementType& type : orbit_types()) all.push_back(std::move(type));
  return all;
}

}  // namespace nadir::sim
