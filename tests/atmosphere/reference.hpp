#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace nadir::atmosphere::support {

/// Transmittances of LOWTRAN7 (tests/atmosphere/data/lowtran7_transmittance.csv): 1,626 wavenumbers
/// from 500 to 33,000 cm^-1, carbon dioxide 330 ppmv. Paths: <profile>_clear (0 to 100 km,
/// molecules only, for the six standard profiles), us_rural23, mls_urban5, mls_rural23_60deg,
/// mls_air3km, us_horiz5km (with haze).
struct Reference {
  std::vector<double> wavenumber;  ///< cm^-1
  std::vector<double> transmittance;
};

inline Reference lowtran7(const std::string& path) {
  std::ifstream file{NADIR_SOURCE_DIR "/tests/atmosphere/data/lowtran7_transmittance.csv"};
  if (!file) throw std::runtime_error("no reference figures");
  Reference reference;
  std::size_t column = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> cells;
    std::istringstream stream{line};
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (column == 0) {  // the names
      while (column < cells.size() && cells[column] != path) ++column;
      if (column == cells.size()) throw std::runtime_error("no reference path " + path);
      continue;
    }
    reference.wavenumber.push_back(std::stod(cells[0]));
    reference.transmittance.push_back(std::stod(cells[column]));
  }
  return reference;
}

}  // namespace nadir::atmosphere::support
