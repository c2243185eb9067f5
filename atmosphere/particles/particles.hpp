#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "atmosphere/particles/particle_tables.hpp"
#include "atmosphere/particles/phase_function.hpp"
#include "core/quantity.hpp"

namespace nadir::atmosphere {

enum class AerosolType { none, rural, urban, maritime, tropospheric, fog_advection, fog_radiation };
enum class Season { spring_summer, autumn_winter };
enum class Volcanic { background, moderate, high, extreme };

/// The haze, as a user describes it.
struct Aerosol {
  AerosolType type = AerosolType::rural;    ///< of the boundary layer, 0 to 2 km above the ground
  double visibility_km = 23.0;              ///< meteorological range at 0.55 um, > 0, below 337 km
  std::optional<double> optical_depth_550;  ///< of the whole column at 0.55 um, in place of the
                                            ///< visibility: the visibility that gives it is sought
  double relative_humidity = 0.7;           ///< 0 to 0.99, of the boundary layer
  Season season = Season::spring_summer;
  Volcanic volcanic = Volcanic::background;
};

/// A cloud: a layer that covers the sky.
struct Cloud {
  std::string type;  ///< a row of the tables: cumulus, altostratus, stratus, ..., cirrus
  double base_m = 0.0, top_m = 0.0;  ///< above the ground, base < top
  double optical_depth_550 = 0.0;    ///< vertical extinction at 0.55 um, >= 0
};

/// Optics of one kind of particles at one wavelength.
struct KindOptics {
  double scattering = 0.0, absorption = 0.0;  ///< times the extinction at 0.55 um
  std::shared_ptr<const PhaseFunction> phase;
};

/// Haze and clouds over a scene: which kinds there are, how much of each lies in each layer, and
/// what light does at a wavelength.
///
/// The haze has four regions, each of its own kind: the boundary layer (0 to 2 km above the ground,
/// of the given type), the troposphere to 10 km, the stratosphere to 30 km and the upper air to
/// 100 km. Extinction between the tables' heights is exponential, or linear where one end is 0, so
/// that a region fades out while the next one begins. Over raised ground (height G) a height h
/// below z0 = max(6 km, G + 1 km) counts as z0 (h - G) / (z0 - G) in the tables: what lies below
/// 6 km is squeezed into the air that is left.
/// Source: LOWTRAN7, Kneizys et al., AFGL-TR-88-0177 (1988); figures as in ParticleTables.
class Particles {
 public:
  /// @param level_height_m  above mean sea level, descending; the last one is the ground
  /// @throws InputError with one message: visibility not positive or more than clean air's, an
  ///         unknown cloud (nearest name), a cloud without thickness or outside the levels, an
  ///         optical depth of the column that no visibility gives
  Particles(std::shared_ptr<const ParticleTables> tables, const Aerosol& aerosol,
            const std::vector<Cloud>& clouds, const std::vector<double>& level_height_m);

  /// Kinds that are anywhere; those that are optically alike count as one.
  [[nodiscard]] int kinds() const noexcept { return static_cast<int>(depth_550_.size()); }
  /// Vertical extinction at 0.55 um by layer.
  [[nodiscard]] const std::vector<double>& depth_550(int kind) const {
    return depth_550_[static_cast<std::size_t>(kind)];
  }
  /// Linear between the tables' wavelengths; the phase function is a mixture of those at the two
  /// nearest of its own wavelengths, and so continuous in wavelength. Costs 0.05 ms,
  /// nearly all for the moments of the mixture.
  /// @throws InputError outside the tables' wavelengths, 0.2 to 200 um
  [[nodiscard]] KindOptics optics(int kind, Micrometres wavelength) const;
  /// The scattering of `optics` alone, which costs next to nothing.
  [[nodiscard]] double scattering(int kind, Micrometres wavelength) const;
  /// The visibility that the haze has, km: as given, or the one found for the optical depth.
  [[nodiscard]] double visibility_km() const noexcept { return visibility_km_; }
  /// Where a column needs levels of its own: edges of the haze's regions and of the clouds, m above
  /// sea level, ascending, above the ground.
  [[nodiscard]] static std::vector<double> edges_m(const Aerosol& aerosol,
                                                   const std::vector<Cloud>& clouds,
                                                   double ground_height_m);

 private:
  /// Two rows of the tables, (1 - share) of the first and share of the second.
  struct Kind {
    const ParticleOptics* low = nullptr;
    const ParticleOptics* high = nullptr;
    double share = 0.0;
    bool operator==(const Kind&) const = default;
  };
  [[nodiscard]] Kind humid_kind(const std::string& name, double relative_humidity) const;
  void add_haze(const Aerosol& aerosol, const std::vector<double>& level_height_m);
  void add_cloud(const Cloud& cloud, const std::vector<double>& level_height_m);
  void add(const Kind& kind, const std::vector<double>& depth);
  struct Amounts {
    double scattering = 0.0, absorption = 0.0, asymmetry = 0.0;
  };
  [[nodiscard]] Amounts amounts(const Kind& kind, double wavelength_um) const;
  [[nodiscard]] std::shared_ptr<const PhaseFunction> phase(const Kind& kind,
                                                           double wavelength_um) const;

  std::shared_ptr<const ParticleTables> tables_;  // the kinds point into it
  std::vector<Kind> kinds_;
  std::vector<std::vector<double>> depth_550_;  // by kind and layer
  double visibility_km_ = 0.0;
};

}  // namespace nadir::atmosphere
