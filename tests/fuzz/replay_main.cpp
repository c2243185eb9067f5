// Feeds every target with its corpus once: what was found once stays mended in every build.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz_targets.hpp"

namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) files.push_back(entry);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_replay CORPUS\n");
    return 2;
  }
  for (const auto& target : nadir::fuzz::targets()) {
    const auto files = files_in(std::filesystem::path{argv[1]} / target.name);
    for (const auto& file : files) {
      std::printf("%s\n", file.c_str());  // the last one that is told is the one that crashes
      std::fflush(stdout);
      target.feed(bytes_of(file));
    }
    if (files.empty()) return 1;
  }
  return 0;
}
