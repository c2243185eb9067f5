#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "radiometry/lamps/bound_lamps.hpp"

// Part of BoundLamps; not for others.

namespace nadir::radiometry {

/// Checks lamps one by one and adds them to what is bound; tells of all mistakes at the end.
class BoundLamps::Binder {
 public:
  Binder(BoundLamps& bound, const spectral::Lanes& lanes) : bound_{&bound}, lanes_{&lanes} {}

  void add(const Lamp& lamp);
  /// Builds the hierarchy. @throws InputError with the mistakes of all lamps
  void finish();

 private:
  [[nodiscard]] LightTreeItem bind(const PointLamp& lamp, Emitter& emitter);
  [[nodiscard]] LightTreeItem bind(const AreaLamp& lamp, Emitter& emitter);
  void bind_flux(const LampFlux& flux, Emitter& emitter);
  [[nodiscard]] std::uint32_t shape_index(const IntensityShape& shape);
  void take_object(std::uint32_t object);

  BoundLamps* bound_;
  const spectral::Lanes* lanes_;
  std::vector<LightTreeItem> items_;
  std::map<const spectral::Curve*, std::uint32_t> known_curves_;
  std::map<const IntensityTable*, std::uint32_t> known_tables_;
  std::map<std::pair<double, double>, std::uint32_t> known_cosines_;
  std::vector<InputIssue> issues_;
};

}  // namespace nadir::radiometry
