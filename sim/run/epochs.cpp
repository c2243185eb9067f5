#include "sim/run/epochs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "core/error.hpp"

namespace nadir::sim {
namespace {

constexpr std::size_t most_epochs = 32;    // bits of a ray's mask
constexpr double clock_rounding_s = 1e-6;  // differences of instants are good to 1e-10 s
constexpr double ever = std::numeric_limits<double>::infinity();

const PresenceInput* presence_of(const GeometryInput& input) {
  if (const auto* object = std::get_if<ObjectInput>(&input)) return &object->presence;
  if (const auto* list = std::get_if<InstancesInput>(&input)) return &list->presence;
  return nullptr;
}

}  // namespace

Epochs::Epochs(const Scenario& scenario) : picture_{scenario.time} {
  for (const GeometryInput& input : scenario.geometry) {
    const PresenceInput* presence = presence_of(input);
    if (presence == nullptr) continue;
    for (const auto& time : {presence->from, presence->until}) {
      // What comes or goes after the picture changes nothing in it.
      if (time && after_picture_s(*time) <= 0.0) begins_s_.push_back(after_picture_s(*time));
    }
  }
  std::sort(begins_s_.begin(), begins_s_.end(), std::greater<>{});
  begins_s_.erase(std::unique(begins_s_.begin(), begins_s_.end()), begins_s_.end());
  begins_s_.push_back(-ever);
  if (begins_s_.size() > most_epochs) {
    throw InputError{
        fmt::format("objects come or go at {} different times before the picture, "
                    "more than the {} that can be told apart",
                    begins_s_.size() - 1, most_epochs - 1)};
  }
}

double Epochs::after_picture_s(const ephemeris::Instant& time) const {
  return (time - picture_).value;
}

std::uint32_t Epochs::of(const PresenceInput& presence) const {
  if (!presence.from && !presence.until) return geometry::always;
  const double from = presence.from ? after_picture_s(*presence.from) : -ever;
  const double until = presence.until ? after_picture_s(*presence.until) : ever;
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < begins_s_.size(); ++i) {
    // An epoch lies wholly inside or outside: its ends are among the times of all objects.
    if (begins_s_[i] >= from && begins_s_[i] < until) mask |= 1U << i;
  }
  return mask;
}

double Epochs::first_change_s(double within_s) const {
  double first_s = 0.0;
  for (const double begin_s : begins_s_) {
    if (begin_s >= -within_s) first_s = std::max(first_s, -begin_s);
  }
  return first_s;
}

std::uint32_t Epochs::at(double time_s) const {
  std::size_t i = 0;
  while (time_s < begins_s_[i] - clock_rounding_s) ++i;  // the last begins at minus infinity
  return 1U << i;
}

}  // namespace nadir::sim
