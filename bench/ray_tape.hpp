#pragma once

#include <cstdint>
#include <vector>

// The one place outside geometry/ that sees its private header: raw Embree can only be timed on the
// simulator's own Embree scene and with the calls that geometry/ makes, for either version.
#include "geometry/embree.hpp"

namespace nadir::bench {

/// The rays that were given to Embree, in order, exactly as Embree got them (float, about the
/// scene's centre). Works for scenes of triangles: shapes need more context than a ray.
class RayTape {
 public:
  /// Second tries of the same ray (equal direction, one after the other) are left out: raw Embree
  /// would be asked once.
  void add(RTCScene scene, const RTCRay& ray, bool any_hit);
  /// Asks Embree again, without filters, on this thread. Returns how many rays hit something.
  [[nodiscard]] std::uint64_t replay() const;
  [[nodiscard]] std::uint64_t rays() const noexcept { return entries_.size(); }
  /// Calls of Embree that were seen, second tries included.
  [[nodiscard]] std::uint64_t calls() const noexcept { return calls_; }

 private:
  struct Entry {
    RTCRay ray;
    bool any_hit;  ///< rtcOccluded1 rather than rtcIntersect1
  };
  RTCScene scene_ = nullptr;
  std::vector<Entry> entries_;
  std::uint64_t calls_ = 0;
};

/// While it lives every ray that this thread gives to Embree goes to the tape, too.
class Recording {
 public:
  explicit Recording(RayTape& tape) noexcept;
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
};

}  // namespace nadir::bench
