#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nadir::atmosphere {

/// Paths on which sums of exponentials are compared: from the top or the ground to some levels.
inline constexpr std::size_t probe_count = 20;
using Probes = std::array<double, probe_count>;
/// Each of them at these air masses.
inline constexpr std::array<double, 4> probe_air_masses{1.0, 2.0, 4.0, 6.0};
/// Transmittances or errors of all probes: [air mass][path].
using ProbeTable = std::array<Probes, probe_air_masses.size()>;

/// exp(-depth) at every air mass.
[[nodiscard]] ProbeTable transmittances(const Probes& depth) noexcept;

/// A sum of exponentials while it is put together: each term has a weight, its optical depth along
/// the probes, and what it takes of each column of amounts (`parts` numbers). The first probe is
/// the whole air.
class TermMixture {
 public:
  explicit TermMixture(std::size_t parts) : parts_{parts} {}

  struct Term {
    double weight = 0.0;
    Probes depth{};
    ProbeTable passed{};  ///< transmittances(depth), kept by those who merge
  };
  [[nodiscard]] std::size_t size() const noexcept { return terms_.size(); }
  [[nodiscard]] std::size_t parts() const noexcept { return parts_; }
  [[nodiscard]] Term& operator[](std::size_t i) { return terms_[i]; }
  [[nodiscard]] const Term& operator[](std::size_t i) const { return terms_[i]; }
  [[nodiscard]] double* part(std::size_t i) { return coefficients_.data() + i * parts_; }
  [[nodiscard]] const double* part(std::size_t i) const {
    return coefficients_.data() + i * parts_;
  }

  /// A new term without weight, depth or parts.
  std::size_t add();
  void clear();
  /// Term `into` becomes the mean of both by weight; `from` loses its weight.
  void merge(std::size_t into, std::size_t from);
  /// Takes out terms without weight, and sorts what is left by depth of the whole air.
  void tidy();
  /// Sum of weight times transmittance.
  [[nodiscard]] ProbeTable transmittance() const;

 private:
  std::size_t parts_;
  std::vector<Term> terms_;
  std::vector<double> coefficients_;
};

/// Gathers terms, and merges those at once that are alike both in the depth of the whole air and in
/// that of its upper part.
class TermBins {
 public:
  /// @param width  of a bin, in the logarithm of depth
  TermBins(std::size_t parts, double width);

  /// The bin of a term of those depths: an index into mixture().
  [[nodiscard]] std::size_t find(double whole, double upper);
  [[nodiscard]] TermMixture& mixture() noexcept { return mixture_; }
  void clear();

 private:
  struct Slot {
    std::uint32_t cell = 0;
    int index = -1;  ///< -1: free
  };
  [[nodiscard]] Slot& slot_of(std::uint32_t cell);
  void grow();

  double width_;
  std::vector<Slot> slots_;  ///< a hash table; its size is a power of 2
  TermMixture mixture_;
};

}  // namespace nadir::atmosphere
