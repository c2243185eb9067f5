#pragma once

#include "materials/solver_settings.hpp"
#include "sim/plan/solver_choice.hpp"

// Closed forms behind BiasTerms (solver_choice.hpp); docs/solver-settings.md.

namespace nadir::sim {

/// rms error of the air's own light by the default solver (eight streams, terms to 5e-4), of what
/// comes out of it: docs/air-model.md, "Accuracy against time". The fast mode's is 2.8 %: who uses
/// it adds that to the table's error.
inline constexpr double air_solver_rms = 0.0026;
inline constexpr double fast_air_solver_rms = 0.028;

/// What lights a band's surfaces at the most.
struct LightBound {
  double irradiance = 0.0;  ///< of bodies and lamps, W m^-2 um^-1
  double radiance = 0.0;    ///< of sky and warmest surface, W m^-2 sr^-1 um^-1
};

/// Generations whose hits start full samples by a budget that bodies and lamps share: where
/// ceil(initial / decay^g) is no more than their rays, nothing goes on, whatever max_bounces says.
/// @param lights  bodies that have risen
[[nodiscard]] int effective_bounces(const materials::SolverSettings& settings, int lights,
                                    bool lamps) noexcept;

/// Greatest radiance that is missing where light is followed over fewer than n reflections:
///
///     rho^n (L + E / (pi (1 - rho)))
///
/// What is missing is R^n of the whole field, R the scattering operator, whose norm is at most rho.
/// The field that sky and warm surfaces make is nowhere brighter than the brightest of them (a
/// passive scene), so that furnaces of radiance L meet the bound: rho^n L. What bodies and lamps
/// make is at most rho E / (pi (1 - rho)), their light reflected once, twice, ... (Neumann series);
/// of that R^(n-1) is missing. Lambertian surfaces.
/// @param rho  greatest reflectance, reflected and transmitted together; 1 or more: infinity
[[nodiscard]] double light_beyond(int n, double rho, const LightBound& light) noexcept;

/// Share of a closed furnace's radiance that the generic solver's threshold for full samples
/// (w = 1e-5) loses, where bounces go on for `bounces` generations:
///
///     sum_k rho^(k+1) (P_k - P_(k-1)),  P_k = P(r^k mu_1 .. mu_k < w) = Q(k, 2 ln(r^k / w))
///
/// The weight of a sample is the product of r and cosines mu; light that comes from all around
/// alike has squares of cosines that are uniform, so that -ln(mu^2) adds up to a gamma variate and
/// Q is the regularised incomplete gamma function, e^-x sum_(j<k) x^j / j! (DLMF 8.4.10). Where the
/// weight first falls below w at bounce k, rho^(k+1) of the light is missing.
/// @param rho  reflectance, reflected and transmitted together, 0 .. 1
/// @param r    what a weight knows of it: rho, or half of it in leaves, > 0 where rho is
/// Accuracy: the furnace's measured losses to 0.4 % of the radiance at 0.8, 1.1 % at 0.9.
[[nodiscard]] double threshold_loss(double rho, double r, int bounces) noexcept;

}  // namespace nadir::sim
