#include "materials/scattering/cox_munk.hpp"

#include <cmath>
#include <numbers>

#include "core/sampler.hpp"
#include "materials/scattering/fresnel.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using namespace nadir::materials;
using spectral::Curve;
using spectral::Spectrum;

namespace {

constexpr double pi = std::numbers::pi;
const spectral::Lanes lanes{{0.5_um, 0.85_um, 1.65_um, 10.0_um}};

BoundCoxMunk bound(const CoxMunk& model) {
  const Spectrum none{lanes.count()};
  return {model, {lanes, none, none}};
}

CoxMunk sea(double wind_m_s) {
  CoxMunk model;
  model.wind_speed_m_s = wind_m_s;
  model.n = Curve::constant(1.34);
  model.foam = false;
  return model;
}

/// The published glitter, rho = F p / (4 cos_i cos_o cos^4 beta) (in sr^-1), for wind from the
/// north.
double published(double wind_m_s, Vec3 wi, Vec3 wo) {
  const Vec3 h = normalised(wi + wo);
  const double up = h.y / h.z, across = h.x / h.z;
  const double s_up = 0.00316 * wind_m_s, s_across = 0.003 + 0.00192 * wind_m_s;
  const double p = std::exp(-0.5 * (up * up / s_up + across * across / s_across)) /
                   (2.0 * pi * std::sqrt(s_up * s_across));
  return fresnel_reflectance(dot(wi, h), 1.34, 0.0) * p / (4.0 * wi.z * wo.z * std::pow(h.z, 4));
}

double value(const BoundCoxMunk& model, Vec3 wi, Vec3 wo) {
  return static_cast<double>(model.eval(wi, wo)[0]);
}

}  // namespace

TEST_CASE("glitter seen from on high is Cox and Munk's", "[materials][cox_munk]") {
  const double wind = GENERATE(1.0, 5.0, 14.0);
  const BoundCoxMunk model = bound(sea(wind));
  const Vec3 sun = support::direction(std::cos(0.5), 0.3);
  for (const double azimuth : {0.3 + pi, 2.0, 4.5}) {
    const Vec3 wo = support::direction(std::cos(0.35), azimuth);
    CAPTURE(wind, azimuth);
    // at 30 degrees Smith's masking, which they leave out, takes 3e-6 in the strongest wind; float
    CHECK(value(model, sun, wo) == Approx(published(wind, sun, wo)).epsilon(1e-5));
  }
}

TEST_CASE("the glitter is longer along the wind, wherever that blows from",
          "[materials][cox_munk]") {
  CoxMunk east = sea(10.0);
  east.wind_azimuth_rad = 0.5 * pi;
  const Vec3 up{0.0, 0.0, 1.0};
  const Vec3 from_north = support::direction(0.8, 0.5 * pi),
             from_east = support::direction(0.8, 0.0);
  const BoundCoxMunk north_wind = bound(sea(10.0)), east_wind = bound(east);
  CHECK(value(north_wind, from_north, up) > 1.3 * value(north_wind, from_east, up));
  CHECK(value(east_wind, from_east, up) ==
        Approx(value(north_wind, from_north, up)).epsilon(1e-6));  // float
  CHECK(value(east_wind, from_north, up) == Approx(value(north_wind, from_east, up)).epsilon(1e-6));
}

TEST_CASE("a calm sea reflects as flat water does", "[materials][cox_munk]") {
  const double degrees = GENERATE(0.0, 30.0, 60.0);
  CAPTURE(degrees);
  const double mu = std::cos(degrees * pi / 180.0);
  const double flat = fresnel_reflectance(mu, 1.34, 0.0);
  // slopes of 3 degrees: they raise the mean over Fresnel's curve by 2 % at 60 degrees
  CHECK(bound(sea(0.0)).albedo(support::direction(mu, 0.5)).reflectance[0] ==
        Approx(flat).epsilon(0.03));
}

