#include <algorithm>
#include <cmath>

#include "core/share_bound.hpp"
#include "core/statistics.hpp"
#include "core/student_t.hpp"
#include "sim/run/audit.hpp"

namespace nadir::sim {
namespace {

constexpr double audit_confidence = 0.95;

/// What leaving effects out changed in a band of a pixel, with the standard error of that.
Estimate difference(const ProbedPixel& dropped, const ProbedPixel& complete, std::size_t band) {
  Welford change;
  const auto& a = dropped.replicates[band];
  const auto& b = complete.replicates[band];
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) change.add(b[i] - a[i]);
  // Bands that the optics spread differently weight their replicates: the estimates themselves say
  // by how much they differ, the replicates how uncertain that is.
  return {complete.bands[band].mean - dropped.bands[band].mean, change.estimate().standard_error};
}

/// So many standard errors that in an audit in which nothing differs, one chance in twenty lets any
/// pixel and band of all look as if it did (Bonferroni): Student's quantile for the replicates.
double sure_errors(std::span<const ProbedPixel> pixels) {
  double looks = 0.0;
  std::size_t replicates = 2;
  for (const ProbedPixel& pixel : pixels) {
    looks += static_cast<double>(pixel.bands.size());
    if (!pixel.replicates.empty()) replicates = std::max(replicates, pixel.replicates[0].size());
  }
  const double chance = 0.5 * (1.0 - audit_confidence) / std::max(looks, 1.0);
  return student_t_quantile(1.0 - chance, static_cast<int>(replicates) - 1);
}

/// |change| / unit; infinite where that is not a number.
double relative_change(double change, double unit) {
  if (change == 0.0) return 0.0;
  const double relative = std::fabs(change) / unit;
  return std::isfinite(relative) ? relative : HUGE_VAL;
}

}  // namespace

void compare_pixels(std::span<const ProbedPixel> dropped, std::span<const ProbedPixel> complete,
                    const ByBand& floor, const CameraNames& names, AuditReport& report) {
  const double sure = sure_errors(dropped);
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    const PixelPlace& place = complete[i].place;
    const auto array = static_cast<std::size_t>(place.array);
    bool beyond = false, surely = false;
    for (std::size_t band = 0; band < complete[i].bands.size(); ++band) {
      const Estimate change = difference(dropped[i], complete[i], band);
      const double unit = std::max(complete[i].bands[band].mean, floor[array][band]);
      const double relative = relative_change(change.mean, unit);
      const double error = unit > 0.0 ? change.standard_error / unit : 0.0;
      beyond = beyond || !(relative <= report.budget);
      surely = surely || !(relative - sure * error <= report.budget);
      const bool first = report.pixels == 0 && band == 0;
      if (!first && !(relative > report.largest)) continue;
      report.largest = relative;
      report.largest_error = error;
      report.array = names[array].array;
      report.band = names[array].bands[band];
      report.sample = place.sample;
      report.line = place.line;
    }
    ++report.pixels;
    report.beyond += beyond ? 1U : 0U;
    report.surely_beyond += surely ? 1U : 0U;
  }
  report.beyond_share = share_upper_bound(report.beyond, report.pixels, audit_confidence);
  report.surely_beyond_share =
      share_upper_bound(report.surely_beyond, report.pixels, audit_confidence);
}

}  // namespace nadir::sim
