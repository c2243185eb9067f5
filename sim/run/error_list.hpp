#pragma once

#include <string>
#include <utility>
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
  /// The same for a part that has a name: mistakes that do not say where they are get it, and the
  /// file that the part stands in.
  template <class F>
  bool attempt(const std::string& name, const std::string& file, F&& part) {
    return attempt([&] {
      try {
        part();
      } catch (const InputError& error) {
        throw named(error, name, file);
      }
    });
  }
  [[nodiscard]] bool any() const noexcept { return !issues_.empty(); }
  /// @throws InputError with everything that was kept, if there is anything
  void throw_if_any() const {
    if (!issues_.empty()) throw InputError{issues_};
  }

 private:
  static InputError named(const InputError& error, const std::string& name,
                          const std::string& file) {
    std::vector<InputIssue> issues = error.issues();
    for (InputIssue& issue : issues) {
      if (!issue.where.file.empty()) continue;
      issue.where.file = file;
      issue.message = name + ": " + issue.message;
    }
    return InputError{std::move(issues)};
  }

  std::vector<InputIssue> issues_;
};

}  // namespace nadir::sim
