#include "atmosphere/gases/term_builder.hpp"

#include <algorithm>
#include <cmath>

#include "atmosphere/gases/merge_terms.hpp"

namespace nadir::atmosphere {

namespace {

/// Heights above the ground that the probes go to, km: from the top, then from the ground.
constexpr std::array<double, 14> from_top_km{70.0, 50.0, 43.0, 36.0, 29.0, 23.0, 18.0,
                                             15.0, 12.0, 9.5,  7.5,  5.0,  3.2,  1.6};
constexpr std::array<double, 5> from_ground_km{0.4, 1.2, 3.0, 8.0, 16.0};
/// The probe that terms are told apart by beside the whole air: from the top to 18 km.
constexpr std::size_t upper = 7;
static_assert(1 + from_top_km.size() + from_ground_km.size() == probe_count);

/// The layer that begins nearest to a height above the ground.
std::size_t nearest_level(const std::vector<double>& level_height_m, double above_ground_km) {
  const double height = level_height_m.back() + above_ground_km * 1e3;
  std::size_t best = 0;
  for (std::size_t i = 0; i < level_height_m.size(); ++i) {
    if (std::abs(level_height_m[i] - height) < std::abs(level_height_m[best] - height)) best = i;
  }
  return best;
}

}  // namespace

TermBuilder::TermBuilder(const BandTables& tables, const GasAmounts& amounts,
                         std::vector<GridPoint> points, double tolerance)
    : tables_{tables}, amounts_{amounts}, points_{std::move(points)}, tolerance_{tolerance} {
  find_sources();
}

void TermBuilder::find_sources() {
  constexpr std::size_t unknown = static_cast<std::size_t>(-1);
  std::vector<std::size_t> index(tables_.sets.size() + smooth_count, unknown);
  const std::vector<double>& heights = amounts_.level_height_m();
  std::array<std::pair<std::size_t, std::size_t>, probe_count> spans;  // layers from, to
  const std::size_t layers = heights.size() - 1;
  std::size_t p = 0;
  spans[p++] = {0, layers};
  for (const double km : from_top_km) spans[p++] = {0, nearest_level(heights, km)};
  for (const double km : from_ground_km) spans[p++] = {nearest_level(heights, km), layers};

  const auto find = [&](std::size_t column) {
    if (index[column] != unknown) return index[column];
    index[column] = sources_.size();
    Source source{column, {}};
    const std::vector<double>& amount = amounts_.of(column);
    for (std::size_t i = 0; i < probe_count; ++i) {
      for (std::size_t l = spans[i].first; l < spans[i].second; ++l) source.amount[i] += amount[l];
    }
    sources_.push_back(source);
    return index[column];
  };
  for (GridPoint& point : points_) {
    for (GridPoint::Part& part : point.bands) part.column = find(part.column);
    for (GridPoint::Part& part : point.smooth) part.column = find(part.column);
  }
}

std::vector<TermBuilder::GasTerm> TermBuilder::gas_terms(const GridPoint::Part& part) const {
  const Source& source = sources_[part.column];
  const BandSet& set = tables_.sets[source.column];
  const double x = part.coefficient * source.amount[0];
  const double longest = probe_air_masses.back();
  // Ascending in k. Neighbours that are thin along the longest path, or that let nothing through
  // the shortest, are one.
  const double spare = 0.01 * tolerance_;
  std::vector<GasTerm> terms;
  for (std::size_t j = 0; j < set.k.size(); ++j) {
    const GasTerm term{set.weight[j], set.k[j] * part.coefficient};
    if (!terms.empty()) {
      GasTerm& last = terms.back();
      const double weight = last.weight + term.weight;
      const double mean =
          (last.weight * last.coefficient + term.weight * term.coefficient) / weight;
      const double apart = longest * set.k[j] * x;
      if (0.5 * last.weight * term.weight / weight * apart * apart < spare) {
        last = {weight, mean};
        continue;
      }
    }
    terms.push_back(term);
  }
  return terms;
}

void TermBuilder::multiply(const TermMixture& terms, std::size_t source,
                           const std::vector<GasTerm>& gas, TermBins& into) {
  const Source& from = sources_[source];
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const TermMixture::Term& term = terms[i];
    for (const GasTerm& g : gas) {
      const double weight = term.weight * g.weight;
      const std::size_t bin = into.find(term.depth[0] + g.coefficient * from.amount[0],
                                        term.depth[upper] + g.coefficient * from.amount[upper]);
      TermMixture::Term& to = into.mixture()[bin];
      const double whole = to.weight + weight;
      const double share = weight / whole;
      for (std::size_t p = 0; p < probe_count; ++p) {
        to.depth[p] += share * (term.depth[p] + g.coefficient * from.amount[p] - to.depth[p]);
      }
      double* parts = into.mixture().part(bin);
      const double* own = terms.part(i);
      for (std::size_t c = 0; c < terms.parts(); ++c) parts[c] += share * (own[c] - parts[c]);
      parts[source] += share * g.coefficient;
      to.weight = whole;
    }
  }
}

