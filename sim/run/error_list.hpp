#pragma once

#include <vector>

#include "core/error.hpp"

namespace nadir::sim {

/// Lets a step of several parts report the mistakes of all of them at once.
class ErrorList {
 public:
  /// Runs a part; its InputError is kept. Returns whether it succeeded.
  template <class F>
  bool attempt(F&& part) {
    try {
      part();
      return true;
    } catch (const InputError& error) {
      issues_.insert(issues_.end(), error.issues().begin(), error.issues().end());
      return false;
    }
  }
  /// @throws InputError with everything that was kept, if there is anything
  void throw_if_any() const {
    if (!issues_.empty()) throw InputError{issues_};
  }

 private:
  std::vector<InputIssue> issues_;
};

}  // namespace nadir::sim
