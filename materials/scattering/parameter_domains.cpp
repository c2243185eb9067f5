#include "materials/scattering/parameter_domains.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "materials/material.hpp"

namespace nadir::materials {
namespace {

using spectral::Curve;
using spectral::Lanes;

struct Range {
  double lo, hi;
  bool open_lo = false, open_hi = false;

  [[nodiscard]] bool holds(double x) const {  // false for NaN
    return (open_lo ? x > lo : x >= lo) && (open_hi ? x < hi : x <= hi);
  }
  [[nodiscard]] std::string text() const {
    return (open_lo ? "(" : "[") + number_text(lo) + ", " + number_text(hi) + (open_hi ? ")" : "]");
  }
};

constexpr Range unit{0.0, 1.0};
// Measured indices lie between 0.02 (silver) and about 60 (metals at 14 um).
constexpr Range index_n{0.01, 100.0};
constexpr Range index_k{0.0, 100.0};
constexpr Range roughness{1e-4, 1.0};
// A whole turn either way; more is most likely degrees.
constexpr Range turn{-2.0 * std::numbers::pi, 2.0 * std::numbers::pi};

/// Collects the mistakes of one model.
class Checker {
 public:
  Checker(std::string model, const BindContext& context)
      : model_{std::move(model)}, context_{context} {}

  void number(const char* name, double value, const Range& range) {
    if (range.holds(value)) return;
    issue(std::string{name} + " is " + number_text(value) + "; it must be in " + range.text());
  }

  void curve(const char* name, const Curve& curve, const Range& range) {
    const Lanes& lanes = context_.lanes;
    const Micrometres first = lanes[0], last = lanes[lanes.count() - 1];
    bool missing = false;
    for (const Micrometres lane : lanes) {
      const double value = curve.at(lane);
      missing = missing || std::isnan(value);
      if (std::isnan(value) || range.holds(value)) continue;
      issue(std::string{name} + " is " + number_text(value) + " at " + number_text(lane.value) +
            " um; it must be in " + range.text());
      return;
    }
    if (curve.covers(first, last)) return;
    const std::string message =
        std::string{name} + " is tabulated from " + number_text(curve.first().value) + " to " +
        number_text(curve.last().value) + " um, the simulated wavelengths are " +
        number_text(first.value) + " to " + number_text(last.value) + " um";
    if (missing) {
      issue(message);
    } else if (context_.diagnostics != nullptr) {
      context_.diagnostics->warn(model_ + ": " + message + "; it is extrapolated");
    }
  }
  void curve(const char* name, const std::optional<Curve>& c, const Range& range) {
    if (c) curve(name, *c, range);
  }

  void issue(std::string message) {
    issues_.push_back({{}, model_ + ": " + std::move(message), {}, {}});
  }
  void done() {
    if (!issues_.empty()) throw InputError{std::move(issues_)};
  }

