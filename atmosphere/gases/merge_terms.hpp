#pragma once

#include "atmosphere/gases/term_mixture.hpp"

namespace nadir::atmosphere {

/// Terms, and the largest difference of their transmittance from the exact one at the probes.
struct MergedTerms {
  TermMixture terms;
  double error = 0.0;
};

/// The fewest terms found whose transmittance stays within the tolerance of `exact` at every probe,
/// ascending in depth of the whole air; the best found where none does.
///
/// Pairs of terms are merged, the cheapest first; what merging does to the transmittance is made
/// up for by fitting the weights of those left, none negative, to the exact transmittance.
[[nodiscard]] MergedTerms merged_terms(TermMixture mixture, const ProbeTable& exact,
                                       double tolerance);

}  // namespace nadir::atmosphere
