#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

SpectralType radiance() { return {from_to(0.0, 1e9)}; }

Attribute ground_reflectance() {
  return optional("ground_reflectance", fraction(), "",
                  "the mean of the surfaces that the scene shows from above",
                  "Of the ground about the scene, which lights the air from below and is seen "
                  "beyond the scene's edge.");
}
Attribute ground_temperature() {
  return optional("ground_temperature_k", temperature(), "K",
                  "the mean emission of the surfaces that the scene shows from above",
                  "Of the ground about the scene; its emissivity is 1 - reflectance.");
}

ElementType layered() {
  return {
      .id = "layered",
      .name = "layered",
      .doc =
          "Air in layers, from which sky, path and transmittance are computed for this sun, "
          "place and camera. Without an aerosol element it holds rural haze with 23 km "
          "visibility: a clear day. The site's height counts as above sea level, and as that of "
          "the ground that lights the air.",
      .attributes =
          {defaulted(
               "profile",
               EnumerationType{{"us_standard_1976", "tropical", "midlatitude_summer",
                                "midlatitude_winter", "subarctic_summer", "subarctic_winter"}},
               "", "us_standard_1976", "Temperature, pressure and gases by height, 0 to 120 km."),
           optional(
               "sounding", PathType{{".csv"}}, "", "the profile alone",
               "Measured air: columns height_m, pressure_hpa, temperature_k or temperature_c, and "
               "one of relative_humidity_percent, dewpoint_c, mixing_ratio_g_kg or h2o_ppmv. Other "
               "gases, and the air above it, are the profile's; see docs/air-gases.md."),
           defaulted("mode", EnumerationType{{"accurate", "fast"}}, "", "accurate",
                     "accurate: discrete ordinates. fast: single scattering plus a source from "
                     "two streams; skies within about a tenth."),
           optional("streams", IntegerType{4, 64}, "", "8; 16 where there are clouds",
                    "Directions of the accurate mode, an even number: 8 for about 1 % of a clear "
                    "sky, 16 for 0.2 %, and for 0.5 to 2 % under clouds."),
           defaulted("gas_tolerance", from_to(1e-5, 0.1), "", "0.0005",
                     "Of transmittance: how well few exponentials, each a lane of its own, must "
                     "stand for the lines of gases. Looser is faster; see docs/air-gases.md."),
           optional("water_vapour_g_cm2", from_to(0.0, 20.0), "g cm^-2", "as in the profile",
                    "Of the whole column above the site; the profile's vapour is scaled to it, but "
                    "stays below saturation."),
           optional("water_vapour_factor", from_to(0.0, 20.0), "", "1",
                    "Scales the profile's water vapour, which stays below saturation."),
           optional("ozone_du", from_to(0.0, 2000.0), "DU", "as in the profile",
                    "Of the whole column above the site, in Dobson units (1 DU: 1e-3 atm-cm)."),
           optional("ozone_factor", from_to(0.0, 20.0), "", "1", "Scales the profile's ozone."),
           defaulted("co2_ppm", from_to(0.0, 10000.0), "ppm", "420",
                     "Carbon dioxide by volume, alike at all heights."),
           ground_reflectance(), ground_temperature(),
           defaulted("refraction", boolean(), "", "false",
                     "Sun and moon of the ephemeris stand where the air lifts them, and the "
                     "camera's rays bend where that shows."),
           defaulted("night_sky", boolean(), "", "true", "Airglow, starlight and zodiacal light.")},
      .content = Content::list,
      .children = {{"aerosol"}, {"cloud"}, {"urban_glow"}}};
}

ElementType aerosol() {
  return {.id = "aerosol",
          .name = "aerosol",
          .doc = "The haze; at most one. The air above it has the background of its season.",
          .attributes = {
              defaulted("type",
                        EnumerationType{{"none", "rural", "urban", "maritime", "tropospheric",
                                         "fog_advection", "fog_radiation"}},
                        "", "rural",
                        "Of the lowest 2 km above the ground; none: no particles at any height."),
              optional("visibility_km", above_to(0.0, 336.0), "km", "23",
                       "Meteorological range at 0.55 um."),
              optional("optical_depth_550", from_to(0.0, 20.0), "", "it follows the visibility",
                       "Of the whole column at 0.55 um, in place of visibility_km."),
              defaulted("relative_humidity_percent", from_to(0.0, 99.0), "%", "70",
                        "Of the lowest 2 km: particles swell with it."),
              defaulted("season", EnumerationType{{"spring_summer", "autumn_winter"}}, "",
                        "spring_summer", "Of the haze from 2 to 30 km."),
              defaulted("volcanic", EnumerationType{{"background", "moderate", "high", "extreme"}},
                        "", "background", "State of the stratosphere, 10 to 30 km.")}};
}

ElementType cloud() {
  return {.id = "cloud",
          .name = "cloud",
          .doc =
              "A cloud that covers the whole sky, a layer of the air. Any number of them; those "
              "that overlap add up.",
          .attributes = {
              required("type",
                       EnumerationType{{"cumulus", "altostratus", "stratus", "stratocumulus",
                                        "nimbostratus", "cirrus", "cirrus_thin", "fog_advection",
                                        "fog_radiation"}},
                       "", "Which droplets or crystals."),
              required("base_m", from_to(0.0, 3e4), "m", "Height of its base above the ground."),
              required("top_m", above_to(0.0, 3e4), "m", "Height of its top above the ground."),
              required("optical_depth_550", from_to(0.0, 500.0), "",
                       "Vertical extinction at 0.55 um.")}};
}

ElementType urban_glow() {
  return {.id = "urban_glow",
          .name = "urban_glow",
          .doc = "Light of a town's lamps that the air sends back; at most one.",
          .attributes = {required("radiance", radiance(), "W m^-2 sr^-1 um^-1",
                                  "In the zenith, as seen from the scene.")}};
}

ElementType table() {
  return {.id = "air_table",
          .name = "table",
          .doc =
              "Air whose sky, path and transmittance were computed or measured elsewhere, for "
              "this place and sun: see docs/air-table-format.md.",
          .attributes = {required("file", PathType{{".air"}}, "", "A table of the air."),
                         ground_reflectance(), ground_temperature()}};
}

}  // namespace

std::vector<ElementType> schema_of_air() {
  return {
      {.id = "atmosphere",
       .name = "atmosphere",
       .doc = "The air between sun, sky, ground and sensor.",
       .content = Content::one_of,
       .children = {{"none"}, {"uniform"}, {"layered"}, {"air_table"}}},
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
      layered(),
      aerosol(),
      cloud(),
      urban_glow(),
      table(),
  };
}

}  // namespace nadir::sim
