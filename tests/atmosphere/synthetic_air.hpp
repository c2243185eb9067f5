#pragma once
// Air tables whose every entry comes from a formula, so that what rays look up is known.

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/bound_air_table.hpp"

namespace nadir::atmosphere {

/// A place in a view's table. `way` is the whole way.
struct Place {
  double height_m = 0.0, zenith_rad = 0.0, share = 1.0, azimuth_rad = 0.0;
  bool below = false;
  std::size_t lane = 0, kind = 0;
};

using Formula = std::function<double(const Place&)>;
[[nodiscard]] inline Formula constant(double value) {
  return [value](const Place&) { return value; };
}

/// What the table holds, in views and in the sky alike.
struct SyntheticAir {
  double ground_m = 0.0, top_m = 100e3;
  std::vector<double> wavelengths_um{0.55};
  std::vector<double> view_heights_m{1500.0};
  Formula extinction = constant(0.0), first = constant(0.0), smooth = constant(0.0),
          even = constant(0.0), ground = constant(0.0);
  int kinds = 0;
  std::function<double(std::size_t kind, double cosine)> phase;
  int phase_steps = 64;
  double body_zenith_rad = 0.7, body_azimuth_rad = 2.0;
  int zenith_nodes = 12;      ///< on either side of the horizon
  double zenith_power = 2.0;  ///< how much closer towards it
  std::vector<double> azimuth_rad{0.0, 0.5 * std::numbers::pi, std::numbers::pi};
  std::vector<double> share{0.1, 0.25, 0.5, 0.75, 1.0};

  /// Nodes of the zenith axis as shares of the way to the horizon: closer towards it.
  [[nodiscard]] double node(int i) const {
    const double x = 1.0 - i / (zenith_nodes - 1.0);
    return 1.0 - std::pow(x, zenith_power);
  }

  [[nodiscard]] AirTable table() const {
    AirTable t;
    const std::size_t n = wavelengths_um.size();
    for (const double um : wavelengths_um) t.lanes.push_back({um, {}, 1.0});
    t.top_m = top_m;
    t.ground_m = ground_m;
    t.bodies.push_back({"sun", body_zenith_rad, body_azimuth_rad, std::vector<float>(n, 1.0F),
                        std::vector<float>(n, 0.8F), std::vector<float>(n, 0.75F)});
    t.kinds = kinds;
    fill_phase(t);
    t.sky = view(ground_m, false, {1.0});
    for (const double h : view_heights_m) t.views.push_back(view(h, true, share));
    t.spherical_albedo.assign(n, 0.1F);
    t.even_ground_irradiance.assign(n, 0.25F);
    t.made_by = "a formula";
    return t;
  }

 private:
  void fill_phase(AirTable& t) const {
    if (kinds == 0) return;
    for (int i = 0; i <= phase_steps; ++i) {
      t.phase_grid.push_back(static_cast<double>(i) / phase_steps);
    }
    for (int k = 0; k < kinds; ++k) {
      for (const double u : t.phase_grid) {
        const double cosine = 1.0 - 2.0 * u * u * u * u;  // u^2 = sin(Theta / 2)
        t.phase.insert(t.phase.end(), wavelengths_um.size(),
                       static_cast<float>(phase(static_cast<std::size_t>(k), cosine)));
      }
    }
  }

  [[nodiscard]] AirTable::View view(double height_m, bool below, std::vector<double> shares) const {
    AirTable::View v;
    v.height_m = height_m;
    const double horizon = std::acos(horizon_mu(ground_m, height_m));
    for (int i = 0; i < zenith_nodes; ++i) v.zenith_rad.push_back(horizon * node(i));
    for (int i = 0; below && i < zenith_nodes; ++i) {
      v.zenith_rad.push_back(horizon +
                             (std::numbers::pi - horizon) * (1.0 - node(zenith_nodes - 1 - i)));
    }
    v.azimuth_rad = azimuth_rad;
    v.share = std::move(shares);
    fill(v, v.extinction, extinction, 0, 0.0);
    fill(v, v.even, even, 0, 0.0);
    fill(v, v.ground, ground, 0, 0.0);
    for (int k = 0; k < kinds; ++k) fill(v, v.first, first, k, 0.0);
    for (const double a : azimuth_rad) fill(v, v.smooth, smooth, 0, a);
    return v;
  }

  void fill(const AirTable::View& v, std::vector<float>& out, const Formula& formula, int kind,
            double azimuth) const {
    const auto nodes = static_cast<std::size_t>(zenith_nodes);
    for (std::size_t z = 0; z < v.zenith_rad.size(); ++z) {
      for (const double u : v.share) {
        for (std::size_t lane = 0; lane < wavelengths_um.size(); ++lane) {
          out.push_back(
              static_cast<float>(formula({v.height_m, v.zenith_rad[z], u, azimuth, z >= nodes, lane,
                                          static_cast<std::size_t>(kind)})));
        }
      }
    }
  }
};

/// Bound at the table's own lanes over a ground alike at all of them.
[[nodiscard]] inline BoundAirTable bound(const AirTable& table, float reflectance = 0.0F,
                                         float emission = 0.0F) {
  std::vector<Micrometres> wavelengths;
  std::vector<spectral::AbsorptionLane> absorption;
  for (const AirTable::Lane& lane : table.lanes) {
    wavelengths.emplace_back(lane.wavelength_um);
    absorption.push_back(lane.absorption);
  }
  const std::size_t n = wavelengths.size();
  return {std::make_shared<const AirTable>(table),
          {std::vector<float>(n, reflectance), std::vector<float>(n, emission)},
          spectral::Lanes{wavelengths, absorption}};
}

/// A unit vector in scene axes.
[[nodiscard]] inline Vec3 towards(double zenith_rad, double azimuth_rad) {
  const double s = std::sin(zenith_rad);
  return {s * std::sin(azimuth_rad), s * std::cos(azimuth_rad), std::cos(zenith_rad)};
}

}  // namespace nadir::atmosphere
