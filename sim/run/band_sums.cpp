#include "sim/run/band_sums.hpp"

#include <algorithm>

namespace nadir::sim {

BandSums::BandSums(std::size_t bands, int replicates, bool weighted)
    : bands_{bands},
      weighted_{weighted},
      weighted_sum_(bands),
      weight_sum_(bands),
      plain_(bands * static_cast<std::size_t>(replicates)),
      weighted_mean_(weighted ? plain_.size() : 0),
      mean_weight_(weighted ? plain_.size() : 0) {}

void BandSums::begin_pixel() {
  closed_ = 0;
  std::fill(weighted_sum_.begin(), weighted_sum_.end(), 0.0);
  std::fill(weight_sum_.begin(), weight_sum_.end(), 0.0);
}

void BandSums::close_replicate(std::span<const double> plain_mean, int paths) {
  for (std::size_t band = 0; band < bands_; ++band) {
    plain_[at(closed_, band)] = plain_mean[band];
    if (!weighted_) continue;
    weighted_mean_[at(closed_, band)] = weighted_sum_[band] / paths;
    mean_weight_[at(closed_, band)] = weight_sum_[band] / paths;
    weighted_sum_[band] = weight_sum_[band] = 0.0;
  }
  ++closed_;
}

Estimate BandSums::estimate(std::size_t band) const {
  Welford spread;
  double all = 0.0;
  for (std::size_t r = 0; r < closed_; ++r) all += plain_[at(r, band)];
  for (std::size_t r = 0; r < closed_; ++r) {
    const double plain = plain_[at(r, band)];
    if (!weighted_) {
      spread.add(plain);
      continue;
    }
    const double others = closed_ > 1 ? (all - plain) / static_cast<double>(closed_ - 1) : 0.0;
    spread.add(weighted_mean_[at(r, band)] - (mean_weight_[at(r, band)] - 1.0) * others);
  }
  return spread.estimate();
}

}  // namespace nadir::sim
