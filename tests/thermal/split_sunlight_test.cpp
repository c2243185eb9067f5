#include "thermal/weather/split_sunlight.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

double cosine_of_deg(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

// The paper's equation by hand: 1 - 0.009; 0.9511 - 0.0802 + 1.097 - 2.07975 + 0.771; 0.165.
TEST_CASE("the diffuse share is Erbs, Klein and Duffie's", "[thermal]") {
  CHECK(diffuse_share(0.1) == Approx(0.991).epsilon(1e-14));
  CHECK(diffuse_share(0.5) == Approx(0.65915).epsilon(1e-12));
  CHECK(diffuse_share(0.85) == 0.165);
  CHECK(diffuse_share(0.0) == 1.0);
  CHECK(diffuse_share(-0.2) == 1.0);
  CHECK(diffuse_share(5.0) == 0.165);
}

// The published branches meet to 4e-4 at 0.22 and 6e-5 at 0.80.
TEST_CASE("the diffuse share is continuous and falls until the sky is clear", "[thermal]") {
  CHECK(diffuse_share(std::nextafter(0.22, 1.0)) == Approx(diffuse_share(0.22)).margin(5e-4));
  CHECK(diffuse_share(std::nextafter(0.80, 1.0)) == Approx(diffuse_share(0.80)).margin(1e-3));
  for (double k = 0.0; k < 0.74; k += 0.01)
    CHECK(diffuse_share(k + 0.01) < diffuse_share(k) + 5e-4);
}

// pvlib's regression values of its erbs(): global 50 W m^-2 at 85 degrees and 1000 at 10 degrees on
// 1 January, where its extraterrestrial irradiance is 1413.98 W m^-2 (from its own clearness,
// 0.718132729 = 1000 / (E cos 10 degrees)).
TEST_CASE("direct and diffuse sunlight agree with another program's", "[thermal]") {
  const double outside = 1000.0 / (0.718132729 * cosine_of_deg(10.0));
  const SplitSunlight high = split_sunlight(1000.0, {cosine_of_deg(10.0), outside});
  CHECK(high.direct_normal_w_m2 == Approx(794.205651).epsilon(1e-7));
  CHECK(high.diffuse_horizontal_w_m2 == Approx(217.860117).epsilon(1e-7));
  const SplitSunlight low = split_sunlight(50.0, {cosine_of_deg(85.0), outside});
  CHECK(low.direct_normal_w_m2 == Approx(96.7192672).epsilon(1e-7));
  CHECK(low.diffuse_horizontal_w_m2 == Approx(41.5703604).epsilon(1e-7));
}

TEST_CASE("split sunlight adds up again, whatever the sun's height", "[thermal]") {
  Rng rng{4, 9};
  for (int i = 0; i < 5000; ++i) {
    const double cosine = 2.0 * rng.next() - 1.0;
    const double global = 1500.0 * rng.next() * rng.next();
    const SplitSunlight split = split_sunlight(global, {cosine, 1361.0});
    CAPTURE(cosine, global);
    REQUIRE(split.direct_normal_w_m2 >= 0.0);
    REQUIRE(split.direct_normal_w_m2 <= 1361.0);
    REQUIRE(split.diffuse_horizontal_w_m2 >= 0.0);
    const double sum = split.direct_normal_w_m2 * cosine + split.diffuse_horizontal_w_m2;
    REQUIRE(sum == Approx(global).epsilon(1e-13).margin(1e-12));  // two roundings
  }
}

TEST_CASE("a sun at the horizon or below gives diffuse light alone", "[thermal]") {
  for (const double cosine : {-0.3, 0.0, 1e-9, 0.05}) {
    const SplitSunlight split = split_sunlight(30.0, {cosine, 1361.0});
    CHECK(split.direct_normal_w_m2 == 0.0);
    CHECK(split.diffuse_horizontal_w_m2 == 30.0);
  }
  CHECK(split_sunlight(-4.0, {0.5, 1361.0}).diffuse_horizontal_w_m2 == 0.0);
}

TEST_CASE("light beyond what the sun gives is diffuse", "[thermal]") {
  const SplitSunlight split = split_sunlight(300.0, {0.1, 1361.0});  // 3 times what is there
  CHECK(split.direct_normal_w_m2 == 1361.0);
  CHECK(split.diffuse_horizontal_w_m2 == Approx(300.0 - 136.1).epsilon(1e-13));
}

}  // namespace
}  // namespace nadir::thermal
