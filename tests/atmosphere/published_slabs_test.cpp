#include <cmath>
#include <numbers>

#include "atmosphere/data/published_slabs.hpp"
#include "atmosphere/slab.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;
using test::PublishedSlab;
using test::Slab;

struct Setting {
  PhaseFunction phase;
  double mu0;
  std::array<double, 6> mu;
  int truncated;  // the list's own treatment of first scattering: 16 streams throughout
  bool mean;      // over azimuth
};

double listed_radiance(const Slab& slab, const PublishedSlab& listed, const Setting& setting,
                       std::size_t i) {
  if (listed.beam == 0.0) return slab.even_radiance(i);
  const int azimuths = setting.mean ? 16 : 1;  // more than modes
  double sum = 0.0;
  for (int a = 0; a < azimuths; ++a) {
    const double azimuth = setting.mean ? pi * (a + 0.5) / azimuths : 0.0;
    sum += slab_radiance(slab.scaled, slab.problem, slab.solution,
                         {Light::beam, 0, i, azimuth, setting.truncated});
  }
  return listed.beam * sum / azimuths;
}

// The list gives six digits of a solution with 16 streams in the same ordinates. Irradiances agree
// to its digits; radiances to 2e-4, what J linear within 300 layers costs. The list counts light in
// the forward peak with the diffuse.
void check_slab(const PublishedSlab& listed, const Setting& setting) {
  CAPTURE(listed.name);
  const Slab slab{test::column_of(test::graded(listed.depth, 300), listed.omega, setting.phase),
                  16,
                  setting.mu0,
                  {setting.mu.begin(), setting.mu.end()}};
  const double strength = listed.beam > 0.0 ? listed.beam : 1.0;
  const FieldFluxes& fluxes =
      listed.beam > 0.0 ? slab.solution.beams[0].fluxes : slab.solution.sky.fluxes;
  const double peak = listed.beam > 0.0
                          ? setting.mu0 * (slab.problem.beams[0].transmittance.back() -
                                           std::exp(-listed.depth / setting.mu0))
                          : 0.0;
  CHECK(strength * (fluxes.down_at_ground + peak) ==
        Approx(listed.down).epsilon(6e-6).margin(1e-7));
  CHECK(strength * fluxes.up_at_top == Approx(listed.up).epsilon(5e-6));
  for (std::size_t i = 0; i < 6; ++i) {
    const double expected = i < 3 ? listed.bottom[i] : listed.top[i - 3];
    CHECK(listed_radiance(slab, listed, setting, i) == Approx(expected).epsilon(2e-4).margin(1e-7));
  }
}

TEST_CASE("slabs of isotropic scatterers match van de Hulst's table 12", "[atmosphere][transfer]") {
  for (const PublishedSlab& slab : test::isotropic_slabs) {
    check_slab(slab,
               {PhaseFunction::henyey_greenstein(0.0), test::mu0_hulst, test::mu_hulst, 0, false});
  }
}

TEST_CASE("Rayleigh slabs match Sweigart's table 1", "[atmosphere][transfer]") {
  for (const PublishedSlab& slab : test::rayleigh_slabs) {
    check_slab(slab,
               {PhaseFunction::rayleigh(0.0), test::mu0_sweigart, test::mu_sweigart, 0, false});
  }
}

TEST_CASE("Henyey-Greenstein slabs match van de Hulst's table 35", "[atmosphere][transfer]") {
  for (const PublishedSlab& slab : test::henyey_greenstein_slabs) {
    check_slab(slab,
               {PhaseFunction::henyey_greenstein(0.75), test::mu0_hulst, test::mu_hulst, 16, true});
  }
}

// Chandrasekhar (1950), section 36: a semi-infinite medium of isotropic scatterers sends back
// I(mu) = F omega / (4 pi) mu0 / (mu + mu0) H(mu) H(mu0).
TEST_CASE("a bottomless layer reflects as Chandrasekhar's H functions say",
          "[atmosphere][transfer]") {
  // Layers growing from 1e-4 to 1 down to a depth of 20, then one without end: for omega = 1 the
  // share of light that would come through it is 1e-8.
  std::vector<double> depths;
  for (double depth = 1e-4, step = 1e-4; depth < 20.0; depth += step) {
    step = std::max(1e-4, 0.03 * depth);
    depths.push_back(step);
  }
  depths.push_back(1e8);
  for (const test::PublishedH& listed : test::h_isotropic) {
    const OpticalColumn column =
        test::column_of(depths, listed.omega, PhaseFunction::henyey_greenstein(0.0));
    for (const std::size_t from : {std::size_t{0}, std::size_t{2}, std::size_t{4}}) {
      const double mu0 = test::h_mu[from];
      const Slab slab{column, 32, mu0, {test::h_mu.begin(), test::h_mu.end()}};
      for (std::size_t i = 0; i < test::h_mu.size(); ++i) {
        CAPTURE(listed.omega, mu0, test::h_mu[i]);
        const double exact =
            listed.omega / (4.0 * pi) * mu0 / (test::h_mu[i] + mu0) * listed.h[from] * listed.h[i];
        CHECK(slab.radiance(i) == Approx(exact).epsilon(1e-4));
      }
    }
  }
}

}  // namespace
}  // namespace nadir::atmosphere
