#include <cmath>
#include <cstddef>
#include <vector>

#include "spectral/band_quadrature.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::literals;
using namespace nadir::spectral;

namespace {

BandQuadrature band(const std::vector<double>& wavelengths_um) {
  BandQuadrature b;
  for (std::size_t i = 0; i < wavelengths_um.size(); ++i) {
    b.wavelengths.emplace_back(wavelengths_um[i]);
    b.weights.push_back(1.0 / static_cast<double>(i + 1));
  }
  return b;
}

/// Every term must lead back to its band's wavelength (to 1e-9) with its weight.
void check_terms(const SpectralPlan& plan, const std::vector<BandQuadrature>& bands) {
  REQUIRE(plan.bands.size() == bands.size());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    REQUIRE(plan.bands[b].size() == bands[b].wavelengths.size());
    for (std::size_t i = 0; i < plan.bands[b].size(); ++i) {
      const SpectralPlan::Term& term = plan.bands[b][i];
      const Lanes& lanes = plan.blocks.at(static_cast<std::size_t>(term.block));
      REQUIRE(term.lane < lanes.count());
      REQUIRE(lanes[term.lane].value == Approx(bands[b].wavelengths[i].value).epsilon(1.0001e-9));
      REQUIRE(term.weight == bands[b].weights[i]);
    }
  }
}

}  // namespace

TEST_CASE("a plan simulates each distinct wavelength once, ascending", "[spectral][plan]") {
  const std::vector<BandQuadrature> bands = {band({10.0, 11.0, 12.0}), band({0.5, 0.6}),
                                             band({0.6, 10.0, 13.0}),
                                             band({11.0 * (1.0 + 5e-10), 12.0 * (1.0 + 2e-9)})};
  const SpectralPlan plan = plan_lanes(bands);
  REQUIRE(plan.blocks.size() == 1);
  CHECK(std::vector<Micrometres>(plan.blocks[0].begin(), plan.blocks[0].end()) ==
        std::vector<Micrometres>{0.5_um, 0.6_um, 10.0_um, 11.0_um, 12.0_um,
                                 Micrometres{12.0 * (1.0 + 2e-9)}, 13.0_um});
  check_terms(plan, bands);
  CHECK(plan.bands[2][0].lane == plan.bands[1][1].lane);
  CHECK(plan.bands[3][0].lane == plan.bands[0][1].lane);
  CHECK(plan.bands[3][1].lane == plan.bands[0][2].lane + 1);
}

TEST_CASE("a chain of near wavelengths does not merge into one", "[spectral][plan]") {
  std::vector<double> chain;
  for (int i = 0; i < 5; ++i) chain.push_back(10.0 * (1.0 + 0.6e-9 * i));
  const std::vector<BandQuadrature> bands = {band(chain)};
  const SpectralPlan plan = plan_lanes(bands);
  CHECK(plan.blocks[0].count() == 3);  // 0 and 0.6, 1.2 and 1.8, 2.4
  check_terms(plan, bands);
}

TEST_CASE("more wavelengths than the lanes of a ray go into blocks", "[spectral][plan]") {
  std::vector<BandQuadrature> bands;
  for (int b = 0; b < 30; ++b) {
    std::vector<double> wavelengths;
    for (int i = 0; i < 10; ++i) wavelengths.push_back(0.4 + 0.011 * b + 0.5 * i);
    bands.push_back(band(wavelengths));
  }
  const SpectralPlan plan = plan_lanes(bands);
  REQUIRE(plan.blocks.size() == 3);
  CHECK(plan.blocks[0].count() == 128);
  CHECK(plan.blocks[1].count() == 128);
  CHECK(plan.blocks[2].count() == 44);
  CHECK(plan.blocks[0][127] < plan.blocks[1][0]);
  CHECK(plan.blocks[1][127] < plan.blocks[2][0]);
  check_terms(plan, bands);
}

TEST_CASE("a full block is not followed by an empty one", "[spectral][plan]") {
  std::vector<double> wavelengths;
  for (int i = 0; i < 128; ++i) wavelengths.push_back(1.0 + 0.1 * i);
  CHECK(plan_lanes({band(wavelengths)}).blocks.size() == 1);
  CHECK(plan_lanes({}).blocks.empty());
}

