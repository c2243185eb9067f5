#include "sensor/platform/jitter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"

namespace nadir::sensor {
namespace {

using Complex = std::complex<double>;

constexpr double steps_a_period = 16.0;
// Steps of the table before the span's first moment and after its last: what the cubic reaches.
constexpr std::size_t margin_steps = 2;
constexpr double Vec3::*jitter_axes[3] = {&Vec3::x, &Vec3::y, &Vec3::z};

void check_spectrum(const JitterSpectrum& spectrum) {
  const auto& frequencies = spectrum.frequencies_hz;
  const auto& densities = spectrum.density_rad2_hz;
  if (frequencies.size() != densities.size()) {
    throw InputError{"a spectrum of jitter has " + std::to_string(frequencies.size()) +
                     " frequencies but " + std::to_string(densities.size()) + " densities"};
  }
  if (frequencies.size() == 1) throw InputError{"a spectrum of jitter needs two frequencies"};
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    if (!(frequencies[i] > 0.0 && std::isfinite(frequencies[i]))) {
      throw InputError{"the frequencies of jitter must be above 0, not " +
                       number_text(frequencies[i]) + " Hz"};
    }
    if (i > 0 && !(frequencies[i] > frequencies[i - 1])) {
      throw InputError{"the frequencies of jitter must ascend: " + number_text(frequencies[i]) +
                       " Hz follows " + number_text(frequencies[i - 1]) + " Hz"};
    }
    if (!(densities[i] >= 0.0 && std::isfinite(densities[i]))) {
      throw InputError{"the density of jitter must not be negative: " + number_text(densities[i]) +
                       " rad2/Hz at " + number_text(frequencies[i]) + " Hz"};
    }
  }
}

void check_jitter(const JitterDescription& description) {
  const Vec3 white = description.white_rms_rad;
  if (!is_finite(white) || white.x < 0.0 || white.y < 0.0 || white.z < 0.0) {
    throw InputError{"the rms of jitter must be finite and not negative"};
  }
  for (const JitterSpectrum& spectrum : description.spectra) check_spectrum(spectrum);
}

/// Integral of the density from point i of a spectrum to a frequency up to point i + 1.
double partial_power(const JitterSpectrum& spectrum, std::size_t i, double to_hz) {
  const double f0 = spectrum.frequencies_hz[i], f1 = spectrum.frequencies_hz[i + 1];
  const double s0 = spectrum.density_rad2_hz[i], s1 = spectrum.density_rad2_hz[i + 1];
  if (s0 == 0.0 || s1 == 0.0) {
    const double s = s0 + (s1 - s0) * (to_hz - f0) / (f1 - f0);
    return 0.5 * (s0 + s) * (to_hz - f0);
  }
  // s0 f0 ((f / f0)^q - 1) / q with q = slope + 1; its limit at q = 0 is the logarithm.
  const double q = std::log(s1 / s0) / std::log(f1 / f0) + 1.0;
  const double x = std::log(to_hz / f0);
  const double exponent = q * x;
  return s0 * f0 * x * (std::abs(exponent) < 1e-12 ? 1.0 : std::expm1(exponent) / exponent);
}

/// power_below for frequencies that ascend from call to call.
class RunningPower {
 public:
  explicit RunningPower(const JitterSpectrum& spectrum) : spectrum_{spectrum} {}

  double below(double frequency_hz) {
    const auto& frequencies = spectrum_.frequencies_hz;
    for (; next_ + 1 < frequencies.size() && frequencies[next_ + 1] <= frequency_hz; ++next_) {
      passed_ += partial_power(spectrum_, next_, frequencies[next_ + 1]);
    }
    const bool inside = next_ + 1 < frequencies.size() && frequencies[next_] < frequency_hz;
    return inside ? passed_ + partial_power(spectrum_, next_, frequency_hz) : passed_;
  }

 private:
  const JitterSpectrum& spectrum_;
  std::size_t next_ = 0;
  double passed_ = 0.0;
};

/// The sums of a block from those of its even members, which stand first, and its odd ones. Half by
/// half, so that small blocks stay in the cache.
void add_waves(Complex* c, std::size_t count, const std::vector<Complex>& turns) {
  if (count == 1) return;
  const std::size_t half = count / 2, stride = turns.size() / half;
  add_waves(c, half, turns);
  add_waves(c + half, half, turns);
  for (std::size_t k = 0; k < half; ++k) {
    const Complex turn = turns[k * stride], odd = c[half + k];
    // By hand: the product of std::complex looks for infinities.
    const Complex b{turn.real() * odd.real() - turn.imag() * odd.imag(),
                    turn.real() * odd.imag() + turn.imag() * odd.real()};
    c[half + k] = c[k] - b;
    c[k] += b;
  }
}

/// exp(2 pi i k / count) for the first half, each by its own angle: no rounding adds up.
std::vector<Complex> half_turns(std::size_t count) {
  std::vector<Complex> turns(count / 2);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(count);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    turns[k] = std::polar(1.0, step * static_cast<double>(k));
  }
  return turns;
}

