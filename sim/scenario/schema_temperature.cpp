#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

const char* const other_unit = "the other unit's attribute, or none";

Attribute gain_of_values() {
  return defaulted("gain", from_to(-1e6, 1e6), "", "1", "Temperature = gain x value + offset_k.");
}
Attribute offset_of_values() {
  return defaulted("offset_k", from_to(-1e4, 1e4), "K", "0", "Added after the gain.");
}
Attribute unit_of_values(const std::string& of) {
  return defaulted("unit", EnumerationType{{"K", "C"}}, "", "K",
                   "Of " + of + ", gain and offset counted; C: degrees Celsius.");
}

ElementType temperature_raster() {
  std::vector<Attribute> own = {
      optional("file", PathType{}, "", "the slices name theirs", "Any raster that GDAL reads."),
      optional("band", band_number(), "", "1", "Of the file."), gain_of_values(),
      offset_of_values(), unit_of_values("the raster's values")};
  return {.id = "temperature_raster",
          .name = "temperature_raster",
          .doc =
              "Temperatures from a raster, linear between pixel centres. Names one file, or holds "
              "slices taken at several times, between which they are linear as well.",
          .attributes = map_placement(std::move(own)),
          .content = Content::list,
          .children = {{"temperature_slice"}}};
}

std::vector<ElementType> given_temperatures() {
  return {
      temperature_raster(),
      {.id = "temperature_slice",
       .name = "slice",
       .doc = "A raster of temperatures and when it holds.",
       .attributes = {required("utc", InstantType{}, "", "When the raster was taken."),
                      required("file", PathType{}, "", "Any raster that GDAL reads."),
                      defaulted("band", band_number(), "", "1", "Of the file.")}},
      {.id = "temperature_table",
       .name = "temperature_table",
       .doc = "One temperature for the whole material, from a table over time, linear between its "
              "rows.",
       .attributes = {required("file", PathType{{".csv"}}, "",
                               "With a column utc and at least one of temperatures; "
                               "docs/formats.md."),
                      optional("column", TextType{}, "", "temperature_k or temperature_c",
                               "Name of the column; ends in _k or _c.")}},
      {.id = "vertex_temperature",
       .name = "vertex_temperature",
       .doc = "What the vertices of a PLY mesh carry, linear within each triangle: property "
              "temperature_k, temperature_c (turned into K) or temperature (in K, unless offset_k "
              "says otherwise).",
       .attributes = {gain_of_values(), offset_of_values()}},
      {.id = "air_temperature",
       .name = "air_temperature",
       .doc = "As warm as the air of <heat> at the moment of the image.",
       .attributes = {defaulted("offset_k", from_to(-200.0, 200.0), "K", "0",
                                "Warmer than the air by this.")}},
  };
}

std::vector<Attribute> balance_attributes() {
  std::vector<Attribute> all = {
      optional("solar_absorptance", from_to(0.0, 1.0), "", "from the material's spectra",
               "Share of sunlight that heats the surface."),
      optional("emissivity", from_to(0.0, 1.0), "", "from the material's spectra",
               "Hemispherical, of heat radiation; the share of it that is absorbed as well."),
      defaulted("convection", EnumerationType{{"tarp", "mcadams", "simple", "fixed"}}, "", "tarp",
                "How moving air takes heat; docs/temperature-sources.md."),
      optional("roughness",
               EnumerationType{{"very_rough", "rough", "medium_rough", "medium_smooth", "smooth",
                                "very_smooth"}},
               "", "medium_rough", "For convection tarp and simple: stucco to glass."),
      optional("film_w_m2_k", from_to(0.0, 1e4), "W m^-2 K^-1", "convection is not fixed",
               "For convection fixed: heat per area and kelvin between air and surface."),
      optional("wind_factor", from_to(0.0, 10.0), "", "1",
               "Wind at the surface over the weather's; not for convection fixed."),
      defaulted("wetness", from_to(0.0, 1.0), "", "0",
                "Share of the evaporation of open water: 0 dry, 1 open water."),
      defaulted("back", EnumerationType{{"adiabatic", "fixed", "room", "open"}}, "", "adiabatic",
                "Behind the last layer: nothing passes; a fixed temperature; a room; weather on "
                "both sides of a thin sheet.")};
  for (Attribute& a : temperature_pair("back_temperature", other_unit, "For back fixed.")) {
    all.push_back(std::move(a));
  }
  for (Attribute& a :
       temperature_pair("room_temperature", "that of the air outdoors", "For back room.")) {
    all.push_back(std::move(a));
  }
  all.push_back(optional("room_offset_k", from_to(-200.0, 200.0), "K", "0",
                         "For back room without a temperature: warmer than the air outdoors."));
  // 8.3 W/m2/K: still air at a wall, convection and radiation (ASHRAE HOF 2005, chapter 25)
  all.push_back(optional("room_film_w_m2_k", above_to(0.0, 1e4), "W m^-2 K^-1", "8.3",
                         "For back room: heat per area and kelvin between room and last layer."));
  return all;
}

std::vector<ElementType> heat_balance_types() {
  return {
      {.id = "heat_balance",
       .name = "heat_balance",
       .doc = "Temperatures that sun, sky, air and the layers beneath the surface bring about. "
              "Needs <heat>. Its layers stand from the surface inwards.",
       .attributes = balance_attributes(),
       .content = Content::list,
       .children = {{"heat_layer"}},
       .at_least = 1},
      {.id = "heat_layer",
       .name = "layer",
       .doc = "Has a substance, or three figures of its own.",
       .attributes = {optional("substance", NameType{}, "", "the figures below",
                               "Of the table of substances."),
                      optional("conductivity_w_m_k", above_to(0.0, 1e5), "W m^-1 K^-1",
                               "the substance's", "Thermal conductivity."),
                      optional("density_kg_m3", above_to(0.0, 1e5), "kg m^-3", "the substance's",
                               "Density."),
                      optional("specific_heat_j_kg_k", above_to(0.0, 1e5), "J kg^-1 K^-1",
                               "the substance's", "Specific heat."),
                      optional("thickness_m", above_to(0.0, 1e3), "m",
                               "the last layer: as deep as a day's wave goes",
                               "Needed but for the last layer above an adiabatic back."),
                      defaulted(
                          "heat_w_m2", from_to(-1e6, 1e6), "W m^-2", "0",
                          "Released within the layer, per area of surface; below 0: taken out.")}},
  };
}

}  // namespace

std::vector<Attribute> temperature_pair(const std::string& name, const std::string& without,
                                        const std::string& doc) {
  return {optional(name + "_k", temperature(), "K", without, doc),
          optional(name + "_c", celsius(), "deg C", without,
                   "The same in degrees Celsius; give one of the two.")};
}

std::vector<Attribute> own_temperature() {
  std::vector<Attribute> all =
      temperature_pair("temperature", "as its material's",
                       "In place of the material's temperature; 0 K: it does not "
                       "emit.");
  all.push_back(optional("temperature_of", NameType{}, "", "as its material's",
                         "Name of a material whose source of temperature to take; give at most "
                         "one of the three."));
  return all;
}

std::vector<Child> temperature_children() {
  return {{"heat_balance"},
          {"temperature_raster"},
          {"temperature_table"},
          {"vertex_temperature"},
          {"air_temperature"}};
}

std::vector<ElementType> schema_of_temperature() {
  std::vector<ElementType> all = heat_balance_types();
  for (ElementType& type : given_temperatures()) all.push_back(std::move(type));
  return all;
}

}  // namespace nadir::sim
