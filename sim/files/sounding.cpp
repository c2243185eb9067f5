#include "sim/files/sounding.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "sim/files/number_table.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {

namespace {

using atmosphere::Gas;
using atmosphere::Level;
using atmosphere::Profile;

constexpr std::array<const char*, 4> humidity_columns{"relative_humidity_percent", "dewpoint_c",
                                                      "mixing_ratio_g_kg", "h2o_ppmv"};
/// Radiosondes report a little more than saturation now and then; clouds and fog are saturated.
constexpr double most_humidity = 1.02;

std::vector<NumberColumn> known_columns() {
  return {{"height_m", true, -500.0, 1e5},
          {"pressure_hpa", true, 1e-4, 1100.0},
          {"temperature_k", false, 150.0, 340.0},
          {"temperature_c", false, 150.0 - si::zero_celsius, 340.0 - si::zero_celsius},
          {"relative_humidity_percent", false, 0.0, 100.0 * most_humidity},
          {"dewpoint_c", false, -120.0, 60.0},
          {"mixing_ratio_g_kg", false, 0.0, 100.0},
          {"h2o_ppmv", false, 0.0, 2e5},
          {"o3_ppmv", false, 0.0, 100.0}};
}

/// The lines of the text, to show with a mistake and to place it.
class Places {
 public:
  Places(std::string_view text, FileIssues& issues) : issues_{issues} {
    while (!text.empty()) lines_.push_back(take_line(text));
    for (const std::string_view line : lines_) {
      if (!without_blanks(line).empty() && without_blanks(line).front() != '#') {
        header_ = line;
        break;
      }
    }
  }
  /// A mistake in a cell of a row: the column is found by its name.
  void report(int line, std::string_view column, std::string message) const {
    const std::string_view text = lines_[static_cast<std::size_t>(line - 1)];
    std::size_t header_begin = 0, begin = 0;
    while (without_blanks(cell(header_, header_begin)) != column &&
           header_.find(',', header_begin) != std::string_view::npos) {
      header_begin = header_.find(',', header_begin) + 1;
      begin = text.find(',', begin) + 1;
    }
    const std::string_view at = without_blanks(cell(text, begin));
    issues_.add({at.empty() ? text.substr(begin, 0) : at, text, line}, std::move(message));
  }

