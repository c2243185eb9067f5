#include "atmosphere/table/lane_match.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {
namespace {

constexpr double slack = 1e-9;  // relative: wavelengths may have gone through a file

bool alike(double a, double b) { return std::abs(a - b) <= slack * std::max(a, b); }

bool alike(const spectral::AbsorptionLane& a, const spectral::AbsorptionLane& b) {
  return a.term == b.term && alike(a.lo_um, b.lo_um) && alike(a.hi_um, b.hi_um);
}

bool has_interval(const spectral::AbsorptionLane& lane) { return lane.hi_um > 0.0; }

/// Lanes of the table that are not split: alone at their wavelength, and without an interval.
std::vector<std::size_t> unsplit(const std::vector<AirTable::Lane>& table) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto shares = [&](std::size_t k) {
      return k < table.size() && alike(table[k].wavelength_um, table[i].wavelength_um);
    };
    if (has_interval(table[i].absorption) || shares(i + 1) || (i > 0 && shares(i - 1))) continue;
    found.push_back(i);
  }
  return found;
}

std::string um(double wavelength) { return number_text(wavelength) + " um"; }

[[noreturn]] void refuse(const std::vector<AirTable::Lane>& table, double wavelength_um,
                         const spectral::AbsorptionLane& lane) {
  std::string what = um(wavelength_um);
  if (has_interval(lane)) {
    what += " (term " + std::to_string(lane.term + 1) + " of " + um(lane.lo_um) + " to " +
            um(lane.hi_um) + ")";
  }
  throw InputError{"the air table has nothing for " + what + ": it covers " +
                   std::to_string(table.size()) + " lanes from " + um(table.front().wavelength_um) +
                   " to " + um(table.back().wavelength_um)};
}

class Matcher {
 public:
  explicit Matcher(const std::vector<AirTable::Lane>& table)
      : table_{table}, unsplit_{unsplit(table)} {}

  [[nodiscard]] LaneMatch match(double wavelength_um, const spectral::AbsorptionLane& lane) const {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      if (alike(table_[i].wavelength_um, wavelength_um) && alike(table_[i].absorption, lane)) {
        return {i, i, 0.0F};
      }
    }
    const bool whole = unsplit_.size() == table_.size();
    if (lane.term != 0 || (has_interval(lane) && !whole)) refuse(table_, wavelength_um, lane);
    return between(wavelength_um, lane);
  }

 private:
  [[nodiscard]] LaneMatch between(double wavelength_um,
                                  const spectral::AbsorptionLane& lane) const {
    for (std::size_t k = 0; k < unsplit_.size(); ++k) {
      const std::size_t i = unsplit_[k];
      const double here = table_[i].wavelength_um;
      if (alike(here, wavelength_um)) return {i, i, 0.0F};
      if (here < wavelength_um) continue;
      // Not over a band whose lanes are split: the air differs there.
      if (k == 0 || unsplit_[k - 1] + 1 != i) break;
      const double before = table_[unsplit_[k - 1]].wavelength_um;
      return {unsplit_[k - 1], i, static_cast<float>((wavelength_um - before) / (here - before))};
    }
    refuse(table_, wavelength_um, lane);
  }

  const std::vector<AirTable::Lane>& table_;
  std::vector<std::size_t> unsplit_;
};

}  // namespace

std::vector<LaneMatch> match_lanes(const std::vector<AirTable::Lane>& table,
                                   const spectral::Lanes& lanes) {
  const Matcher matcher{table};
  std::vector<LaneMatch> matches;
  for (int lane = 0; lane < lanes.count(); ++lane) {
    matches.push_back(matcher.match(lanes[lane].value, lanes.absorption(lane)));
  }
  return matches;
}

}  // namespace nadir::atmosphere
