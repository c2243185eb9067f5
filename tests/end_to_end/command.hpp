#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "sim/scratch_folder.hpp"

namespace nadir::end_to_end {

/// What a command line said and how it ended.
struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the `nadir` command of this build with the given arguments, as a shell would.
inline CommandResult run_nadir(const std::string& arguments) {
  const sim::support::ScratchFolder scratch;
  const auto out = scratch / "out", err = scratch / "err";
  const std::string line =
      std::string{NADIR_COMMAND} + " " + arguments + " >" + out.string() + " 2>" + err.string();
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, sim::support::content_of(out),
          sim::support::content_of(err)};
}

inline std::string data_file(const std::string& name) {
  return std::string{NADIR_SOURCE_DIR} + "/tests/end_to_end/data/" + name;
}

}  // namespace nadir::end_to_end
