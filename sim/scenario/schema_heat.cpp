#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

std::vector<Attribute> heat_settings() {
  return {
      defaulted("step_min", from_to(0.2, 60.0), "min", "10",
                "Between the moments that are solved for; 24 h are a whole number of steps."),
      defaulted("resolution_m", above_to(0.0, 1e6), "m", "1",
                "Facets are cut into cells no longer than this, each with a temperature."),
      defaulted("indirect_factor", from_to(1.0, 1000.0), "", "8",
                "By which cells are longer for rays between surfaces, which blur what they meet."),
      optional("history_h", from_to(24.0, 8784.0), "h", "from the layers' own time scales",
               "How much of the weather before the image counts, a whole number of steps; before "
               "it its first 24 hours repeat."),
      defaulted("shadow_interval_min", from_to(0.2, 60.0), "min", "10",
                "Between the places of the sun that are looked at; 24 h are a whole number of "
                "them, and it is a multiple or a whole fraction of step_min."),
      defaulted("shadow_days", IntegerType{1, 366}, "", "1",
                "Days before the image whose shadows are their own; earlier days have those of the "
                "first of them."),
      defaulted("sky_rays", IntegerType{1, 65536}, "", "64",
                "By which each cell looks about: how much sky, which surroundings."),
      defaulted("surroundings", IntegerType{0, 1024}, "", "8",
                "Surfaces about each cell whose sun is followed through the day."),
      defaulted("spin_up_k", above_to(0.0, 10.0), "K", "0.05",
                "The repeated day is done with when it ends this near to where it began."),
      defaulted("spin_up_days", IntegerType{1, 10000}, "", "30", "Repeated days at most."),
      // thermal::GridSettings: docs say what they cost and bring
      defaulted("first_fraction", above_to(0.0, 1.0), "", "0.05",
                "First interval of depth over the depth at which a day's wave has fallen to 1/e."),
      defaulted("growth", from_to(1.0, 3.0), "", "1.3",
                "Of each interval of depth over the one above it."),
      optional("substances", PathType{{".csv"}}, "", "library:thermal.csv",
               "Table of the substances that layers name; docs/formats.md."),
      optional("ground_reflectance", from_to(0.0, 1.0), "", "0.2",
               "Of sunlight, beyond the scene.")};
}

ElementType weather_file_type() {
  return {.id = "weather_file",
          .name = "weather_file",
          .doc = "Measured or typical weather; docs/formats.md.",
          .attributes = {
              required("file", PathType{}, "", "CSV, TMY3, EPW or SURFRAD."),
              defaulted("format", EnumerationType{{"auto", "csv", "tmy3", "epw", "surfrad"}}, "",
                        "auto", "auto: as the file looks."),
              optional("any_year", boolean(), "", "true for TMY3 and EPW, false for others",
                       "Only month, day and hour of the file's dates count."),
              defaulted("long_wave",
                        EnumerationType{{"prata", "brutsaert", "idso", "swinbank", "from_air"}}, "",
                        "prata",
                        "Heat radiation of the sky where the file has none: a published fit to the "
                        "air's temperature and humidity (docs/heat-balance.md), or from the "
                        "scenario's atmosphere.")}};
}

ElementType clear_sky_type() {
  std::vector<Attribute> attributes = temperature_pair(
      "air_low", "12 K below air_high; 15 deg C without either", "Of the air at sunrise.");
  for (Attribute& a : temperature_pair("air_high", "12 K above air_low",
                                       "Of the air some two hours after noon.")) {
    attributes.push_back(std::move(a));
  }
  for (Attribute& a :
       temperature_pair("dew_point", "3 K below air_low", "Of the air; at most air_low.")) {
    attributes.push_back(std::move(a));
  }
  attributes.push_back(
      defaulted("wind_m_s", from_to(0.0, 100.0), "m s^-1", "2", "The same all day."));
  return {.id = "clear_sky",
          .name = "clear_sky",
          .doc =
              "No file: a cloudless day like the days before it, its sunlight from ephemeris and "
              "atmosphere.",
          .attributes = std::move(attributes)};
}

}  // namespace

std::vector<ElementType> schema_of_heat() {
  return {{.id = "heat",
           .name = "heat",
           .doc = "The weather, and how temperatures follow from it. Needed by <heat_balance>, "
                  "solve and <air_temperature> of materials.",
           .attributes = heat_settings(),
           .content = Content::one_of,
           .children = {{"weather_file"}, {"clear_sky"}}},
          weather_file_type(),
          clear_sky_type()};
}

}  // namespace nadir::sim