TEST_CASE("the nodes of a box band stand for pieces as wide as their weights", "[spectral][plan]") {
  const BoxResponse box{0.5_um, 0.9_um};
  const int count = GENERATE(1, 2, 4, 32);
  const BandQuadrature nodes = gauss_quadrature(box, count);
  const std::vector<Micrometres> edges = interval_edges(box, nodes);
  REQUIRE(edges.size() == nodes.weights.size() + 1);
  double edge_um = 0.5;
  for (std::size_t i = 0; i < nodes.weights.size(); ++i) {
    CHECK(edges[i].value == Approx(edge_um).epsilon(0.0).margin(1e-13));  // sums of 32 roundings
    edge_um += 0.4 * nodes.weights[i];
  }
  CHECK(edges.back() == 0.9_um);
}

TEST_CASE("the interval of a node holds it and its share of the response", "[spectral][plan]") {
  // A triangle, whose integral from its left end is a parabola; a table with a gap; a Gaussian,
  // whose integral is the error function.
  const TabulatedResponse triangle{Curve{{0.4, 0.5, 0.7}, {0.0, 1.0, 0.0}, Outside::zero}};
  const TabulatedResponse gap{
      Curve{{0.4, 0.45, 0.46, 0.6, 0.61, 0.8}, {1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, Outside::zero}};
  const GaussianResponse bell{0.55_um, 0.02_um};
  for (const Response& response : {Response{triangle}, Response{gap}, Response{bell}}) {
    const BandQuadrature nodes = gauss_quadrature(response, 5);
    const std::vector<Micrometres> edges = interval_edges(response, nodes);
    const auto integral = [&](double lo, double hi) {  // midpoint rule, error below 1e-6 here
      double sum = 0.0;
      for (int i = 0; i < 4000; ++i) {
        sum += at(response, Micrometres{std::lerp(lo, hi, (i + 0.5) / 4000)});
      }
      return sum * (hi - lo) / 4000;
    };
    double all = 0.0;
    std::vector<double> shares;
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(edges[i] < nodes.wavelengths[i]);
      CHECK(nodes.wavelengths[i] < edges[i + 1]);
      shares.push_back(integral(edges[i].value, edges[i + 1].value));
      all += shares.back();
    }
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(shares[i] / all == Approx(nodes.weights[i]).epsilon(1e-4));
    }
  }
}

TEST_CASE("lanes that share a wavelength but not interval and term stay apart",
          "[spectral][plan]") {
  const AbsorptionLane wide0{0.5, 0.7, 0}, wide1{0.5, 0.7, 1}, narrow{0.58, 0.62, 0};
  const std::vector<std::vector<LaneShare>> bands = {
      {{0.6_um, wide0, 0.75}, {0.6_um, wide1, 0.25}},
      {{0.55_um, {0.5, 0.6, 0}, 0.5}, {0.6_um, narrow, 0.5}},
      {{0.6_um, wide1, 0.9}, {0.6_um, wide0, 0.1}}};
  const SpectralPlan plan = plan_split_lanes(bands);
  REQUIRE(plan.blocks.size() == 1);
  const Lanes& lanes = plan.blocks[0];
  REQUIRE(lanes.count() == 4);
  CHECK(lanes[0] == 0.55_um);
  CHECK(lanes.absorption(1) == wide0);
  CHECK(lanes.absorption(2) == wide1);
  CHECK(lanes.absorption(3) == narrow);
  for (std::size_t b = 0; b < bands.size(); ++b) {
    REQUIRE(plan.bands[b].size() == bands[b].size());
    for (std::size_t i = 0; i < bands[b].size(); ++i) {
      const SpectralPlan::Term& term = plan.bands[b][i];
      CHECK(lanes[term.lane] == bands[b][i].wavelength);
      CHECK(lanes.absorption(term.lane) == bands[b][i].absorption);
      CHECK(term.weight == bands[b][i].weight);
    }
  }
}

TEST_CASE("the terms of one wavelength may fall into two blocks", "[spectral][plan]") {
  std::vector<LaneShare> band;
  for (int i = 0; i < 300; ++i) {  // 3 terms each, so that lanes 126 to 128 belong together
    band.push_back({Micrometres{0.5 + 0.01 * (i / 3)}, {0.1, 0.2, i % 3}, 1.0 / 300.0});
  }
  const SpectralPlan plan = plan_split_lanes({band});
  REQUIRE(plan.blocks.size() == 3);
  CHECK(plan.blocks[0][127] == plan.blocks[1][0]);
  CHECK(plan.blocks[1].absorption(0).term == 2);
  double sum = 0.0;
  for (const auto& term : plan.bands[0]) sum += term.weight;
  CHECK(sum == Approx(1.0).epsilon(1e-13));
  CHECK(plan.bands[0][128].block == 1);
  CHECK(plan.bands[0][128].lane == 0);
  CHECK(plan_split_lanes({}).blocks.empty());
}
