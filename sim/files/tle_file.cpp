#include "sim/files/tle_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

constexpr std::size_t set_columns = 69;

/// The lines of one satellite, as they stand in the file.
struct ElementSet {
  std::string_view name;  // empty where there is none
  Token first, second;
};

/// Columns of a line, counted from 1 as in the format's description.
Token columns(const Token& line, std::size_t first, std::size_t last) {
  return {line.line_text.substr(first - 1, last - first + 1), line.line_text, line.line};
}
Token trimmed_columns(const Token& line, std::size_t first, std::size_t last) {
  Token field = columns(line, first, last);
  if (const std::string_view inner = without_blanks(field.text); !inner.empty()) field.text = inner;
  return field;
}

bool starts_as(const Token& line, char number) {
  return line.text.size() > 1 && line.text[0] == number && line.text[1] == ' ';
}

/// Sum of the digits, a minus counting 1, modulo 10.
int checksum_of(std::string_view text) {
  int sum = 0;
  for (const char c : text) {
    if (c >= '0' && c <= '9') sum += c - '0';
    if (c == '-') ++sum;
  }
  return sum % 10;
}

/// Reads fields of one set and gathers what is wrong with them.
class SetReader {
 public:
  explicit SetReader(FileIssues& issues) : issues_{issues} {}

  /// A line's length and checksum. @return whether its columns can be read
  bool has_columns(const Token& line) {
    if (line.text.size() != set_columns) {
      issues_.add(line, "a line of two-line elements has 69 columns, this one has " +
                            std::to_string(line.text.size()));
      return false;
    }
    const int found = line.text[68] - '0', sum = checksum_of(line.text.substr(0, 68));
    if (found != sum) {
      issues_.add(columns(line, 69, 69), "the checksum is " + in_quotes(line.text.substr(68)) +
                                             ", the line's is " + std::to_string(sum) +
                                             ": a digit has been changed");
    }
    return true;
  }

  struct Range {
    double least, most;
    const char* text;
  };
  double number(const Token& field, const char* what, const Range& range) {
    std::string_view text = field.text;
    if (text.size() > 1 && text[0] == '+') text.remove_prefix(1);
    return checked(strict_number_in<double>(text), field, what, range);
  }

  /// Digits with the point before them, and with an exponent: " 28098-4", "-30915-6".
  double with_exponent(const Token& field, const char* what) {
    std::string text{field.text};
    const bool negative = text[0] == '-';
    if (negative || text[0] == '+') text.erase(0, 1);
    const std::size_t sign = text.find_first_of("+-");
    std::optional<double> value;
    if (sign != std::string::npos && sign > 0) {
      const std::size_t skipped = text[sign] == '+' ? sign + 1 : sign;
      value = strict_number_in<double>("0." + text.substr(0, sign) + "e" + text.substr(skipped));
    }
    if (value && negative) value = -*value;
    return checked(value, field, what, {-1e9, 1e9, "digits, a sign and an exponent"});
  }

  /// Digits with the point before them; blanks are zeros.
  double decimals(const Token& field, const char* what) {
    std::string text = "0.";
    for (const char c : field.text) text += c == ' ' ? '0' : c;
    return checked(strict_number_in<double>(text), field, what, {0.0, 1.0, "seven digits"});
  }

  void add(const Token& at, const std::string& message) { issues_.add(at, message); }

 private:
  double checked(std::optional<double> value, const Token& field, const char* what,
                 const Range& range) {
    if (value && *value >= range.least && *value <= range.most) return *value;
    issues_.add(field,
                std::string{what} + " is " + in_quotes(field.text) + ", expected " + range.text);
    return 0.0;
  }

  FileIssues& issues_;
};

