#pragma once

#include <array>
#include <vector>

#include "atmosphere/particles/particles.hpp"

namespace nadir::atmosphere {

/// Extinction of the haze at 0.55 um by height, in its four regions. See Particles for the rules.
class HazeProfile {
 public:
  static constexpr int regions = 4;  ///< boundary layer, troposphere, stratosphere, upper air

  /// @param visibility_km  greater than 0. Boundary layer and, above 23 km, troposphere linear in
  ///        1 / visibility between the tables' (2 to 50 km) and on to smaller ones. Beyond 50 km
  ///        both shrink with Koschmieder's extinction, 3.912 / visibility - 0.01159 km^-1, to 0 at
  ///        clean_air_km.
  HazeProfile(const ParticleTables& tables, const Aerosol& aerosol, double visibility_km,
              double ground_height_m);

  /// Vertical optical depth of a region from `height_m` down to the ground.
  [[nodiscard]] double depth_below(int region, double height_m) const;
  /// Of all regions, from the top of the tables to the ground.
  [[nodiscard]] double column() const;

  /// Koschmieder's range in air without any particles, km: 3.912 / 0.01159.
  static constexpr double clean_air_km = 3.912 / 0.01159;

 private:
  const ParticleTables& tables_;
  double ground_km_;
  std::array<std::vector<double>, regions> extinction_;  // km^-1, by the tables' heights
};

/// The visibility in km at which the column has the optical depth that `aerosol` asks for.
/// @throws InputError  less than the stratosphere alone has, or more than that of a view of 1 m
[[nodiscard]] double visibility_of_depth(const ParticleTables& tables, const Aerosol& aerosol,
                                         double ground_height_m);

/// Height above the sea in km at which something stands that the tables have at `table_km`.
[[nodiscard]] double squeezed_km(double table_km, double ground_km) noexcept;

}  // namespace nadir::atmosphere
