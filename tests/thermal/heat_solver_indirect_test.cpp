// Rays between surfaces blur what they meet: larger cells will do for them.
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

geometry::Hit by_way_of_another(geometry::Hit hit) {
  hit.indirect = true;
  return hit;
}

/// Ground of 128 m beside a wall whose shadow makes every place different.
struct Place {
  Day day{10.0};
  HeatModel model = model_of(day);
  geometry::Scene scene =
      scene_of({surface(ground(64.0), of_soil),
                surface({{8.0, -64.0, 0.0}, {0.0, 128.0, 0.0}, {0.0, 0.0, 12.0}}, of_wall)});

  /// The ground's triangles are 181 m long: cut by 91 for rays of the camera, by 3 for others.
  Place() {
    model.settings.resolution_m = 2.0;
    model.settings.indirect_factor = 32.0;
  }
};

TEST_CASE("rays between surfaces see cells that are longer", "[thermal][heat_solver]") {
  Place place;
  const HeatSolver solver{place.scene, place.model};
  // Both lie below the diagonal of the middle one of 3 x 3 squares, but in different ones of 1.4 m:
  // one close to the wall.
  const auto near = from_above(place.scene, 6.5, 3.0), far = from_above(place.scene, -12.0, -16.0);
  CHECK(solver.at(near).value != solver.at(far).value);
  CHECK(solver.at(by_way_of_another(near)).value == solver.at(by_way_of_another(far)).value);
  const HeatCounters counters = solver.counters();
  CHECK(counters.cells_on_demand == 3);
}

TEST_CASE("a large cell is as warm as its small ones on the average", "[thermal][heat_solver]") {
  Place place;
  place.model.settings.exposure.sky_rays = 128;
  const auto within = from_above(place.scene, -12.0, -16.0);
  double large = 0.0, small = 0.0;
  constexpr int seeds = 8;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const HeatSolver solver{place.scene, place.model, seed};
    const double coarse = solver.at(by_way_of_another(within)).value;
    double sum = 0.0;
    int count = 0;
    for (double x = -20.9; x < 21.0; x += 3.3) {
      for (double y = -20.9; y < 21.0; y += 3.3) {
        const auto hit = from_above(place.scene, x, y);
        if (solver.at(by_way_of_another(hit)).value != coarse) continue;  // of another large cell
        sum += solver.at(hit).value;
        ++count;
      }
    }
    CHECK(count > 70);
    large += coarse / seeds;
    small += sum / count / seeds;
  }
  // Emission is not linear in T: 0.05 K of the ten by which these places differ. The rays of the
  // large cell leave 0.6 K of it undecided, 0.2 K of the mean of eight, and the hundred places of
  // the small ones (4 K apart, one behind the other) 0.3 K.
  CHECK(large == Approx(small).epsilon(0.0).margin(0.8));
}

TEST_CASE("a facet that is one cell for all rays is solved once", "[thermal][heat_solver]") {
  Place place;
  place.model.settings.resolution_m = 1000.0;
  const HeatSolver solver{place.scene, place.model};
  const auto hit = from_above(place.scene, -12.0, 6.0);
  const bool direct_first = GENERATE(true, false);
  const double first = solver.at(direct_first ? hit : by_way_of_another(hit)).value;
  const double second = solver.at(direct_first ? by_way_of_another(hit) : hit).value;
  CHECK(first == second);
  CHECK(solver.counters().cells_on_demand == 1);
}

}  // namespace
}  // namespace nadir::thermal
