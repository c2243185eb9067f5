#include "sim/files/brdf_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/quantity.hpp"
#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

constexpr std::string_view brdf_version_line = "# nadir-brdf:";

struct Key {
  std::string_view name;
  bool required;
  bool repeats;
};
constexpr std::array<Key, 8> known_keys{{{"nadir-brdf", true, false},
                                         {"title", true, false},
                                         {"quantity", true, false},
                                         {"zero-azimuth", true, false},
                                         {"wavelength", true, false},
                                         {"source", true, true},
                                         {"licence", true, true},
                                         {"note", false, true}}};

struct AngleColumn {
  std::string_view name;
  double most_deg;
};
constexpr std::array<AngleColumn, 3> angle_columns{
    {{"incidence_deg", 90.0}, {"view_deg", 90.0}, {"relative_azimuth_deg", 180.0}}};

/// Angles of one row in degrees, as they stand in the file.
using Angles = std::array<double, 3>;

std::string text_of(const Angles& angles) {
  return "incidence " + number_text(angles[0]) + ", view " + number_text(angles[1]) +
         ", relative azimuth " + number_text(angles[2]);
}

struct Row {
  Angles angles{};
  std::vector<float> values;
  Token at;  ///< its first cell
};

/// Reads one file, line by line, and gathers its mistakes.
class BrdfParser {
 public:
  BrdfParser(std::string_view text, const std::string& name)
      : rest_{text}, name_{name}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    if (!rest_.starts_with(brdf_version_line)) {
      issues_.add("the first line of a measured reflectance is \"# nadir-brdf: 1\"");
    }
    issues_.throw_if_any();  // a file of another kind
  }

  BrdfFile parse() {
    while (!rest_.empty()) {
      line_text_ = take_line(rest_);
      ++line_;
      read_line();
      if (bad_columns_) break;  // without sound columns every row would be a mistake
    }
    if (!have_columns_ && issues_.empty()) issues_.add("the file has no row of column names");
    issues_.throw_if_any();
    build();
    issues_.throw_if_any();
    return std::move(file_);
  }

 private:
  void read_line() {
    if (without_blanks(line_text_).empty()) return;
    if (line_text_.front() == '#') {
      read_header_line();
    } else if (!have_columns_) {
      check_header();
      read_columns();
    } else {
      read_row();
    }
  }

  [[nodiscard]] Token token(std::string_view text) const { return {text, line_text_, line_}; }

  [[nodiscard]] std::vector<Token> cells() const {
    std::vector<Token> found;
    for (std::size_t begin = 0; begin <= line_text_.size();) {
      const std::size_t end = std::min(line_text_.find(',', begin), line_text_.size());
      std::string_view text = without_blanks(line_text_.substr(begin, end - begin));
      if (text.empty()) text = line_text_.substr(begin, 0);  // keeps its place
      found.push_back(token(text));
      begin = end + 1;
    }
    return found;
  }

  // ---- header ------------------------------------------------------------------------------

  void read_header_line() {
    if (have_columns_) {
      return issues_.add(token(line_text_.substr(0, 1)),
                         "a header line must stand above the row of column names");
    }
    const std::size_t colon = line_text_.find(':');
    if (colon == std::string_view::npos) {
      return issues_.add(token(line_text_.substr(0, 1)), "expected a header line \"# key: value\"");
    }
    const Token key = token(without_blanks(line_text_.substr(1, colon - 1)));
    const Token value = token(without_blanks(line_text_.substr(colon + 1)));
    const auto* const known = std::find_if(known_keys.begin(), known_keys.end(),
                                           [&](const Key& k) { return k.name == key.text; });
    if (known == known_keys.end()) return unknown_key(key);
    if (!known->repeats && std::find(seen_.begin(), seen_.end(), key.text) != seen_.end()) {
      return issues_.add(key, "header key " + in_quotes(key.text) + " is given twice");
    }
    seen_.push_back(key.text);
    if (value.text.empty()) {
      return issues_.add(token(line_text_.substr(0, 1)),
                         "header key " + in_quotes(key.text) + " has no value");
    }
    keep(key.text, value);
  }

  void unknown_key(const Token& key) {
    std::vector<std::string> names;
    for (const Key& k : known_keys) names.emplace_back(k.name);
    const std::string nearest = nearest_name(std::string{key.text}, names);
    issues_.add(key.text.empty() ? token(line_text_.substr(0, 1)) : key,
                "unknown header key " + in_quotes(key.text),
                nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
  }

  static void append(std::string& text, std::string_view more) {
    text += (text.empty() ? "" : "; ") + std::string{more};
  }

  void keep(std::string_view key, const Token& value) {
    if (key == "title") file_.title = value.text;
    if (key == "source") append(file_.source, value.text);
    if (key == "licence") append(file_.licence, value.text);
    if (key == "nadir-brdf") (void)one_of(value, {"1"});
    if (key == "wavelength") (void)one_of(value, {"um, vacuum"});
    // a reflectance factor is relative to a white Lambertian surface, whose f is 1 / pi
    if (key == "quantity" && one_of(value, {"brdf", "reflectance_factor"}) == 1) {
      scale_ = std::numbers::inv_pi;
    }
    if (key == "zero-azimuth") forward_is_zero_ = one_of(value, {"backward", "forward"}) == 1;
  }

  std::size_t one_of(const Token& value, const std::vector<std::string_view>& allowed) {
    const auto found = std::find(allowed.begin(), allowed.end(), value.text);
    if (found == allowed.end()) {
      std::string expected = in_quotes(allowed.front());
      for (std::size_t i = 1; i < allowed.size(); ++i) expected += " or " + in_quotes(allowed[i]);
      issues_.add(value, "found " + in_quotes(value.text) + ", expected " + expected);
    }
    return static_cast<std::size_t>(found - allowed.begin());
  }

  void check_header() {
    for (const Key& key : known_keys) {
      if (!key.required || std::find(seen_.begin(), seen_.end(), key.name) != seen_.end()) continue;
      issues_.add("header line \"# " + std::string{key.name} + ": ...\" is missing");
    }
  }

  // ---- columns and rows ----------------------------------------------------------------------

  void read_columns() {
    have_columns_ = true;
    const std::vector<Token> names = cells();
    for (std::size_t i = 0; i < angle_columns.size(); ++i) {
      if (i < names.size() && names[i].text == angle_columns[i].name) continue;
      issues_.add(names[std::min(i, names.size() - 1)],
                  "the first columns are incidence_deg, view_deg and relative_azimuth_deg");
      bad_columns_ = true;
      return;
    }
    for (std::size_t i = angle_columns.size(); i < names.size(); ++i) add_wavelength(names[i]);
    if (names.size() == angle_columns.size()) {
      issues_.add(names.back(), "there is no wavelength after the angles");
      bad_columns_ = true;
    }
  }

  void add_wavelength(const Token& cell) {
    std::vector<double>& all = file_.table.wavelength_um;
    const auto um = strict_number_in<double>(cell.text);
    if (!um || *um <= 0.0) {
      issues_.add(
          cell, "expected a wavelength in um as the column's name, found " + in_quotes(cell.text));
      bad_columns_ = true;
    } else if (!all.empty() && *um <= all.back()) {
      issues_.add(
          cell, "wavelength " + std::string{cell.text} + " is not greater than the one before it");
      bad_columns_ = true;
    } else {
      all.push_back(*um);
    }
  }

  void read_row() {
    const std::vector<Token> row = cells();
    const std::size_t expected = angle_columns.size() + file_.table.wavelength_um.size();
    if (row.size() != expected) {
      return issues_.add(row.front(), "expected " + std::to_string(expected) + " cells, found " +
                                          std::to_string(row.size()));
    }
    Row read;
    read.at = row.front();
    bool sound = true;
    for (std::size_t i = 0; i < row.size(); ++i) {
      sound = (i < 3 ? read_angle(row[i], i, read.angles[i]) : read_value(row[i], read.values)) &&
              sound;
    }
    if (sound) keep_row(std::move(read));
  }

  bool read_angle(const Token& cell, std::size_t column, double& angle) {
    const auto [name, most] = angle_columns[column];
    const auto number = strict_number_in<double>(cell.text);
    if (!number || *number < 0.0 || *number > most) {
      issues_.add(cell, std::string{name} + " is " + in_quotes(cell.text) + "; 0 to " +
                            number_text(most) + " is allowed");
      return false;
    }
    angle = *number;
    return true;
  }

  bool read_value(const Token& cell, std::vector<float>& values) {
    const auto number = strict_number_in<double>(cell.text);
    if (!number || *number < 0.0 || *number > 1e6) {  // beyond any measured peak, within a float
      issues_.add(
          cell, "the reflectance is " + in_quotes(cell.text) + "; expected a number from 0 to 1e6");
      return false;
    }
    values.push_back(static_cast<float>(*number * scale_));
    return true;
  }

  void keep_row(Row row) {
    if (!rows_.empty() && row.angles == rows_.back().angles) {
      return issues_.add(row.at, text_of(row.angles) + " is there twice");
    }
    if (!rows_.empty() && row.angles < rows_.back().angles) {
      return issues_.add(row.at,
                         text_of(row.angles) + " comes after " + text_of(rows_.back().angles),
                         "sort the rows by incidence, then view, then azimuth");
    }
    rows_.push_back(std::move(row));
  }

  // ---- table ---------------------------------------------------------------------------------

  [[nodiscard]] std::vector<double> axis(std::size_t column) const {
    std::vector<double> all;
    for (const Row& row : rows_) all.push_back(row.angles[column]);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  void build() {
    if (rows_.empty()) return issues_.add("the file has no rows");
    const std::vector<double> incidences = axis(0), views = axis(1), azimuths = axis(2);
    for (const double incidence : incidences) {
      for (const double view : views) add_group(incidence, view, azimuths);
    }
    if (!issues_.empty()) return;
    materials::BrdfTable& table = file_.table;
    for (const double angle : incidences) table.incidence_rad.push_back(angle * radians_per_degree);
    for (const double angle : views) table.view_rad.push_back(angle * radians_per_degree);
    for (const double angle : azimuths) {
      table.azimuth_rad.push_back((forward_is_zero_ ? 180.0 - angle : angle) * radians_per_degree);
    }
    if (forward_is_zero_) std::reverse(table.azimuth_rad.begin(), table.azimuth_rad.end());
    try {
      materials::check(table);
    } catch (const InputError& error) {
      throw error.located({name_, 0, 0}, {});
    }
  }

  [[nodiscard]] bool in_group(std::size_t row, double incidence, double view) const {
    return row < rows_.size() && rows_[row].angles[0] == incidence && rows_[row].angles[1] == view;
  }

  /// Appends the values of one pair of zenith angles, all azimuths. A pair with a vertical
  /// direction may have a single row, which then stands for all azimuths.
  void add_group(double incidence, double view, const std::vector<double>& azimuths) {
    const std::size_t begin = next_row_;
    while (in_group(next_row_, incidence, view)) ++next_row_;
    const bool any_azimuth = next_row_ - begin == 1 && (incidence == 0.0 || view == 0.0);
    std::vector<std::size_t> group(any_azimuth ? azimuths.size() : 0, begin);
    for (std::size_t row = begin, a = 0; !any_azimuth && a < azimuths.size(); ++a) {
      if (row < next_row_ && rows_[row].angles[2] == azimuths[a]) {
        group.push_back(row++);
      } else {
        report_hole(row, {incidence, view, azimuths[a]});
      }
    }
    if (forward_is_zero_) std::reverse(group.begin(), group.end());
    std::vector<float>& all = file_.table.value;
    for (const std::size_t row : group) {
      all.insert(all.end(), rows_[row].values.begin(), rows_[row].values.end());
    }
  }

  void report_hole(std::size_t next, const Angles& missing) {
    const bool at_end = next >= rows_.size();
    issues_.add(
        at_end ? rows_.back().at : rows_[next].at,
        std::string{at_end ? "after" : "before"} + " here a row is missing: " + text_of(missing));
  }

  std::string_view rest_;
  std::string name_;
  FileIssues issues_;
  BrdfFile file_;
  std::string_view line_text_;
  int line_ = 0;
  std::vector<std::string_view> seen_;
  bool have_columns_ = false, bad_columns_ = false;
  bool forward_is_zero_ = false;
  double scale_ = 1.0;
  std::vector<Row> rows_;
  std::size_t next_row_ = 0;  // of `build`
};

}  // namespace

BrdfFile parse_brdf_file(std::string_view text, const std::string& name) {
  return BrdfParser{text, name}.parse();
}

BrdfFile read_brdf_file(const std::filesystem::path& file) {
  return parse_brdf_file(read_bytes(file), file.string());
}

}  // namespace nadir::sim