void TermBuilder::gather(const TermMixture& terms, double weight) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const TermMixture::Term& term = terms[i];
    const std::size_t bin = all_.find(term.depth[0], term.depth[upper]);
    TermMixture::Term& to = all_.mixture()[bin];
    const double whole = to.weight + weight * term.weight;
    const double share = weight * term.weight / whole;
    for (std::size_t p = 0; p < probe_count; ++p) {
      to.depth[p] += share * (term.depth[p] - to.depth[p]);
    }
    double* parts = all_.mixture().part(bin);
    const double* own = terms.part(i);
    for (std::size_t c = 0; c < terms.parts(); ++c) parts[c] += share * (own[c] - parts[c]);
    to.weight = whole;
  }
}

void TermBuilder::add_exact(const GridPoint& point) {
  Probes depth{};
  for (const GridPoint::Part& part : point.smooth) {
    for (std::size_t p = 0; p < probe_count; ++p) {
      depth[p] += part.coefficient * sources_[part.column].amount[p];
    }
  }
  ProbeTable passed = transmittances(depth);
  for (const GridPoint::Part& part : point.bands) {
    const Source& source = sources_[part.column];
    const BandSet& set = tables_.sets[source.column];
    ProbeTable gas{};
    for (std::size_t j = 0; j < set.k.size(); ++j) {
      for (std::size_t p = 0; p < probe_count; ++p) {
        depth[p] = set.k[j] * part.coefficient * source.amount[p];
      }
      const ProbeTable term = transmittances(depth);
      for (std::size_t m = 0; m < gas.size(); ++m) {
        for (std::size_t p = 0; p < probe_count; ++p) gas[m][p] += set.weight[j] * term[m][p];
      }
    }
    for (std::size_t m = 0; m < gas.size(); ++m) {
      for (std::size_t p = 0; p < probe_count; ++p) passed[m][p] *= gas[m][p];
    }
  }
  for (std::size_t m = 0; m < passed.size(); ++m) {
    for (std::size_t p = 0; p < probe_count; ++p) exact_[m][p] += point.weight * passed[m][p];
  }
}

void TermBuilder::add_point(const GridPoint& point) {
  here_.clear();
  const std::size_t first = here_.mixture().add();
  TermMixture::Term& smooth = here_.mixture()[first];
  smooth.weight = 1.0;
  for (const GridPoint::Part& part : point.smooth) {
    here_.mixture().part(first)[part.column] += part.coefficient;
    for (std::size_t p = 0; p < probe_count; ++p) {
      smooth.depth[p] += part.coefficient * sources_[part.column].amount[p];
    }
  }
  for (const GridPoint::Part& part : point.bands) {
    next_.clear();
    multiply(here_.mixture(), part.column, gas_terms(part), next_);
    std::swap(here_, next_);
  }
  gather(here_.mixture(), point.weight);
}

AbsorptionTerm TermBuilder::expanded(const TermMixture& mixture, std::size_t i) const {
  AbsorptionTerm term{mixture[i].weight,
                      std::vector<double>(static_cast<std::size_t>(amounts_.layers()), 0.0)};
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    const double coefficient = mixture.part(i)[s];
    if (coefficient == 0.0) continue;
    const std::vector<double>& amount = amounts_.of(sources_[s].column);
    for (std::size_t l = 0; l < amount.size(); ++l) term.depth[l] += coefficient * amount[l];
  }
  // Fits in temperature may fall a hair below nothing in thin layers.
  for (double& depth : term.depth) depth = std::max(depth, 0.0);
  return term;
}

void TermBuilder::gather_all(double width) {
  all_ = here_ = next_ = TermBins{sources_.size(), width};
  for (const GridPoint& point : points_) add_point(point);
}

std::vector<AbsorptionTerm> TermBuilder::build() {
  for (const GridPoint& point : points_) add_exact(point);
  // Bins as wide as the tolerance seems to allow; narrower ones where it turns out that they do
  // not.
  double width = std::clamp(6.0 * std::sqrt(tolerance_), 0.05, 0.3);
  gather_all(width);
  MergedTerms merged = merged_terms(all_.mixture(), exact_, tolerance_);
  for (int attempt = 0; attempt < 2 && merged.error > tolerance_; ++attempt) {
    width *= 0.5;
    gather_all(width);
    MergedTerms again = merged_terms(all_.mixture(), exact_, tolerance_);
    if (again.error < merged.error) merged = std::move(again);
  }
  const TermMixture& mixture = merged.terms;
  std::vector<AbsorptionTerm> terms;
  double sum = 0.0;
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    terms.push_back(expanded(mixture, i));
    sum += terms.back().weight;
  }
  for (AbsorptionTerm& term : terms) term.weight /= sum;  // rounding
  return terms;
}

}  // namespace nadir::atmosphere
