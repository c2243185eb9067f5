#include "ephemeris/curve_product.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace nadir::ephemeris {

using spectral::Curve;
using spectral::Outside;

Outside outside_of(const Curve& curve) {
  if (curve.is_constant()) return Outside::hold;
  const double below = curve.at(curve.first() * 0.5), above = curve.at(curve.last() * 2.0);
  if (std::isnan(below)) return Outside::reject;
  const bool held = below == curve.values().front() && above == curve.values().back();
  return held ? Outside::hold : Outside::zero;
}

Curve product(const Curve& curve, const std::vector<double>& at_um,
              const std::function<double(Micrometres)>& factor) {
  const std::vector<double>& own = curve.wavelengths_um();
  std::vector<double> grid;
  std::set_union(own.begin(), own.end(), at_um.begin(), at_um.end(), std::back_inserter(grid));
  std::erase_if(grid, [&](double um) {
    return Micrometres{um} < curve.first() || Micrometres{um} > curve.last();
  });
  std::vector<double> values;
  values.reserve(grid.size());
  for (const double um : grid) {
    values.push_back(curve.at(Micrometres{um}) * factor(Micrometres{um}));
  }
  return {std::move(grid), std::move(values), outside_of(curve)};
}

}  // namespace nadir::ephemeris
