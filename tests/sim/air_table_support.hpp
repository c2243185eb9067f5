#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/air_table.hpp"
#include "sim/files/hash.hpp"

// Small tables of the air for the tests of their files.

namespace nadir::sim::support {

/// Numbers that differ from one another and use all of a float's digits.
inline std::vector<float> some(std::size_t count, float first) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = first / (1.0F + 0.37F * static_cast<float>(i));
  }
  return values;
}

inline atmosphere::AirTable::View some_view(const atmosphere::AirTable& table, double height_m,
                                            std::vector<double> zenith, std::vector<double> share) {
  atmosphere::AirTable::View view;
  view.height_m = height_m;
  view.zenith_rad = std::move(zenith);
  view.azimuth_rad = {0.0, 1.0, std::numbers::pi};
  view.share = std::move(share);
  const std::size_t all = view.places() * table.lanes.size(), bodies = table.bodies.size();
  view.extinction = some(all, 1.1e-5F);
  view.first = some(bodies * static_cast<std::size_t>(table.kinds) * all, 3.0F);
  view.smooth = some(bodies * view.azimuth_rad.size() * all, -0.7F);
  view.even = some(all, 9.9F);
  view.ground = some(all, 0.123F);
  return view;
}

/// Every part of a table has something in it.
inline atmosphere::AirTable some_table() {
  atmosphere::AirTable table;
  table.lanes = {{0.55, {0.545, 0.555, 0}, 0.1}, {0.55, {0.545, 0.555, 1}, 0.9}, {10.1, {}, 1.0}};
  table.ground_m = 120.5;
  table.top_m = 1e5;
  table.bodies = {{"sun", 0.7, 1.0 / 3.0, some(3, 1900.0F), some(3, 0.8F), some(3, 900.0F)},
                  {"moon", 1.2, 5.0, some(3, 5e-3F), some(3, 0.6F), some(3, 1e-3F)}};
  table.kinds = 2;
  for (int i = 0; i <= 4; ++i) table.phase_grid.push_back(0.25 * i);
  table.phase = some(2 * 5 * 3, 7.0F);
  table.sky = some_view(table, 120.5, {0.0, 0.5, 1.5}, {1.0});
  const double horizon = std::acos(atmosphere::horizon_mu(120.5, 3000.0));
  table.views = {some_view(table, 3000.0, {0.1, horizon, horizon, 3.0}, {0.25, 1.0})};
  table.spherical_albedo = some(3, 0.2F);
  table.even_ground_irradiance = some(3, 25.0F);
  table.night_top = some(3, 1e-6F);
  table.made_by = "a test, with = signs and \\ back\nslashes";
  table.notes = {"first", "", " second with blanks "};
  table.interpolation_error = 0.1;
  return table;
}

/// A file's text changed: `from` once by `to`, and its checksum made anew where `seal`.
inline std::string changed(std::string bytes, const std::string& from, const std::string& to) {
  const std::size_t at = bytes.find(from);
  if (at == std::string::npos) return "not found: " + from;
  bytes.replace(at, from.size(), to);
  return bytes;
}
inline std::string sealed(std::string bytes) {
  const std::string key = "head_sha256 = ";
  const std::size_t at = bytes.find(key);
  if (at == std::string::npos) return bytes;
  return bytes.replace(at + key.size(), 64, digest_bytes(bytes.substr(0, at)).sha256);
}

}  // namespace nadir::sim::support
