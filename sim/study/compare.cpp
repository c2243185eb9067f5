#include <algorithm>
#include <cmath>

#include "core/statistics.hpp"
#include "sim/study/analyse.hpp"

namespace nadir::sim {
namespace {

// Where no floor is known, pixels darker than a tenth of their band's mean are held to its
// accuracy: otherwise a few deep shadows would be the whole error.
constexpr double floor_of_mean = 0.1;

double pixel_mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

void set_scale(Reference& reference, const StudyHeader& header) {
  for (std::size_t b = 0; b < reference.mean.size(); ++b) {
    const double mean = pixel_mean(reference.mean[b]);
    const double stated = b < header.bands.size() ? header.bands[b].floor_radiance : 0.0;
    double floor = stated > 0.0 ? stated : floor_of_mean * mean;
    if (!(floor > 0.0)) floor = 1e-30;  // a black band: any error is absolute
    std::vector<double> scale;
    double squares = 0.0;
    for (std::size_t i = 0; i < reference.mean[b].size(); ++i) {
      scale.push_back(std::max(reference.mean[b][i], floor));
      squares += reference.variance[b][i] / (scale[i] * scale[i]);
    }
    const double pixels = std::max(1.0, static_cast<double>(scale.size()));
    reference.radiance.push_back(mean);
    reference.floor.push_back(floor);
    reference.error.push_back(std::sqrt(squares / pixels));
    reference.scale.push_back(std::move(scale));
  }
}

/// One band's sums over pixels.
struct BandSum {
  Welford square_bias, noise2;
  double difference = 0.0, difference_variance = 0.0, scale = 0.0, variance_of_noise2 = 0.0;
};

BandMeasures figures_of(const BandSum& sum) {
  BandMeasures f;
  const double pixels = static_cast<double>(sum.square_bias.count());
  if (pixels < 1.0 || !(sum.scale > 0.0)) return f;
  f.bias = sum.difference / sum.scale;
  f.bias_error = std::sqrt(sum.difference_variance) / sum.scale;
  f.square_bias = sum.square_bias.mean();
  const double spread = sum.square_bias.estimate().standard_error;
  f.square_bias_error = std::isfinite(spread) ? spread : std::abs(f.square_bias);
  f.noise = std::sqrt(std::max(0.0, sum.noise2.mean()));
  if (f.noise > 0.0) {
    f.noise_error = std::sqrt(sum.variance_of_noise2) / pixels / (2.0 * f.noise);
  }
  return f;
}

}  // namespace

Reference reference_of(const StudyRecord& record) {
  Reference reference;
  const double rounds = static_cast<double>(record.reference.size());
  for (const StudySample& round : record.reference) {
    const double replicates = round.request.replicates;
    reference.paths += round.paths();
    if (reference.mean.empty()) {
      for (const auto& band : round.mean) {
        reference.mean.emplace_back(band.size(), 0.0);
        reference.variance.emplace_back(band.size(), 0.0);
      }
    }
    for (std::size_t b = 0; b < round.mean.size(); ++b) {
      for (std::size_t i = 0; i < round.mean[b].size(); ++i) {
        reference.mean[b][i] += round.mean[b][i] / rounds;
        reference.variance[b][i] += round.variance[b][i] / (replicates * rounds * rounds);
      }
    }
  }
  set_scale(reference, record.header);
  return reference;
}

std::vector<BandMeasures> compare(const StudySample& sample, const Reference& reference,
                                  const StudySample* paired_with) {
  std::vector<BandMeasures> bands;
  const double replicates = sample.request.replicates;
  for (std::size_t b = 0; b < sample.mean.size(); ++b) {
    BandSum sum;
    Welford differences;
    for (std::size_t i = 0; i < sample.mean[b].size(); ++i) {
      const double scale = reference.scale[b][i], v = sample.variance[b][i];
      const bool paired = paired_with != nullptr;
      const double other = paired ? paired_with->mean[b][i] : reference.mean[b][i];
      const double d = sample.mean[b][i] - other;
      // Of a difference with the same random numbers the noise is not known: none is taken off.
      const double noise = paired ? 0.0 : v / replicates + reference.variance[b][i];
      sum.square_bias.add((d * d - noise) / (scale * scale));
      sum.noise2.add(v / (scale * scale));
      // Of a variance from R draws: 2 v^2 / (R - 1), for a normal distribution.
      const double relative = v / (scale * scale);
      sum.variance_of_noise2 += 2.0 * relative * relative / std::max(1.0, replicates - 1.0);
      sum.difference += d;
      sum.difference_variance += noise;
      sum.scale += scale;
      differences.add(d);
    }
    if (paired_with != nullptr && differences.count() > 1) {
      sum.difference_variance = differences.variance() * static_cast<double>(differences.count());
    }
    bands.push_back(figures_of(sum));
  }
  return bands;
}

}  // namespace nadir::sim
