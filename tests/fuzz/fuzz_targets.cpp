#include "fuzz_targets.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "ephemeris/instant.hpp"
#include "ephemeris/iso_time.hpp"
#include "ephemeris/sun_moon.hpp"
#include "sim/files/air_table_file.hpp"
#include "sim/files/attitude_file.hpp"
#include "sim/files/brdf_file.hpp"
#include "sim/files/grid_file.hpp"
#include "sim/files/ies_file.hpp"
#include "sim/files/mesh_obj.hpp"
#include "sim/files/mesh_ply.hpp"
#include "sim/files/oem_file.hpp"
#include "sim/files/raster.hpp"
#include "sim/files/spectrum_file.hpp"
#include "sim/files/tle_file.hpp"
#include "sim/files/weather_format.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::fuzz {
namespace {

/// Bad input is what these bytes may be; nothing else may come out of a reader.
template <class Read>
void refused_or_read(Read&& read) {
  try {
    read();
  } catch (const InputError&) {
  }
}

void scenario(std::string_view bytes) {
  refused_or_read([&] {
    Diagnostics diagnostics;
    (void)sim::parse_scenario(std::string{bytes}, "/nowhere/fuzzed.xml", diagnostics);
  });
}

void spectrum(std::string_view bytes) {
  refused_or_read([&] {
    const sim::SpectrumFile file = sim::parse_spectrum(bytes, "fuzzed.csv");
    for (const auto& column : file.columns) {
      refused_or_read([&] {
        (void)sim::curve_in(file, column.name, sim::SpectrumQuantity::reflectance,
                            spectral::Outside::reject);
      });
    }
  });
  refused_or_read(
      [&] { (void)sim::parse_spectrum(bytes, "fuzzed.csv", sim::SpectrumQuantity::reflectance); });
}

void mesh(std::string_view bytes) {
  refused_or_read([&] { (void)sim::parse_obj(bytes, "fuzzed.obj"); });
  refused_or_read([&] { (void)sim::parse_ply(bytes, "fuzzed.ply"); });
}

void weather(std::string_view bytes) {
  refused_or_read([&] { (void)sim::parse_weather(bytes, "fuzzed.csv", std::nullopt); });
}

/// GDAL reads files only.
void raster(std::string_view bytes) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("nadir-fuzzed-" + std::to_string(getpid()) + ".tif");
  std::ofstream{file, std::ios::binary} << bytes;
  refused_or_read([&] { (void)sim::read_raster(file); });
  refused_or_read([&] { (void)sim::read_height_grid(file, 0.0); });
  std::filesystem::remove(file);
}

void moment(std::string_view bytes) {
  refused_or_read([&] {
    const auto instant = ephemeris::Instant::parse_utc(bytes);
    // What was read is written and read again, and the sky knows it.
    const std::string text = instant.to_string();
    if (ephemeris::Instant::parse_utc(text).to_string() != text) {
      throw std::logic_error{"a time does not read back: " + text};
    }
    refused_or_read([&] { (void)ephemeris::sun_and_moon(instant, {36.6, -84.2, 300.0}); });
  });
}

void orbit(std::string_view bytes) {
  refused_or_read([&] { (void)sim::parse_two_line_elements(bytes, "fuzzed.tle"); });
  refused_or_read([&] { (void)sim::parse_oem(bytes, "fuzzed.oem"); });
  refused_or_read([&] {
    const auto origin = ephemeris::Instant::parse_utc("2026-06-21T13:00:00Z");
    (void)sim::parse_attitude_file(bytes, "fuzzed.csv", origin);
  });
}

void table(std::string_view bytes) {
  refused_or_read([&] { (void)sim::parse_ies(bytes, "fuzzed.ies"); });
  refused_or_read([&] { (void)sim::parse_brdf_file(bytes, "fuzzed.csv"); });
  refused_or_read([&] { (void)sim::parse_grid(bytes, "fuzzed.nrrd"); });
  refused_or_read([&] { (void)sim::parse_air_table(bytes, "fuzzed.air"); });
}

constexpr Target all[] = {{"scenario", scenario}, {"spectrum", spectrum}, {"mesh", mesh},
                          {"raster", raster},     {"weather", weather},   {"time", moment},
                          {"orbit", orbit},       {"table", table}};

}  // namespace

std::span<const Target> targets() { return all; }

const Target* find_target(std::string_view name) {
  const auto* found = std::find_if(std::begin(all), std::end(all),
                                   [&](const Target& target) { return target.name == name; });
  return found == std::end(all) ? nullptr : found;
}

}  // namespace nadir::fuzz
