#include "sensor/platform/jitter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using sensor::Jitter;
using sensor::JitterDescription;
using sensor::JitterSpectrum;

namespace {

constexpr double Vec3::*axis_of[3] = {&Vec3::x, &Vec3::y, &Vec3::z};

// A platform's: flat at low frequencies, falling, with a line of a reaction wheel at 20 Hz.
const JitterSpectrum falling{{0.5, 5.0, 19.0, 20.0, 21.0, 50.0},
                             {1e-12, 1e-12, 2e-13, 8e-12, 2e-13, 1e-14}};

JitterDescription all_axes(const JitterSpectrum& spectrum, std::uint64_t seed) {
  JitterDescription description;
  for (JitterSpectrum& s : description.spectra) s = spectrum;
  description.seed = seed;
  return description;
}

/// Mean over the span of products of two axes.
double mean_product(const Jitter& jitter, int a, int b, double last_s) {
  double sum = 0.0;
  int count = 0;
  for (double t = 0.0; t < last_s; t += 0.0017) {
    const Vec3 angles = jitter.angles_rad(t);
    sum += angles.*axis_of[a] * (angles.*axis_of[b]);
    ++count;
  }
  return sum / count;
}

/// Share of the power about x in a band, by the squares of its Fourier coefficients in a span.
double measured_power(const Jitter& jitter, double from_hz, double to_hz, double span_s) {
  const double step_s = 0.002;
  const int count = static_cast<int>(std::lround(span_s / step_s));
  double power = 0.0;
  for (double f = from_hz + 0.5 / span_s; f < to_hz; f += 1.0 / span_s) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * f * step_s);
    std::complex<double> phase = 1.0, sum = 0.0;
    for (int n = 0; n < count; ++n) {
      sum += jitter.angles_rad(n * step_s).x * phase;
      phase *= turn;
    }
    power += 2.0 * std::norm(sum / static_cast<double>(count));
  }
  return power;
}

std::string message_of(const JitterDescription& description, double last_s = 1.0) {
  try {
    const Jitter jitter{description, 0.0, last_s};
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

std::string message_of(const JitterSpectrum& spectrum) { return message_of(all_axes(spectrum, 1)); }

}  // namespace

TEST_CASE("the power of a spectrum is its integral, of power laws exactly", "[sensor][jitter]") {
  const JitterSpectrum steep{{1.0, 4.0}, {3.0, 3.0 / 16.0}};  // 3 / f^2
  CHECK(sensor::power_below(steep, 2.0) == Approx(1.5).epsilon(1e-14));
  CHECK(sensor::power_below(steep, 9.0) == Approx(2.25).epsilon(1e-14));
  CHECK(sensor::power_below(steep, 1.0) == 0.0);
  const JitterSpectrum pink{{1.0, 10.0}, {1.0, 0.1}};  // 1 / f, whose integral is the logarithm
  CHECK(sensor::power_below(pink, 5.0) == Approx(std::log(5.0)).epsilon(1e-14));
  const JitterSpectrum edge{{1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}};  // a triangle
  CHECK(sensor::power_below(edge, 1.5) == Approx(0.125).epsilon(1e-14));
  CHECK(sensor::power_below(edge, 3.0) == Approx(1.0).epsilon(1e-14));
}

// The mean square over 60 s. Of N = (band 3 Hz or so) x 60 s independent cosines the power is
// fixed; a span that is not their period leaves the leakage, measured below 1 % for these seeds.
TEST_CASE("the rms of a realisation is that of its spectrum", "[sensor][jitter]") {
  const Jitter jitter{all_axes(falling, 5), 0.0, 60.0};
  const double power = sensor::power_below(falling, 100.0);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(mean_product(jitter, axis, axis, 60.0) == Approx(power).epsilon(0.05));
    CHECK(jitter.coloured_rms_rad().*axis_of[axis] == Approx(std::sqrt(power)).epsilon(1e-12));
  }
}

// Correlation of two axes over 60 s: 1 / sqrt(2 x bandwidth x 60 s) = 0.05 to 0.1; 4 sigma.
TEST_CASE("the axes shake independently", "[sensor][jitter]") {
  const Jitter jitter{all_axes(falling, 5), 0.0, 60.0};
  const double power = sensor::power_below(falling, 100.0);
  CHECK(std::abs(mean_product(jitter, 0, 1, 60.0)) < 0.3 * power);
  CHECK(std::abs(mean_product(jitter, 1, 2, 60.0)) < 0.3 * power);
  CHECK(std::abs(mean_product(jitter, 2, 0, 60.0)) < 0.3 * power);
}

// 64 coefficients and 4 seeds a band: 1 / sqrt(256) = 6 %, and leakage between them; 4 sigma.
TEST_CASE("each band of frequencies has its share of the power", "[sensor][jitter]") {
  const JitterSpectrum steps{{1.0, 10.0, 10.1, 20.0, 20.1, 30.0},
                             {1e-12, 1e-12, 4e-12, 4e-12, 5e-13, 5e-13}};
  Vec3 power;
  double above = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Jitter jitter{all_axes(steps, seed), 0.0, 8.0};
    power +=
        0.25 * Vec3{measured_power(jitter, 1.5, 9.5, 8.0), measured_power(jitter, 11.0, 19.0, 8.0),
                    measured_power(jitter, 21.0, 29.0, 8.0)};
    above += 0.25 * measured_power(jitter, 40.0, 48.0, 8.0);
  }
  CHECK(power.x == Approx(8e-12).epsilon(0.25));
  CHECK(power.y == Approx(32e-12).epsilon(0.25));
  CHECK(power.z == Approx(4e-12).epsilon(0.25));
  CHECK(above < 4e-13);  // leakage of a span that is no period
}

