#include "materials/scattering/albedo_table.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using materials::Albedo;
using materials::AlbedoTable;
using materials::ScatteringDraw;
using materials::ScatteringSample;
using spectral::Spectrum;
using support::direction;

namespace {

/// A made-up model of two lanes with known shares: every draw goes up or down with weights that
/// depend on the direction only.
AlbedoTable::Sampling shares(double (*reflected)(Vec3)) {
  return [reflected](Vec3 wo, const ScatteringDraw& u) {
    Spectrum weight{2};
    weight[0] = static_cast<float>(reflected(wo));
    weight[1] = 0.5F * weight[0];
    const double z = u.choice < 0.75 ? wo.z : -wo.z;
    return std::optional{ScatteringSample{{0.0, 0.0, z > 0.0 ? 1.0 : -1.0}, 1.0, false, weight}};
  };
}

}  // namespace

TEST_CASE("an albedo table is the mean of the weights, apart for each side", "[materials]") {
  const AlbedoTable table{{.lanes = 2}, shares([](Vec3) { return 0.8; })};
  for (const double mu : {0.0, 1e-4, 0.3, 1.0, -0.3}) {
    const Albedo a = table.at(direction(mu, 1.0));
    CAPTURE(mu);
    // one in 256 draws may fall on the other side of the choice at each node
    CHECK(a.reflectance[0] == Approx(0.6).margin(0.8 / 256));
    CHECK(a.transmittance[0] == Approx(0.2).margin(0.8 / 256));
    CHECK(a.reflectance[1] == Approx(0.3).margin(0.4 / 256));
  }
}

TEST_CASE("an albedo table interpolates in the root of the cosine", "[materials]") {
  const AlbedoTable table{{.lanes = 2}, shares([](Vec3 wo) { return std::sqrt(std::abs(wo.z)); })};
  for (const double mu : {1e-3, 0.02, 0.3, 0.77}) {
    // exact but for the choice of side, as above, and the first node's 1e-3
    CHECK(table.reflectance_at(direction(mu, 1.0)) == Approx(0.75 * std::sqrt(mu)).margin(4e-3));
  }
}

TEST_CASE("an albedo table knows azimuths and sides where it should", "[materials]") {
  const AlbedoTable table{{.lanes = 2, .two_sided = true, .anisotropic = true}, shares([](Vec3 wo) {
                            return (wo.z > 0.0 ? 0.6 : 0.2) * (1.0 + 0.2 * wo.x * wo.x);
                          })};
  const double azimuth = GENERATE(0.0, 0.1, 1.0, 3.0, 3.2, 6.2);
  const Vec3 wo = direction(0.5, azimuth), below = direction(-0.5, azimuth);
  // 1/128 of the side's choice, and 8 % of the amplitude by linear interpolation over 22.5 degrees
  CHECK(table.at(wo).reflectance[0] == Approx(0.45 * (1.0 + 0.2 * wo.x * wo.x)).margin(0.008));
  CHECK(table.at(below).reflectance[0] == Approx(0.15 * (1.0 + 0.2 * wo.x * wo.x)).margin(0.003));
}

TEST_CASE("noise in an albedo table creates no energy", "[materials]") {
  const AlbedoTable table{{.lanes = 2}, shares([](Vec3) { return 1.1; })};
  const Albedo a = table.at(direction(0.37, 0.0));
  CHECK(a.reflectance[0] + a.transmittance[0] <= 1.0F + 2e-7F);  // two float roundings
}
