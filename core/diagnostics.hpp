#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace nadir {

/// Collects what the user should know but what need not stop the run: an extrapolated spectrum, a
/// date past the leap-second table. Shown at the end of a run and stored in its report.
/// Thread-safe; a repeated message is kept once.
class Diagnostics {
 public:
  void warn(std::string message);
  [[nodiscard]] std::vector<std::string> messages() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
};

}  // namespace nadir
