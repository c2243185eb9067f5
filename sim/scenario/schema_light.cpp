#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// The sun at 1 AU has 2000 W m^-2 um^-1 at its peak; lamps may be much brighter.
SpectralType irradiance() { return {from_to(0.0, 1e9)}; }
SpectralType radiance() { return {from_to(0.0, 1e9)}; }
SpectralType fraction() { return {from_to(0.0, 1.0)}; }

std::vector<ElementType> illumination() {
  return {
      {.id = "illumination",
       .name = "illumination",
       .doc = "The bodies that light the scene.",
       .content = Content::one_of,
       .children = {{"ephemeris"}, {"fixed"}}},
      {.id = "ephemeris",
       .name = "ephemeris",
       .doc = "Sun and moon where they stand at the scenario's time, seen from its site.",
       .attributes =
           {optional("solar_irradiance", irradiance(), "W m^-2 um^-1", "the sun is dark",
                     "Of the sun at 1 AU above the air, on a plane normal to its direction; scaled "
                     "by the actual distance."),
            optional("lunar_irradiance", irradiance(), "W m^-2 um^-1", "the moon is dark",
                     "Of the moon above the air, as it arrives that night.")}},
      {.id = "fixed",
       .name = "fixed",
       .doc = "Bodies at given angles. Without any the scene has no sun and no moon.",
       .content = Content::list,
       .children = {{"body"}}},
      {.id = "body",
       .name = "body",
       .doc = "A luminous disc in the sky.",
       .attributes = {required("name", NameType{}, "", "Such as sun."),
                      required("azimuth_deg", full_turn(), "deg", "Clockwise from north."),
                      required("elevation_deg", from_to(-90.0, 90.0), "deg", "Above the horizon."),
                      // 0.2666 deg: the sun's radius of 695700 km seen from 1 AU
                      defaulted("angular_radius_deg", above_to(0.0, 89.0), "deg", "0.2666",
                                "Half the angle that it spans; the default is the sun's."),
                      required("irradiance", irradiance(), "W m^-2 um^-1",
                               "Above the air, on a plane normal to its direction.")}},
  };
}

std::vector<ElementType> air() {
  return {
      {.id = "atmosphere",
       .name = "atmosphere",
       .doc = "The air between sun, sky, ground and sensor.",
       .content = Content::one_of,
       .children = {{"none"}, {"uniform"}}},
      {.id = "none", .name = "none", .doc = "A vacuum: the sky is black."},
      {.id = "uniform",
       .name = "uniform",
       .doc = "The same air everywhere: a sky of one radiance, a path of one transmittance.",
       .attributes =
           {defaulted("sky_radiance", radiance(), "W m^-2 sr^-1 um^-1", "0",
                      "Of the sky in every direction; added to its emission."),
            defaulted("sky_temperature_k", temperature(), "K", "0",
                      "The sky also emits like a black body of this temperature; 0: not at all."),
            defaulted("solar_transmittance", fraction(), "", "1",
                      "Of the air between sun or moon and the ground."),
            defaulted("transmittance", fraction(), "", "1",
                      "Of the air between a surface and the sensor."),
            defaulted("path_radiance", radiance(), "W m^-2 sr^-1 um^-1", "0",
                      "Scattered into the path between a surface and the sensor."),
            defaulted("air_temperature_k", temperature(), "K", "0",
                      "The path also emits (1 - transmittance) of a black body of this "
                      "temperature; 0: not at all."),
            defaulted("sky_shape", EnumerationType{{"even", "overcast"}}, "", "even",
                      "How sky_radiance is spread over the dome: alike in all directions, or three "
                      "times as bright in the zenith as at the horizon. A level surface gets the "
                      "same light either way.")}},
  };
}

/// @param without  empty: the attributes have defaults; otherwise what holds where one is missing
Attribute setting(const std::string& name, AttributeType type, const std::string& value,
                  const std::string& without, const std::string& doc) {
  if (without.empty()) return defaulted(name, std::move(type), "", value, doc);
  return optional(name, std::move(type), "", without, doc);
}

ElementType solver(const std::string& id, const std::string& doc, const std::string& without) {
  return {.id = id,
          .name = "solver",
          .doc = doc,
          .attributes = {
              setting("initial_sample_count", IntegerType{0, 100000}, "8", without,
                      "Full samples at the surface that a pixel sees."),
              setting("sample_decay_rate", from_to(1.0, 1e6), "2", without,
                      "Each bounce has that many times fewer full samples, rounded up."),
              setting("max_bounces", IntegerType{0, 1000}, "3", without,
                      "Surfaces after the first one whose own surroundings are sampled."),
              setting("mu_samples", IntegerType{1, 1000}, "2", without,
                      "Parts of the hemisphere over the cosine of the zenith angle."),
              setting("phi_samples", IntegerType{1, 1000}, "6", without,
                      "Parts of the hemisphere over azimuth."),
              setting("min_quad_samples", IntegerType{0, 1000}, "1", without,
                      "Parts of the hemisphere with fewer full samples are topped up with samples "
                      "that collect emission and sky only.")}};
}

}  // namespace

std::vector<ElementType> schema_of_light() {
  std::vector<ElementType> all = illumination();
  for (ElementType& type : air()) all.push_back(std::move(type));
  ElementType scenario_solver =
      solver("solver", "How radiance is computed, unless a material says otherwise.", "");
  scenario_solver.attributes.push_back(
      defaulted("method", EnumerationType{{"generic", "path"}}, "", "generic",
                "generic: the generic radiometry solver, which the attributes above set. path: the "
                "unbiased path solver, which ignores them."));
  scenario_solver.attributes.push_back(
      defaulted("path_max_bounces", IntegerType{0, 1000000}, "", "0",
                "Of the path solver: surfaces after the first one that a path may reach. 0: no "
                "limit, and no bias."));
  all.push_back(std::move(scenario_solver));
  all.push_back(solver("material_solver", "How radiance is computed on this material.",
                       "as in the scenario's solver"));
  return all;
}

}  // namespace nadir::sim
