#include "sim/files/modtran_tape7.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "atmosphere/paths/spherical_path.hpp"
#include "core/error.hpp"
#include "core/quantity.hpp"
#include "sim/files/modtran_columns.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

std::vector<Token> words_of(const Token& line) {
  std::vector<Token> words;
  std::string_view rest = line.text;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    if (rest.empty()) return words;
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    words.push_back({word, line.line_text, line.line});
    rest.remove_prefix(word.size());
  }
}

/// A number as Fortran prints it: "2050.", "1.0E-07", and "1.0-107" where the exponent has three
/// digits.
std::optional<double> fortran_number(std::string_view word) {
  std::string text{word};
  if (text.starts_with('+')) text.erase(0, 1);
  const std::size_t sign = text.find_first_of("+-", 1);
  if (sign != std::string::npos && std::isdigit(static_cast<unsigned char>(text[sign - 1])) != 0) {
    text.insert(sign, "e");
  }
  std::replace(text.begin(), text.end(), 'D', 'e');
  return strict_number_in<double>(text);
}

/// The right edge of a word in its line, where Fortran aligns names and numbers.
std::size_t right_edge(const Token& word) {
  return static_cast<std::size_t>(word.text.data() - word.line_text.data()) + word.text.size();
}

bool has_radiance(const ModtranSpectrum& spectrum) {
  return std::find(spectrum.columns.begin(), spectrum.columns.end(), ModtranColumn::total) !=
         spectrum.columns.end();
}

struct Heading {
  std::vector<ModtranColumn> columns;
  std::vector<std::size_t> edges;
};

/// The cards before a run's columns.
struct Cards {
  std::vector<Token> lines;
};

class Tape7 {
 public:
  Tape7(std::string_view text, const std::string& name, const AirRunSettings& settings)
      : rest_{text}, name_{name}, issues_{name}, settings_{settings} {}

  AirRunSet read() {
    AirRunSet all;
    int count = 0;
    while (skip_blank_lines()) {
      ++count;
      const AirRunSet run = next_run(count);
      merge(all, run);
    }
    if (count == 0) issues_.add("the file is empty");
    issues_.throw_if_any();
    all.made_by = "MODTRAN tape7 " + name_;
    return all;
  }

 private:
  std::optional<Token> next_line() {
    if (rest_.empty()) return std::nullopt;
    const std::string_view text = take_line(rest_);
    return Token{text, text, ++line_};
  }

  bool skip_blank_lines() {
    while (!rest_.empty()) {
      std::string_view peek = rest_;
      if (!without_blanks(take_line(peek)).empty()) return true;
      rest_ = peek;
      ++line_;
    }
    return false;
  }

  [[noreturn]] void fail(const Token& at, const std::string& message) {
    issues_.add(at, message);
    issues_.throw_if_any();
    throw InputError{message};  // not reached
  }

  AirRunSet next_run(int count) {
    Cards cards;
    std::optional<Token> line;
    while ((line = next_line()) && !without_blanks(line->text).starts_with("FREQ")) {
      cards.lines.push_back(*line);
    }
    if (!line) {
      fail(cards.lines.back(), "the file ends before a line of column names, FREQ and others");
    }
    ModtranSpectrum spectrum{name_ + ", run " + std::to_string(count), {}, {}};
    const Heading heading = heading_of(*line);
    spectrum.columns = heading.columns;
    rows(heading, *line, spectrum);
    sun_zenith_.reset();
    const RunGeometry looks = geometry(cards, *line, spectrum);
    try {
      AirRunSet run = run_of_modtran(spectrum, looks, settings_);
      if (!run.sun_zenith_rad) run.sun_zenith_rad = sun_zenith_;
      return run;
    } catch (const InputError& error) {
      throw error.located({name_, line->line, 1}, std::string{line->text});
    }
  }

  /// Names of one word, or of two as MODTRAN 4 writes them.
  Heading heading_of(const Token& line) {
    Heading heading;
    const std::vector<Token> words = words_of(line);
    for (std::size_t i = 0; i < words.size(); ++i) {
      std::optional<ModtranColumn> column;
      if (i + 1 < words.size()) {
        const std::string both = std::string{words[i].text} + "_" + std::string{words[i + 1].text};
        column = modtran_column(both);
        if (column) ++i;
      }
      if (!column) column = modtran_column(words[i].text);
      heading.columns.push_back(column.value_or(ModtranColumn::other));
      heading.edges.push_back(right_edge(words[i]));
    }
    return heading;
  }

  void rows(const Heading& heading, const Token& at, ModtranSpectrum& spectrum) {
    while (const auto line = next_line()) {
      const std::vector<Token> words = words_of(*line);
      if (words.empty()) continue;
      if (words.front().text.starts_with("-9999")) return;
      if (words.front().text.starts_with("CM-1")) continue;  // the names' second line
      spectrum.rows.push_back(row(heading, words, spectrum));
    }
    fail(at, "the run has no end: a last line -9999. is missing");
  }

