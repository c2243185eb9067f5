#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/products/preview.hpp"
#include "sim/products/report.hpp"

namespace nadir::sim {

/// The summary of an image that comes in strips. Counts, ranges and means hold for all pixels,
/// percentiles for all of those that a preview of so many pixels keeps.
class RunningSummary {
 public:
  /// @param first        the first strip
  /// @param top_dn       of each band, the number that says "saturated", where it is known; or none
  /// @param most_pixels  for percentiles
  explicit RunningSummary(const ArrayImage& first,
                          std::vector<std::optional<std::uint16_t>> top_dn = {},
                          std::size_t most_pixels = most_preview_pixels);
  /// The strips in their order, the first included.
  void take(const ArrayImage& strip);
  [[nodiscard]] ArraySummary finish();

 private:
  struct Range {
    ValueRange range;
    double sum = 0.0;
    std::uint64_t count = 0;

    void add(double value);
    [[nodiscard]] ValueRange finish() const;
  };
  struct RunningBand {
    BandSummary summary;
    Range radiance, brightness, dn;
    DnSummary numbers;
    std::vector<float> relative_errors;
  };
  void take_band(const ArrayImage& strip, std::size_t band);

  int step_;
  ArraySummary summary_;
  std::vector<RunningBand> bands_;
  std::vector<std::optional<std::uint16_t>> top_dn_;
  std::uint64_t seen_ = 0, sky_ = 0;
  std::vector<float> room_;
};

}  // namespace nadir::sim
