#include "materials/bound_material.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::materials {
namespace {

using spectral::Curve;
using spectral::Lanes;
using spectral::Spectrum;

// Sums that are off by less are rounding: tables carry five or six digits.
constexpr double rounding = 1e-6;

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

std::string subject(const Material& material) { return "material \"" + material.name + "\": "; }

InputIssue issue(const Material& material, const std::string& message) {
  return {material.where, subject(material) + message, {}, {}};
}

std::string range(Micrometres lo, Micrometres hi) {
  return number_text(lo.value) + " to " + number_text(hi.value) + " um";
}

std::string tabulated(const char* name, const Curve& curve, const Lanes& lanes) {
  return std::string{name} + " is tabulated from " + range(curve.first(), curve.last()) +
         ", the simulated wavelengths are " + range(lanes[0], lanes[lanes.count() - 1]);
}

void check_values(const Material& material, const char* name, const std::optional<Curve>& curve,
                  std::vector<InputIssue>& issues) {
  if (!curve) return;
  const double low = curve->min_value(), high = curve->max_value();
  if (low >= 0.0 && high <= 1.0) return;
  const std::string found = curve->is_constant()
                                ? number_text(low)
                                : "from " + number_text(low) + " to " + number_text(high);
  issues.push_back(
      issue(material, std::string{name} + " is " + found + "; it must be from 0 to 1"));
}

/// Which curves must be there and which must not.
void check_presence(const Material& material, std::vector<InputIssue>& issues) {
  const CurvesTaken taken = curves_taken(material.scattering);
  const bool given = material.reflectance || material.emissivity;
  if (taken.reflectance && !given) {
    issues.push_back(issue(material, "neither reflectance nor emissivity is given"));
  }
  if (!taken.reflectance && given) {
    const std::string name = material.reflectance ? "reflectance" : "emissivity";
    issues.push_back(issue(material, name + " is given, but the scattering model brings its own; "
                                            "leave out one of the two"));
  }
  if (!taken.transmittance && material.transmittance) {
    issues.push_back(issue(material, taken.reflectance
                                         ? "transmittance is given, but the scattering model lets "
                                           "nothing through"
                                         : "transmittance is given, but the scattering model "
                                           "brings its own; leave out one of the two"));
  }
}

bool covers(const std::optional<Curve>& curve, Micrometres wavelength) {
  return curve && curve->covers(wavelength, wavelength);
}

/// The material's own curves at the lanes, Kirchhoff's law applied.
class Curves {
  const Material& material_;
  const Lanes& lanes_;

 public:
  Curves(const Material& material, const Lanes& lanes) : material_{material}, lanes_{lanes} {
    for (int lane = 0; lane < lanes.count(); ++lane) take(lane);
  }

  Spectrum reflectance{lanes_.count()}, transmittance{lanes_.count()};
  Spectrum emissivity{lanes_.count()};
  Spectrum derived{lanes_.count()};  ///< 1 where emissivity is 1 - reflectance - transmittance

  [[nodiscard]] std::vector<InputIssue>& issues() { return issues_; }
  void report(Diagnostics& diagnostics) const {
    const auto report_curve = [&](const char* name, const std::optional<Curve>& curve) {
      diagnostics.warn(subject(material_) + tabulated(name, *curve, lanes_) +
                       "; it is extrapolated");
    };
    if (extrapolated_) report_curve(leading_name(), leading());
    if (transmittance_extrapolated_) report_curve("transmittance", material_.transmittance);
    if (excess_at_.value <= 0.0) return;
    diagnostics.warn(subject(material_) +
                     (material_.transmittance ? "reflectance + transmittance + emissivity is "
                                              : "reflectance + emissivity is ") +
                     number_text(excess_) + " at " + number_text(excess_at_.value) +
                     " um; more than 1 creates energy");
  }

 private:
  [[nodiscard]] const std::optional<Curve>& leading() const {
    return material_.reflectance ? material_.reflectance : material_.emissivity;
  }
  [[nodiscard]] const char* leading_name() const {
    return material_.reflectance ? "reflectance" : "emissivity";
  }

  void take(int lane) {
    const Micrometres at = lanes_[lane];
    const bool has_rho = covers(material_.reflectance, at);
    const bool has_eps = covers(material_.emissivity, at);
    const bool from_rho = has_rho || (!has_eps && material_.reflectance);
    extrapolated_ = extrapolated_ || (!has_rho && !has_eps);
    const double given = (from_rho ? material_.reflectance : material_.emissivity)->at(at);
    const double tau = transmittance_at(at);
    if (std::isnan(given)) return missing(leading_name(), leading());
    if (std::isnan(tau)) return missing("transmittance", material_.transmittance);
    const double rest = 1.0 - given - tau;
    if (rest < -rounding) return too_much(from_rho ? "reflectance" : "emissivity", given + tau, at);

    double rho = from_rho ? given : rest, eps = from_rho ? rest : given;
    const bool both = has_rho && has_eps;
    if (both) eps = material_.emissivity->at(at);
    // What is absorbed is what the float lanes lack of 1: beside a reflectance of 0.999999 the
    // rounding of that would be a per cent of the emissivity.
    if (!both && from_rho) eps = 1.0 - rounded(rho) - rounded(tau);
    note_excess(rho + tau + eps, at);
    reflectance[lane] = static_cast<float>(std::max(rho, 0.0));
    transmittance[lane] = static_cast<float>(tau);
    emissivity[lane] = static_cast<float>(std::max(eps, 0.0));
    derived[lane] = both ? 0.0F : 1.0F;
  }

