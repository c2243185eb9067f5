#include "materials/scattering/optical_constants.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::materials {

using spectral::Spectrum;

OpticalConstants::OpticalConstants(const spectral::Curve& n, const spectral::Curve& k,
                                   const spectral::Lanes& lanes)
    : n_{n.at(lanes)}, real_part_{lanes.count()}, imaginary_part_{lanes.count()} {
  for (int lane = 0; lane < lanes.count(); ++lane) {
    const double n_lane = n.at(lanes[lane]), k_lane = k.at(lanes[lane]);
    real_part_[lane] = static_cast<float>((n_lane - 1.0) * (n_lane + 1.0) - k_lane * k_lane);
    imaginary_part_[lane] = static_cast<float>(2.0 * n_lane * k_lane);
  }
}

Spectrum OpticalConstants::reflectance(double cosine) const noexcept {
  constexpr float tiny = 1e-30F;  // for a face between equal media seen along itself: 0 / tiny
  const double c_exact = std::min(std::abs(cosine), 1.0);
  const auto c = static_cast<float>(c_exact);
  const auto c_sq = static_cast<float>(c_exact * c_exact);
  const auto s_sq = static_cast<float>((1.0 - c_exact) * (1.0 + c_exact));
  Spectrum result{n_.count()};
  for (int lane = 0; lane < n_.count(); ++lane) {
    // sqrt(a + i b) = u + i v, the larger part by the sum that does not cancel; chosen by factors
    // of 0 and 1, since a comparison would keep compilers from vectorising
    const float a = real_part_[lane] + c_sq, b = imaginary_part_[lane];
    const float larger = std::sqrt(0.5F * (std::sqrt(a * a + b * b) + std::abs(a)));
    const float smaller = 0.5F * b / (larger + tiny);
    const float real_larger = std::copysign(0.5F, a) + 0.5F, imaginary_larger = 1.0F - real_larger;
    const float u = real_larger * larger + imaginary_larger * smaller;
    const float v = real_larger * smaller + imaginary_larger * larger, v_sq = v * v;
    const float s_away = (c - u) * (c - u) + v_sq, s_toward = (c + u) * (c + u) + v_sq;
    const float p_away = (u * c - s_sq) * (u * c - s_sq) + v_sq * c_sq;
    const float p_toward = (u * c + s_sq) * (u * c + s_sq) + v_sq * c_sq;
    const float r_s = s_away / (s_toward + tiny);
    // neither quotient rounds to more than 1, nor does their mean
    result[lane] = 0.5F * r_s * (1.0F + p_away / (p_toward + tiny));
  }
  return result;
}

}  // namespace nadir::materials
