#pragma once

#include <memory>

#include "atmosphere/air_parts.hpp"
#include "atmosphere/path_terms.hpp"
#include "atmosphere/table/air_table.hpp"
#include "core/vec.hpp"
#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// An air table at the lanes of a block: what rays look up. Immutable, cheap to copy, no allocation
/// in look-ups; radiances are never negative. Directions are unit vectors in scene axes (east,
/// north, up), away from who looks; the origin of the scene axes is `ground_m` above sea level, and
/// the earth curves away below. docs/air-tables.md states the formulas and their errors.
class BoundAirTable {
 public:
  /// Lanes that are split into absorption terms must be those of the table (wavelength, interval
  /// and term alike); other wavelengths are interpolated linearly among the table's.
  /// @param table  one that check() accepts
  /// @param parts  what is wanted: the rest is 0, a transmittance of the line of sight 1. Light of
  ///               the bodies, of the night and what the ground about reflects of them counts as
  ///               scattered, the air's own and what the ground emits as emitted
  /// @throws InputError where the table does not cover a lane
  BoundAirTable(const std::shared_ptr<const AirTable>& table, const GroundLight& ground,
                const spectral::Lanes& lanes, const AirParts& parts = {});

  /// Radiance from a direction of the open sky at the ground; below the horizon that of the ground
  /// about.
  [[nodiscard]] spectral::Spectrum sky(Vec3 direction_enu) const noexcept;
  /// Share of a body's irradiance that reaches the scene: that of the table's body nearest to the
  /// direction if within 2 degrees of it, otherwise by the table's extinction of the whole way;
  /// nothing from more than 1 degree below the horizon.
  [[nodiscard]] spectral::Spectrum direct_transmittance(Vec3 direction_enu) const noexcept;
  /// The way from an eye to a surface it sees. An eye above the air looks from where its ray enters
  /// it; one between two of the table's heights gets a blend of both, one beyond them the nearest.
  [[nodiscard]] PathTerms path(Vec3 eye, Vec3 direction, double length_m) const noexcept;
  /// Where an eye sees nothing of the scene: sky, or the ground about.
  [[nodiscard]] spectral::Spectrum beyond(Vec3 eye, Vec3 direction) const noexcept;

  /// The mean radiance of the ground about as surfaces see it, by lane: what it reflects and emits.
  [[nodiscard]] spectral::Spectrum ground_radiance() const noexcept;

 private:
  struct Bound;
  std::shared_ptr<const Bound> bound_;
};

}  // namespace nadir::atmosphere
