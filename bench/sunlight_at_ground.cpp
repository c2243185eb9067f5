// Sunlight at the ground on a clear day, by wavelength:
//
//     sunlight_at_ground scenes/library
//
// prints wavelength (um) and spectral irradiance of level ground (W m^-2 um^-1; direct and diffuse)
// for the US standard atmosphere of 1976 with 420 ppm of carbon dioxide and rural haze of 23 km,
// the sun at 1 au and air mass 1.5, over ground that reflects 0.2: what tools/make_library.py ships
// as illumination/sunlight_at_ground.csv. Means over 10 nm to 1 um, 20 nm to 2.5 um, 50 nm to 4 um.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <vector>

#include "atmosphere/broadband/broadband_fluxes.hpp"
#include "sim/files/band_tables.hpp"
#include "sim/files/particle_tables.hpp"
#include "sim/files/spectrum_file.hpp"

namespace {

using namespace nadir;

std::vector<double> edges_um() {
  struct Bins {
    int to_nm, step_nm;
  };
  std::vector<double> edges;
  int nm = 300;
  for (const auto& [to_nm, step_nm] : {Bins{1000, 10}, Bins{2500, 20}, Bins{4000, 50}}) {
    for (; nm < to_nm; nm += step_nm) edges.push_back(1e-3 * nm);
  }
  edges.push_back(4.0);
  return edges;
}

atmosphere::Layered clear_air(const std::filesystem::path& library) {
  using namespace atmosphere;
  const auto gases =
      std::make_shared<const BandTables>(sim::read_band_tables(library / "atmosphere"));
  const auto particles = std::make_shared<const ParticleTables>(
      sim::read_particle_tables(library / "atmosphere" / "particles.txt"));
  const auto dark = spectral::Curve::constant(0.0);
  return {gases, particles,         standard_profile(*gases, "us_standard_1976"), 0.0, {},
          {},    {dark, dark, dark}};
}

void print_sunlight(const std::filesystem::path& library) {
  atmosphere::BroadbandSettings settings;
  settings.solar_edges_um = edges_um();
  settings.long_wave_edges_um = {};
  settings.term_tolerance = 5e-4;
  settings.cos_zenith = {};
  const auto sun = sim::read_curve(library / "illumination" / "solar.csv", "",
                                   sim::SpectrumQuantity::irradiance, spectral::Outside::reject);
  const auto light = atmosphere::broadband_fluxes(clear_air(library), settings, sun).spectrum;
  for (std::size_t i = 0; i < light.values().size(); ++i) {
    std::printf("%.5g,%.5g\n", light.wavelengths_um()[i], light.values()[i]);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: sunlight_at_ground scenes/library\n", stderr);
    return 2;
  }
  try {
    print_sunlight(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
