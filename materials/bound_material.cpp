#include "materials/bound_material.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::materials {
namespace {

using spectral::Curve;
using spectral::Lanes;

std::string subject(const Material& material) { return "material \"" + material.name + "\": "; }

std::string range(Micrometres lo, Micrometres hi) {
  return number_text(lo.value) + " to " + number_text(hi.value) + " um";
}

std::string tabulated(const char* name, const Curve& curve, const Lanes& lanes) {
  return std::string{name} + " is tabulated from " + range(curve.first(), curve.last()) +
         ", the simulated wavelengths are " + range(lanes[0], lanes[lanes.count() - 1]);
}

void check_values(const Material& material, const char* name, const Curve& curve,
                  std::vector<InputIssue>& issues) {
  const double low = curve.min_value(), high = curve.max_value();
  if (low >= 0.0 && high <= 1.0) return;
  const std::string found = curve.is_constant()
                                ? number_text(low)
                                : "from " + number_text(low) + " to " + number_text(high);
  issues.push_back(
      {{}, subject(material) + name + " is " + found + "; it must be from 0 to 1", {}, {}});
}

std::vector<InputIssue> check(const Material& material) {
  std::vector<InputIssue> issues;
  if (!material.reflectance && !material.emissivity) {
    issues.push_back(
        {{}, subject(material) + "neither reflectance nor emissivity is given", {}, {}});
  }
  if (material.reflectance) check_values(material, "reflectance", *material.reflectance, issues);
  if (material.emissivity) check_values(material, "emissivity", *material.emissivity, issues);
  return issues;
}

bool covers(const std::optional<Curve>& curve, Micrometres wavelength) {
  return curve && curve->covers(wavelength, wavelength);
}

/// Values of both at one wavelength, and whether they had to be extrapolated.
struct Values {
  double reflectance;
  double emissivity;
  bool extrapolated;
};

Values values_at(const Material& material, Micrometres wavelength) {
  const bool has_rho = covers(material.reflectance, wavelength);
  const bool has_eps = covers(material.emissivity, wavelength);
  if (has_rho && has_eps) {
    return {material.reflectance->at(wavelength), material.emissivity->at(wavelength), false};
  }
  const bool from_rho = has_rho || (!has_eps && material.reflectance);
  const double given =
      from_rho ? material.reflectance->at(wavelength) : material.emissivity->at(wavelength);
  const bool extrapolated = !has_rho && !has_eps;
  return from_rho ? Values{given, 1.0 - given, extrapolated}
                  : Values{1.0 - given, given, extrapolated};
}

/// Where the material gains energy most.
struct Excess {
  double sum = 1.0 + 1e-6;  // less is rounding: tables carry five or six digits
  Micrometres wavelength;
};

void report_excess(const Material& material, const Excess& excess, Diagnostics& diagnostics) {
  if (excess.wavelength.value <= 0.0) return;
  diagnostics.warn(subject(material) + "reflectance + emissivity is " + number_text(excess.sum) +
                   " at " + number_text(excess.wavelength.value) +
                   " um; more than 1 creates energy");
}

}  // namespace

BoundMaterial bind(const Material& material, const Lanes& lanes, Diagnostics& diagnostics) {
  std::vector<InputIssue> issues = check(material);
  if (!issues.empty()) throw InputError{std::move(issues)};

  BoundMaterial bound{spectral::Spectrum{lanes.count()}, spectral::Spectrum{lanes.count()}, 0.0F,
                      material.scattering};
  bool extrapolated = false;
  Excess excess;
  const char* const leading = material.reflectance ? "reflectance" : "emissivity";
  const Curve& curve = material.reflectance ? *material.reflectance : *material.emissivity;
  for (int lane = 0; lane < lanes.count(); ++lane) {
    const Values values = values_at(material, lanes[lane]);
    if (std::isnan(values.reflectance)) {
      throw InputError{subject(material) + tabulated(leading, curve, lanes)};
    }
    extrapolated = extrapolated || values.extrapolated;
    const double sum = values.reflectance + values.emissivity;
    if (sum > excess.sum) excess = {sum, lanes[lane]};
    bound.reflectance[lane] = static_cast<float>(values.reflectance);
    bound.emissivity[lane] = static_cast<float>(values.emissivity);
  }
  if (extrapolated) {
    diagnostics.warn(subject(material) + tabulated(leading, curve, lanes) + "; it is extrapolated");
  }
  report_excess(material, excess, diagnostics);
  bound.max_reflectance = bound.reflectance.max();
  return bound;
}

}  // namespace nadir::materials
