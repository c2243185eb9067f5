#include "atmosphere/gases/term_mixture.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::atmosphere {

namespace {

/// Depths below this are alike: optically thin.
constexpr double thin = 0.03;
/// Terms deeper than this are alike even to the probes of the upper air.
constexpr double deepest = 1e10;

}  // namespace

ProbeTable transmittances(const Probes& depth) noexcept {
  ProbeTable passed;
  for (std::size_t p = 0; p < probe_count; ++p) {
    const double once = std::exp(-depth[p]), twice = once * once;
    passed[0][p] = once;
    passed[1][p] = twice;
    passed[2][p] = twice * twice;
    passed[3][p] = twice * twice * twice;
  }
  return passed;
}

std::size_t TermMixture::add() {
  terms_.emplace_back();
  coefficients_.resize(coefficients_.size() + parts_, 0.0);
  return terms_.size() - 1;
}

void TermMixture::clear() {
  terms_.clear();
  coefficients_.clear();
}

void TermMixture::merge(std::size_t into, std::size_t from) {
  Term& a = terms_[into];
  Term& b = terms_[from];
  const double weight = a.weight + b.weight;
  const double share_a = a.weight / weight, share_b = b.weight / weight;
  for (std::size_t p = 0; p < probe_count; ++p) {
    a.depth[p] = share_a * a.depth[p] + share_b * b.depth[p];
  }
  double* to = part(into);
  const double* other = part(from);
  for (std::size_t i = 0; i < parts_; ++i) to[i] = share_a * to[i] + share_b * other[i];
  a.weight = weight;
  b.weight = 0.0;
}

void TermMixture::tidy() {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < size(); ++i) {
    if (terms_[i].weight > 0.0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return terms_[a].depth[0] < terms_[b].depth[0];
  });
  std::vector<Term> terms;
  std::vector<double> coefficients;
  terms.reserve(order.size());
  coefficients.reserve(order.size() * parts_);
  for (const std::size_t i : order) {
    terms.push_back(terms_[i]);
    coefficients.insert(coefficients.end(), part(i), part(i) + parts_);
  }
  terms_ = std::move(terms);
  coefficients_ = std::move(coefficients);
}

ProbeTable TermMixture::transmittance() const {
  ProbeTable sum{};
  for (const Term& term : terms_) {
    const ProbeTable passed = transmittances(term.depth);
    for (std::size_t m = 0; m < sum.size(); ++m) {
      for (std::size_t p = 0; p < probe_count; ++p) sum[m][p] += term.weight * passed[m][p];
    }
  }
  return sum;
}

TermBins::TermBins(std::size_t parts, double width) : width_{width}, slots_(256), mixture_{parts} {}

TermBins::Slot& TermBins::slot_of(std::uint32_t cell) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = (cell * 2'654'435'769U >> 8U) & mask;  // Knuth's multiplicative hash
  while (slots_[at].index >= 0 && slots_[at].cell != cell) at = (at + 1) & mask;
  return slots_[at];
}

void TermBins::grow() {
  std::vector<Slot> old(slots_.size() * 2);
  std::swap(old, slots_);
  for (const Slot& slot : old) {
    if (slot.index >= 0) slot_of(slot.cell) = slot;
  }
}

std::size_t TermBins::find(double whole, double upper) {
  const auto place = [&](double depth) {
    return static_cast<std::uint32_t>(std::log((std::min(depth, deepest) + thin) / thin) / width_);
  };
  const std::uint32_t cell = place(whole) * 65'536U + place(upper);
  Slot* slot = &slot_of(cell);
  if (slot->index < 0) {
    if (2 * (mixture_.size() + 1) > slots_.size()) {
      grow();
      slot = &slot_of(cell);
    }
    *slot = {cell, static_cast<int>(mixture_.add())};
  }
  return static_cast<std::size_t>(slot->index);
}

void TermBins::clear() {
  std::fill(slots_.begin(), slots_.end(), Slot{});
  mixture_.clear();
}

}  // namespace nadir::atmosphere
