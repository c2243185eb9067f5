#pragma once

#include <optional>
#include <vector>

#include "sim/scenario/build_context.hpp"

// The parts of a platform, one file each.

namespace nadir::sim {

/// The scenario's platform, built part by part.
struct PlatformBuilder {
  const BuildContext& context;
  bool has_terrain = false;

  void build_position(const CheckedElement& position, PlatformInput& platform) const;
  /// After the position. @param origin  of the scene's axes
  void build_attitude(const CheckedElement& attitude, const geometry::Geodetic& origin,
                      PlatformInput& platform) const;
  [[nodiscard]] JitterInput build_jitter(const CheckedElement& element) const;
  /// From the outermost carrier to the camera.
  [[nodiscard]] std::vector<MountInput> build_mounts(const CheckedElement& element) const;
  /// The <geodetic> or <local> inside an element; nothing after a mistake.
  [[nodiscard]] std::optional<PlaceInput> build_place(const CheckedElement& element) const;
};

/// none, or the one element that <position> or <attitude> holds.
[[nodiscard]] inline const CheckedElement* only_child(const CheckedElement& element) {
  return element.children.empty() ? nullptr : &element.children.front();
}

}  // namespace nadir::sim
