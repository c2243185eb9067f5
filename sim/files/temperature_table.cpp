#include "sim/files/temperature_table.hpp"

#include <algorithm>
#include <optional>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

constexpr double hottest_k = 6000.0;  // as for temperatures in scenario files

std::vector<Token> split_line(std::string_view line, int number) {
  std::vector<Token> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::string_view whole = line.substr(begin, end - begin), text = without_blanks(whole);
    cells.push_back({text.empty() ? whole.substr(0, 0) : text, line, number});
    begin = end + 1;
  }
  return cells;
}

class TemperatureTableReader {
 public:
  TemperatureTableReader(std::string_view text, const std::string& name, const std::string& column)
      : rest_{text}, wanted_{column}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    table_.name = name;
  }

  TemperatureTable read() {
    const std::vector<Token> names = next_row();
    if (names.empty()) issues_.add("the table is empty: its first row names the columns");
    issues_.throw_if_any();
    find_columns(names);
    issues_.throw_if_any();  // without its columns every row would be a mistake
    for (auto cells = next_row(); !cells.empty(); cells = next_row()) {
      if (cells.size() == names.size()) {
        read_row(cells);
      } else {
        issues_.add(cells.front(), "expected " + std::to_string(names.size()) + " cells, found " +
                                       std::to_string(cells.size()));
      }
    }
    if (table_.time.empty() && issues_.empty()) issues_.add("the table has no rows");
    issues_.throw_if_any();
    return std::move(table_);
  }

 private:
  std::vector<Token> next_row() {
    while (!rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++line_;
      const std::string_view content = without_blanks(line);
      if (!content.empty() && content.front() != '#') return split_line(line, line_);
    }
    return {};
  }

  void find_columns(const std::vector<Token>& names) {
    time_ = place_of(names, "utc");
    if (time_ == names.size()) missing(names, "utc");
    if (!wanted_.empty()) {
      value_ = place_of(names, wanted_);
      if (value_ == names.size()) missing(names, wanted_);
      const bool kelvin = wanted_.ends_with("_k");
      celsius_ = wanted_.ends_with("_c");
      if (!kelvin && !celsius_) {
        issues_.add("the name of column " + in_quotes(wanted_) +
                    " must end in _k or _c, which tells its unit");
      }
      return;
    }
    value_ = place_of(names, "temperature_k");
    if (value_ < names.size()) return;
    celsius_ = true;
    value_ = place_of(names, "temperature_c");
    if (value_ == names.size()) missing(names, "temperature_k or temperature_c");
  }

  std::size_t place_of(const std::vector<Token>& names, std::string_view wanted) {
    const auto is_wanted = [&](const Token& name) { return name.text == wanted; };
    const auto found = std::find_if(names.begin(), names.end(), is_wanted);
    if (found != names.end()) {
      const auto again = std::find_if(found + 1, names.end(), is_wanted);
      if (again != names.end()) {
        issues_.add(*again, "the column " + in_quotes(wanted) + " is there twice");
      }
    }
    return static_cast<std::size_t>(found - names.begin());
  }

  void missing(const std::vector<Token>& names, const std::string& wanted) {
    std::vector<std::string> there;
    for (const Token& name : names) there.emplace_back(name.text);
    const std::string nearest = nearest_name(wanted, there);
    issues_.add(names.front(), "there is no column " + wanted,
                nearest.empty() ? "" : "did you mean " + in_quotes(nearest) + "?");
  }

  void read_row(const std::vector<Token>& cells) {
    const auto time = time_of(cells[time_]);
    const auto kelvin = kelvin_of(cells[value_]);
    if (!time || !kelvin) return;
    if (!table_.time.empty() && (*time - table_.time.back()).value <= 0.0) {
      issues_.add(cells[time_],
                  "times must ascend: this one follows " + table_.time.back().to_string());
      return;
    }
    table_.time.push_back(*time);
    table_.kelvin.push_back(*kelvin);
  }

  std::optional<ephemeris::Instant> time_of(const Token& cell) {
    try {
      return ephemeris::Instant::parse_utc(cell.text);
    } catch (const InputError& error) {
      for (const InputIssue& issue : error.issues()) issues_.add(cell, issue.message, issue.hint);
      return std::nullopt;
    }
  }

  std::optional<double> kelvin_of(const Token& cell) {
    const auto value = strict_number_in<double>(cell.text);
    if (!value) {
      issues_.add(cell, "expected a finite temperature, found " + in_quotes(cell.text));
      return std::nullopt;
    }
    const double kelvin = *value + (celsius_ ? si::zero_celsius : 0.0);
    if (kelvin >= 0.0 && kelvin <= hottest_k) return kelvin;
    issues_.add(cell,
                "the temperature " + number_text(kelvin) + " K is not from 0 to " +
                    number_text(hottest_k) + " K",
                celsius_ || kelvin > 0.0 ? "" : "a column in degrees Celsius ends in _c");
    return std::nullopt;
  }

  std::string_view rest_;
  std::string wanted_;
  FileIssues issues_;
  int line_ = 0;
  std::size_t time_ = 0, value_ = 0;
  bool celsius_ = false;
  TemperatureTable table_;
};

}  // namespace

Kelvin TemperatureTable::at(const ephemeris::Instant& moment) const {
  const auto seconds_to = [&](const ephemeris::Instant& t) { return (t - moment).value; };
  if (seconds_to(time.front()) > 0.0 || seconds_to(time.back()) < 0.0) {
    throw InputError{InputIssue{{name, 0, 0},
                                "the table runs from " + time.front().to_string() + " to " +
                                    time.back().to_string() + ", which does not cover " +
                                    moment.to_string(),
                                {},
                                {}}};
  }
  const auto after =
      std::find_if(time.begin(), time.end(), [&](const auto& t) { return seconds_to(t) >= 0.0; });
  const auto i = static_cast<std::size_t>(after - time.begin());
  if (i == 0) return Kelvin{kelvin.front()};
  const double share = -seconds_to(time[i - 1]) / (time[i] - time[i - 1]).value;
  return Kelvin{kelvin[i - 1] + share * (kelvin[i] - kelvin[i - 1])};
}

TemperatureTable parse_temperature_table(std::string_view text, const std::string& name,
                                         const std::string& column) {
  return TemperatureTableReader{text, name, column}.read();
}

TemperatureTable read_temperature_table(const std::filesystem::path& file,
                                        const std::string& column) {
  const std::string text = read_bytes(file);
  return parse_temperature_table(text, file.string(), column);
}

}  // namespace nadir::sim
