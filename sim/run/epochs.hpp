#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// The spans of time between which objects come and go, one bit each (geometry::Ray::epochs): bit 0
/// is the span of the picture, bit 1 the one before it and so on.
class Epochs {
 public:
  /// @throws InputError for more spans before the picture than there are bits
  explicit Epochs(const Scenario& scenario);

  /// When an object is there.
  [[nodiscard]] std::uint32_t of(const PresenceInput& presence) const;
  /// The bit of a moment.
  /// @param time_s  seconds after the picture, at most 0
  [[nodiscard]] std::uint32_t at(double time_s) const;
  /// How long before the picture the first object came or went that did so in the last
  /// `within_s`; 0 where none did.
  [[nodiscard]] double first_change_s(double within_s) const;

 private:
  [[nodiscard]] double after_picture_s(const ephemeris::Instant& time) const;

  ephemeris::Instant picture_;
  std::vector<double> begins_s_;  // of the epochs, latest first: begins_s_[i] starts bit i
};

}  // namespace nadir::sim
