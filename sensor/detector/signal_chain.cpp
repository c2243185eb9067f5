#include "sensor/detector/signal_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "sensor/detector/checks.hpp"
#include "sensor/detector/photon_yield.hpp"
#include "sensor/detector/shot_noise.hpp"

namespace nadir::sensor {
namespace {

constexpr double rounding_variance = 1.0 / 12.0;  // of numbers rounded to whole ones, DN^2

double top_of(const Digitiser& digitiser) noexcept {
  return static_cast<double>((1U << static_cast<unsigned>(digitiser.bits)) - 1U);
}

/// Electrons per s of the optics' and the shield's own light, for a relative efficiency of 1.
///
/// Warm optics of transmittance 1 - eps emit eps B towards the detector through the cone that the
/// scene's light takes; what stands behind them, a cold filter, has tau / (1 - eps). The shield
/// shines from beside the cone, past lens and filter.
double own_light(const spectral::Response& response, const Optics& optics) {
  double sum = 0.0;
  if (optics.temperature_k > 0.0 && optics.emissivity > 0.0) {
    const double behind =
        optics.transmittance / std::max(1.0 - optics.emissivity, optics.transmittance);
    sum += cone_sr(optics) * behind * optics.emissivity *
           band_planck(response, Kelvin{optics.temperature_k});
  }
  if (optics.shield_temperature_k > 0.0) {
    sum += shield_sr(optics) * band_planck(response, Kelvin{optics.shield_temperature_k});
  }
  return sum;
}

FixedPattern::Rms rms_of(const Detector& detector) noexcept {
  const auto* photons = std::get_if<PhotonDetector>(&detector.element);
  return photons == nullptr
             ? FixedPattern::Rms{0.0, 0.0, detector.dead_share}
             : FixedPattern::Rms{photons->prnu, photons->dsnu_e, detector.dead_share};
}

LineNoise::Rms line_rms(const Detector& detector) noexcept {
  const auto* photons = std::get_if<PhotonDetector>(&detector.element);
  if (photons == nullptr) return {};
  return {photons->line_noise_e, photons->line_correlation, photons->flicker_noise_e};
}

/// Published figures are of calibrated images: their light does not fall off.
double falloff_power(const Detector& detector) noexcept {
  return std::holds_alternative<PhotonDetector>(detector.element) ? detector.optics.falloff_power
                                                                  : 0.0;
}

/// Fall-off at places spread evenly over the image, the middles of as many equal parts.
std::vector<double> spread_falloff(const DetectorArray& array, double power) {
  constexpr int parts = 16;
  if (power == 0.0 || !std::holds_alternative<Perspective>(array.projection)) return {};
  FallOff falloff{array, power};
  const int lines = std::min(array.lines, parts), samples = std::min(array.samples, parts);
  const auto middle = [](int i, int n, int all) {
    return static_cast<int>((2 * static_cast<std::int64_t>(i) + 1) * all / (2 * n));
  };
  std::vector<double> found;
  for (int j = 0; j < lines; ++j) {
    falloff.line(middle(j, lines, array.lines));
    for (int i = 0; i < samples; ++i) {
      found.push_back(falloff.at(static_cast<std::size_t>(middle(i, samples, array.samples))));
    }
  }
  return found;
}

void check_lengths(std::size_t samples, const SignalChain::Line& out) {
  const auto fits = [&](const auto& plane) { return plane.empty() || plane.size() == samples; };
  if (out.dn.size() == samples && fits(out.electrons) && fits(out.noise)) return;
  throw std::invalid_argument{"a line's radiance and its numbers differ in length"};
}

/// What a float cannot hold is the largest one: light beyond all wells must not become infinite.
float in_float(double value) {
  constexpr float most = std::numeric_limits<float>::max();
  if (std::isnan(value)) return std::numeric_limits<float>::quiet_NaN();
  return value < static_cast<double>(most) ? static_cast<float>(value) : most;
}

}  // namespace

SignalChain::Photons SignalChain::folded(const DetectorArray& array, std::size_t band,
                                         const Detector& detector) {
  const auto& element = std::get<PhotonDetector>(detector.element);
  const Timing& timing = array.timing;
  if (!(timing.exposure_s > 0.0)) {
    throw InputError{"array " + in_quotes(array.name) +
                     " looks for a moment only: a detector that counts photons needs an exposure "
                     "(noise by published figures does not)"};
  }
  const spectral::Response& response = array.bands[band].response;
  const double seconds = timing.exposure_s * std::max(timing.tdi_stages, 1);
  const double counted =
      seconds * element.area_m2 * element.efficiency * photon_yield(response).per_radiance;
  Photons p;
  p.per_radiance = counted * cone_sr(detector.optics) * detector.optics.transmittance;
  p.background = counted * own_light(response, detector.optics);
  p.dark = seconds * element.dark_e_s *
           std::exp2((element.temperature_k - element.dark_reference_k) / element.dark_doubling_k);
  p.read = element.read_noise_e;
  p.line = line_rms(detector);
  p.full_well = element.full_well_e;
  p.dn_per_electron = detector.digitiser.gain_dn_e.value_or(
      (top_of(detector.digitiser) - detector.digitiser.black_level_dn) / element.full_well_e);
  if (p.background + p.dark >= p.full_well) {
    throw InputError{"dark current (" + number_text(p.dark) +
                     " electrons) and the optics' own "
                     "light (" +
                     number_text(p.background) + ") fill the well of " + number_text(p.full_well) +
                     " in one exposure"};
  }
  return p;
}

SignalChain::Element SignalChain::element_of(const DetectorArray& array, std::size_t band,
                                             const Detector& detector) {
  if (band >= array.bands.size()) throw std::invalid_argument{"no such band in the array"};
  check(detector);
  const auto* published = std::get_if<PublishedNoise>(&detector.element);
  if (published == nullptr) return folded(array, band, detector);
  const Digitiser& digitiser = detector.digitiser;
  return Published{digitiser.saturation / (top_of(digitiser) - digitiser.black_level_dn),
                   published->alpha * published->alpha, published->beta};
}

SignalChain::SignalChain(const DetectorArray& array, std::size_t band, const Detector& detector,
                         std::uint64_t noise_seed)
    : element_{element_of(array, band, detector)},
      black_dn_{detector.digitiser.black_level_dn},
      top_dn_{top_of(detector.digitiser)},
      flat_{detector.digitiser.flat},
      noisy_{detector.noisy},
      pattern_{array, band_key(detector.pattern_seed, array, band), rms_of(detector)},
      falloff_{array, falloff_power(detector)},
      falloff_over_image_{spread_falloff(array, falloff_power(detector))},
      // Apart from the pattern's numbers though the two seeds be alike.
      noise_key_{mix(band_key(noise_seed, array, band), 1)},
      line_noise_{line_rms(detector)} {}

double SignalChain::digitised(double dn) const noexcept {
  return std::clamp(std::floor(dn + 0.5), 0.0, top_dn_);
}

void SignalChain::next_line() {
  ++line_;
  pattern_.line(line_);
  falloff_.line(line_);
  const auto counter = static_cast<std::uint64_t>(line_);
  line_key_ = mix(noise_key_, counter);
  of_line_ = line_noise_.next(mix(line_key_, ~std::uint64_t{0}));
}

double SignalChain::shot(double mean, double normal, std::uint64_t own) const noexcept {
  return mean < exact_poisson_mean ? poisson_by_sum(mean, to_unit(mix(line_key_, own + 2)))
                                   : poisson_by_normal(mean, normal);
}

SignalChain::Pixel SignalChain::pixel(const Photons& p, double radiance, std::size_t sample) const {
  const std::uint64_t own = 4 * static_cast<std::uint64_t>(sample);
  const double falloff = falloff_.at(sample);
  const double signal = std::max(p.per_radiance * falloff * radiance, 0.0);
  const double mean = (signal + p.background) * pattern_.gain(sample) + p.dark;
  const Vec2 z = normal_pair(mix(line_key_, own), mix(line_key_, own + 1));
  const double charge = std::min(noisy_ ? shot(mean, z.x, own) : mean, p.full_well);
  const double noise = noisy_ ? p.read * z.y + of_line_ : 0.0;
  const double read_out = charge + pattern_.offset(sample) + noise;
  double dn = digitised(p.dn_per_electron * read_out + black_dn_);
  if (flat_ && falloff != 1.0) {
    const double without_light = black_dn_ + p.dn_per_electron * (p.background + p.dark);
    dn = digitised(without_light + (dn - without_light) / falloff);
  }
  return {dn, signal, sigma(p, radiance, falloff)};
}

SignalChain::Pixel SignalChain::pixel(const Published& p, double radiance,
                                      std::size_t sample) const {
  const std::uint64_t own = 4 * static_cast<std::uint64_t>(sample);
  // The figures hold for the numbers as they are delivered: what rounding adds is in them.
  const double variance = p.constant + p.slope * std::max(radiance, 0.0) -
                          rounding_variance * p.radiance_per_dn * p.radiance_per_dn;
  const double z = normal_pair(mix(line_key_, own), mix(line_key_, own + 1)).x;
  const double measured = radiance + (noisy_ ? std::sqrt(std::max(variance, 0.0)) * z : 0.0);
  return {digitised(black_dn_ + measured / p.radiance_per_dn), 0.0, sigma(p, radiance)};
}

double SignalChain::converted_variance(const Photons& p, double radiance, double falloff) {
  const double mean = std::max(p.per_radiance * falloff * radiance, 0.0) + p.background + p.dark;
  const double electrons =
      mean + p.read * p.read + p.line.stripe * p.line.stripe + p.line.flicker * p.line.flicker;
  return electrons * p.dn_per_electron * p.dn_per_electron + rounding_variance;
}

double SignalChain::second_rounding(const Photons& p, double radiance,
                                    double falloff) const noexcept {
  if (!flat_) return 0.0;
  // The whole number n of the converter moves by d = (n - P)(1 / falloff - 1) and is rounded again.
  // Near the axis, d < 1/2, that brings n back: an error of d. Where d is of several steps, its
  // fraction is anything: 1/12. Means over neighbouring pixels, whose d differ.
  const double moved =
      p.dn_per_electron * p.per_radiance * std::max(radiance, 0.0) * (1.0 - falloff);
  return std::min(moved * moved, rounding_variance);
}

double SignalChain::sigma(const Photons& p, double radiance, double falloff) const {
  const double converted = converted_variance(p, radiance, falloff) / (falloff * falloff);
  return std::sqrt(converted + second_rounding(p, radiance, falloff)) /
         (p.per_radiance * p.dn_per_electron);
}

double SignalChain::sigma(const Published& p, double radiance) const {
  return std::sqrt(std::max(p.constant + p.slope * std::max(radiance, 0.0),
                            rounding_variance * p.radiance_per_dn * p.radiance_per_dn));
}

void SignalChain::expose(std::span<const float> radiance, const Line& out) {
  check_lengths(radiance.size(), out);
  next_line();
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto each = [&](const auto& element) {
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const auto value = static_cast<double>(radiance[i]);
      Pixel found{0.0, 0.0, unknown};
      if (!std::isfinite(value)) {
        found.electrons = unknown;
      } else if (!pattern_.dead(i)) {
        found = pixel(element, value, i);
      }
      out.dn[i] = static_cast<std::uint16_t>(found.dn);
      if (!out.electrons.empty()) out.electrons[i] = in_float(found.electrons);
      if (!out.noise.empty()) out.noise[i] = in_float(found.noise);
    }
  };
  std::visit(each, element_);
}

