#include "core/diagnostics.hpp"

#include <algorithm>
#include <utility>

namespace nadir {

void Diagnostics::warn(std::string message) {
  const std::scoped_lock lock{mutex_};
  if (std::find(messages_.begin(), messages_.end(), message) == messages_.end()) {
    messages_.push_back(std::move(message));
  }
}

std::vector<std::string> Diagnostics::messages() const {
  const std::scoped_lock lock{mutex_};
  return messages_;
}

}  // namespace nadir
