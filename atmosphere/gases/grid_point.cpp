#include "atmosphere/gases/grid_point.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {

namespace {

/// Clough's radiation field v tanh(h c v / 2 k T), cm^-1.
double radiation_field(double wavenumber, double temperature_k) {
  constexpr double boltzmann_per_cm = 0.6952;  // k/(h c), cm^-1 K^-1, as in LOWTRAN7
  return wavenumber * std::tanh(wavenumber / (2.0 * boltzmann_per_cm * temperature_k));
}

/// Water's continuum (Clough 1982) with LOWTRAN7's two patches: the dip of the self part about 1050
/// cm^-1, and an additional foreign part.
void add_water(const BandTables& tables, const GasAmounts& amounts, double v, GridPoint& point) {
  if (v > tables.foreign.last()) return;
  const double dip = 1.0 - 0.2333 * 4e4 / ((v - 1050.0) * (v - 1050.0) + 4e4);
  const double at_296 = tables.self_296.at(v) * dip * radiation_field(v, 296.0);
  const double at_260 = tables.self_260.at(v) * dip * radiation_field(v, 260.0);
  const double near = 1.025 * 3.159e-8 * std::exp(-2.75e-4 * v);
  const double far = 8.97e-6 * std::exp(-1.3e-3 * v);
  const double patch = 1.0 / (1.0 / near + 1.0 / far);
  const double foreign = (tables.foreign.at(v) + patch) * radiation_field(v, 296.0);
  point.smooth.push_back({amounts.column_of(Smooth::water_self), 1e-20 * at_296});
  point.smooth.push_back({amounts.column_of(Smooth::water_cold), 1e-20 * (at_260 - at_296)});
  point.smooth.push_back({amounts.column_of(Smooth::water_foreign), 1e-20 * foreign});
}

void add_ozone(const BandTables& tables, const GasAmounts& amounts, double v, GridPoint& point) {
  constexpr double per_atm_cm = 0.269;  // 1e-20 cm^2 times molecules of 1 atm cm
  if (v > tables.ozone_c0.last()) {
    point.smooth.push_back({amounts.column_of(Smooth::ozone), tables.ozone_far.at(v)});
    return;
  }
  const double c0 = per_atm_cm * tables.ozone_c0.at(v);
  point.smooth.push_back({amounts.column_of(Smooth::ozone), tables.ozone_visible.at(v) + c0});
  if (c0 == 0.0) return;
  point.smooth.push_back({amounts.column_of(Smooth::ozone_warm), c0 * tables.ozone_c1.at(v)});
  point.smooth.push_back({amounts.column_of(Smooth::ozone_warm2), c0 * tables.ozone_c2.at(v)});
}

void add_smooth(const BandTables& tables, const GasAmounts& amounts, double v, GridPoint& point) {
  add_water(tables, amounts, v, point);
  add_ozone(tables, amounts, v, point);
  point.smooth.push_back({amounts.column_of(Smooth::nitrogen), tables.nitrogen.at(v)});
  const double oxygen = tables.oxygen.at(v);
  point.smooth.push_back({amounts.column_of(Smooth::oxygen), oxygen});
  point.smooth.push_back(
      {amounts.column_of(Smooth::oxygen_warm), oxygen * tables.oxygen_per_k.at(v)});
  point.smooth.push_back(
      {amounts.column_of(Smooth::oxygen_warm2), oxygen * tables.oxygen_per_k2.at(v)});
  for (const EvenRun& run : tables.nitric_acid) {
    point.smooth.push_back({amounts.column_of(Smooth::nitric_acid), run.at(v)});
  }
  const auto nothing = [&](const GridPoint::Part& part) {
    return part.coefficient == 0.0 || amounts.total(part.column) == 0.0;
  };
  point.smooth.erase(std::remove_if(point.smooth.begin(), point.smooth.end(), nothing),
                     point.smooth.end());
}

/// Weights of the grid's points, by index, for an interval of wavenumbers: the integral over
/// wavelength of the triangle about each.
std::map<int, double> weights_between(double lo, double hi) {
  std::map<int, double> weights;
  const auto add = [&](double v, double weight) {
    const int i =
        std::min(static_cast<int>(v / grid_step), static_cast<int>(grid_end / grid_step) - 1);
    const double share = std::clamp(v / grid_step - i, 0.0, 1.0);
    if (share < 1.0) weights[i] += weight * (1.0 - share);
    if (share > 0.0) weights[i + 1] += weight * share;
  };
  double sum = 0.0;
  for (int cell = static_cast<int>(lo / grid_step); cell * grid_step <= hi; ++cell) {
    const double a = std::max(lo, cell * grid_step), b = std::min(hi, (cell + 1) * grid_step);
    if (b <= a && lo < hi) continue;
    // Two points of Gauss: the triangles are linear, and dlambda = dv / v^2 hardly bends in a cell.
    for (const double node : {-0.577'350'269'189'626, 0.577'350'269'189'626}) {
      const double v = 0.5 * (a + b) + 0.5 * (b - a) * node;
      const double weight = lo < hi ? (b - a) / (v * v) : 1.0;
      add(v, weight);
      sum += weight;
    }
    if (lo == hi) break;
  }
  for (auto& [index, weight] : weights) weight /= sum;
  return weights;
}

void check_interval(double lo_um, double hi_um) {
  constexpr double shortest = 1e4 / grid_end, longest = 1e4;
  if (lo_um >= shortest && hi_um <= longest && lo_um <= hi_um) return;
  throw InputError("absorption by the air's gases is known from " + number_text(shortest) + " to " +
                   number_text(longest) + " um, asked for " + number_text(lo_um) + " to " +
                   number_text(hi_um) + " um");
}

}  // namespace

std::vector<GridPoint> grid_points(const BandTables& tables, const GasAmounts& amounts,
                                   double lo_um, double hi_um) {
  check_interval(lo_um, hi_um);
  const double lo = 1e4 / hi_um, hi = std::min(1e4 / lo_um, grid_end);
  std::vector<const BandRun*> runs;
  for (const BandRun& run : tables.bands) {
    const bool apart = run.log10_c.first > hi + grid_step || run.log10_c.last() < lo - grid_step;
    if (!apart && amounts.total(static_cast<std::size_t>(run.set)) > 0.0) runs.push_back(&run);
  }
  std::vector<GridPoint> points;
  for (const auto& [index, weight] : weights_between(lo, hi)) {
    GridPoint point{index * grid_step, weight, {}, {}};
    for (const BandRun* run : runs) {
      const EvenRun& c = run->log10_c;
      if (point.wavenumber < c.first || point.wavenumber > c.last()) continue;
      point.bands.push_back(
          {static_cast<std::size_t>(run->set), std::pow(10.0, c.at(point.wavenumber))});
    }
    add_smooth(tables, amounts, point.wavenumber, point);
    points.push_back(std::move(point));
  }
  return points;
}

double rayleigh_per_km(double wavenumber) noexcept {
  const double v2 = wavenumber * wavenumber;
  return v2 * v2 / (9.38076e18 - 1.08426e9 * v2);
}

}  // namespace nadir::atmosphere
