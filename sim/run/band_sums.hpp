#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/statistics.hpp"

namespace nadir::sim {

/// The radiance of each band of a pixel from the replicates of its paths, and its standard error.
///
/// Where the point-spread function differs from band to band, a path that was drawn for all of them
/// counts w_b in band b, mean 1. The plain mean of w_b L would have the weights' noise even over a
/// level field. Therefore replicate r estimates
///
///     mean(w_b L) - (mean(w_b) - 1) C,     C: mean of L in the other replicates,
///
/// a control variate: C is independent of replicate r, so that the expectation stays, and over a
/// level field the estimate is exact.
/// Replicates go on where a pixel is sampled in rounds: what a later round closes is averaged with
/// what the same replicate had, by paths.
/// Source of the principle: M. Kalos and P. Whitlock, "Monte Carlo Methods" (2008), section 4.2.
class BandSums {
 public:
  BandSums(std::size_t bands, int replicates, bool weighted);

  void begin_pixel();
  /// The next replicate to be closed is the first again.
  void begin_round() noexcept { closed_ = 0; }
  /// One path of a band that has weights. @param radiance  of the band
  void add_weighted(std::size_t band, double weight, double radiance) noexcept {
    weighted_sum_[band] += weight * radiance;
    weight_sum_[band] += weight;
  }
  /// Ends a replicate. @param plain_mean  of each band over its paths
  void close_replicate(std::span<const double> plain_mean, int paths);
  /// Of all replicates that were closed since begin_pixel.
  [[nodiscard]] Estimate estimate(std::size_t band) const;
  /// What each of them estimates. @param values  one a replicate that can be closed
  void estimates(std::size_t band, std::span<double> values) const;

 private:
  [[nodiscard]] std::size_t at(std::size_t replicate, std::size_t band) const {
    return replicate * bands_ + band;
  }

  /// Sum over the replicates of a band's plain means.
  [[nodiscard]] double sum_of_plain(std::size_t band) const;
  [[nodiscard]] double value(std::size_t replicate, std::size_t band, double sum_of_plain) const;

  std::size_t bands_;
  bool weighted_;
  std::size_t closed_ = 0;                                   // in the present round
  std::size_t seen_ = 0;                                     // closed at least once
  std::vector<int> paths_;                                   // by replicate
  std::vector<double> weighted_sum_, weight_sum_;            // of the present replicate, by band
  std::vector<double> plain_, weighted_mean_, mean_weight_;  // by replicate and band
};

}  // namespace nadir::sim
