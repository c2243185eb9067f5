#include "ephemeris/site.hpp"

#include <array>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "ephemeris/number_text.hpp"

namespace nadir::ephemeris {
namespace {

struct Coordinate {
  const char* name;
  const char* unit;
  double value, lowest, highest;
};

InputIssue outside(const Coordinate& c) {
  InputIssue issue;
  issue.message = std::string{"site "} + c.name + " is " + number_text(c.value) + c.unit +
                  ", allowed range is [" + number_text(c.lowest) + ", " + number_text(c.highest) +
                  "]";
  return issue;
}

}  // namespace

Site checked(const Site& site) {
  const std::array<Coordinate, 3> coordinates{{
      {"latitude", " deg", site.latitude_deg, -90.0, 90.0},
      {"longitude", " deg", site.longitude_deg, -180.0, 360.0},
      {"height", " m", site.height_m, -12e3, 1000e3},
  }};
  std::vector<InputIssue> issues;
  for (const Coordinate& c : coordinates) {
    const bool inside = c.value >= c.lowest && c.value <= c.highest;  // false for NaN
    if (!inside) issues.push_back(outside(c));
  }
  if (!issues.empty()) throw InputError{std::move(issues)};
  return site;
}

}  // namespace nadir::ephemeris