 private:
  static std::string_view cell(std::string_view line, std::size_t begin) {
    return line.substr(begin, line.find(',', begin) - begin);
  }
  FileIssues& issues_;
  std::vector<std::string_view> lines_;
  std::string_view header_;
};

/// Which of some columns a table has; an issue where it is not just one.
std::string only_one_of(const NumberTable& table, const std::vector<std::string>& columns,
                        FileIssues& issues) {
  std::string found, all;
  int count = 0;
  for (const std::string& column : columns) {
    all += (all.empty() ? "" : ", ") + column;
    if (!table.has(column)) continue;
    found = column;
    ++count;
  }
  if (count != 1) {
    issues.add("expected one of the columns " + all + ", found " +
               (count == 0 ? std::string{"none"} : std::to_string(count)));
  }
  return found;
}

/// Share of water among all molecules, from a column of humidity.
double water_share(const std::string& column, double value, const Level& level) {
  constexpr double dry_to_water_mass = 0.62198;  // of a molecule: 18.015 / 28.965
  const double saturation = atmosphere::saturation_pressure_hpa(level.temperature_k);
  if (column == "relative_humidity_percent") return 1e-2 * value * saturation / level.pressure_hpa;
  if (column == "dewpoint_c") {
    return atmosphere::saturation_pressure_hpa(value + si::zero_celsius) / level.pressure_hpa;
  }
  if (column == "mixing_ratio_g_kg") return 1e-3 * value / (dry_to_water_mass + 1e-3 * value);
  return 1e-6 * value;
}

/// Height difference over the one that hydrostatic balance gives to the pressures, with the mean
/// virtual temperature; less 1.
double imbalance(const Level& below, const Level& above) {
  constexpr double gas_constant = 287.05;  // of dry air, J kg^-1 K^-1
  constexpr double gravity = 9.80665;
  const auto virtual_temperature = [](const Level& l) {
    return l.temperature_k * (1.0 + 0.378 * l.mixing(Gas::h2o) * 1e-6);
  };
  const double mean = 0.5 * (virtual_temperature(below) + virtual_temperature(above));
  // Gravity falls with the square of the distance from the earth's centre.
  const double height = 0.5 * (below.height_m + above.height_m);
  const double here = gravity * std::pow(6.371e6 / (6.371e6 + height), 2);
  const double expected =
      gas_constant * mean / here * std::log(below.pressure_hpa / above.pressure_hpa);
  return (above.height_m - below.height_m) / expected - 1.0;
}

/// One row as a level, with its mistakes reported.
Level level_of(const NumberTable& table, const NumberTable::Row& row, const Profile& standard,
               const std::string& humidity, const Places& places) {
  const double height = table.value(row, "height_m", 0.0);
  Level level = level_at(
      standard, std::max(height, standard.levels.front().height_m - standard.reaches_below_m));
  level.height_m = height;
  level.pressure_hpa = table.value(row, "pressure_hpa", 0.0);
  level.temperature_k = table.has("temperature_k")
                            ? table.value(row, "temperature_k", 0.0)
                            : table.value(row, "temperature_c", 0.0) + si::zero_celsius;
  level.mixing(Gas::h2o) = 1e6 * water_share(humidity, table.value(row, humidity, 0.0), level);
  if (table.has("o3_ppmv")) level.mixing(Gas::o3) = table.value(row, "o3_ppmv", 0.0);
  const double found = relative_humidity(level);
  if (found > most_humidity) {
    places.report(row.line, humidity,
                  "the humidity lies above saturation: " + number_text(std::round(100.0 * found)) +
                      " % of what air of this temperature holds");
  }
  return level;
}

void check_order(const Level& below, const Level& above, int line, const Places& places) {
  if (above.height_m <= below.height_m) {
    places.report(line, "height_m",
                  "heights must ascend: " + number_text(above.height_m) + " m follows " +
                      number_text(below.height_m) + " m");
  }
  if (above.pressure_hpa >= below.pressure_hpa) {
    places.report(line, "pressure_hpa",
                  "pressures must fall with height: " + number_text(above.pressure_hpa) +
                      " hPa follows " + number_text(below.pressure_hpa) + " hPa");
  }
}

/// The layer below a level against hydrostatic balance: refused above 20 %, told above 5 %.
/// Close levels are given in rounded pressures: 0.5 m or 0.05 hPa may be amiss at either end.
void check_balance(const Level& below, const Level& above, int line, const Places& places,
                   const std::string& name, Diagnostics& diagnostics) {
  if (above.height_m <= below.height_m || above.pressure_hpa >= below.pressure_hpa) return;
  const double rounding =
      1.0 / (above.height_m - below.height_m) + 0.1 / (below.pressure_hpa - above.pressure_hpa);
  const double off = imbalance(below, above);
  const std::string text = number_text(std::round(100.0 * off)) + " %";
  if (std::abs(off) > 0.20 + rounding) {
    places.report(line, "height_m",
                  "heights and pressures disagree: the layer below is thicker by " + text +
                      " than its pressures and temperatures allow");
  } else if (std::abs(off) > 0.05 + rounding) {
    diagnostics.warn(name + ": heights and pressures disagree by " + text + " below " +
                     number_text(above.height_m) + " m");
  }
}

/// What lies above the sounding: the standard profile, its pressure scaled to join, beginning a
/// kilometre above so that temperature has room to change.
void add_above(Profile& profile, const Profile& standard) {
  constexpr double room_m = 1000.0;
  const Level& top = profile.levels.back();
  if (top.height_m + room_m >= standard.levels.back().height_m) return;
  const double scale =
      top.pressure_hpa /
      level_at(standard, std::max(top.height_m, standard.levels.front().height_m)).pressure_hpa;
  const double from = top.height_m + room_m;
  for (Level level : standard.levels) {
    if (level.height_m < from) continue;
    level.pressure_hpa *= scale;
    profile.levels.push_back(level);
  }
}

}  // namespace

Profile parse_sounding(std::string_view text, const std::string& name, const Profile& standard,
                       Diagnostics& diagnostics) {
  const NumberTable table{text, name, known_columns()};
  FileIssues issues{name};
  const Places places{text, issues};
  static_cast<void>(only_one_of(table, {"temperature_k", "temperature_c"}, issues));
  const std::string humidity =
      only_one_of(table, {humidity_columns.begin(), humidity_columns.end()}, issues);
  if (table.rows().size() < 2) issues.add("a sounding needs at least two rows");
  issues.throw_if_any();

  Profile profile{name, {}, 0.0};
  for (const NumberTable::Row& row : table.rows()) {
    const Level level = level_of(table, row, standard, humidity, places);
    if (!profile.levels.empty()) {
      check_order(profile.levels.back(), level, row.line, places);
      check_balance(profile.levels.back(), level, row.line, places, name, diagnostics);
    }
    profile.levels.push_back(level);
  }
  issues.throw_if_any();
  add_above(profile, standard);
  check(profile);
  return profile;
}

Profile read_sounding(const std::filesystem::path& file, const Profile& standard,
                      Diagnostics& diagnostics) {
  const std::string text = read_bytes(file);
  return parse_sounding(text, file.string(), standard, diagnostics);
}

}  // namespace nadir::sim
