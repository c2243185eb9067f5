#include "spectral/planck.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using namespace nadir::literals;
using namespace nadir::spectral;

namespace {

using Long = long double;

constexpr Long h = 6.62607015e-34L, c = 299792458.0L, k = 1.380649e-23L;
constexpr Long c1 = 2.0L * h * c * c * 1e24L, c2 = h * c / k * 1e6L;

Long exact_planck(Long lambda_um, Long t) {
  return c1 / std::pow(lambda_um, 5.0L) / std::expm1(c2 / (lambda_um * t));
}

Long exact_derivative(Long lambda_um, Long t) {
  const Long x = c2 / (lambda_um * t);
  return exact_planck(lambda_um, t) * x / t / -std::expm1(-x);
}

/// The band integral over x = c2 / (lambda T), from the definition; the width is taken from hi -
/// lo, which is exact, and cut where exp(-60) = 1e-26 is below the precision of long double.
Long exact_band(Long lo_um, Long hi_um, Long t) {
  const Long from = c2 / (hi_um * t);
  const Long width = std::min(c2 / t * (hi_um - lo_um) / (lo_um * hi_um), 60.0L);
  const auto integrand = [&](Long s) {
    const Long x = from + s * width;
    return x * x * x / std::expm1(x);
  };
  const int panels = 1 + static_cast<int>(width / 6.0L);
  return c1 * std::pow(t / c2, 4.0L) * width * support::integrate(integrand, 0.0L, 1.0L, panels);
}

double relative_error(double value, Long exact) {
  return static_cast<double>(std::abs(static_cast<Long>(value) / exact - 1.0L));
}

const std::vector<double> wavelengths_um = {0.2, 0.31, 0.55, 0.87, 1.6,  2.2, 3.9,
                                            5.0, 8.65, 10.9, 12.0, 14.0, 20.0};
const std::vector<double> temperatures_k = {3.0,   30.0,   77.0,   200.0,  273.15, 300.0,
                                            320.0, 1000.0, 2856.0, 5772.0, 6000.0};

}  // namespace

// Identity: the hemispherical integral over all wavelengths is the Stefan-Boltzmann law.
// The trapezoid rule in ln(lambda) converges exponentially; measured 2e-14, so 1e-12 has margin.
TEST_CASE("Planck radiance integrates to the Stefan-Boltzmann law", "[spectral][planck]") {
  const Kelvin t = GENERATE(3.0_K, 300.0_K, 5772.0_K);
  const double step = 0.02;
  double integral = 0.0;
  for (double x = std::log(20.0 / t.value); x < std::log(3e9 / t.value); x += step) {
    const Micrometres lambda{std::exp(x)};
    integral += std::numbers::pi * planck(lambda, t).value * lambda.value * step;
  }
  CAPTURE(t.value);
  CHECK(integral / (si::stefan_boltzmann * std::pow(t.value, 4)) == Approx(1.0).epsilon(1e-12));
}

// The stated accuracy, for the whole range that it is stated for. The error grows with x because a
// rounding of the exponent is multiplied by it.
TEST_CASE("Planck radiance and its derivative keep their stated accuracy", "[spectral][planck]") {
  for (const double lambda : wavelengths_um) {
    for (const double t : temperatures_k) {
      const auto x = static_cast<double>(c2 / (static_cast<Long>(lambda) * static_cast<Long>(t)));
      const double radiance = planck(Micrometres{lambda}, Kelvin{t}).value;
      const double derivative = planck_derivative(Micrometres{lambda}, Kelvin{t});
      CAPTURE(lambda, t, x);
      REQUIRE(std::isfinite(radiance));
      REQUIRE(std::isfinite(derivative));
      if (x > 700.0) {  // exp(700) = 1e304
        CHECK(radiance < 1e-290);
        CHECK(derivative < 1e-290);
        continue;
      }
      CHECK(relative_error(radiance, exact_planck(lambda, t)) < 1e-15 + 4e-16 * x);
      CHECK(relative_error(derivative, exact_derivative(lambda, t)) < 1e-15 + 4e-16 * x);
    }
  }
}