// Slower than the span: over many seeds the mean square at one moment is still the whole power.
// Of N values a^2 (1 + cos 2 phi) the mean has the relative error sqrt(1 / (2 N)): 4 % at 300.
TEST_CASE("what is slower than the span keeps its power", "[sensor][jitter]") {
  // 1e-12 / f^2: all but a hundredth of its power is slower than the period of the cosines.
  const JitterSpectrum slow{{1e-6, 0.01}, {1.0, 1e-8}};
  double sum = 0.0;
  constexpr int seeds = 300;
  for (int seed = 0; seed < seeds; ++seed) {
    JitterDescription description;
    description.spectra[1] = slow;
    description.seed = static_cast<std::uint64_t>(seed);
    const Jitter jitter{description, 0.0, 1.0};
    sum += std::pow(jitter.angles_rad(0.5).y, 2);
    CHECK(jitter.angles_rad(0.5).x == 0.0);
  }
  CHECK(sum / seeds == Approx(1e-6).epsilon(0.16));
}

// A narrow line at the highest frequency, 16 steps a period, is the cubic's worst case:
// (3 / 128) (2 pi / 16)^4 = 5.6e-4 of the amplitude in the middle of a step. The line's envelope
// over a part of a period is a plain cosine, fitted here by three of its own values.
TEST_CASE("between its steps the table is within 6e-4 of the rms", "[sensor][jitter]") {
  const Jitter jitter{all_axes({{9.999999, 10.0}, {1.0, 1.0}}, 3), 0.0, 0.2};
  const double w = 2.0 * std::numbers::pi * 10.0;
  // Through what the table holds exactly: c cos w t + s sin w t from two of its moments.
  const double t0 = 0.0, t1 = 4.0 / 160.0;  // a quarter of a period apart
  const double a = jitter.angles_rad(t0).x, b = jitter.angles_rad(t1).x;
  const double rms = jitter.coloured_rms_rad().x;
  double worst = 0.0;
  for (double t = 0.0; t < 0.1; t += 0.00037) {
    const double exact = a * std::cos(w * t) + b * std::sin(w * t);
    worst = std::max(worst, std::abs(jitter.angles_rad(t).x - exact));
  }
  CAPTURE(worst / rms);
  CHECK(worst < 6e-4 * std::hypot(a, b));
  CHECK(worst > 1e-4 * std::hypot(a, b));  // it is a cubic
}

TEST_CASE("a seed gives one realisation, another seed another", "[sensor][jitter]") {
  const Jitter one{all_axes(falling, 5), -2.0, 3.0}, same{all_axes(falling, 5), -2.0, 3.0};
  const Jitter other{all_axes(falling, 6), -2.0, 3.0};
  for (const double t : {-2.0, -0.1234, 3.0}) {
    CHECK(one.angles_rad(t) == same.angles_rad(t));
    CHECK(one.angles_rad(t) != other.angles_rad(t));
    CHECK(one.angles_rad(t).x != one.angles_rad(t).y);
  }
}

TEST_CASE("without spectra nothing has memory", "[sensor][jitter]") {
  JitterDescription description;
  CHECK_FALSE(Jitter{}.has_memory());
  CHECK_FALSE(Jitter{}.is_white());
  description.white_rms_rad = {0, 1e-6, 0};
  const Jitter white{description, 0.0, 1e9};
  CHECK_FALSE(white.has_memory());
  CHECK(white.is_white());
  CHECK(white.angles_rad(5.0) == Vec3{});
  CHECK(white.white_rms_rad() == Vec3{0, 1e-6, 0});
}

TEST_CASE("spectra that are none are refused", "[sensor][jitter]") {
  CHECK(message_of(JitterSpectrum{{1, 2}, {1}}) ==
        "a spectrum of jitter has 2 frequencies but 1 densities");
  CHECK(message_of(JitterSpectrum{{1}, {1}}) == "a spectrum of jitter needs two frequencies");
  CHECK(message_of(JitterSpectrum{{0, 1}, {1, 1}}) ==
        "the frequencies of jitter must be above 0, not 0 Hz");
  CHECK(message_of(JitterSpectrum{{2, 2}, {1, 1}}) ==
        "the frequencies of jitter must ascend: 2 Hz follows 2 Hz");
  CHECK(message_of(JitterSpectrum{{1, 2}, {1, -1}}) ==
        "the density of jitter must not be negative: -1 rad2/Hz at 2 Hz");
  JitterDescription description;
  description.white_rms_rad.z = -1.0;
  CHECK(message_of(description) == "the rms of jitter must be finite and not negative");
  CHECK(message_of(all_axes({{1, 1000}, {1, 1}}, 1), 1000.0) ==
        "jitter of up to 1000 Hz over 1000 s needs 16000004 steps; at most 4000000 are kept");
}
