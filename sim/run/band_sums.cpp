#include "sim/run/band_sums.hpp"

#include <algorithm>

namespace nadir::sim {
namespace {

/// The mean over `old_paths` and `new_paths`; the new one itself where there is no old one.
double mean_of_both(double old_mean, int old_paths, double new_mean, int new_paths) {
  if (old_paths == 0) return new_mean;
  return (old_mean * old_paths + new_mean * new_paths) / (old_paths + new_paths);
}

}  // namespace

BandSums::BandSums(std::size_t bands, int replicates, bool weighted)
    : bands_{bands},
      weighted_{weighted},
      paths_(static_cast<std::size_t>(replicates)),
      weighted_sum_(bands),
      weight_sum_(bands),
      plain_(bands * static_cast<std::size_t>(replicates)),
      weighted_mean_(weighted ? plain_.size() : 0),
      mean_weight_(weighted ? plain_.size() : 0) {}

void BandSums::begin_pixel() {
  closed_ = seen_ = 0;
  std::fill(paths_.begin(), paths_.end(), 0);
  std::fill(weighted_sum_.begin(), weighted_sum_.end(), 0.0);
  std::fill(weight_sum_.begin(), weight_sum_.end(), 0.0);
}

void BandSums::close_replicate(std::span<const double> plain_mean, int paths) {
  const int before = paths_[closed_];
  for (std::size_t band = 0; band < bands_; ++band) {
    const auto take = [&](std::vector<double>& means, double mean) {
      double& old = means[at(closed_, band)];
      old = mean_of_both(old, before, mean, paths);
    };
    take(plain_, plain_mean[band]);
    if (!weighted_) continue;
    take(weighted_mean_, weighted_sum_[band] / paths);
    take(mean_weight_, weight_sum_[band] / paths);
    weighted_sum_[band] = weight_sum_[band] = 0.0;
  }
  paths_[closed_] += paths;
  ++closed_;
  seen_ = std::max(seen_, closed_);
}

double BandSums::sum_of_plain(std::size_t band) const {
  double all = 0.0;
  for (std::size_t r = 0; r < seen_; ++r) all += plain_[at(r, band)];
  return all;
}

double BandSums::value(std::size_t r, std::size_t band, double sum_of_plain) const {
  const double plain = plain_[at(r, band)];
  if (!weighted_) return plain;
  const double others = seen_ > 1 ? (sum_of_plain - plain) / static_cast<double>(seen_ - 1) : 0.0;
  return weighted_mean_[at(r, band)] - (mean_weight_[at(r, band)] - 1.0) * others;
}

Estimate BandSums::estimate(std::size_t band) const {
  Welford spread;
  const double all = sum_of_plain(band);
  for (std::size_t r = 0; r < seen_; ++r) spread.add(value(r, band, all));
  return spread.estimate();
}

void BandSums::estimates(std::size_t band, std::span<double> values) const {
  const double all = sum_of_plain(band);
  for (std::size_t r = 0; r < seen_; ++r) values[r] = value(r, band, all);
}

}  // namespace nadir::sim
