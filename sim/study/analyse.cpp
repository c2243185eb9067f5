#include "sim/study/analyse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/study/study_points.hpp"

namespace nadir::sim {
namespace {

constexpr double one_sided_95 = 1.645;  // standard deviations
// A rate is believed when it is known so well; otherwise that of independent paths holds.
constexpr double rate_known = 0.15;
// The heaviest tails that levels of path tracing have in practice make a variance that much less
// certain than a normal distribution's would.
constexpr double tail_allowance = 2.0;

const StudySample* same_numbers(const StudyRecord& record, const StudyRun& run) {
  const std::string path = key_of(reference_settings(record.header.scope.scenario));
  for (const StudyRun& other : record.runs) {
    const SamplingRequest &a = run.sample.request, &b = other.sample.request;
    if (other.key == path && a.samples == b.samples && a.replicates == b.replicates &&
        a.seed == b.seed) {
      return &other.sample;
    }
  }
  return nullptr;
}

double sum_over(const std::vector<BandMeasures>& bands, double BandMeasures::*figure,
                bool squared) {
  double sum = 0.0;
  for (const BandMeasures& band : bands)
    sum += squared ? band.*figure * band.*figure : band.*figure;
  return sum;
}

/// Bias does not depend on the number of paths: all levels' estimates, weighted by their paths.
/// (Not by the variances found: few paths that miss a rare bright one have too little of both.)
void pool_bias(RowFigures& row) {
  for (std::size_t b = 0; b < row.bands.size(); ++b) {
    double weight = 0.0, bias = 0.0, variance = 0.0, square = 0.0, square_variance = 0.0;
    for (const LevelFigures& level : row.levels) {
      const BandMeasures& f = level.bands[b];
      const double w = static_cast<double>(level.samples) * level.replicates;
      weight += w;
      bias += w * f.bias;
      variance += w * w * f.bias_error * f.bias_error;
      square += w * f.square_bias;
      square_variance += w * w * f.square_bias_error * f.square_bias_error;
    }
    RowBand& band = row.bands[b];
    band.bias = bias / weight;
    band.bias_error = std::sqrt(variance) / weight;
    if (row.point.unbiased()) continue;
    const double mean = square / weight, error = std::sqrt(square_variance) / weight;
    band.pixel_bias = std::sqrt(std::max(0.0, mean));
    band.pixel_bias_limit = std::sqrt(std::max(0.0, mean) + one_sided_95 * error);
  }
}

void fit_rates(RowFigures& row) {
  std::vector<RatePoint> noise;
  const double bands = static_cast<double>(row.bands.size());
  for (const LevelFigures& level : row.levels) {
    const double rms = std::sqrt(sum_over(level.bands, &BandMeasures::noise, true) / bands);
    if (!(rms > 0.0)) continue;
    double variance = 0.0;
    for (const BandMeasures& f : level.bands) {
      variance += f.noise * f.noise * f.noise_error * f.noise_error;
    }
    const double sigma = tail_allowance * std::sqrt(variance) / bands / rms;
    noise.push_back({static_cast<double>(level.samples), rms, std::max(sigma, 1e-6 * rms)});
    // error^2 of one replicate: bias and its own noise
    const double square_bias = sum_over(level.bands, &BandMeasures::square_bias, false) / bands;
    const double error2 = rms * rms + square_bias;
    if (!(error2 > 0.0)) continue;
    const double error = std::sqrt(error2);
    const double bias_sigma =
        std::sqrt(sum_over(level.bands, &BandMeasures::square_bias_error, true)) / bands;
    row.errors.push_back({static_cast<double>(level.samples), error,
                          std::hypot(2.0 * rms * sigma, bias_sigma) / (2.0 * error)});
  }
  row.rate = fit_rate(noise, RateBias::none);
  row.with_bias = fit_rate(row.errors, RateBias::fitted);
}

double known_rate(const RateFit& fit) { return fit.rate_uncertainty < rate_known ? fit.rate : 0.5; }

LevelFigures level_of(const StudyRun& run, const StudySample* pair, const Reference& reference) {
  LevelFigures level;
  level.samples = run.sample.request.samples;
  level.replicates = run.sample.request.replicates;
  level.bands = compare(run.sample, reference, pair);
  level.cost = run.sample.cost;
  return level;
}

void fill_costs(RowFigures& row) {
  // The level with the most paths has the surest times.
  const SampleCost& cost = row.levels.back().cost;
  row.path_cpu_s = cost.path_cpu_s;
  row.path_wall_s = cost.path_wall_s;
  row.picture_cpu_s = cost.picture_cpu_s;
  row.rays_per_path = cost.rays_per_path;
  row.setup_s = std::numeric_limits<double>::infinity();
  for (const LevelFigures& level : row.levels) {
    row.setup_s = std::min(row.setup_s, level.cost.setup_s);
    row.peak_memory_bytes = std::max(row.peak_memory_bytes, level.cost.peak_memory_bytes);
  }
}

void fill_levels(RowFigures& row, const StudyHeader& header) {
  for (LevelFigures& level : row.levels) {
    level.paths = static_cast<double>(header.replicates) * level.samples;
    level.picture_s = row.picture_s(level.paths, header.threads);
    for (std::size_t b = 0; b < row.bands.size(); ++b) {
      level.error.push_back(
          std::hypot(row.bands[b].pixel_bias, level.bands[b].noise / std::sqrt(header.replicates)));
      level.worst_error = std::max(level.worst_error, level.error.back());
    }
  }
}

RowFigures row_of(const StudyPoint& point, const StudyRecord& record, const Reference& reference) {
  RowFigures row;
  row.point = point;
  const std::string key = key_of(point.settings);
  for (const StudyRun& run : record.runs) {
    if (run.key != key) continue;
    const StudySample* pair = point.paired ? same_numbers(record, run) : nullptr;
    if (point.paired && pair == nullptr) continue;
    row.levels.push_back(level_of(run, pair, reference));
  }
  if (row.levels.empty()) return row;
  std::sort(row.levels.begin(), row.levels.end(),
            [](const auto& a, const auto& b) { return a.samples < b.samples; });
  row.bands.resize(reference.mean.size());
  pool_bias(row);
  fit_rates(row);
  for (std::size_t b = 0; b < row.bands.size(); ++b) {
    const LevelFigures& first = row.levels.front();
    row.bands[b].top_noise = row.levels.back().bands[b].noise;
    row.bands[b].path_noise = first.bands[b].noise * std::pow(first.samples, known_rate(row.rate));
  }
  fill_costs(row);
  fill_levels(row, record.header);
  return row;
}

std::vector<TradePoint> front_of(const std::vector<TradePoint>& points) {
  std::vector<CostPoint> costs;
  for (const TradePoint& point : points) costs.push_back(point.cost);
  std::vector<TradePoint> front;
  for (const std::size_t i : pareto_front(costs)) front.push_back(points[i]);
  return front;
}

/// Sets beside a prediction what was found when it was tried.
void add_confirmation(Recommendation& advice, const StudyRecord& record,
                      const Reference& reference) {
  for (const StudyRun& run : record.confirmations) {
    const SamplingRequest& request = run.sample.request;
    if (run.key != key_of(advice.settings) || request.samples != advice.samples) continue;
    advice.found_error = 0.0;
    for (const BandMeasures& f : compare(run.sample, reference, nullptr)) {
      const double square = f.square_bias + f.noise * f.noise / request.replicates;
      advice.found_error = std::max(advice.found_error, std::sqrt(std::max(0.0, square)));
    }
  }
}

}  // namespace

double RowFigures::error(std::size_t band, int replicates, double samples) const {
  const double top = levels.back().samples;
  const double noise = bands[band].top_noise * std::pow(samples / top, -known_rate(rate));
  return std::hypot(bands[band].pixel_bias, noise / std::sqrt(replicates));
}

double RowFigures::picture_s(double paths, int threads) const {
  return setup_s + picture_cpu_s * paths / threads;
}

StudyResult analyse(const StudyRecord& record) {
  StudyResult result;
  result.reference = reference_of(record);
  if (record.reference.empty()) return result;
  for (const StudyPoint& point : study_points(record.header.scope)) {
    RowFigures row = row_of(point, record, result.reference);
    if (!row.levels.empty()) result.rows.push_back(std::move(row));
  }
  for (std::size_t r = 0; r < result.rows.size(); ++r) {
    const RowFigures& row = result.rows[r];
    if (row.point.paired) continue;  // their bias is a difference, not what the reference sees
    for (std::size_t l = 0; l < row.levels.size(); ++l) {
      const LevelFigures& level = row.levels[l];
      result.points.push_back({r, l, {level.picture_s, level.worst_error}});
    }
  }
  result.pareto = front_of(result.points);
  for (const double target : study_targets) {
    result.recommendations.push_back(recommend(target, result.rows, record.header));
    Recommendation& advice = result.recommendations.back();
    if (advice.reached) add_confirmation(advice, record, result.reference);
  }
  return result;
}

}  // namespace nadir::sim
