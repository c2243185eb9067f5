#include "sim/files/lamp_list.hpp"

#include "sim/files/number_table.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {

std::vector<ListedLamp> parse_lamp_list(std::string_view text, const std::string& name) {
  constexpr double farthest_m = 1e8;  // as for coordinates in scenario files
  const NumberTable table{text,
                          name,
                          {{"east_m", true, -farthest_m, farthest_m},
                           {"north_m", true, -farthest_m, farthest_m},
                           {"up_m", false, -farthest_m, farthest_m},
                           {"yaw_deg", false, -360.0, 360.0},
                           {"lumens", false, 0.0, 1e12},
                           {"colour_temperature_k", false, 1000.0, 25000.0}}};
  std::vector<ListedLamp> lamps;
  for (const NumberTable::Row& row : table.rows()) {
    const auto value = [&](const char* column) { return table.value(row, column, 0.0); };
    const auto given = [&](const char* column) {
      return table.has(column) ? std::optional{value(column)} : std::nullopt;
    };
    lamps.push_back({{value("east_m"), value("north_m"), value("up_m")},
                     value("yaw_deg"),
                     given("lumens"),
                     given("colour_temperature_k"),
                     row.line});
  }
  return lamps;
}

std::vector<ListedLamp> read_lamp_list(const std::filesystem::path& file) {
  return parse_lamp_list(read_bytes(file), file.string());
}

}  // namespace nadir::sim