TEST_CASE("Planck radiance at the edges of its domain", "[spectral][planck]") {
  CHECK(planck(10.0_um, 0.0_K).value == 0.0);
  CHECK(planck_derivative(10.0_um, 0.0_K) == 0.0);
  CHECK(planck(0.2_um, 3.0_K).value == 0.0);
  CHECK(planck_derivative(0.2_um, 3.0_K) == 0.0);
  CHECK(planck(10.0_um, Kelvin{1e-200}).value == 0.0);
  CHECK(planck_derivative(10.0_um, Kelvin{1e-200}) == 0.0);
  CHECK(planck(Micrometres{1e-100}, 300.0_K).value == 0.0);
  CHECK(std::isnan(planck(10.0_um, Kelvin{-1.0}).value));
  CHECK(std::isnan(planck(Micrometres{0.0}, 300.0_K).value));
  CHECK(std::isnan(planck(10.0_um, Kelvin{std::nan("")}).value));
  CHECK(std::isnan(planck_derivative(Micrometres{-1.0}, 300.0_K)));
}

// Wien's displacement: lambda_max T = c2 / x with x = 5 (1 - exp(-x)); CODATA 2018 prints
// 2.897771955e-3 m K (cut). A parabola through three points about the maximum finds it to 1e-7.
TEST_CASE("Planck radiance peaks where Wien's law says", "[spectral][planck]") {
  const Kelvin t = GENERATE(77.0_K, 300.0_K, 5772.0_K);
  const double peak = 2897.771955 / t.value, step = 1e-4 * peak;
  const double below = planck(Micrometres{peak - step}, t).value;
  const double top = planck(Micrometres{peak}, t).value;
  const double above = planck(Micrometres{peak + step}, t).value;
  CHECK(top > below);
  CHECK(top > above);
  const double offset = 0.5 * step * (below - above) / (below - 2.0 * top + above);
  // The three-point parabola is off by the cubic term, step^2 / peak, 1e-8; rounding adds 1e-8.
  CHECK(std::abs(offset) < 1e-7 * peak);
}

// For x -> 0: B = 2 c k T / lambda^4 (1 - x/2 + x^2/12 - ..).
TEST_CASE("Planck radiance goes over into the Rayleigh-Jeans law", "[spectral][planck]") {
  const double t = GENERATE(300.0, 6000.0);
  const double lambda = 1e8 / t;  // x = 1.4e-4: the x^4 term is 1e-18
  const double x = si::radiation_c2 / (lambda * t);
  const double classical =
      2.0 * si::speed_of_light * si::boltzmann * t / std::pow(lambda, 4) * 1e18;
  CHECK(planck(Micrometres{lambda}, Kelvin{t}).value ==
        Approx(classical * (1.0 - x / 2.0 + x * x / 12.0)).epsilon(3e-15));
}

TEST_CASE("a lane's Planck radiance is the scalar one, rounded to float", "[spectral][planck]") {
  std::vector<Micrometres> wavelengths;
  for (const double w : wavelengths_um) wavelengths.emplace_back(w);
  const Lanes lanes{wavelengths};
  for (const double t : {0.0, 3.0, 20.0, 300.0, 6000.0}) {
    const Spectrum s = planck(lanes, Kelvin{t});
    REQUIRE(s.count() == lanes.count());
    for (int i = 0; i < s.count(); ++i) {
      CAPTURE(t, i);
      REQUIRE((s[i] == 0.0F || std::isnormal(s[i])));  // denormals would slow every ray
      const double margin = std::numeric_limits<float>::min();
      CHECK(static_cast<double>(s[i]) ==
            Approx(planck(lanes[i], Kelvin{t}).value).epsilon(6e-8).margin(margin));
    }
  }
}

// 1e-40 is a denormal float, 1e-37 a normal one.
TEST_CASE("a lane's Planck radiance is 0 where float would be denormal", "[spectral][planck]") {
  const Kelvin faint = brightness_temperature(10.0_um, SpectralRadiance{1e-40});
  const Kelvin just = brightness_temperature(10.0_um, SpectralRadiance{1e-37});
  CHECK(planck(Lanes{{10.0_um}}, faint)[0] == 0.0F);
  CHECK(static_cast<double>(planck(Lanes{{10.0_um}}, just)[0]) == Approx(1e-37).epsilon(1e-6));
}

// Bands of every kind: wide, narrow, open, on either side of and across the place where the two
// series meet (x = 2), and across the one (width 1 in x) where the short interval takes over.
TEST_CASE("band radiance keeps its stated accuracy", "[spectral][planck]") {
  struct Band {
    double lo, hi;
  };
  for (const Band b : {Band{3, 5}, Band{8, 14}, Band{10.6, 11.2}, Band{0.1, 1000}, Band{0.4, 0.7},
                       Band{10, 10.000001}, Band{20, 1000}, Band{2.3, 2.5}, Band{100, 5000}}) {
    for (const double t : {3.0, 77.0, 300.0, 1000.0, 6000.0}) {
      const auto x = static_cast<double>(c2 / static_cast<Long>(b.hi) / static_cast<Long>(t));
      const double radiance = planck_band(Micrometres{b.lo}, Micrometres{b.hi}, Kelvin{t}).value;
      CAPTURE(b.lo, b.hi, t, x);
      const Long exact = exact_band(b.lo, b.hi, t);
      if (exact < 1e-290L) {
        CHECK((radiance >= 0.0 && radiance < 1e-280));
        continue;
      }
      CHECK(relative_error(radiance, exact) < 4e-15 + 4e-16 * x);
    }
  }
}