  std::vector<double> row(const Heading& heading, const std::vector<Token>& words,
                          const ModtranSpectrum& spectrum) {
    std::vector<double> cells(heading.columns.size(), std::nan(""));
    // Runs of the sun have a column more than names; of transmittance some names stick together.
    const bool in_order =
        words.size() == cells.size() || (!has_radiance(spectrum) && words.size() > cells.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (in_order && i >= cells.size()) break;
      const auto number = fortran_number(words[i].text);
      if (!number)
        fail(words[i], "expected a number, found \"" + std::string{words[i].text} + "\"");
      cells[in_order ? i : column_at(heading, words[i])] = *number;
    }
    return cells;
  }

  std::size_t column_at(const Heading& heading, const Token& word) {
    const auto found = std::find(heading.edges.begin(), heading.edges.end(), right_edge(word));
    if (found == heading.edges.end()) {
      fail(word, "this number stands under no column's name, and the row has not one for each");
    }
    return static_cast<std::size_t>(found - heading.edges.begin());
  }

  /// Numbers of a card, counted back from the line of names.
  std::vector<double> card(const Cards& cards, std::size_t before) {
    if (cards.lines.size() <= before) return {};
    std::vector<double> values;
    for (const Token& word : words_of(cards.lines[cards.lines.size() - before])) {
      const auto number = fortran_number(word.text);
      if (!number) break;
      values.push_back(*number);
    }
    return values;
  }

  RunGeometry geometry(const Cards& cards, const Token& names, const ModtranSpectrum& spectrum) {
    const std::vector<double> way = card(cards, 5);
    if (way.size() < 4)
      fail(names,
           "the fifth line before the names of the columns has no H1, H2, "
           "ANGLE and RANGE: this is no echo of MODTRAN's cards");
    const std::string_view first = cards.lines.front().text;
    const auto type =
        strict_number_in<int>(first.size() < 10 ? "" : without_blanks(first.substr(5, 5)));
    RunGeometry result;
    result.height_m = way[0] * 1e3;
    result.zenith_rad = way[2] * radians_per_degree;
    if (!type || *type < 1 || *type > 3) {
      fail(cards.lines.front(), "columns 6 to 10 of a run's first card hold no ITYPE of 1, 2 or 3");
    }
    if (*type == 1) {
      result.zenith_rad = std::numbers::pi / 2.0;
      result.length_m = way[3] * 1e3;
    } else if (*type == 2) {
      between(way, result);
    }
    if (has_radiance(spectrum)) from_sun(cards, result);
    return result;
  }

  /// ITYPE 2: two heights and an angle; or height, angle and range; or two heights and a range.
  static void between(const std::vector<double>& way, RunGeometry& result) {
    const double end_m = way[1] * 1e3, range_m = way[3] * 1e3;
    const atmosphere::PathPoint start{result.height_m, std::cos(result.zenith_rad)};
    const double reached = atmosphere::advanced(start, range_m).height_m;
    if (range_m <= 0.0) {
      const bool far = way.size() > 6 && way[6] == 1.0;
      const double down = atmosphere::way_down_to_m(start, end_m);
      const double up = atmosphere::way_up_to_m(start, end_m);
      result.length_m = down >= 0.0 && !far ? down : up;
    } else if (way[2] == 0.0 && std::abs(reached - end_m) > 10.0 + 0.01 * range_m) {
      // Law of cosines in the triangle with the earth's centre.
      const double r1 = atmosphere::earth_radius_m + result.height_m;
      const double r2 = atmosphere::earth_radius_m + end_m;
      const double mu = ((r2 - r1) * (r2 + r1) - range_m * range_m) / (2.0 * r1 * range_m);
      result.zenith_rad = std::acos(std::clamp(mu, -1.0, 1.0));
      result.length_m = range_m;
    } else {
      result.length_m = range_m;
    }
  }

  void from_sun(const Cards& cards, RunGeometry& result) {
    const std::vector<double> kind = card(cards, 4), angles = card(cards, 3);
    if (kind.empty() || kind[0] != 2.0 || angles.size() < 2) return;
    result.azimuth_rad = std::abs(std::remainder(angles[0], 360.0)) * radians_per_degree;
    sun_zenith_ = angles[1] * radians_per_degree;
  }

  std::string_view rest_;
  std::string name_;
  FileIssues issues_;
  const AirRunSettings& settings_;
  int line_ = 0;
  std::optional<double> sun_zenith_;
};

}  // namespace

AirRunSet parse_modtran_tape7(std::string_view text, const std::string& name,
                              const AirRunSettings& settings) {
  return Tape7{text, name, settings}.read();
}

AirRunSet read_modtran_tape7(const std::filesystem::path& file, const AirRunSettings& settings) {
  return parse_modtran_tape7(read_bytes(file), file.string(), settings);
}

}  // namespace nadir::sim
