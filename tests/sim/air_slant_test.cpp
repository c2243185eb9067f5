// Transmittance of slant and level paths through gases, molecules and haze against LOWTRAN7.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/make/levels.hpp"
#include "atmosphere/particles/haze_profile.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/reference.hpp"
#include "sim/lowtran_air.hpp"
#include "support/catch.hpp"

namespace nadir::sim::test {
namespace {

using namespace atmosphere;
using std::numbers::pi;

constexpr double endless = std::numeric_limits<double>::infinity();

struct Path {
  const char* name;  ///< of the reference
  const char* profile;
  AerosolType haze;
  double visibility_km, height_m, zenith_deg, length_m;
};

/// LOWTRAN7 takes the haze's humidity from the profile, its mean over the haze that a path meets.
double haze_humidity(const Layered& air, const Path& path) {
  if (path.zenith_deg == 90.0) return relative_humidity(level_at(air.profile, path.height_m));
  const HazeProfile haze{*air.particles, air.aerosol, path.visibility_km, 0.0};
  double depth = 0.0, sum = 0.0;
  for (double z = 0.0; z < 2000.0; z += 50.0) {
    const double here = haze.depth_below(0, z) - haze.depth_below(0, z + 50.0);
    depth += here;
    sum += here * relative_humidity(level_at(air.profile, z + 25.0));
  }
  return sum / depth;
}

Layered slant_air_of(const Path& path) {
  Layered air = lowtran_air(path.profile, path.haze);
  air.aerosol.visibility_km = path.visibility_km;
  air.aerosol.relative_humidity = haze_humidity(air, path);
  return air;
}

/// What lies in the air between levels, and how a path crosses it.
class PathAir {
 public:
  PathAir(const Layered& air, std::vector<double> levels_m, const Path& path)
      : gases_{air.gases, air.profile, levels_m},
        particles_{air.particles, air.aerosol, {}, levels_m},
        slant_(levels_m.size() - 1, 0.0) {
    const double mu = path.zenith_deg == 90.0 ? 0.0 : std::cos(path.zenith_deg * pi / 180.0);
    for (const PathPiece& piece : path_through(levels_m, path.height_m, mu, path.length_m)) {
      const auto k = static_cast<std::size_t>(piece.layer);
      slant_[k] += piece.length_m / (levels_m[k] - levels_m[k + 1]);
    }
  }
  [[nodiscard]] double transmittance(double wavenumber) const {
    const Micrometres wavelength{1e4 / wavenumber};
    return gases_.band_transmittance(wavelength, slant_) * scattered_less(wavelength);
  }
  /// The gases by their sum of exponentials, as tables are made.
  [[nodiscard]] double by_terms(double wavenumber) const {
    const Micrometres wavelength{1e4 / wavenumber};
    double sum = 0.0;
    for (const AbsorptionTerm& term : gases_.terms(wavelength, wavelength, 5e-4)) {
      sum += term.weight * std::exp(-along(term.depth));
    }
    return sum * scattered_less(wavelength);
  }

 private:
  [[nodiscard]] double along(const std::vector<double>& depth) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < depth.size(); ++k) sum += depth[k] * slant_[k];
    return sum;
  }
  [[nodiscard]] double scattered_less(Micrometres wavelength) const {
    double depth = along(gases_.rayleigh_depth(wavelength));
    for (int k = 0; k < particles_.kinds(); ++k) {
      const KindOptics optics = particles_.optics(k, wavelength);
      depth += along(particles_.depth_550(k)) * (optics.absorption + optics.scattering);
    }
    return std::exp(-depth);
  }

  GasAbsorption gases_;
  Particles particles_;
  std::vector<double> slant_;
};

struct AirSlantDifference {
  double rms = 0.0, worst = 0.0;
};

/// From 700 to 27,000 cm^-1, every `step`th point of the reference.
template <class Transmittance>
AirSlantDifference compared(const Path& path, std::size_t step,
                            const Transmittance& transmittance) {
  const auto reference = atmosphere::support::lowtran7(path.name);
  AirSlantDifference difference;
  int count = 0;
  for (std::size_t i = 0; i < reference.wavenumber.size(); i += step) {
    const double v = reference.wavenumber[i];
    if (v < 700.0 || v > 27'000.0) continue;
    const double error = std::abs(transmittance(v) - reference.transmittance[i]);
    difference.worst = std::max(difference.worst, error);
    difference.rms += error * error;
    ++count;
  }
  difference.rms = std::sqrt(difference.rms / count);
  return difference;
}

std::vector<double> table_levels(const Layered& air) {
  return column_levels_m(air.profile, air.aerosol, {}, 0.0);
}

const Path level_path{"us_horiz5km", "us_standard_1976", AerosolType::rural, 23.0, 0.0, 90.0, 5e3};

}  // namespace

