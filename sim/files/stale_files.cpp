#include "sim/files/stale_files.hpp"

#include <sys/types.h>

#include <cerrno>
#include <csignal>
#include <regex>
#include <string>
#include <system_error>

namespace nadir::sim {
namespace {

bool is_at_work(const std::string& process) {
  return ::kill(static_cast<pid_t>(std::stol(process)), 0) == 0 || errno != ESRCH;
}

}  // namespace

void remove_stale_temporaries(const std::filesystem::path& folder) {
  static const std::regex temporary{R"(\..+\.([0-9]{1,9})-[0-9]+\.tmp)"};  // as AtomicFile names
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{folder, ignored}) {
    const std::string name = entry.path().filename().string();
    std::smatch parts;
    if (!std::regex_match(name, parts, temporary) || is_at_work(parts[1].str())) continue;
    std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace nadir::sim
