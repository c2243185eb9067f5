#pragma once

#include <memory>
#include <vector>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/layered.hpp"
#include "atmosphere/optical_column.hpp"
#include "atmosphere/particles/particles.hpp"

namespace nadir::atmosphere {

/// Makes the optical column of a scene's air at any wavelength and absorption term. Kinds of
/// particles that scatter less than 1e-7 of everything at all the wavelengths are left out; of the
/// others, the weakest are merged so that at most `most_kinds` remain, Rayleigh included.
class ColumnMaker {
 public:
  static constexpr int most_kinds = 5;

  ColumnMaker(const Layered& air, const std::vector<Micrometres>& wavelengths);

  [[nodiscard]] const std::vector<double>& levels_m() const noexcept { return levels_m_; }
  [[nodiscard]] std::vector<AbsorptionTerm> terms(const spectral::AbsorptionLane& lane,
                                                  Micrometres wavelength, double tolerance) const;
  /// @param gas_depth  of the absorption term, by layer
  [[nodiscard]] OpticalColumn column(Micrometres wavelength,
                                     const std::vector<double>& gas_depth) const;

 private:
  void group_kinds(const std::vector<Micrometres>& wavelengths);
  [[nodiscard]] OpticalColumn::Kind merged(const std::vector<int>& group,
                                           const std::vector<KindOptics>& optics) const;

  std::vector<double> levels_m_;
  std::vector<double> temperatures_k_;
  GasAbsorption gases_;
  Particles particles_;
  std::vector<double> total_550_;         // extinction of each kind of particles, whole column
  std::vector<std::vector<int>> groups_;  // kinds of particles that make one kind of the column
};

}  // namespace nadir::atmosphere
