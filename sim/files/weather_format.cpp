#include "sim/files/weather_format.hpp"

#include <vector>

#include "core/error.hpp"
#include "sim/files/weather_csv.hpp"
#include "sim/files/weather_epw.hpp"
#include "sim/files/weather_surfrad.hpp"
#include "sim/files/weather_text.hpp"
#include "sim/files/weather_tmy3.hpp"

namespace nadir::sim {
namespace {

/// The header of our CSV: the first line that is neither blank nor a comment names the time.
bool names_a_time(std::string_view text) {
  WeatherLines lines{text};
  while (const auto line = lines.next()) {
    const std::string_view content = without_blanks(line->text);
    if (content.empty() || content.front() == '#') continue;
    for (const Token& cell : comma_cells(*line)) {
      if (cell.text == "utc" || cell.text == "local") return true;
    }
    return false;
  }
  return false;
}

bool is_number(std::string_view text) { return strict_number_in<double>(text).has_value(); }

/// A name, then latitude, longitude and height between blanks.
bool looks_like_surfrad(const Token& second) {
  const std::vector<Token> cells = blank_cells(second);
  return cells.size() >= 3 && is_number(cells[0].text) && is_number(cells[1].text) &&
         is_number(cells[2].text) && second.text.find(',') == std::string_view::npos;
}

}  // namespace

WeatherLayout weather_layout_of(std::string_view text, const std::string& name) {
  WeatherLines lines{text};
  const auto first = lines.next();
  const auto second = lines.next();
  if (first && second) {
    if (first->text.starts_with("LOCATION,")) return WeatherLayout::epw;
    if (without_blanks(second->text).starts_with("Date (MM/DD/YYYY)")) return WeatherLayout::tmy3;
    if (names_a_time(text)) return WeatherLayout::csv;
    if (looks_like_surfrad(*second)) return WeatherLayout::surfrad;
  }
  throw InputError{InputIssue{
      {name, 1, 1},
      "this is no weather that can be read: an EPW file begins with LOCATION, the second line of a "
      "TMY3 file with Date (MM/DD/YYYY) and that of a SURFRAD file with latitude, longitude and "
      "height; the header of a CSV has a column \"utc\" or \"local\"",
      {},
      std::string{first ? first->text.substr(0, 60) : std::string_view{}}}};
}

WeatherRecord parse_weather(std::string_view text, const std::string& name,
                            std::optional<WeatherLayout> layout) {
  switch (layout ? *layout : weather_layout_of(text, name)) {
    case WeatherLayout::tmy3:
      return parse_weather_tmy3(text, name);
    case WeatherLayout::epw:
      return parse_weather_epw(text, name);
    case WeatherLayout::surfrad:
      return parse_weather_surfrad(text, name);
    case WeatherLayout::csv:
      break;
  }
  return parse_weather_csv(text, name);
}

}  // namespace nadir::sim
