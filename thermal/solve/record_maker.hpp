#pragma once

#include "thermal/solve/heat_solver.hpp"
#include "thermal/solve/material_heat.hpp"

// Private to this folder.

namespace nadir::thermal {

/// Marches a cell through its record once more and writes down what happens.
class RecordMaker {
 public:
  /// @param memory  loads and balances, and the temperatures that the record begins with
  /// @param asked   the side whose sun is told
  RecordMaker(const MaterialHeat& heat, const SharedStages& shared, CellMemory& memory,
              const SideLoad& asked)
      : heat_{heat}, shared_{shared}, memory_{memory}, asked_{asked} {}

  void fill(HeatRecord& record) const;

 private:
  /// Both sides of an open sheet together.
  [[nodiscard]] BalanceTerms terms(std::size_t stage, double surface_k) const;

  const MaterialHeat& heat_;
  const SharedStages& shared_;
  CellMemory& memory_;
  const SideLoad& asked_;
};

}  // namespace nadir::thermal
