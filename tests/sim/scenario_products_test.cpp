#include "scenario_support.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

/// The minimal scenario with <products> in line 25.
std::string with_products(const std::string& attributes) {
  return replaced(minimal_text(), "</scenario>", "<products " + attributes + "/></scenario>");
}
ProductsInput products_from(const std::string& text) {
  Diagnostics diagnostics;
  return parse_scenario(text, test::data_folder() / "test.xml", diagnostics).products;
}
std::string with_detector(const std::string& attributes, const std::string& detector) {
  return replaced(with_products(attributes), "<band_box", detector + "<band_box");
}

}  // namespace

TEST_CASE("products that nobody asks for have their defaults", "[scenario][products]") {
  const ProductsInput found = products_from(with_products(""));
  const ProductsInput standard;
  CHECK(found.geotiff == standard.geotiff);
  CHECK(found.netcdf == standard.netcdf);
  CHECK(found.sidecars == standard.sidecars);
  CHECK(found.electrons == standard.electrons);
  CHECK(found.statistics == standard.statistics);
  CHECK(found.sky_view == standard.sky_view);
  CHECK(found.fractions == standard.fractions);
}

TEST_CASE("each switch of the products turns its own", "[scenario][products]") {
  CHECK(products_from(with_products("geotiff=\"true\"")).geotiff);
  CHECK(products_from(with_products("netcdf=\"true\"")).netcdf);
  CHECK_FALSE(products_from(with_products("sidecars=\"false\"")).sidecars);
  CHECK(products_from(with_products("statistics=\"true\"")).statistics);
  CHECK(products_from(with_products("sky_view=\"true\"")).sky_view);
  CHECK(products_from(with_products("fractions=\"true\"")).fractions);
  const ProductsInput found = products_from(with_products("netcdf=\"true\""));
  CHECK_FALSE(found.geotiff);
  CHECK_FALSE(found.fractions);
}

TEST_CASE("planes of the truth need the truth", "[scenario][products][mistakes]") {
  CHECK(mistake_lines(with_products("truth=\"false\" sky_view=\"true\" fractions=\"true\"")) ==
        "25:25: sky_view=\"true\" asks for a plane that truth=\"false\" leaves out\n"
        "25:41: fractions=\"true\" asks for a plane that truth=\"false\" leaves out\n");
}

TEST_CASE("electrons need a detector that counts them", "[scenario][products][mistakes]") {
  CHECK(mistake_lines(with_products("electrons=\"true\"")) ==
        "25:11: electrons=\"true\", but no array of the camera has a detector\n");
  CHECK(mistake_lines(with_detector("electrons=\"true\"",
                                    "<published_noise bits=\"12\" saturation_radiance=\"20\" />"))
            .find("the camera's detectors are known by published noise: none counts electrons") !=
        std::string::npos);
}