 private:
  std::string model_;
  const BindContext& context_;
  std::vector<InputIssue> issues_;
};

void check(const Lambertian& /*m*/, const BindContext& /*context*/) {}
void check(const Leaf& /*m*/, const BindContext& /*context*/) {}

void check(const OrenNayar& m, const BindContext& context) {
  Checker c{"oren_nayar", context};
  c.number("slope_sigma_rad", m.slope_sigma_rad, {0.0, 0.5 * std::numbers::pi, false, true});
  c.done();
}

void check(const Minnaert& m, const BindContext& context) {
  Checker c{"minnaert", context};
  c.number("k", m.k, {0.0, 3.0});
  c.done();
}

void check(const Mirror& m, const BindContext& context) {
  Checker c{"mirror", context};
  if (m.k && !m.n) c.issue("k is given without n");
  c.curve("n", m.n, index_n);
  c.curve("k", m.k, index_k);
  c.done();
}

void check(const ClearSheet& m, const BindContext& context) {
  Checker c{"clear_sheet", context};
  if (m.absorption && !m.n) {
    c.issue(
        "absorption is given without n; without n the material's reflectance and "
        "transmittance say all");
  }
  c.curve("n", m.n, index_n);
  c.curve("absorption", m.absorption, {0.0, 1e6});
  c.done();
}

void check(const Ward& m, const BindContext& context) {
  Checker c{"ward", context};
  c.curve("specular", m.specular, unit);
  c.number("alpha_x", m.alpha_x, roughness);
  c.number("alpha_y", m.alpha_y, roughness);
  c.number("azimuth_rad", m.azimuth_rad, turn);
  c.done();
}

void check(const Microfacet& m, const BindContext& context) {
  Checker c{"microfacet", context};
  c.number("alpha_x", m.alpha_x, roughness);
  c.number("alpha_y", m.alpha_y, roughness);
  c.number("azimuth_rad", m.azimuth_rad, turn);
  c.curve("n", m.n, index_n);
  c.curve("k", m.k, m.transmits ? Range{0.0, 0.0} : index_k);
  c.done();
}

void check(const PriestGermer& m, const BindContext& context) {
  Checker c{"priest_germer", context};
  c.curve("n", m.n, index_n);
  c.curve("k", m.k, index_k);
  c.number("slope_sigma", m.slope_sigma, roughness);
  c.done();
}

void check(const CoxMunk& m, const BindContext& context) {
  Checker c{"cox_munk", context};
  c.number("wind_speed_m_s", m.wind_speed_m_s, {0.0, 20.0});
  c.number("wind_azimuth_rad", m.wind_azimuth_rad, turn);
  c.curve("n", m.n, index_n);
  c.curve("k", m.k, index_k);
  c.curve("water_body", m.water_body, unit);
  c.done();
}

void check(const RossLi& m, const BindContext& context) {
  Checker c{"ross_li", context};
  // Fitted weights; the model itself refuses those that gain energy.
  c.curve("isotropic", m.isotropic, {0.0, 10.0});
  c.curve("volumetric", m.volumetric, {0.0, 10.0});
  c.curve("geometric", m.geometric, {0.0, 10.0});
  c.done();
}

void check(const RahmanPintyVerstraete& m, const BindContext& context) {
  Checker c{"rahman_pinty_verstraete", context};
  c.curve("rho0", m.rho0, {0.0, 10.0});
  c.curve("k", m.k, {0.0, 2.0});
  c.curve("asymmetry", m.asymmetry, {-1.0, 1.0, true, true});
  c.curve("rho_c", m.rho_c, unit);
  c.done();
}

void check(const Hapke& m, const BindContext& context) {
  Checker c{"hapke", context};
  c.curve("single_scattering_albedo", m.single_scattering_albedo, unit);
  c.number("asymmetry_b", m.asymmetry_b, {0.0, 1.0, false, true});
  c.number("asymmetry_c", m.asymmetry_c, {-1.0, 1.0});
  c.number("opposition_b0", m.opposition_b0, unit);
  c.number("opposition_h", m.opposition_h, {0.0, 1e3, true});
  c.number("mean_slope_rad", m.mean_slope_rad, {0.0, std::numbers::pi / 3.0});
  c.done();
}

void check(const Measured& m, const BindContext& context) {
  Checker c{"measured", context};
  if (m.table == nullptr) c.issue("no table is given");
  c.done();
}

void check(const Mixture& m, const BindContext& context) {
  Checker c{"mixture", context};
  if (m.parts.empty()) c.issue("it has no parts");
  for (const Mixture::Part& part : m.parts) {
    if (part.material == nullptr) {
      c.issue("a part has no material");
    } else if (!(std::isfinite(part.weight) && part.weight >= 0.0)) {
      c.issue("the weight of \"" + part.material->name + "\" is " + number_text(part.weight) +
              "; it must not be negative");
    }
  }
  c.done();
}

}  // namespace

void check_parameters(const Scattering& model, const BindContext& context) {
  std::visit([&](const auto& m) { check(m, context); }, model);
}

}  // namespace nadir::materials
