#include "sim/products/rpc_fit.hpp"

#include <cmath>

#include "sim/geo_scene.hpp"
#include "sim/products/geotiff.hpp"
#include "sim/products/least_squares.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

/// Places that no point of the fit is at: where image_of has them.
double off_from_camera(const support::GeoScene& scene, const Rpc& rpc, double height_m) {
  double largest = 0.0;
  for (const auto& image : image_grid(scene.array(), {7, 5}, true)) {
    const auto ground = ground_at(scene.geometry, scene.array(), image, height_m);
    const auto seen = sensor::image_of(scene.array(), scene.camera.platform, ground->place);
    const Vec2 found = image_of(rpc, ground->geodetic);
    largest = std::max(largest, std::hypot(found.x - seen->sample, found.y - seen->line));
  }
  return largest;
}

}  // namespace

TEST_CASE("least squares finds what satisfies all equations, and the mean of what cannot") {
  const auto line = least_squares({1, 0, 1, 1, 1, 2}, {1, 3, 5}, 2);
  REQUIRE(line);
  CHECK((*line)[0] == Approx(1.0).epsilon(1e-14));
  CHECK((*line)[1] == Approx(2.0).epsilon(1e-14));
  const auto mean = least_squares({1, 1, 1}, {1, 2, 6}, 1);
  CHECK((*mean)[0] == Approx(3.0).epsilon(1e-14));
  CHECK_FALSE(least_squares({0, 1, 0, 2, 0, 3}, {1, 2, 3}, 2));
}

TEST_CASE("rational polynomials stand for a pushbroom on an orbit to a hundredth of a pixel") {
  const auto scene = support::satellite();
  const Georeference place = georeference(scene->task());
  REQUIRE(place.rpc);
  CHECK(place.control.size() == 81);
  CHECK_FALSE(place.map);
  INFO("residual " << place.rpc->largest_px);
  // The view over 10 km is all but linear: cubic terms leave next to nothing.
  CHECK(place.rpc->largest_px < 0.01);
  for (const double height_m : {80.0, 120.0, 190.0}) {
    // Between the grid's places the fit may be a little worse than where it was judged.
    CHECK(off_from_camera(*scene, place.rpc->rpc, height_m) < 0.01);
  }
}

TEST_CASE("rational polynomials of a distorted frame are off by what is stated") {
  const auto scene = support::drone();
  const Georeference place = georeference(scene->task());
  REQUIRE(place.rpc);
  INFO("residual " << place.rpc->largest_px);
  CHECK(place.rpc->largest_px <= most_rpc_residual_px);
  CHECK(off_from_camera(*scene, place.rpc->rpc, 121.0) < 1.5 * place.rpc->largest_px + 1e-3);
}

TEST_CASE(
    "GDAL's offsets count from the first pixel's centre, and terms come in the standard's order") {
  Rpc rpc;
  rpc.line_off = 100.5;
  rpc.sample_off = 50.5;
  rpc.line_numerator[1] = 2.0;
  for (const auto& [key, value] : gdal_rpc(rpc)) {
    if (key == "LINE_OFF") CHECK(std::stod(value) == 100.0);
    if (key == "SAMP_OFF") CHECK(std::stod(value) == 50.0);
    if (key == "LINE_NUM_COEFF") CHECK(value.substr(0, 5) == "0 2 0");
  }
  // RPC00B: the second term is the longitude, the third the latitude, the fourth the height.
  rpc.line_denominator[0] = rpc.sample_denominator[0] = 1.0;
  CHECK(image_of(rpc, {0.0, 0.25, 0.0}).y == Approx(101.0).epsilon(1e-14));
  CHECK(image_of(rpc, {0.25, 0.0, 0.5}).y == Approx(100.5).epsilon(1e-14));
}

TEST_CASE("too few points have no rational polynomials") {
  CHECK_FALSE(fit_rpc(std::vector<RpcPoint>(99), std::vector<RpcPoint>(5)));
}