/// Five digits, or a letter (without I and O) and four: A0000 is 100000.
std::optional<int> catalogue_number(std::string_view text) {
  text = without_blanks(text);
  int thousands = 0;
  if (text.size() == 5 && text[0] >= 'A' && text[0] <= 'Z' && text[0] != 'I' && text[0] != 'O') {
    const char letter = text[0];
    thousands = letter - 'A' + 10 - (letter > 'I' ? 1 : 0) - (letter > 'O' ? 1 : 0);
    text.remove_prefix(1);
  }
  const std::optional<int> rest = strict_number_in<int>(text);
  if (!rest || *rest < 0) return std::nullopt;
  return 10000 * thousands + *rest;
}

std::string_view satellite_name(std::string_view line) {
  if (line.substr(0, 2) == "0 ") line.remove_prefix(2);
  return without_blanks(line);
}

/// Puts the lines of a file together to sets.
class SetCollector {
 public:
  explicit SetCollector(FileIssues& issues) : issues_{issues} {}

  void take(const Token& line) {
    if (starts_as(line, '1')) {
      end_alone();
      first_ = line;
    } else if (starts_as(line, '2')) {
      if (first_) {
        sets_.push_back({name_, *first_, line});
      } else {
        issues_.add(line, "line 2 of a set of elements without its line 1");
      }
      first_.reset();
      name_ = {};
    } else {
      end_alone();
      name_ = satellite_name(line.text);
    }
  }
  std::vector<ElementSet> sets() {
    end_alone();
    return std::move(sets_);
  }

 private:
  void end_alone() {
    if (first_) issues_.add(*first_, "line 1 of a set of elements without its line 2");
    first_.reset();
  }

  FileIssues& issues_;
  std::vector<ElementSet> sets_;
  std::optional<Token> first_;
  std::string_view name_;
};

std::vector<ElementSet> sets_of(std::string_view text, FileIssues& issues) {
  SetCollector collector{issues};
  for (int number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    if (!line.empty() && line[0] != '#') collector.take({line, line, number});
  }
  return collector.sets();
}

bool is_satellite(const ElementSet& set, const std::string& satellite) {
  if (set.name == satellite) return true;
  const std::optional<int> wanted = catalogue_number(satellite);
  return wanted && set.first.text.size() > 7 &&
         catalogue_number(set.first.text.substr(2, 5)) == wanted;
}

/// `the file has 25544 "ISS (ZARYA)", 5, and 3 more`.
std::string satellites_in(const std::vector<ElementSet>& sets) {
  constexpr std::size_t most = 8;
  std::string text = "the file has ";
  for (std::size_t i = 0; i < std::min(sets.size(), most); ++i) {
    if (i > 0) text += ", ";
    text += without_blanks(sets[i].first.text.substr(2, 5));
    if (!sets[i].name.empty()) text += " " + in_quotes(sets[i].name);
  }
  return sets.size() > most ? text + ", and " + std::to_string(sets.size() - most) + " more" : text;
}

std::string hint_for(const std::vector<ElementSet>& sets, const std::string& satellite) {
  std::vector<std::string> names;
  for (const ElementSet& set : sets) {
    if (!set.name.empty()) names.emplace_back(set.name);
  }
  const std::string nearest = nearest_name(satellite, names);
  return nearest.empty() ? satellites_in(sets) : "did you mean " + in_quotes(nearest) + "?";
}

const ElementSet& chosen_set(const std::vector<ElementSet>& sets, const std::string& file,
                             const std::string& satellite) {
  const auto refuse = [&](std::string message) {
    throw InputError{InputIssue{{file, 0, 0}, std::move(message), {}, {}}};
  };
  if (sets.empty()) refuse("there is no two-line element set in the file");
  // What was asked for is wrong, not the file: whoever asked knows where that stands.
  const auto refuse_wish = [](std::string message, std::string hint) {
    throw InputError{InputIssue{{}, std::move(message), std::move(hint), {}}};
  };
  if (satellite.empty() && sets.size() > 1) {
    refuse_wish(file + " has " + std::to_string(sets.size()) +
                    " element sets: say which by its name or catalogue number",
                satellites_in(sets));
  }
  if (satellite.empty()) return sets.front();
  const ElementSet* found = nullptr;
  for (const ElementSet& set : sets) {
    if (!is_satellite(set, satellite)) continue;
    if (found) {
      refuse("the file has more than one element set for " + in_quotes(satellite) + ", in lines " +
             std::to_string(found->first.line) + " and " + std::to_string(set.first.line) +
             ": keep the one whose epoch is nearest");
    }
    found = &set;
  }
  if (!found) {
    refuse_wish("there is no satellite " + in_quotes(satellite) + " in " + file,
                hint_for(sets, satellite));
  }
  return *found;
}