  double transmittance_at(Micrometres at) {
    if (!material_.transmittance) return 0.0;
    if (!covers(material_.transmittance, at)) transmittance_extrapolated_ = true;
    return material_.transmittance->at(at);
  }

  void missing(const char* name, const std::optional<Curve>& curve) {
    add(tabulated(name, *curve, lanes_));
  }
  void too_much(const char* name, double sum, Micrometres at) {
    if (refused_) return;  // one wavelength tells enough
    refused_ = true;
    add(std::string{name} + " + transmittance is " + number_text(sum) + " at " +
        number_text(at.value) + " um; it must be at most 1");
  }
  void add(const std::string& message) {
    InputIssue found = issue(material_, message);
    for (const InputIssue& known : issues_) {
      if (known.message == found.message) return;  // of another lane
    }
    issues_.push_back(std::move(found));
  }
  void note_excess(double sum, Micrometres at) {
    if (sum <= excess_) return;
    excess_ = sum;
    excess_at_ = at;
  }

  std::vector<InputIssue> issues_;
  bool extrapolated_ = false, transmittance_extrapolated_ = false, refused_ = false;
  double excess_ = 1.0 + rounding;
  Micrometres excess_at_;
};

/// What the model itself refuses, under the material's name and place.
InputError at_material(const Material& material, const InputError& error) {
  std::vector<InputIssue> issues = error.issues();
  for (InputIssue& one : issues) {
    const bool placed = one.where.line > 0 || !one.where.file.empty();
    if (!placed) one = issue(material, one.message);
  }
  return InputError{std::move(issues)};
}

/// Binds the scattering model; what it says and refuses gets the material's name.
BoundScattering bind_model(const Material& material, const Lanes& lanes, const Spectrum& rho,
                           const Spectrum& tau, Diagnostics& diagnostics) {
  Diagnostics heard;
  try {
    BoundScattering model = bind(material.scattering, {lanes, rho, tau, &heard});
    for (const std::string& message : heard.messages()) {
      diagnostics.warn(subject(material) + message);
    }
    return model;
  } catch (const InputError& error) {
    throw at_material(material, error);
  }
}

/// Scaled models whose albedo is the same for every direction.
bool looks_alike(const Scattering& model) {
  return curves_taken(model).reflectance &&
         (std::holds_alternative<Lambertian>(model) || std::holds_alternative<Leaf>(model) ||
          std::holds_alternative<Mirror>(model) || std::holds_alternative<ClearSheet>(model));
}

/// 1 - rho - tau of a direction. Rounding and tables of albedo may leave a little less than 0.
float absorbed(const Albedo& albedo, int lane) {
  return std::max(0.0F, 1.0F - albedo.reflectance[lane] - albedo.transmittance[lane]);
}

/// For lanes without a stated emissivity of a model whose albedo depends on direction.
void let_follow(BoundMaterial& bound, const Spectrum& derived) {
  bound.follows_direction = derived;
  bound.constant_emissivity = !(derived.max() > 0.0F);
  if (bound.constant_emissivity) return;
  const Albedo normal = albedo(bound.scattering, {0.0, 0.0, 1.0});
  for (int lane = 0; lane < derived.count(); ++lane) {
    if (derived[lane] > 0.0F) bound.own_emissivity[lane] = absorbed(normal, lane);
  }
}

}  // namespace

Spectrum BoundMaterial::emissivity(Vec3 wo) const noexcept {
  if (constant_emissivity) return own_emissivity;
  const Albedo there = albedo(scattering, wo);
  Spectrum result = own_emissivity;
  for (int lane = 0; lane < result.count(); ++lane) {
    if (follows_direction[lane] > 0.0F) result[lane] = absorbed(there, lane);
  }
  return result;
}

BoundMaterial bind(const Material& material, const Lanes& lanes, Diagnostics& diagnostics) {
  std::vector<InputIssue> issues;
  check_presence(material, issues);
  check_values(material, "reflectance", material.reflectance, issues);
  check_values(material, "transmittance", material.transmittance, issues);
  check_values(material, "emissivity", material.emissivity, issues);
  if (!issues.empty()) throw InputError{std::move(issues)};

  const Spectrum none{lanes.count()};
  if (!curves_taken(material.scattering).reflectance) {
    BoundScattering model = bind_model(material, lanes, none, none, diagnostics);
    BoundMaterial bound{std::move(model), {}, none, none, false};
    bound.traits = traits(bound.scattering);
    let_follow(bound, Spectrum{lanes.count(), 1.0F});
    return bound;
  }

  Curves curves{material, lanes};
  if (!curves.issues().empty()) throw InputError{std::move(curves.issues())};
  curves.report(diagnostics);
  BoundScattering model =
      bind_model(material, lanes, curves.reflectance, curves.transmittance, diagnostics);
  BoundMaterial bound{std::move(model), {}, curves.emissivity, none, true};
  bound.traits = traits(bound.scattering);
  if (!looks_alike(material.scattering)) let_follow(bound, curves.derived);
  return bound;
}

}  // namespace nadir::materials
