#include "thermal/conduction/depth_grid.hpp"

#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

const Substance asphalt{0.75, 2110.0, 920.0};
const Substance soil{1.0, 1700.0, 1200.0};
const Substance insulation{0.03, 30.0, 1400.0};
const Substance steel{45.0, 7800.0, 500.0};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double damping(const Substance& substance) {
  return damping_depth(substance, Seconds{86400.0}).value;
}

}  // namespace

// Sums of shares: rounding only.
TEST_CASE("a grid holds the heat, the resistance and the sources of its layers",
          "[thermal][conduction]") {
  const LayerStack stack{{{steel, 0.001, 3.0}, {insulation, 0.08, 0.0}, {soil, 0.7, 11.0}},
                         AdiabaticBack{}};
  const DepthGrid grid = make_grid(stack);
  REQUIRE(grid.capacity_j_m2_k.size() == grid.nodes());
  REQUIRE(grid.heat_w_m2.size() == grid.nodes());
  REQUIRE(grid.conductance_w_m2_k.size() == grid.nodes() - 1);
  double capacity = 0.0, resistance = 0.0, through = 0.0;
  for (const Layer& layer : stack.layers) {
    capacity += layer.thickness_m * layer.substance.heat_capacity_j_m3_k();
    resistance += layer.thickness_m / layer.substance.conductivity_w_m_k;
  }
  for (const double conductance : grid.conductance_w_m2_k) through += 1.0 / conductance;
  CHECK(sum(grid.capacity_j_m2_k) == Approx(capacity).epsilon(1e-13));
  CHECK(sum(grid.heat_w_m2) == Approx(14.0).epsilon(1e-13));
  CHECK(through == Approx(resistance).epsilon(1e-13));
  CHECK(grid.depth_m.back() == Approx(0.781).epsilon(1e-13));
}

TEST_CASE("a grid has nodes at the surface and at every joint", "[thermal][conduction]") {
  const DepthGrid grid =
      make_grid({{{asphalt, 0.07, 0.0}, {insulation, 0.05, 0.0}, {soil, 0.5, 0.0}}, RoomBack{}});
  CHECK(grid.depth_m.front() == 0.0);
  for (const double joint : {0.07, 0.12, 0.62}) {
    CAPTURE(joint);
    double nearest = 1.0;
    for (const double depth : grid.depth_m) nearest = std::min(nearest, std::abs(depth - joint));
    CHECK(nearest < 1e-14);  // rounding of sums
  }
}

TEST_CASE("intervals begin at the asked share of a damping depth and grow as asked",
          "[thermal][conduction]") {
  const GridSettings settings{.first_fraction = 0.05, .growth = 1.3, .least_per_layer = 1};
  const DepthGrid grid = make_grid({{{soil, 1.0, 0.0}}, AdiabaticBack{}}, settings);
  const double first = grid.depth_m[1] / damping(soil);
  CHECK(first <= 0.05);
  CHECK(first > 0.05 / 1.3);  // fitted to the layer: less than one more interval's worth
  for (std::size_t i = 2; i < grid.nodes(); ++i) {
    CHECK((grid.depth_m[i] - grid.depth_m[i - 1]) / (grid.depth_m[i - 1] - grid.depth_m[i - 2]) ==
          Approx(1.3).epsilon(1e-9));  // differences of depths lose some digits
  }
  CHECK(grid.nodes() >= 15);
  CHECK(grid.nodes() <= 20);
}

TEST_CASE("no interval is longer than its depth allows, in any layer", "[thermal][conduction]") {
  const GridSettings settings{.first_fraction = 0.03, .growth = 1.2, .least_per_layer = 2};
  const std::vector<Layer> layers{
      {steel, 0.0005, 0.0}, {insulation, 0.03, 0.0}, {asphalt, 0.1, 0.0}, {soil, 0.6, 0.0}};
  const DepthGrid grid = make_grid({layers, AdiabaticBack{}}, settings);
  double xi = 0.0;
  std::size_t node = 1;
  for (const Layer& layer : layers) {
    double left = layer.thickness_m;
    int intervals = 0;
    for (; left > 1e-12; ++node, ++intervals) {
      const double length = grid.depth_m[node] - grid.depth_m[node - 1];
      const double scaled = length / damping(layer.substance);
      CHECK(scaled <= (0.03 + 0.2 * xi) * (1.0 + 1e-9));
      xi += scaled;
      left -= length;
    }
    CHECK(intervals >= 2);
  }
  CHECK(node == grid.nodes());
}

TEST_CASE("what has one temperature has one node", "[thermal][conduction]") {
  const LayerStack sheet{{{steel, 0.001, 7.0}}, AdiabaticBack{}};
  CHECK(make_grid(sheet).nodes() == 1);
  CHECK(make_grid(sheet).capacity_j_m2_k[0] == Approx(3900.0).epsilon(1e-14));
  CHECK(make_grid(sheet).heat_w_m2[0] == 7.0);
  CHECK(make_grid({sheet.layers, RoomBack{}}).nodes() == 1);
  CHECK(make_grid({{{{1.0, 2500.0, 750.0}, 0.004, 0.0}}, OpenBack{}}).nodes() == 1);
  // glass on a wall has a temperature on either side, and so has a sheet on a cooled plate
  CHECK(make_grid({{{{1.0, 2500.0, 750.0}, 0.004, 0.0}}, RoomBack{}}).nodes() == 2);
  CHECK(make_grid({sheet.layers, FixedBack{Kelvin{280.0}}}).nodes() == 2);
  // a thin sheet on insulation: one interval
  const DepthGrid panel = make_grid({{{steel, 0.001, 0.0}, {insulation, 0.1, 0.0}}, RoomBack{}});
  CHECK(panel.depth_m[1] == Approx(0.001).epsilon(1e-12));
}

TEST_CASE("grid settings out of range and too many nodes are refused", "[thermal][conduction]") {
  const LayerStack ground{{{soil, 1.0, 0.0}}, AdiabaticBack{}};
  CHECK_THROWS_AS(make_grid(ground, {.first_fraction = 0.0}), InputError);
  CHECK_THROWS_AS(make_grid(ground, {.growth = 0.99}), InputError);
  CHECK_THROWS_AS(make_grid(ground, {.least_per_layer = 0}), InputError);
  CHECK_THROWS_WITH(make_grid(ground, {.first_fraction = 1e-3, .growth = 1.0}),
                    Catch::Matchers::Contains("more than 128 nodes"));
  // evenly cut: as many as fit; the rounding of 0.1 x 30 decides on one more
  const std::size_t even = make_grid({{{soil, 3.0 * damping(soil), 0.0}}, AdiabaticBack{}},
                                     {.first_fraction = 0.1, .growth = 1.0})
                               .nodes();
  CHECK(even >= 31);
  CHECK(even <= 32);
}

}  // namespace nadir::thermal
