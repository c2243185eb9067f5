#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "end_to_end/command.hpp"

namespace nadir::end_to_end {

/// Starts `nadir` and kills it (SIGKILL) after a while.
/// @return whether it was still at work then
inline bool kill_nadir_after(const std::vector<std::string>& arguments,
                             std::chrono::duration<double> while_it_works) {
  std::vector<char*> line;
  std::string command = NADIR_COMMAND;
  line.push_back(command.data());
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) line.push_back(argument.data());
  line.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    ::execv(line[0], line.data());
    ::_exit(127);
  }
  std::this_thread::sleep_for(while_it_works);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

/// Every file of a run's folder by name, but for the report, which holds the clock's readings, and
/// the samples, which lie in the order in which threads made them.
inline std::map<std::string, std::string> files_of_run(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    if (name != "report.json" && name != "samples.nadir") {
      all[name] = sim::support::content_of(entry.path());
    }
  }
  return all;
}

}  // namespace nadir::end_to_end