TEST_CASE("band radiances of adjoining bands add up to Stefan-Boltzmann", "[spectral][planck]") {
  const Kelvin t = GENERATE(3.0_K, 300.0_K, 6000.0_K);
  const Micrometres infinity{std::numeric_limits<double>::infinity()};
  const double all = si::stefan_boltzmann * std::pow(t.value, 4) / std::numbers::pi;
  // Six roundings of the fourth power and the constants.
  CHECK(planck_band(0.0_um, infinity, t).value == Approx(all).epsilon(2e-15));
  for (const double scaled : {100.0, 1000.0, 2898.0, 7193.8, 7194.0, 20000.0, 1e6}) {
    const Micrometres cut{scaled / t.value};
    CHECK(planck_band(0.0_um, cut, t).value + planck_band(cut, infinity, t).value ==
          Approx(all).epsilon(3e-15));
  }
}

TEST_CASE("band radiance at the edges of its domain", "[spectral][planck]") {
  const Micrometres infinity{std::numeric_limits<double>::infinity()};
  CHECK(planck_band(8.0_um, 14.0_um, 0.0_K).value == 0.0);
  CHECK(planck_band(8.0_um, 8.0_um, 300.0_K).value == 0.0);
  CHECK(planck_band(0.0_um, 0.0_um, 300.0_K).value == 0.0);
  CHECK(planck_band(infinity, infinity, 300.0_K).value == 0.0);
  CHECK(planck_band(0.0_um, 0.001_um, 300.0_K).value == 0.0);
  CHECK(planck_band(0.2_um, 0.3_um, 3.0_K).value == 0.0);
  CHECK(std::isnan(planck_band(9.0_um, 8.0_um, 300.0_K).value));
  CHECK(std::isnan(planck_band(Micrometres{-1.0}, 8.0_um, 300.0_K).value));
  CHECK(std::isnan(planck_band(8.0_um, 9.0_um, Kelvin{-1.0}).value));
}

