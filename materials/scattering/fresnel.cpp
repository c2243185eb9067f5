#include "materials/scattering/fresnel.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::materials {

using spectral::Spectrum;

double fresnel_reflectance(double cos_incidence, double n, double k) noexcept {
  const double c = std::min(std::abs(cos_incidence), 1.0);
  const double s2 = (1.0 - c) * (1.0 + c);
  // g^2 = a + i b; (n - 1)(n + 1) + c^2 keeps its digits where n is near 1 and c near 0
  const double a = (n - 1.0) * (n + 1.0) + c * c - k * k, b = 2.0 * n * k;
  const double modulus = std::sqrt(a * a + b * b);
  const double larger = std::sqrt(0.5 * (modulus + std::abs(a)));
  const double smaller = larger > 0.0 ? 0.5 * b / larger : 0.0;
  const double u = a >= 0.0 ? larger : smaller, v = a >= 0.0 ? smaller : larger;

  const double s_denominator = (c + u) * (c + u) + v * v;
  if (s_denominator <= 0.0) return 0.0;  // no face at all (m = 1) seen along itself
  const double r_s = ((c - u) * (c - u) + v * v) / s_denominator;
  const double p_away = u * c - s2, p_toward = u * c + s2, vc = v * c;
  const double r_p = r_s * (p_away * p_away + vc * vc) / (p_toward * p_toward + vc * vc);
  return std::min(0.5 * (r_s + r_p), 1.0);
}

double fresnel_dielectric(double cos_incidence, double eta) noexcept {
  const double c = std::min(std::abs(cos_incidence), 1.0);
  const double eta_cos_sq = (eta - 1.0) * (eta + 1.0) + c * c;  // (eta cos_t)^2
  if (eta_cos_sq <= 0.0) return eta == 1.0 ? 0.0 : 1.0;
  const double eta_cos = std::sqrt(eta_cos_sq);
  const double r_s = (c - eta_cos) / (c + eta_cos);
  const double r_p = (eta * eta * c - eta_cos) / (eta * eta * c + eta_cos);
  return 0.5 * (r_s * r_s + r_p * r_p);
}

Spectrum fresnel_reflectance(double cos_incidence, const Spectrum& n, const Spectrum& k) noexcept {
  Spectrum result{n.count()};
  for (int lane = 0; lane < n.count(); ++lane) {
    result[lane] = static_cast<float>(fresnel_reflectance(
        cos_incidence, static_cast<double>(n[lane]), static_cast<double>(k[lane])));
  }
  return result;
}

Spectrum fresnel_dielectric(double cos_incidence, const Spectrum& eta) noexcept {
  Spectrum result{eta.count()};
  for (int lane = 0; lane < eta.count(); ++lane) {
    result[lane] =
        static_cast<float>(fresnel_dielectric(cos_incidence, static_cast<double>(eta[lane])));
  }
  return result;
}

}  // namespace nadir::materials
