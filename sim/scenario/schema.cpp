#include "sim/scenario/schema.hpp"

#include <iterator>

#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {

Schema::Schema(std::vector<ElementType> types) : types_{std::move(types)} {
  for (std::size_t i = 0; i < types_.size(); ++i) index_[types_[i].id] = i;
}

const Schema& schema() {
  static const Schema table = [] {
    std::vector<ElementType> all;
    for (auto&& part : {schema_of_root(), schema_of_light(), schema_of_air(), schema_of_heat(),
                        schema_of_solver(), schema_of_materials(), schema_of_scattering(),
                        schema_of_temperature(), schema_of_maps(), schema_of_geometry(),
                        schema_of_volumes(), schema_of_lamps(), schema_of_platform(),
                        schema_of_camera(), schema_of_effects(), schema_of_results()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return Schema{std::move(all)};
  }();
  return table;
}

std::vector<ElementType> schema_of_root() {
  return {
      {.id = scenario_root,
       .name = "scenario",
       .doc = "Everything about one image: when and where, light, air, ground, sensor, products.",
       .attributes = {required("name", NameType{}, "", "Products are called after it."),
                      optional("title", TextType{}, "", "no title", "For people.")},
       .content = Content::record,
       .children = {{"time", true},
                    {"site", true},
                    {"illumination", true},
                    {"atmosphere", true},
                    {"heat"},
                    {"solver"},
                    {"materials", true},
                    {"geometry", true},
                    {"volumes"},
                    {"lamps"},
                    {"platform", true},
                    {"camera", true},
                    {"effects"},
                    {"accuracy"},
                    {"sampling"},
                    {"products"}}},
      {.id = "time",
       .name = "time",
       .doc = "The moment of the image, 1900 to 2100.",
       .attributes =
           {required("utc", InstantType{}, "", "Date and time, at most nine decimals of a second."),
            defaulted("ut1_minus_utc_s", from_to(-200.0, 200.0), "s", "0",
                      "UT1 - UTC from the bulletins of the IERS. At most 1 s, but 200 s after the "
                      "end of the table of leap seconds, and 0 before 1960.")}},
      {.id = "site",
       .name = "site",
       .doc = "Origin of the scene's axes (x east, y north, z up) on or above the WGS84 ellipsoid, "
              "and where sun and moon are seen from.",
       .attributes = {required("latitude_deg", latitude(), "deg", "Geodetic, north positive."),
                      required("longitude_deg", longitude(), "deg", "East positive."),
                      required("height_m", from_to(-1e4, 1e5), "m", "Above the ellipsoid.")}},
  };
}

}  // namespace nadir::sim
