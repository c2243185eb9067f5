#include <fmt/format.h>

#include <cstdlib>

#include "core/text.hpp"
#include "sim/files/therm_values.hpp"

namespace nadir::sim {
namespace {

double rounded(double value) { return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr); }

std::string notes_text(const ThermValues& values, const std::vector<ThermNote>& notes) {
  std::string text;
  for (const ThermNote& note : notes) {
    text += fmt::format("  {}:{}: {}{}\n", values.file, note.line, note.warning ? "warning: " : "",
                        note.text);
  }
  return text;
}

}  // namespace

std::string heat_balance_xml(const ThermMaterial& material) {
  const auto attribute = [](std::string_view name, const std::optional<double>& value) {
    return value ? fmt::format(" {}=\"{}\"", name, number_text(rounded(*value))) : std::string{};
  };
  return fmt::format("<heat_balance{}{}>\n  <layer{}{}{}{}/>\n</heat_balance>\n",
                     attribute("solar_absorptance", material.solar_absorptance),
                     attribute("emissivity", material.emissivity),
                     attribute("conductivity_w_m_k", material.substance.conductivity_w_m_k),
                     attribute("density_kg_m3", material.substance.density_kg_m3),
                     attribute("specific_heat_j_kg_k", material.substance.specific_heat_j_kg_k),
                     attribute("thickness_m", material.thickness_m));
}

std::string therm_report(const ThermValues& values) {
  std::string text = fmt::format("{}: {} material{}; 1 cal = {} J (thermochemical)\n", values.file,
                                 values.materials.size(), values.materials.size() == 1 ? "" : "s",
                                 joule_per_calorie);
  text += notes_text(values, values.notes);
  for (const ThermMaterial& material : values.materials) {
    text += "\n" + material.name;
    if (!material.given.empty() && material.given != material.name) {
      text += ", in the file " + in_quotes(material.given);
    }
    text += "\n" + notes_text(values, material.notes) + heat_balance_xml(material);
  }
  return text;
}

std::string therm_csv(const ThermValues& values) {
  SubstanceTable table;
  for (const ThermMaterial& material : values.materials) {
    ListedSubstance& row = table[material.name];
    row.substance = {rounded(material.substance.conductivity_w_m_k),
                     rounded(material.substance.density_kg_m3),
                     rounded(material.substance.specific_heat_j_kg_k)};
    row.solar_absorptance = material.solar_absorptance;
    row.emissivity = material.emissivity;
    row.checked = "no";
    row.source = fmt::format("{} line {}", std::filesystem::path{values.file}.filename().string(),
                             material.line);
    if (!material.given.empty()) row.source += ", " + material.given;
  }
  return substances_text(table, {"title: Thermal properties converted from calorie units",
                                 "made-by: nadir materials therm"});
}

}  // namespace nadir::sim