void read_first_line(const Token& line, SetReader& reader, sensor::TwoLineElements& set) {
  const Token number = trimmed_columns(line, 3, 7);
  const std::optional<int> known = catalogue_number(number.text);
  if (!known) {
    reader.add(number, "the catalogue number is " + in_quotes(number.text) +
                           ", expected five digits or a letter and four");
  }
  set.catalogue_number = known.value_or(0);
  set.designator = without_blanks(line.text.substr(9, 8));
  const int year = static_cast<int>(
      reader.number(trimmed_columns(line, 19, 20), "the epoch's year", {0.0, 99.0, "two digits"}));
  set.epoch_year = year + (year >= 57 ? 1900 : 2000);  // the first satellite is of 1957
  const bool leap = set.epoch_year % 4 == 0;           // so is 2000
  set.epoch_day =
      reader.number(trimmed_columns(line, 21, 32), "the epoch's day of the year",
                    {1.0, std::nextafter(leap ? 367.0 : 366.0, 0.0), "1 to the year's last day"});
  set.drag_term = reader.with_exponent(trimmed_columns(line, 54, 61), "the drag term B*");
  if (const char type = line.text[62]; type != '0' && type != ' ') {
    reader.add(columns(line, 63, 63), "the ephemeris type is " + in_quotes({&type, 1}) +
                                          ", expected 0: the elements are not for SGP4");
  }
}

void read_second_line(const Token& line, SetReader& reader, sensor::TwoLineElements& set) {
  constexpr SetReader::Range turn{0.0, 360.0, "0 to 360 degrees"};
  set.inclination_deg = reader.number(trimmed_columns(line, 9, 16), "the inclination",
                                      {0.0, 180.0, "0 to 180 degrees"});
  set.ascending_node_deg = reader.number(trimmed_columns(line, 18, 25), "the ascending node", turn);
  set.eccentricity = reader.decimals(columns(line, 27, 33), "the eccentricity");
  set.argument_of_perigee_deg =
      reader.number(trimmed_columns(line, 35, 42), "the argument of perigee", turn);
  set.mean_anomaly_deg = reader.number(trimmed_columns(line, 44, 51), "the mean anomaly", turn);
  set.mean_motion_rev_day = reader.number(trimmed_columns(line, 53, 63), "the mean motion",
                                          {1e-8, 18.0, "above 0, at most 18 revolutions a day"});
}

}  // namespace

sensor::TwoLineElements parse_two_line_elements(std::string_view text, const std::string& name,
                                                const std::string& satellite) {
  FileIssues issues{name};
  const std::vector<ElementSet> sets = sets_of(text, issues);
  issues.throw_if_any();
  const ElementSet& found = chosen_set(sets, name, satellite);

  SetReader reader{issues};
  const bool first = reader.has_columns(found.first), second = reader.has_columns(found.second);
  sensor::TwoLineElements set;
  if (first) read_first_line(found.first, reader, set);
  if (second) read_second_line(found.second, reader, set);
  if (first && second && found.first.text.substr(2, 5) != found.second.text.substr(2, 5)) {
    reader.add(columns(found.second, 3, 7),
               "line 2 is of " + in_quotes(found.second.text.substr(2, 5)) + ", line 1 of " +
                   in_quotes(found.first.text.substr(2, 5)));
  }
  issues.throw_if_any();
  return set;
}

sensor::TwoLineElements read_two_line_elements(const std::filesystem::path& file,
                                               const std::string& satellite) {
  const std::string text = read_bytes(file);
  return parse_two_line_elements(text, file.string(), satellite);
}

}  // namespace nadir::sim
