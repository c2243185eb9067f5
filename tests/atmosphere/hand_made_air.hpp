#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "atmosphere/make/table_job.hpp"

namespace nadir::atmosphere::test {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Air made by hand: molecules that scatter, haze in the lowest 2 km, an even absorber.
struct HandMadeAir {
  double rayleigh = 0.1, haze = 0.0, haze_g = 0.7, haze_albedo = 1.0;
  double absorption = 0.0;     ///< of gas that falls off like the air
  double temperature_k = 0.0;  ///< everywhere

  [[nodiscard]] static std::vector<double> levels_m() {
    return {100e3, 90e3, 82e3, 75e3,  68e3, 62e3, 57e3, 52e3, 47e3, 42e3,  37e3,
            33e3,  29e3, 25e3, 22e3,  19e3, 16e3, 13e3, 10e3, 8e3,  6.5e3, 5e3,
            4e3,   3e3,  2e3,  1.5e3, 1e3,  500., 250., 100., 0.0};
  }

  [[nodiscard]] OpticalColumn column() const {
    OpticalColumn made;
    made.level_height_m = levels_m();
    made.level_temperature_k.assign(made.level_height_m.size(), temperature_k);
    std::vector<double> molecules, particles;
    for (std::size_t k = 0; k + 1 < made.level_height_m.size(); ++k) {
      const double top = made.level_height_m[k], bottom = made.level_height_m[k + 1];
      const double share = std::exp(-bottom / 8e3) - std::exp(-top / 8e3);
      const double in_haze = bottom < 2e3 ? (top - bottom) / 2e3 : 0.0;
      molecules.push_back(rayleigh * share);
      particles.push_back(haze * haze_albedo * in_haze);
      made.absorption.push_back(absorption * share + haze * (1.0 - haze_albedo) * in_haze);
    }
    made.kinds.push_back(
        {molecules, std::make_shared<const PhaseFunction>(PhaseFunction::rayleigh(0.0))});
    if (haze > 0.0) {
      made.kinds.push_back({particles, std::make_shared<const PhaseFunction>(
                                           PhaseFunction::henyey_greenstein(haze_g))});
    }
    return made;
  }
};

/// A job of one lane with this air.
inline TableJob job_of(const HandMadeAir& air, double wavelength_um) {
  TableJob job;
  job.level_m = HandMadeAir::levels_m();
  job.lanes = {{wavelength_um, {}, 1.0}};
  job.column = [air](std::size_t) { return air.column(); };
  job.airglow = job.starlight = job.urban_glow = {0.0};
  job.settings.observer_height_m = 100e3;
  return job;
}

inline TableJob::Body body_at(double elevation_deg, double azimuth_deg = 180.0,
                              double irradiance = 1.0) {
  const double h = elevation_deg * degree, a = azimuth_deg * degree;
  return {"sun",
          {std::cos(h) * std::sin(a), std::cos(h) * std::cos(a), std::sin(h)},
          Angle{0.00465},
          {irradiance}};
}

/// Looking up in a view of one lane.
struct Place {
  std::size_t zenith = 0, share = 0;
};
inline double value(const std::vector<float>& rows, const AirTable::View& view, Place at,
                    std::size_t block = 0) {
  return static_cast<double>(
      rows[block * view.places() + at.zenith * view.share.size() + at.share]);
}

}  // namespace nadir::atmosphere::test
