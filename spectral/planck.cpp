#include "spectral/planck.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/constants.hpp"

namespace nadir::spectral {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double power5(double x) noexcept { return x * x * x * x * x; }

/// Whether exp(c2 / (lambda T)) is more than a double holds, asked without computing either. There
/// Planck's radiance is 0: below 1e-290 from 0.2 um on.
bool extinct(double lambda, double t) noexcept {
  constexpr double largest_exponent = 709.78;  // the logarithm of the largest double, 1.8e308
  return lambda * t < si::radiation_c2 / largest_exponent;
}

// The photon energy in units of k T, x = c2 / (lambda T), turns the band integral into
//   int B dlambda = c1 T^4 / c2^4  int x^3 / (exp(x) - 1) dx.

/// The integral from x to infinity, by the series of Planck's denominator in exp(-x). For x >= 2
/// the terms fall by exp(-2) or faster: 20 of them leave less than 1e-17 of the first.
/// Source: Chang & Rhee, Int. Comm. Heat Mass Transfer 11, 451 (1984),
/// doi:10.1016/0735-1933(84)90051-4.
double integral_above(double x) noexcept {
  constexpr double underflow = 745.0;  // exp(-x) is 0 beyond, and infinity^3 must not meet it
  if (x > underflow) return 0.0;
  double sum = 0.0;
  for (int n = 20; n >= 1; --n) {
    const double m = 1.0 / n;
    sum += std::exp(-n * x) * m * (x * x * x + m * (3.0 * x * x + m * (6.0 * x + m * 6.0)));
  }
  return sum;
}

/// The integral from 0 to x <= 2, by the Taylor series of x / (exp(x) - 1), whose coefficients are
/// B_2k / (2k)! = 2 (-1)^(k+1) zeta(2k) / (2 pi)^2k. Terms fall by (x / 2 pi)^2 <= 0.102: 16 of
/// them leave less than 1e-17.
double integral_below(double x) noexcept {
  constexpr std::array<double, 6> bernoulli = {
      1.0 / 12.0,       -1.0 / 720.0,     1.0 / 30240.0,
      -1.0 / 1209600.0, 1.0 / 47900160.0, -691.0 / 1307674368000.0};  // B_2k / (2k)!, k = 1 .. 6
  const double x2 = x * x;
  double sum = 1.0 / 3.0 - x / 8.0;
  double power = 1.0;
  for (std::size_t k = 1; k <= bernoulli.size(); ++k) {
    power *= x2;
    sum += bernoulli[k - 1] * power / static_cast<double>(2 * k + 3);
  }
  // From k = 7 on zeta(2k) is 1 + 2^-2k + 3^-2k to 4e-9, and the terms are below 2e-8.
  const double q = x2 / (4.0 * std::numbers::pi * std::numbers::pi);
  double term = 2.0 * power * std::pow(2.0 * std::numbers::pi, -12);  // without its sign and zeta
  for (int k = 7; k <= 16; ++k) {
    term *= q;
    const double zeta = 1.0 + std::pow(2.0, -2 * k) + std::pow(3.0, -2 * k);
    sum += (k % 2 == 0 ? -term : term) * zeta / (2 * k + 3);
  }
  return x2 * x * sum;
}

/// The integral over an interval of half-width at most 0.5 about x, without cancellation: Gauss's
/// rule of 8 points (Abramowitz & Stegun, table 25.4), here exact to rounding.
double integral_about(double x, double half) noexcept {
  struct Node {
    double position, weight;
  };
  constexpr std::array<Node, 4> nodes = {{{0.1834346424956498, 0.3626837833783620},
                                          {0.5255324099163290, 0.3137066458778873},
                                          {0.7966664774136267, 0.2223810344533745},
                                          {0.9602898564975363, 0.1012285362903763}}};
  const auto integrand = [](double t) { return t * t * t / std::expm1(t); };
  double sum = 0.0;
  for (const Node& node : nodes) {
    const double step = half * node.position;
    sum += node.weight * (integrand(x - step) + integrand(x + step));
  }
  return sum * half;
}

double integral_between(double lo, double hi) noexcept {
  constexpr double series_meet = 2.0;
  constexpr double whole =
      std::numbers::pi * std::numbers::pi * std::numbers::pi * std::numbers::pi / 15.0;
  if (hi <= series_meet) return integral_below(hi) - integral_below(lo);
  if (lo >= series_meet) return integral_above(lo) - integral_above(hi);
  return whole - integral_below(lo) - integral_above(hi);
}

}  // namespace

SpectralRadiance planck(Micrometres wavelength, Kelvin temperature) noexcept {
  const double lambda = wavelength.value, t = temperature.value;
  if (!(lambda > 0.0) || !(t >= 0.0)) return SpectralRadiance{undefined};
  if (extinct(lambda, t)) return SpectralRadiance{0.0};
  const double grown = std::expm1(si::radiation_c2 / (lambda * t));
  return SpectralRadiance{si::radiation_c1 / power5(lambda) / grown};
}

Spectrum planck(const Lanes& lanes, Kelvin temperature) noexcept {
  constexpr double smallest = std::numeric_limits<float>::min();  // denormals are slow
  Spectrum spectrum{lanes.count()};
  for (int lane = 0; lane < lanes.count(); ++lane) {
    const double radiance = planck(lanes[lane], temperature).value;
    spectrum[lane] = radiance < smallest ? 0.0F : static_cast<float>(radiance);
  }
  return spectrum;
}

double planck_derivative(Micrometres wavelength, Kelvin temperature) noexcept {
  const double lambda = wavelength.value, t = temperature.value;
  if (!(lambda > 0.0) || !(t >= 0.0)) return undefined;
  if (extinct(lambda, t)) return 0.0;
  const double x = si::radiation_c2 / (lambda * t);
  const double grown = std::expm1(x);
  return si::radiation_c1 / power5(lambda) / grown * (x / t) / -std::expm1(-x);
}

Radiance planck_band(Micrometres lo, Micrometres hi, Kelvin temperature) noexcept {
  const double t = temperature.value;
  if (!(lo.value >= 0.0) || !(hi >= lo) || !(t >= 0.0)) return Radiance{undefined};
  if (t == 0.0 || lo == hi) return Radiance{0.0};
  const double scaled = t / si::radiation_c2;
  const double scale = si::radiation_c1 * scaled * scaled * scaled * scaled;
  const double x_lo = 1.0 / (hi.value * scaled);
  const double x_hi = lo.value > 0.0 ? 1.0 / (lo.value * scaled) : infinity;
  // hi - lo is exact where the two are near, the difference of their reciprocals is not.
  const double width = std::isinf(hi.value) ? infinity : (hi - lo).value / hi.value * x_hi;
  const double integral =
      width < 1.0 ? integral_about(x_lo + 0.5 * width, 0.5 * width) : integral_between(x_lo, x_hi);
  return Radiance{scale * integral};
}

Kelvin brightness_temperature(Micrometres wavelength, SpectralRadiance radiance) noexcept {
  const double lambda = wavelength.value, l = radiance.value;
  if (!(lambda > 0.0) || !(l >= 0.0)) return Kelvin{undefined};
  if (l == 0.0) return Kelvin{0.0};
  const double numerator = si::radiation_c1 / power5(lambda);
  // A radiance near the smallest double would overflow the ratio, but not its logarithm.
  const bool faint = l < 1e-300 * numerator;
  const double x = faint ? std::log(numerator) - std::log(l) : std::log1p(numerator / l);
  return Kelvin{si::radiation_c2 / (lambda * x)};
}

}  // namespace nadir::spectral
