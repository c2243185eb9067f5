#include "atmosphere/gases/merge_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "atmosphere/gases/nonnegative_fit.hpp"

namespace nadir::atmosphere {

namespace {

/// All pairs are looked at from this many terms on.
constexpr std::size_t most_terms = 80;

/// What merging two terms takes from the transmittance, to second order: half the variance of depth
/// times the transmittance between; the worst of all probes.
double merging_cost(const TermMixture::Term& a, const TermMixture::Term& b) {
  double worst = 0.0;
  for (std::size_t m = 0; m < probe_air_masses.size(); ++m) {
    const double scale = probe_air_masses[m] * probe_air_masses[m];
    for (std::size_t p = 0; p < probe_count; ++p) {
      const double apart = a.depth[p] - b.depth[p];
      const double lost = scale * apart * apart;
      // Its square, which spares the root of the two transmittances' product.
      worst = std::max(worst, lost * lost * a.passed[m][p] * b.passed[m][p]);
    }
  }
  return 0.5 * a.weight * b.weight / (a.weight + b.weight) * std::sqrt(worst);
}

void merge(TermMixture& mixture, std::size_t into, std::size_t from) {
  mixture.merge(into, from);
  mixture[into].passed = transmittances(mixture[into].depth);
}

/// Passes over neighbours in depth, merging those that cost less than a bound that grows, until few
/// are left.
void thin_out(TermMixture& mixture, double tolerance) {
  constexpr std::size_t window = 10;
  for (double most = 1e-4 * tolerance; mixture.size() > most_terms; most *= 2.5) {
    const std::size_t before = mixture.size();
    std::size_t left = before;
    for (std::size_t i = 0; i < before && left > most_terms; ++i) {
      if (mixture[i].weight == 0.0) continue;
      for (std::size_t j = i + 1; j < std::min(before, i + window); ++j) {
        if (mixture[j].weight == 0.0 || merging_cost(mixture[i], mixture[j]) > most) continue;
        merge(mixture, i, j);
        --left;
      }
    }
    mixture.tidy();
  }
}

/// The order in which all terms merge into one, the cheapest pair first.
class MergingOrder {
 public:
  explicit MergingOrder(TermMixture mixture)
      : mixture_{std::move(mixture)}, n_{mixture_.size()}, cost_(n_ * n_, none), best_(n_, 0) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = i + 1; j < n_; ++j) cost_[i * n_ + j] = cost(i, j);
      find_best(i);
    }
    for (std::size_t left = n_; left > 1; --left) merge_cheapest();
  }
  /// Pairs: the second goes into the first.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& pairs() const {
    return pairs_;
  }

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();

  [[nodiscard]] double least(std::size_t i) const { return cost_[i * n_ + best_[i]]; }
  [[nodiscard]] double cost(std::size_t i, std::size_t j) const {
    const bool there = mixture_[i].weight > 0.0 && mixture_[j].weight > 0.0;
    return there ? merging_cost(mixture_[i], mixture_[j]) : none;
  }
  void find_best(std::size_t i) {
    const auto row = cost_.begin() + static_cast<std::ptrdiff_t>(i * n_);
    best_[i] = static_cast<std::size_t>(
        std::min_element(row, row + static_cast<std::ptrdiff_t>(n_)) - row);
  }
  void renew(std::size_t i, std::size_t j) {
    const std::size_t row = std::min(i, j), column = std::max(i, j);
    cost_[row * n_ + column] = cost(row, column);
    if (best_[row] == column) {
      find_best(row);
    } else if (cost_[row * n_ + column] < least(row)) {
      best_[row] = column;
    }
  }
  void merge_cheapest() {
    std::size_t i = 0;
    for (std::size_t k = 1; k < n_; ++k) {
      if (least(k) < least(i)) i = k;
    }
    const std::size_t j = best_[i];
    pairs_.emplace_back(i, j);
    merge(mixture_, i, j);
    for (std::size_t k = 0; k < n_; ++k) {
      if (k != i) renew(i, k);
      if (k != j) renew(j, k);
    }
  }

  TermMixture mixture_;
  std::size_t n_;
  std::vector<double> cost_;       ///< of pairs i < j; of others: none
  std::vector<std::size_t> best_;  ///< by row
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Fits the weights to the exact transmittance; the largest error at the probes.
double fit_weights(TermMixture& mixture, const ProbeTable& exact) {
  const std::size_t n = mixture.size();
  NonnegativeFit fit{n};
  std::vector<double> row(n);
  for (std::size_t m = 0; m < probe_air_masses.size(); ++m) {
    for (std::size_t p = 0; p < probe_count; ++p) {
      for (std::size_t i = 0; i < n; ++i) row[i] = mixture[i].passed[m][p];
      fit.add(row, exact[m][p], 1.0);
    }
  }
  // Without any air all passes: a row that counts as much as all others a hundred times.
  fit.add(std::vector<double>(n, 1.0), 1.0, 100.0 * probe_count * probe_air_masses.size());
  std::vector<double> weights(n);
  for (std::size_t i = 0; i < n; ++i) weights[i] = mixture[i].weight;
  weights = fit.solve(std::move(weights));
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  for (std::size_t i = 0; i < n; ++i) mixture[i].weight = weights[i] / sum;

  double worst = 0.0;
  for (std::size_t m = 0; m < probe_air_masses.size(); ++m) {
    for (std::size_t p = 0; p < probe_count; ++p) {
      double passed = -exact[m][p];
      for (std::size_t i = 0; i < n; ++i) passed += mixture[i].weight * mixture[i].passed[m][p];
      worst = std::max(worst, std::abs(passed));
    }
  }
  return worst;
}

/// The terms after all but `count` have been merged, weights fitted; and their largest error.
MergedTerms reduced(const TermMixture& all, const MergingOrder& order, std::size_t count,
                    const ProbeTable& exact) {
  TermMixture mixture = all;
  for (std::size_t i = 0; i + count < all.size(); ++i) {
    mixture.merge(order.pairs()[i].first, order.pairs()[i].second);
  }
  mixture.tidy();
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    mixture[i].passed = transmittances(mixture[i].depth);
  }
  const double error = fit_weights(mixture, exact);
  mixture.tidy();
  return {std::move(mixture), error};
}

}  // namespace

MergedTerms merged_terms(TermMixture mixture, const ProbeTable& exact, double tolerance) {
  mixture.tidy();
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    mixture[i].passed = transmittances(mixture[i].depth);
  }
  thin_out(mixture, tolerance);
  // The tolerance holds between the probes too when it holds at them with this to spare.
  const double aim = 0.7 * tolerance;
  const MergingOrder order{mixture};
  std::size_t enough = 1;
  while (enough < mixture.size()) {
    if (reduced(mixture, order, enough, exact).error <= aim) break;
    enough = std::min(enough * 2, mixture.size());
  }
  if (enough == mixture.size()) {
    MergedTerms all = reduced(mixture, order, enough, exact);
    if (all.error > aim) return all;  // fewer will not do better
  }
  std::size_t too_few = enough / 2;
  while (enough - too_few > 1) {
    const std::size_t middle = (enough + too_few) / 2;
    (reduced(mixture, order, middle, exact).error > aim ? too_few : enough) = middle;
  }
  return reduced(mixture, order, enough, exact);
}

}  // namespace nadir::atmosphere