// Source of the figures: exact computation in double precision, printed to eight digits; half a
// unit of the last is at most 5e-8 relative. The derivatives of the source are off by up to 8e-8
// (at 200 K and 3 .. 5 um, against integration of dB/dT in two ways).
TEST_CASE("band radiance and its derivative agree with the tabulated figures",
          "[spectral][planck]") {
  struct Row {
    double t, lo, hi, radiance, derivative;
  };
  const auto row = GENERATE(values<Row>({
      {200, 3, 5, 0.0092608203, 0.0007225701},   {200, 8, 12, 3.4810206, 0.12326803},
      {200, 8, 14, 6.0117504, 0.19363179},       {200, 10.6, 11.2, 0.63231682, 0.020891465},
      {200, 0.1, 1000, 28.878443, 0.57757684},   {250, 3, 5, 0.21703497, 0.011088576},
      {250, 8, 12, 14.559301, 0.3369488},        {250, 8, 14, 22.29229, 0.47595036},
      {250, 10.6, 11.2, 2.3759144, 0.050444505}, {250, 0.1, 1000, 70.504647, 1.1280824},
      {273.15, 3, 5, 0.64426642, 0.027863494},   {273.15, 8, 12, 23.821891, 0.46570082},
      {273.15, 8, 14, 35.151962, 0.63735404},    {273.15, 10.6, 11.2, 3.7279725, 0.066502224},
      {273.15, 0.1, 1000, 100.47627, 1.4713793}, {280, 3, 5, 0.86053608, 0.035526603},
      {280, 8, 12, 27.150517, 0.50632414},       {280, 8, 14, 39.688973, 0.68746612},
      {280, 10.6, 11.2, 4.2001945, 0.071378767}, {280, 0.1, 1000, 110.94073, 1.5848757},
      {290, 3, 5, 1.2831029, 0.049600642},       {290, 8, 12, 32.51686, 0.56723606},
      {290, 8, 14, 46.935151, 0.76201506},       {290, 10.6, 11.2, 4.9497794, 0.078544503},
      {290, 0.1, 1000, 127.65893, 1.7608208},    {300, 3, 5, 1.8659562, 0.067698345},
      {300, 8, 12, 38.500424, 0.62970435},       {300, 8, 14, 54.933461, 0.83782129},
      {300, 10.6, 11.2, 5.7711407, 0.085727282}, {300, 0.1, 1000, 146.19902, 1.9493284},
      {310, 3, 5, 2.6528349, 0.090526721},       {310, 8, 12, 45.114891, 0.69335666},
      {310, 8, 14, 63.694395, 0.91447417},       {310, 10.6, 11.2, 6.6642551, 0.092889264},
      {310, 0.1, 1000, 166.68881, 2.1508315},    {320, 3, 5, 3.694727, 0.11882679},
      {320, 8, 12, 52.370348, 0.75784708},       {320, 8, 14, 73.224515, 0.9915993},
      {320, 10.6, 11.2, 7.6287476, 0.099997886}, {320, 0.1, 1000, 189.26041, 2.3657633},
      {350, 3, 5, 8.9743499, 0.24424975},        {350, 8, 12, 78.035542, 0.95332344},
      {350, 8, 14, 106.44447, 1.222618},         {350, 10.6, 11.2, 10.942514, 0.12074961},
      {350, 0.1, 1000, 270.85229, 3.0954629},    {500, 3, 5, 167.52778, 2.350117},
      {500, 8, 12, 289.83302, 1.8285171},        {500, 8, 14, 369.12111, 2.2246852},
      {500, 10.6, 11.2, 35.713366, 0.2031889},   {500, 0.1, 1000, 1128.0838, 9.0246784},
      {1000, 3, 5, 6506.734, 25.138094},         {1000, 8, 12, 1602.8299, 3.121583},
      {1000, 8, 14, 1924.074, 3.6548702},        {1000, 10.6, 11.2, 169.57098, 0.30559377},
      {1000, 0.1, 1000, 18049.36, 72.197447},
  }));
  CAPTURE(row.t, row.lo, row.hi);
  CHECK(planck_band(Micrometres{row.lo}, Micrometres{row.hi}, Kelvin{row.t}).value ==
        Approx(row.radiance).epsilon(5.1e-8));
  // In ln(lambda), where the integrand is smooth over four decades too.
  const auto integrand = [&](Long u) {
    const auto lambda = static_cast<double>(std::exp(u));
    return static_cast<Long>(lambda * planck_derivative(Micrometres{lambda}, Kelvin{row.t}));
  };
  const Long derivative = support::integrate(integrand, std::log(static_cast<Long>(row.lo)),
                                             std::log(static_cast<Long>(row.hi)), 4);
  CHECK(static_cast<double>(derivative) == Approx(row.derivative).epsilon(1e-7));
}

// The round trip; a relative error e of the radiance moves T by e (1 - exp(-x)) / x. Its units are
// guarded by the tests above, which a wrong constant fails.
TEST_CASE("brightness temperature inverts Planck radiance", "[spectral][planck]") {
  for (const double lambda : wavelengths_um) {
    for (const double t : temperatures_k) {
      const auto radiance = static_cast<double>(exact_planck(lambda, t));
      if (radiance < 1e-300) continue;
      CAPTURE(lambda, t);
      CHECK(brightness_temperature(Micrometres{lambda}, SpectralRadiance{radiance}).value ==
            Approx(t).epsilon(1e-15));
    }
  }
}

// For large radiance T -> lambda^4 L / (2 c k) + c2 / (2 lambda) (Rayleigh-Jeans, next order x^2).
TEST_CASE("brightness temperature at the edges of its domain", "[spectral][planck]") {
  const SpectralRadiance bright{1e12};
  const double classical = 1e4 * 1e12 / (2.0 * si::speed_of_light * si::boltzmann * 1e18);
  CHECK(brightness_temperature(10.0_um, bright).value ==
        Approx(classical + si::radiation_c2 / 20.0).epsilon(1e-14));
  CHECK(brightness_temperature(10.0_um, SpectralRadiance{0.0}).value == 0.0);
  // 1e-320 is denormal: c1 / (lambda^5 L) overflows. x = ln(1.19e3 / 1e-320) = 743.9.
  CHECK(brightness_temperature(10.0_um, SpectralRadiance{1e-320}).value ==
        Approx(si::radiation_c2 / 7439.1).epsilon(1e-3));
  CHECK(std::isnan(brightness_temperature(10.0_um, SpectralRadiance{-1e-9}).value));
  CHECK(std::isnan(brightness_temperature(10.0_um, SpectralRadiance{std::nan("")}).value));
  CHECK(std::isnan(brightness_temperature(0.0_um, SpectralRadiance{1.0}).value));
}
