#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/study/analyse.hpp"

namespace nadir::sim {
namespace {

constexpr int most_samples = 1 << 20;  // of a replicate: more than any picture gets

double worst_row_error(const RowFigures& row, int replicates, double samples) {
  double worst = 0.0;
  for (std::size_t b = 0; b < row.bands.size(); ++b) {
    worst = std::max(worst, row.error(b, replicates, samples));
  }
  return worst;
}

/// The fewest samples of a replicate by which a row reaches the target; none where its bias, as
/// far as it is known, does not let it.
std::optional<int> samples_for(double target, const RowFigures& row, int replicates) {
  for (const RowBand& band : row.bands) {
    // A bias that was not seen but cannot be excluded counts: a row must have been measured well
    // enough to be recommended for this target.
    if (!(band.pixel_bias_limit < target)) return std::nullopt;
  }
  if (worst_row_error(row, replicates, most_samples) > target) return std::nullopt;
  int few = 0, enough = 1;
  while (worst_row_error(row, replicates, enough) > target) {
    few = enough;
    enough *= 2;
  }
  while (enough - few > 1) {
    const int middle = few + (enough - few) / 2;
    (worst_row_error(row, replicates, middle) > target ? few : enough) = middle;
  }
  return enough;
}

std::string reason_for(const Recommendation& best, const RowFigures& row, std::size_t reached) {
  double limit = 0.0;
  for (const RowBand& band : row.bands) limit = std::max(limit, band.pixel_bias_limit);
  const std::string bias = row.point.unbiased()
                               ? std::string{"it has no bias"}
                               : fmt::format("its bias is below {:.2g} %", 100.0 * limit);
  if (reached == 1)
    return fmt::format("the only row that reaches {:g} %; {}", 100.0 * best.target, bias);
  return fmt::format("the fastest of {} rows that reach {:g} %; {}", reached, 100.0 * best.target,
                     bias);
}

}  // namespace

Recommendation recommend(double target, const std::vector<RowFigures>& rows,
                         const StudyHeader& header) {
  Recommendation best;
  best.target = target;
  best.replicates = header.replicates;
  const RowFigures* chosen = nullptr;
  std::size_t reached = 0;
  for (const RowFigures& row : rows) {
    if (row.point.paired) continue;  // told apart: the reference itself has that error
    const auto samples = samples_for(target, row, header.replicates);
    if (!samples) continue;
    ++reached;
    const double paths = static_cast<double>(header.replicates) * *samples;
    const double picture_s = row.picture_s(paths, header.threads);
    if (chosen != nullptr && picture_s >= best.picture_s) continue;
    chosen = &row;
    best.reached = true;
    best.row = row.point.name;
    best.settings = row.point.settings;
    best.samples = *samples;
    best.picture_s = picture_s;
    best.error = worst_row_error(row, header.replicates, *samples);
  }
  if (chosen == nullptr) {
    best.reason = "no row that was measured is known to reach it";
    return best;
  }
  for (const RowBand& band : chosen->bands) best.bias.push_back(band.pixel_bias);
  best.reason = reason_for(best, *chosen, reached);
  return best;
}

}  // namespace nadir::sim
