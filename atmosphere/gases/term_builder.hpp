#pragma once

#include <cstddef>
#include <vector>

#include "atmosphere/gases/absorption_term.hpp"
#include "atmosphere/gases/grid_point.hpp"
#include "atmosphere/gases/term_mixture.hpp"

namespace nadir::atmosphere {

/// Turns the points of an interval into few exponential terms: at each point the product over gases
/// of their sums (random overlap), merged as it grows.
class TermBuilder {
 public:
  TermBuilder(const BandTables& tables, const GasAmounts& amounts, std::vector<GridPoint> points,
              double tolerance);
  [[nodiscard]] std::vector<AbsorptionTerm> build();

 private:
  /// What takes part: its depths along the probes per unit of amount's coefficient.
  struct Source {
    std::size_t column = 0;
    Probes amount{};
  };
  /// One term of one gas at one point.
  struct GasTerm {
    double weight = 0.0, coefficient = 0.0;
  };

  void find_sources();
  void gather_all(double width);
  void add_point(const GridPoint& point);
  void add_exact(const GridPoint& point);
  [[nodiscard]] std::vector<GasTerm> gas_terms(const GridPoint::Part& part) const;
  void multiply(const TermMixture& terms, std::size_t source, const std::vector<GasTerm>& gas,
                TermBins& into);
  void gather(const TermMixture& terms, double weight);
  [[nodiscard]] AbsorptionTerm expanded(const TermMixture& mixture, std::size_t i) const;

  const BandTables& tables_;
  const GasAmounts& amounts_;
  std::vector<GridPoint> points_;  ///< parts' columns: indices into sources_
  double tolerance_;
  std::vector<Source> sources_;
  TermBins all_{0, 1.0}, here_{0, 1.0}, next_{0, 1.0};
  ProbeTable exact_{};
};

}  // namespace nadir::atmosphere
