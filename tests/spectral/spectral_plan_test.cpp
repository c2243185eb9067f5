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
