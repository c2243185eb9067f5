#include "atmosphere/make/twilight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nadir::atmosphere {
namespace {

struct Piece {
  double from_deg;
  std::array<double, 4> l;
};

constexpr std::array<Piece, 6> pieces{{{20.0, {3.74, 3.97, -4.07, 1.47}},
                                       {5.0, {3.05, 13.28, -45.98, 64.33}},
                                       {-0.8, {2.88, 22.26, -207.64, 1034.30}},
                                       {-5.0, {2.88, 21.81, -258.11, -858.36}},
                                       {-12.0, {2.70, 12.17, -431.69, -1899.83}},
                                       {-18.0, {13.84, 262.72, 1447.42, 2797.93}}}};

}  // namespace

double ground_illuminance_lux(double elevation_deg) noexcept {
  const double h = std::clamp(elevation_deg, -18.0, 90.0);
  const auto* piece = pieces.data();
  while (h < piece->from_deg) ++piece;
  const double x = h / 90.0;
  const auto& l = piece->l;
  return std::pow(10.0, l[0] + x * (l[1] + x * (l[2] + x * l[3])));
}

double twilight_growth(double elevation_deg) noexcept {
  // At -2, -3, ... -6 degrees.
  constexpr std::array<double, 5> growth{1.0, 1.09, 1.35, 1.67, 2.07};
  const double place = std::clamp(-2.0 - elevation_deg, 0.0, 4.0);
  const auto i = std::min<std::size_t>(3, static_cast<std::size_t>(place));
  return growth[i] + (place - static_cast<double>(i)) * (growth[i + 1] - growth[i]);
}

}  // namespace nadir::atmosphere