TEST_CASE("Slant paths through hazy air let through what LOWTRAN7 says", "[sim][air]") {
  // Promised: rms below 5e-4 and 0.007 at worst. Found 1.8e-4 to 4.2e-4 and 0.0045, of gases at
  // 800 to 850 and 2800 cm^-1: the layers of LOWTRAN7 have one temperature each. Every third
  // point here; docs/air-gases.md has all.
  const auto path = GENERATE(
      Path{"us_rural23", "us_standard_1976", AerosolType::rural, 23.0, 0.0, 0.0, endless},
      Path{"mls_urban5", "midlatitude_summer", AerosolType::urban, 5.0, 0.0, 0.0, endless},
      Path{"mls_rural23_60deg", "midlatitude_summer", AerosolType::rural, 23.0, 0.0, 60.0, endless},
      Path{"mls_air3km", "midlatitude_summer", AerosolType::rural, 23.0, 3e3, 150.0, endless});
  const Layered air = slant_air_of(path);
  const PathAir along{air, table_levels(air), path};
  const AirSlantDifference band =
      compared(path, 3, [&](double v) { return along.transmittance(v); });
  const AirSlantDifference terms = compared(path, 15, [&](double v) { return along.by_terms(v); });
  CAPTURE(path.name, band.rms, band.worst, terms.rms, terms.worst);
  CHECK(band.rms < 5e-4);
  CHECK(band.worst < 0.007);
  CHECK(terms.rms < 5e-4);
  CHECK(terms.worst < 0.007);
}

TEST_CASE("A level path lets through what LOWTRAN7 says", "[sim][air]") {
  const Layered air = slant_air_of(level_path);
  // 5 km along the ground rise by 2 m: thin layers there give the air at sea level.
  std::vector<double> levels = table_levels(air);
  for (const double z : {10.0, 3.0}) levels.insert(levels.end() - 1, z);
  const PathAir thin{air, levels, level_path};
  const AirSlantDifference band =
      compared(level_path, 3, [&](double v) { return thin.transmittance(v); });
  CAPTURE(band.rms, band.worst);
  CHECK(band.rms < 5e-4);
  CHECK(band.worst < 0.007);
}

TEST_CASE("A table's lowest layer is thin enough for level views at the ground", "[sim][air]") {
  // 30 m at 23 km visibility: 0.8 % less of the haze than at the ground itself.
  const Layered air = slant_air_of(level_path);
  const PathAir coarse{air, table_levels(air), level_path};
  const double at_ground = 5.0 * (3.912 / 23.0);  // Koschmieder, with the air's own scattering
  const double passed = coarse.transmittance(1e4 / 0.55);
  CAPTURE(passed, std::exp(-at_ground));
  CHECK(passed == Approx(std::exp(-at_ground)).epsilon(0.01));
  const AirSlantDifference band =
      compared(level_path, 7, [&](double v) { return coarse.transmittance(v); });
  CHECK(band.worst < 0.007);
}

TEST_CASE("At 60 degrees the earth's curvature is seen in what the air lets through",
          "[sim][air]") {
  // sec z (1 - tan^2 z H / R) with H = 8.3 km, the mean height of molecules: 1.9922 and not 2.
  // (Kasten & Young, Appl. Opt. 28, 4735, 1989, have 1.9943 with refraction.)
  const Path slant{"", "midlatitude_summer", AerosolType::none, 23.0, 0.0, 60.0, endless};
  Path zenith = slant;
  zenith.zenith_deg = 0.0;
  const Layered air = lowtran_air(slant.profile, slant.haze);
  const double blue = 1e4 / 0.4;
  const double ratio = std::log(PathAir{air, table_levels(air), slant}.transmittance(blue)) /
                       std::log(PathAir{air, table_levels(air), zenith}.transmittance(blue));
  CHECK(ratio == Approx(2.0 * (1.0 - 3.0 * 8.3e3 / earth_radius_m)).epsilon(4e-4));
}

}  // namespace nadir::sim::test
