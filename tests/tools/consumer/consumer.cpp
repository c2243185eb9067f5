#include <cstdio>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "spectral/planck.hpp"

// Prints the radiance of a black body and the name of the scenario given as argument, so that both
// the lightest and the heaviest of the libraries are linked and run.
int main(int argc, char** argv) {
  using namespace nadir::literals;
  std::printf("%.4f\n", nadir::spectral::planck(10.0_um, 300.0_K).value);
  if (argc < 2) return 1;
  try {
    nadir::Diagnostics diagnostics;
    const auto scenario = nadir::sim::read_scenario(argv[1], diagnostics);
    std::printf("%zu materials\n", scenario.materials.size());
  } catch (const nadir::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
