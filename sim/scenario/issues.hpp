#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"

namespace nadir::sim {

/// Every mistake found so far, so that the user hears of all of them at once.
class Issues {
 public:
  void add(InputIssue issue) { issues_.push_back(std::move(issue)); }
  void add(const InputError& error) {
    issues_.insert(issues_.end(), error.issues().begin(), error.issues().end());
  }
  [[nodiscard]] bool empty() const noexcept { return issues_.empty(); }
  [[nodiscard]] std::size_t count() const noexcept { return issues_.size(); }

  /// @throws InputError with the mistakes of each file by line and column, if there are any
  void throw_if_any() const;

 private:
  std::vector<InputIssue> issues_;
};

/// `did you mean "x"?` for the nearest of the known names, or else their list; empty for none.
[[nodiscard]] std::string suggestion(const std::string& name,
                                     const std::vector<std::string>& known);

}  // namespace nadir::sim