Calibration SignalChain::calibration() const noexcept {
  if (const auto* published = std::get_if<Published>(&element_)) {
    return {published->radiance_per_dn, -black_dn_ * published->radiance_per_dn};
  }
  const auto& p = *std::get_if<Photons>(&element_);
  const double gain = 1.0 / (p.dn_per_electron * p.per_radiance);
  return {gain, -black_dn_ * gain - (p.background + p.dark) / p.per_radiance};
}

double SignalChain::noise_equivalent_radiance(double radiance) const noexcept {
  if (const auto* published = std::get_if<Published>(&element_)) return sigma(*published, radiance);
  const auto& p = *std::get_if<Photons>(&element_);
  double second = 0.0;
  for (const double falloff : falloff_over_image_) second += second_rounding(p, radiance, falloff);
  if (!falloff_over_image_.empty()) second /= static_cast<double>(falloff_over_image_.size());
  return std::sqrt(converted_variance(p, radiance, 1.0) + second) /
         (p.per_radiance * p.dn_per_electron);
}

double SignalChain::electrons_per_radiance() const noexcept {
  const auto* photons = std::get_if<Photons>(&element_);
  return photons != nullptr ? photons->per_radiance : 0.0;
}

double SignalChain::background_electrons() const noexcept {
  const auto* photons = std::get_if<Photons>(&element_);
  return photons != nullptr ? photons->background + photons->dark : 0.0;
}

double SignalChain::saturation_radiance() const noexcept {
  const auto* photons = std::get_if<Photons>(&element_);
  if (photons == nullptr) {
    return (top_dn_ - black_dn_) * std::get_if<Published>(&element_)->radiance_per_dn;
  }
  const double range = (top_dn_ - black_dn_) / photons->dn_per_electron;
  return (std::min(photons->full_well, range) - photons->background - photons->dark) /
         photons->per_radiance;
}

}  // namespace nadir::sensor
