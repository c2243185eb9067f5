// libFuzzer's entry: `fuzz_readers TARGET [libFuzzer's options] [corpus]`.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz_targets.hpp"

namespace {
const nadir::fuzz::Target* chosen = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc > 1) chosen = nadir::fuzz::find_target((*argv)[1]);
  if (chosen == nullptr) {
    std::fprintf(stderr, "the first argument names a target:");
    for (const auto& target : nadir::fuzz::targets()) {
      std::fprintf(stderr, " %.*s", static_cast<int>(target.name.size()), target.name.data());
    }
    std::fprintf(stderr, "\n");
    std::exit(2);
  }
  // libFuzzer takes it for a corpus otherwise.
  (*argv)[1] = (*argv)[0];
  ++*argv;
  --*argc;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libFuzzer hands on bytes, readers take characters
  chosen->feed({reinterpret_cast<const char*>(data), size});
  return 0;
}
