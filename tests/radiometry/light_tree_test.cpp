#include "radiometry/lamps/light_tree.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using radiometry::LightTree;
using radiometry::LightTreeItem;

namespace {

constexpr double light_tree_pi = std::numbers::pi;

LightTreeItem isotropic(Vec3 place, double weight = 1.0) {
  return {{place, place}, {0.0, 0.0, 1.0}, light_tree_pi, 0.0, weight};
}
LightTreeItem facing(Vec3 place, Vec3 axis, double weight = 1.0) {
  return {{place, place}, axis, 0.0, light_tree_pi / 2, weight};
}

Vec3 random_place(Rng& rng, double size) {
  const double x = rng.next(), y = rng.next(), z = rng.next();
  return size * Vec3{x - 0.5, y - 0.5, z - 0.5};
}

std::vector<LightTreeItem> random_items(Rng& rng, int count) {
  std::vector<LightTreeItem> items;
  for (int i = 0; i < count; ++i) {
    const Vec3 place = random_place(rng, 100.0), axis = support::random_on_sphere(rng);
    const double weight = std::exp(6.0 * rng.next());
    items.push_back(i % 3 == 0 ? isotropic(place, weight) : facing(place, axis, weight));
  }
  return items;
}

double sum_of_chances(const LightTree& tree, std::uint32_t count, Vec3 place, Vec3 normal) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) sum += tree.probability(i, place, normal);
  return sum;
}

}  // namespace

TEST_CASE("the chances of all lamps sum to 1 where each could light the place",
          "[radiometry][lamps]") {
  Rng rng{11};
  const int count = GENERATE(1, 2, 8, 9, 300);
  std::vector<LightTreeItem> items;
  for (int i = 0; i < count; ++i) items.push_back(isotropic(random_place(rng, 50.0)));
  const LightTree tree{items};
  for (int k = 0; k < 10; ++k) {
    // The importances are floats: eight of them sum to 1 within 8 x 6e-8, on five levels.
    CHECK(sum_of_chances(tree, static_cast<std::uint32_t>(count), random_place(rng, 80.0), {}) ==
          Approx(1.0).epsilon(3e-6));
  }
}

TEST_CASE("the chances never sum to more than 1, and what a draw gives has the chance it states",
          "[radiometry][lamps]") {
  Rng rng{12};
  const auto items = random_items(rng, 300);
  const LightTree tree{items};
  for (int k = 0; k < 20; ++k) {
    const Vec3 place = random_place(rng, 120.0), normal = support::random_on_sphere(rng);
    CHECK(sum_of_chances(tree, 300, place, normal) <= 1.0 + 3e-6);  // as above
    const auto drawn = tree.draw(place, normal, rng.next());
    if (!drawn) continue;
    CHECK(drawn->probability > 0.0);
    CHECK(drawn->probability ==
          Approx(tree.probability(drawn->item, place, normal)).epsilon(1e-12));
  }
}

TEST_CASE("lamps are drawn as often as their chances say", "[radiometry][lamps]") {
  Rng rng{13};
  const auto items = random_items(rng, 60);
  const LightTree tree{items};
  const Vec3 place{3.0, -4.0, 10.0}, normal{0.0, 0.0, 1.0};
  constexpr int draws = 40'000;
  std::vector<int> count(items.size(), 0);
  // Equally spaced numbers: each lamp's share is met within its ends, two a level at most.
  for (int k = 0; k < draws; ++k) {
    if (const auto drawn = tree.draw(place, normal, (k + 0.5) / draws)) ++count[drawn->item];
  }
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    CAPTURE(i);
    CHECK(count[i] == Approx(draws * tree.probability(i, place, normal)).margin(4.0).epsilon(1e-4));
  }
}

TEST_CASE("no lamp that can light a place is left out", "[radiometry][lamps]") {
  Rng rng{14};
  const auto items = random_items(rng, 200);
  const LightTree tree{items};
  for (int k = 0; k < 100; ++k) {
    const Vec3 place = random_place(rng, 150.0), normal = support::random_on_sphere(rng);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      const Vec3 away = normalised(place - items[i].box.lo);
      const bool lights =
          (items[i].spread_rad > 3.0 || dot(away, items[i].axis) > 0.0) && dot(away, normal) < 0.0;
      if (lights && !(tree.probability(i, place, normal) > 0.0)) {
        CAPTURE(k, i);
        FAIL("a lamp that lights the place is never drawn");
      }
    }
  }
  SUCCEED();
}

TEST_CASE("a lamp that faces away or stands behind the surface is not drawn",
          "[radiometry][lamps]") {
  const LightTree tree{
      {facing({0, 0, 5}, {0, 0, -1}), facing({1, 0, 5}, {0, 0, 1}), facing({0, 0, -5}, {0, 0, 1})}};
  const Vec3 up{0.0, 0.0, 1.0};
  CHECK(tree.probability(0, {}, up) == Approx(1.0).epsilon(1e-5));  // slack for rounding: 1e-6
  CHECK(tree.probability(1, {}, up) < 1e-5);
  CHECK(tree.probability(2, {}, up) < 1e-5);
  CHECK(tree.probability(2, {}, {}) == Approx(0.5).epsilon(1e-5));  // lit from both sides
}

TEST_CASE("a hierarchy stands lamps in one place, without weight, and of 1e9 times the weight",
          "[radiometry][lamps]") {
  CHECK(LightTree{}.empty());
  CHECK(LightTree{{isotropic({}, 0.0)}}.empty());
  CHECK_FALSE(LightTree{}.draw({}, {}, 0.5));
  std::vector<LightTreeItem> same(20, isotropic({1.0, 2.0, 3.0}));
  same.push_back(isotropic({1.0, 2.0, 3.0}, 0.0));
  const LightTree tree{same};
  CHECK(sum_of_chances(tree, 21, {}, {}) == Approx(1.0).epsilon(3e-6));
  CHECK(tree.probability(20, {}, {}) == 0.0);
  const auto at_lamp = tree.draw({1.0, 2.0, 3.0}, {}, 0.999999);
  REQUIRE(at_lamp);
  CHECK(std::isfinite(at_lamp->probability));
  const LightTree uneven{{isotropic({0, 0, 1}, 1e9), isotropic({0, 0, 2}, 1.0)}};
  CHECK(uneven.probability(1, {}, {}) == Approx(0.25e-9).epsilon(1e-4));
}