/// The sum over k of c_k exp(2 pi i k n / N), in place; N a power of two.
/// Source: Cooley and Tukey, Mathematics of Computation 19, 297 (1965).
void sum_of_waves(std::vector<Complex>& c, const std::vector<Complex>& turns) {
  const std::size_t count = c.size();
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(c[i], c[j]);
  }
  add_waves(c.data(), count, turns);
}

/// Amplitude and phase of a cosine with a share of the power.
Complex random_wave(double power, Rng& rng) {
  return std::polar(std::sqrt(2.0 * std::max(power, 0.0)), 2.0 * std::numbers::pi * rng.next());
}

/// The shaking about one axis at evenly spaced moments, a period of `waves.size()` steps.
void realise(const JitterSpectrum& spectrum, double step_s, Rng rng, std::vector<Complex>& waves,
             const std::vector<Complex>& turns) {
  const std::size_t count = waves.size();
  const double df = 1.0 / (step_s * static_cast<double>(count));
  // What is slower than the period drifts by less than half a turn: one slow cosine.
  RunningPower power{spectrum};
  double below = power.below(0.5 * df);
  const Complex drift = random_wave(below, rng);
  std::fill(waves.begin(), waves.end(), Complex{});
  const double top_hz = spectrum.frequencies_hz.back();
  for (std::size_t k = 1; k < count / 2; ++k) {
    const double f = df * static_cast<double>(k);
    if (f - 0.5 * df > top_hz) break;
    const double up_to = power.below(f + 0.5 * df);
    waves[k] = random_wave(up_to - below, rng);
    below = up_to;
  }
  sum_of_waves(waves, turns);
  if (drift == Complex{}) return;
  const double rate = 2.0 * std::numbers::pi * 0.25 / static_cast<double>(count);
  for (std::size_t n = 0; n < count; ++n) {
    waves[n] += drift * std::polar(1.0, rate * static_cast<double>(n));
  }
}

double fastest_hz(const JitterDescription& description) {
  double fastest = 0.0;
  for (const JitterSpectrum& spectrum : description.spectra) {
    if (!spectrum.frequencies_hz.empty()) {
      fastest = std::max(fastest, spectrum.frequencies_hz.back());
    }
  }
  return fastest;
}

}  // namespace

double power_below(const JitterSpectrum& spectrum, double frequency_hz) noexcept {
  return RunningPower{spectrum}.below(frequency_hz);
}

Jitter::Jitter(const JitterDescription& description, double first_s, double last_s)
    : white_rms_rad_{description.white_rms_rad} {
  check_jitter(description);
  const double fastest = fastest_hz(description);
  if (!(fastest > 0.0)) return;
  step_s_ = 1.0 / (steps_a_period * fastest);
  const double steps = std::ceil((last_s - first_s) / step_s_) + 2.0 * margin_steps;
  if (!(steps <= static_cast<double>(most_steps))) {
    throw InputError{"jitter of up to " + number_text(fastest) + " Hz over " +
                     number_text(last_s - first_s) + " s needs " + number_text(steps) +
                     " steps; at most " + std::to_string(most_steps) + " are kept"};
  }
  first_s_ = first_s - step_s_ * margin_steps;
  table_.resize(static_cast<std::size_t>(steps) + 1);
  // Twice the span at least: the cosines, which all repeat after this, do not within the span.
  std::vector<Complex> waves(std::bit_ceil(2 * std::max<std::size_t>(table_.size(), 512)));
  const std::vector<Complex> turns = half_turns(waves.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const JitterSpectrum& spectrum = description.spectra[axis];
    if (spectrum.frequencies_hz.empty()) continue;
    realise(spectrum, step_s_, Rng{description.seed, axis}, waves, turns);
    for (std::size_t n = 0; n < table_.size(); ++n) table_[n].*jitter_axes[axis] = waves[n].real();
    coloured_rms_rad_.*jitter_axes[axis] =
        std::sqrt(power_below(spectrum, spectrum.frequencies_hz.back()));
  }
}

Vec3 Jitter::angles_rad(double time_s) const noexcept {
  if (table_.empty()) return {};
  const double steps = (time_s - first_s_) / step_s_;
  const auto last = static_cast<double>(table_.size() - 3);
  const auto i = static_cast<std::size_t>(std::clamp(std::floor(steps), 1.0, last));
  // Lagrange's cubic through the two points on either side.
  const double u = steps - static_cast<double>(i), v = 1.0 - u;
  const double outer = u * v / 6.0;
  return table_[i - 1] * (-outer * (1.0 + v)) + table_[i] * (v * (1.0 + u) * (1.0 + v) * 0.5) +
         table_[i + 1] * (u * (1.0 + u) * (1.0 + v) * 0.5) + table_[i + 2] * (-outer * (1.0 + u));
}

}  // namespace nadir::sensor
