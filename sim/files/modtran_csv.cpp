#include "sim/files/modtran_csv.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "sim/files/modtran_columns.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

enum class AxisUnit { wavenumber, micrometres, nanometres };

std::string lower(std::string_view text) {
  std::string result{text};
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

std::string_view unquoted(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    return cell.substr(1, cell.size() - 2);
  }
  return cell;
}

std::vector<Token> cells_of(const Token& line) {
  std::vector<Token> cells;
  std::string_view rest = line.text;
  while (true) {
    const std::size_t comma = rest.find(',');
    cells.push_back({unquoted(without_blanks(rest.substr(0, comma))), line.line_text, line.line});
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  // A comma at the line's end opens no column.
  if (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
  return cells;
}

bool is_wavelength(std::string_view name) {
  return lower(name).starts_with("wav") && lower(name).find("number") == std::string::npos;
}
bool is_spectral(std::string_view name) {
  return is_wavelength(name) || lower(name).starts_with("freq") ||
         lower(name).starts_with("wavenumber");
}

bool is_heading(const std::vector<Token>& cells) {
  const auto known = std::count_if(cells.begin(), cells.end(), [](const Token& cell) {
    return modtran_column(cell.text).has_value();
  });
  return cells.size() > 1 && is_spectral(cells.front().text) && known > 0;
}

class Csv {
 public:
  Csv(std::string_view text, const std::string& name) : rest_{text}, name_{name}, issues_{name} {}

  std::vector<ModtranSpectrum> cases() {
    std::vector<ModtranSpectrum> all;
    while (const auto line = next_line()) {
      const std::vector<Token> cells = cells_of(*line);
      if (!is_heading(cells)) continue;
      all.push_back(spectrum(cells, "case " + std::to_string(all.size() + 1)));
      lines_.push_back(*line);
    }
    if (all.empty()) {
      issues_.add("no line names columns: expected one that begins with FREQ or a wavelength");
    }
    issues_.throw_if_any();
    return all;
  }

  /// Where a case's columns are named.
  [[nodiscard]] const Token& line_of(std::size_t index) const { return lines_[index]; }

 private:
  std::optional<Token> next_line() {
    if (rest_.empty()) return std::nullopt;
    const std::string_view text = take_line(rest_);
    return Token{text, text, ++line_};
  }

  ModtranSpectrum spectrum(const std::vector<Token>& names, const std::string& label) {
    ModtranSpectrum result{name_ + ", " + label, {ModtranColumn::frequency}, {}};
    for (std::size_t i = 1; i < names.size(); ++i) {
      result.columns.push_back(modtran_column(names[i].text).value_or(ModtranColumn::other));
    }
    std::string units = std::string{names.front().text};
    while (!rest_.empty()) {
      std::string_view peek = rest_;
      const std::string_view text = take_line(peek);
      const std::vector<Token> cells = cells_of({text, text, line_ + 1});
      const auto first = strict_number_in<double>(cells.front().text);
      if (!first && result.rows.empty() && !without_blanks(text).empty()) {
        units += " " + std::string{cells.front().text};  // a line of units
      } else if (!first || *first <= -9998.0) {
        break;
      } else {
        result.rows.push_back(row(cells, result.columns.size()));
      }
      rest_ = peek;
      ++line_;
    }
    if (is_wavelength(names.front().text)) to_wavenumber(result, axis(units, result));
    return result;
  }

  std::vector<double> row(const std::vector<Token>& cells, std::size_t columns) {
    if (cells.size() > columns) {
      issues_.add(cells[columns], "the row has more cells than there are names of columns");
    }
    std::vector<double> values(columns, std::nan(""));
    for (std::size_t i = 0; i < std::min(columns, cells.size()); ++i) {
      if (cells[i].text.empty()) continue;
      const auto number = strict_number_in<double>(cells[i].text);
      if (!number) {
        issues_.add(cells[i], "expected a number, found \"" + std::string{cells[i].text} + "\"");
      }
      values[i] = number.value_or(0.0);
    }
    return values;
  }

  static AxisUnit axis(const std::string& units, const ModtranSpectrum& spectrum) {
    const std::string text = lower(units);
    if (text.find("nm") != std::string::npos || text.find("nano") != std::string::npos) {
      return AxisUnit::nanometres;
    }
    if (text.find("um") != std::string::npos || text.find("mic") != std::string::npos ||
        text.find("mcrn") != std::string::npos) {
      return AxisUnit::micrometres;
    }
    // Not said: MODTRAN reaches from 0.2 um, so that only nm are above 100.
    return !spectrum.rows.empty() && spectrum.rows.front().front() > 100.0 ? AxisUnit::nanometres
                                                                           : AxisUnit::micrometres;
  }

  /// To what run_of_modtran expects: wavenumbers, radiance per cm^-1.
  static void to_wavenumber(ModtranSpectrum& spectrum, AxisUnit axis) {
    // W cm^-2 um^-1 are 1e4 W m^-2 um^-1; uW cm^-2 nm^-1 are 1e-6 x 1e4 x 1e3 of them.
    const bool nm = axis == AxisUnit::nanometres;
    const double per_m2_um = nm ? 10.0 : 1e4;
    for (std::vector<double>& row : spectrum.rows) {
      const double nu = 1e4 / (nm ? row.front() * 1e-3 : row.front());
      row.front() = nu;
      for (std::size_t i = 1; i < row.size(); ++i) {
        const ModtranColumn column = spectrum.columns[i];
        if (column != ModtranColumn::transmittance && column != ModtranColumn::other) {
          row[i] *= per_m2_um / (nu * nu);
        }
      }
    }
  }

  std::string_view rest_;
  std::string name_;
  FileIssues issues_;
  std::vector<Token> lines_;
  int line_ = 0;
};

}  // namespace

AirRunSet parse_modtran_csv(std::string_view text, const std::string& name,
                            std::span<const RunGeometry> geometry, const AirRunSettings& settings) {
  Csv csv{text, name};
  const std::vector<ModtranSpectrum> cases = csv.cases();
  if (cases.size() != geometry.size()) {
    throw InputError{InputIssue{{name, 0, 0},
                                "the file has " + std::to_string(cases.size()) +
                                    " cases, the geometry of " + std::to_string(geometry.size()) +
                                    " is given",
                                "give one row of --geometry for each case",
                                {}}};
  }
  AirRunSet all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    try {
      merge(all, run_of_modtran(cases[i], geometry[i], settings));
    } catch (const InputError& error) {
      const Token& line = csv.line_of(i);
      throw error.located({name, line.line, 1}, std::string{line.text});
    }
  }
  all.made_by = "MODTRAN 6 CSV " + name;
  return all;
}

AirRunSet read_modtran_csv(const std::filesystem::path& file, std::span<const RunGeometry> geometry,
                           const AirRunSettings& settings) {
  return parse_modtran_csv(read_bytes(file), file.string(), geometry, settings);
}

}  // namespace nadir::sim
