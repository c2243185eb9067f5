#pragma once

#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "atmosphere/layered.hpp"
#include "sim/files/band_tables.hpp"
#include "sim/files/particle_tables.hpp"

namespace nadir::sim::test {

/// Columns of a table of reference figures by name; lines with # are passed over.
inline std::map<std::string, std::vector<double>> reference_columns(const std::string& file) {
  std::ifstream in{std::string{NADIR_SOURCE_DIR "/tests/sim/data/"} + file};
  if (!in) throw std::runtime_error("no reference figures " + file);
  std::map<std::string, std::vector<double>> columns;
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells{line};
    std::string cell;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (columns.size() <= i && (columns.empty() || columns[names.front()].empty())) {
        names.push_back(cell);
        columns[cell] = {};
      } else {
        columns[names[i]].push_back(std::stod(cell));
      }
    }
  }
  return columns;
}

/// The shipped air with LOWTRAN7's carbon dioxide.
inline atmosphere::Layered lowtran_air(const std::string& profile, atmosphere::AerosolType haze) {
  using namespace atmosphere;
  const std::string folder = NADIR_SOURCE_DIR "/scenes/library/atmosphere";
  static const auto gases = std::make_shared<const BandTables>(read_band_tables(folder));
  static const auto particles =
      std::make_shared<const ParticleTables>(read_particle_tables(folder + "/particles.txt"));
  const auto dark = spectral::Curve::constant(0.0);
  Layered air{gases, particles,         standard_profile(*gases, profile, 330.0), 0.0, {},
              {},    {dark, dark, dark}};
  air.aerosol.type = haze;
  return air;
}

}  // namespace nadir::sim::test