// Wind lays facets open to a low view and makes it see them steeper: the horizon of a rough sea is
// darker than that of a smooth one (Cox & Munk, J. Mar. Res. 14, 63, 1955).
TEST_CASE("wind darkens the sea towards the horizon", "[materials][cox_munk]") {
  const Vec3 low = support::direction(0.1, 0.5);
  double before = fresnel_reflectance(0.1, 1.34, 0.0);
  for (const double wind : {0.0, 5.0, 15.0}) {
    const double albedo = static_cast<double>(bound(sea(wind)).albedo(low).reflectance[0]);
    CHECK(albedo < before);
    before = albedo;
  }
}

TEST_CASE("the water body gets what the surface lets through", "[materials][cox_munk]") {
  const double mu = GENERATE(0.1, 0.6, 1.0);
  CoxMunk white = sea(8.0);
  white.water_body = Curve::constant(1.0);
  const Vec3 wo = support::direction(mu, 0.5);
  CHECK(bound(white).albedo(wo).reflectance[0] == Approx(1.0).epsilon(1e-6));  // float
  const double all = support::integrate_hemisphere(
      [&, model = bound(white)](Vec3 wi) { return value(model, wi, wo) * wi.z; });
  CHECK(all == Approx(1.0).epsilon(5e-3));  // the table of surface albedos
}

// Monahan & O'Muircheartaigh's cover at 15 m/s is 0.0407; the rest as Koepke and Frouin measured.
TEST_CASE("white caps cover 4 % of the sea in a gale and fade in the infrared",
          "[materials][cox_munk]") {
  CoxMunk gale = sea(15.0);
  gale.n = Curve::constant(1.0);  // no surface: foam alone
  gale.foam = true;
  const Spectrum f = bound(gale).eval({0.0, 0.0, 1.0}, support::direction(0.5, 1.0));
  const double cover = 2.95e-6 * std::pow(15.0, 3.52);
  CHECK(cover == Approx(0.0407).epsilon(0.01));  // to the digits given
  const double expected[] = {0.22, 0.22 * 0.6, 0.22 * 0.15, 0.0};
  for (int lane = 0; lane < 4; ++lane) {
    CHECK(static_cast<double>(f[lane]) * pi ==
          Approx(cover * expected[lane]).epsilon(1e-5));  // float
  }
}

TEST_CASE("a calm sea has finite glitter everywhere, from the zenith to the horizon",
          "[materials][cox_munk]") {
  const double mu = GENERATE(2e-12, 1e-6, 0.3, 1.0);
  CoxMunk model = sea(0.0);
  model.water_body = Curve::constant(0.02);
  const BoundCoxMunk calm = bound(model);
  const Vec3 wo = support::direction(mu, 0.0);
  CHECK(std::isfinite(value(calm, support::direction(mu, pi), wo)));
  for (const double choice : {0.0, 1.0 - 0x1.0p-53}) {
    for (const double u : {0.0, 0.5, 1.0 - 0x1.0p-53}) {
      const auto s = calm.sample(wo, {choice, {u, u}});
      if (!s) continue;
      CHECK(std::isfinite(s->weight[0]));
      CHECK(s->weight[0] >= 0.0F);
      CHECK(std::isfinite(s->pdf));
    }
  }
  CHECK(value(calm, wo, support::direction(0.0, 0.0)) == 0.0);
}

// Emission follows Kirchhoff: at 11 um water has n = 1.153, k = 0.0968 and so an emissivity of
// 0.9926 straight down (Masuda, Takashima & Takayama, Remote Sens. Environ. 24, 313, 1988, give
// 0.992 to 0.993 for all winds).
TEST_CASE("the sea is almost black at 11 um, whatever the wind", "[materials][cox_munk]") {
  const double wind = GENERATE(0.0, 5.0, 15.0);
  CoxMunk model = sea(wind);
  model.n = Curve::constant(1.153);
  model.k = Curve::constant(0.0968);
  CHECK(1.0 - static_cast<double>(bound(model).albedo({0.0, 0.0, 1.0}).reflectance[3]) ==
        Approx(0.9925).margin(5e-4));  // the spread of the published values
}
