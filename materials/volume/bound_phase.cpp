#include "materials/volume/bound_phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::materials {
namespace {

using Model = std::variant<BoundHenyeyGreenstein, BoundRayleigh, BoundTabulatedPhase>;

Model bound(const HenyeyGreenstein& phase, const spectral::Lanes& lanes) {
  return BoundHenyeyGreenstein{phase, lanes};
}
Model bound(const RayleighPhase& /*phase*/, const spectral::Lanes& lanes) {
  return BoundRayleigh{lanes.count()};
}
Model bound(const TabulatedPhase& phase, const spectral::Lanes& lanes) {
  return BoundTabulatedPhase{phase, lanes};
}

double draw(const BoundHenyeyGreenstein& model, double choice, double u) {
  return model.sample(choice, u);
}
double draw(const BoundRayleigh& /*model*/, double /*choice*/, double u) {
  return BoundRayleigh::sample(u);
}
double draw(const BoundTabulatedPhase& model, double /*choice*/, double u) {
  return model.sample(u);
}

/// 1 - cosine of the scattering angle of unit vectors, [0, 2].
double one_minus_cosine(Vec3 wi, Vec3 wo) { return std::clamp(1.0 + dot(wi, wo), 0.0, 2.0); }

/// The unit vector at 1 - cos = x from a unit axis, `turn` of the way around it.
Vec3 around(Vec3 axis, double x, double turn) {
  // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 1 (2017).
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1.0 / (sign + axis.z), b = axis.x * axis.y * a;
  const Vec3 side{1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
  const Vec3 other{b, sign + axis.y * axis.y * a, -axis.y};
  const double sine = std::sqrt(x * (2.0 - x)), angle = 2.0 * std::numbers::pi * turn;
  return normalised((1.0 - x) * axis + sine * (std::cos(angle) * side + std::sin(angle) * other));
}

}  // namespace

BoundPhase::BoundPhase(const PhaseFunction& phase, const spectral::Lanes& lanes)
    : model_{std::visit([&](const auto& p) { return bound(p, lanes); }, phase)} {}

spectral::Spectrum BoundPhase::eval_at(double x) const noexcept {
  return std::visit([&](const auto& model) { return model.eval(x); }, model_);
}

spectral::Spectrum BoundPhase::eval(Vec3 wi, Vec3 wo) const noexcept {
  return eval_at(one_minus_cosine(wi, wo));
}

double BoundPhase::pdf(Vec3 wi, Vec3 wo) const noexcept {
  return static_cast<double>(eval(wi, wo).mean());
}

PhaseSample BoundPhase::sample(Vec3 wo, double choice, Vec2 u) const noexcept {
  const double x = std::visit([&](const auto& m) { return draw(m, choice, u.x); }, model_);
  PhaseSample sample{around(-wo, x, u.y), 0.0, eval_at(x)};
  sample.pdf = static_cast<double>(sample.weight.mean());
  // A table's zero can be met at the very edge of an interval: nothing is scattered there.
  sample.weight *= sample.pdf > 0.0 ? static_cast<float>(1.0 / sample.pdf) : 0.0F;
  return sample;
}

}  // namespace nadir::materials
