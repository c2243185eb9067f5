#include "sim/files/therm_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

enum class Role { specific_heat, conductivity, density, thickness, absorptance, emissivity, none };

struct ThermKey {
  std::string_view name;
  Role role;
  std::string_view unit, si_unit;
  double factor = 1.0;
  double low = 0.0, high = 1.0;  ///< what is common, in SI units; of fractions: what is possible
  std::string_view instead{};    ///< of what has no counterpart
};

/// Common: from insulation to copper, from foam to lead, lead to water, paint to a metre of soil.
constexpr std::array<ThermKey, 10> therm_keys{{
    {"SPECIFIC_HEAT", Role::specific_heat, "cal/(g C)", "J/(kg K)", 1000.0 * joule_per_calorie,
     100.0, 4500.0},
    {"THERMAL_CONDUCTIVITY", Role::conductivity, "cal/(cm h C)", "W/(m K)",
     100.0 * joule_per_calorie / 3600.0, 0.02, 450.0},
    {"MASS_DENSITY", Role::density, "g/cm3", "kg/m3", 1000.0, 10.0, 20e3},
    {"THICKNESS", Role::thickness, "cm", "m", 0.01, 1e-5, 5.0},
    {"SOLAR_ABSORPTION", Role::absorptance, "", ""},
    {"VISIBLE_EMISSIVITY", Role::absorptance, "", ""},
    {"THERMAL_EMISSIVITY", Role::emissivity, "", ""},
    {"EXPOSED_AREA", Role::none, "", "", 1.0, 0.0, 1.0,
     "what a surface loses at its other side is said by the layers and by back"},
    {"SKY_EXPOSURE", Role::none, "", "", 1.0, 0.0, 1.0,
     "how much sky a surface sees is found from the geometry"},
    {"SPECULARITY", Role::none, "", "", 1.0, 0.0, 1.0,
     "how a surface reflects is said by its material's scattering"},
}};

/// Of a material entry besides: they say nothing of heat.
constexpr std::array<std::string_view, 12> other_keys{
    "NAME",          "ID",           "MATERIAL_NAME",       "MATERIAL_ID",
    "MATERIAL_TYPE", "DESCRIPTION",  "OPTICAL_DESCRIPTION", "TEMP_SOLVER_NAME",
    "DOUBLE_SIDED",  "EDITOR_COLOR", "RAD_SOLVER_NAME",     "SURFACE_PROPERTIES_NAME"};

std::string upper(std::string_view text) {
  std::string out{text};
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

/// Lower case, everything else an underscore, none doubled or at an end.
std::string plain_name(std::string_view given) {
  std::string name;
  for (const char c : given) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte)) {
      name += static_cast<char>(std::tolower(byte));
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

class ThermParser {
 public:
  ThermParser(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    values_.file = name;
  }

  ThermValues parse() {
    while (next()) read_line();
    if (!blocks_.empty()) {
      issues_.add(blocks_.back().at,
                  "the block " + in_quotes(blocks_.back().name) + " is not closed");
    }
    finish();
    if (values_.materials.empty() && issues_.empty()) {
      issues_.add("the file has no thermal values: expected lines such as SPECIFIC_HEAT = 0.2");
    }
    issues_.throw_if_any();
    return std::move(values_);
  }

 private:
  struct Block {
    std::string name;
    Token at;
    bool passed_over = false;
  };

  /// The next line that holds more than a comment.
  bool next() {
    while (!rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++number_;
      const std::string_view content = without_blanks(line.substr(0, comment_at(line)));
      if (content.empty()) continue;
      line_ = {content, line, number_};
      return true;
    }
    return false;
  }

  /// # and // begin comments where a word could begin: paths and colours hold them as well.
  static std::size_t comment_at(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool word = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t';
      if (word && (line[i] == '#' || line.substr(i, 2) == "//")) return i;
    }
    return std::string_view::npos;
  }

  [[nodiscard]] Token part(std::string_view text) const { return {text, line_.line_text, number_}; }

  void read_line() {
    const std::string_view text = line_.text;
    if (text == "}") return close();
    if (text.back() == '{') {
      const std::string_view name = without_blanks(text.substr(0, text.size() - 1));
      return open(name.empty() ? pending_ : part(name));
    }
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos && equals > 0) {
      const std::string_view key = without_blanks(text.substr(0, equals));
      return assign(part(key), part(without_blanks(text.substr(equals + 1))));
    }
    if (!blocks_.empty() && blocks_.back().passed_over) return;
    // A block's name may stand alone, its brace on the next line.
    const std::size_t after = rest_.find_first_not_of(" \t\r\n");
    if (after != std::string_view::npos && rest_[after] == '{') {
      pending_ = line_;
      return;
    }
    issues_.add(line_, "expected KEY = VALUE, the name of a block and {, or }");
  }

  void open(const Token& name) {
    const std::string key = upper(name.text);
    Block block{key, name, !blocks_.empty() && blocks_.back().passed_over};
    if (!block.passed_over && key == "MATERIAL_ENTRY") {
      begin(name);
    } else if (!block.passed_over && key == "TEMP_SOLVER") {
      if (!in_material_) begin(name);
      if (!other_solver_.empty()) {
        block.passed_over = true;
        note("TEMP_SOLVER passed over: its values are for " + in_quotes(other_solver_) +
             ", not for THERM");
      }
    } else if (!block.passed_over) {
      block.passed_over = true;
      const std::string nearest = nearest_name(key, {"MATERIAL_ENTRY", "TEMP_SOLVER"});
      if (nearest.empty()) {
        note("block " + key + " passed over: it says nothing of heat");
      } else {
        issues_.add(name, "unknown block " + in_quotes(key),
                    "did you mean " + in_quotes(nearest) + "?");
      }
    }
    blocks_.push_back(std::move(block));
  }

  void close() {
    if (blocks_.empty()) {
      issues_.add(line_, "there is no block to close");
      return;
    }
    const bool entry = blocks_.size() == 1 && !blocks_.back().passed_over;
    blocks_.pop_back();
    if (entry) finish();
  }

  void assign(const Token& key, const Token& value) {
    if (!blocks_.empty() && blocks_.back().passed_over) return;
    const std::string name = upper(key.text);
    const auto known = std::find_if(therm_keys.begin(), therm_keys.end(),
                                    [&](const ThermKey& k) { return k.name == name; });
    if (known != therm_keys.end()) return heat_value(*known, key, value);
    const bool in_solver = !blocks_.empty() && blocks_.back().name == "TEMP_SOLVER";
    if (!in_solver && std::find(other_keys.begin(), other_keys.end(), name) != other_keys.end()) {
      return other_value(name, key, value);
    }
    std::vector<std::string> names;
    std::string all;
    for (const ThermKey& k : therm_keys) {
      names.emplace_back(k.name);
      all += (all.empty() ? "known are: " : ", ") + names.back();
    }
    if (!in_solver) names.insert(names.end(), other_keys.begin(), other_keys.end());
    const std::string nearest = nearest_name(name, names);
    issues_.add(key, "unknown key " + in_quotes(key.text),
                nearest.empty() ? all : "did you mean " + in_quotes(nearest) + "?");
  }

  void other_value(const std::string& name, const Token& key, const Token& value) {
    const bool names = name == "NAME" || name == "MATERIAL_NAME";
    // Bare files have no braces to tell where the next material begins.
    if (!in_material_ || (names && blocks_.empty() && !seen_.empty())) begin(key);
    if (names) {
      material_.given = value.text;
    } else if (name == "TEMP_SOLVER_NAME" && upper(value.text) != "THERM") {
      other_solver_ = value.text;
    }
  }

  void heat_value(const ThermKey& rule, const Token& key, const Token& value) {
    if (!in_material_) begin(key);
    if (rule.role != Role::none && !seen_.insert(rule.role).second) {
      issues_.add(key, "this is given twice for one material");
      return;
    }
    if (rule.role == Role::none) {
      note(fmt::format("{} = {}: no counterpart; {}", rule.name, value.text, rule.instead));
      return;
    }
    const auto number = strict_number_in<double>(value.text);
    const bool fraction = rule.unit.empty();
    if (!number || (fraction ? *number < 0.0 || *number > 1.0 : *number <= 0.0)) {
      issues_.add(value.text.empty() ? key : value,
                  fmt::format("expected a {} for {}, found \"{}\"",
                              fraction ? "number from 0 to 1" : "number above 0", rule.name,
                              value.text.substr(0, 40)));
      return;
    }
    keep(rule, *number);
  }

  void keep(const ThermKey& rule, double number) {
    const double si = number * rule.factor;
    switch (rule.role) {
      case Role::specific_heat:
        material_.substance.specific_heat_j_kg_k = si;
        break;
      case Role::conductivity:
        material_.substance.conductivity_w_m_k = si;
        break;
      case Role::density:
        material_.substance.density_kg_m3 = si;
        break;
      case Role::thickness:
        material_.thickness_m = si;
        break;
      case Role::absorptance:
        material_.solar_absorptance = si;
        break;
      case Role::emissivity:
        material_.emissivity = si;
        break;
      case Role::none:
        break;
    }
    if (rule.unit.empty()) {
      note(fmt::format("{} = {:.6g}: taken over as {}", rule.name, number,
                       rule.role == Role::emissivity ? "emissivity" : "solar_absorptance"));
      return;
    }
    note(fmt::format("{} = {:.6g} {} x {:.6g} = {:.6g} {}", rule.name, number, rule.unit,
                     rule.factor, si, rule.si_unit));
    if (si >= rule.low && si <= rule.high) return;
    const bool was_si = number >= rule.low && number <= rule.high;
    warn(number_,
         fmt::format("{:.6g} {} is {} than common materials have{}", si, rule.si_unit,
                     si > rule.high ? "more" : "less",
                     was_si ? fmt::format("; {:.6g} {} would be common: is the file in SI units?",
                                          number, rule.si_unit)
                            : ""));
  }

  void begin(const Token& at) {
    finish();
    in_material_ = true;
    material_.line = at.line;
    start_ = at;
  }

  void finish() {
    if (in_material_ && seen_.empty()) {
      const std::string who = material_.given.empty() ? "" : " " + in_quotes(material_.given);
      auto& notes = values_.notes;
      notes.insert(notes.end(), material_.notes.begin(), material_.notes.end());
      notes.push_back({start_.line, "material" + who + " has no values for THERM", false});
    } else if (in_material_) {
      complete();
      values_.materials.push_back(std::move(material_));
    }
    in_material_ = false;
    material_ = {};
    seen_.clear();
    other_solver_.clear();
  }

  void complete() {
    for (const ThermKey& rule : {therm_keys[0], therm_keys[1], therm_keys[2]}) {
      if (seen_.count(rule.role) > 0) continue;
      issues_.add(start_, fmt::format("{} is missing", rule.name));
    }
    const bool whole = seen_.count(Role::specific_heat) && seen_.count(Role::density);
    const double capacity = material_.substance.heat_capacity_j_m3_k();
    // Water holds 4.2e6 and hardly anything more; foam 2e4.
    if (whole && (capacity > 4.5e6 || capacity < 1e4)) {
      warn(material_.line,
           fmt::format("density x specific heat = {:.4g} J/(m3 K): water, which holds most, has "
                       "4.18e+06, foam 2e+04",
                       capacity));
    }
    if (!material_.thickness_m) {
      note_at(material_.line, "no THICKNESS: the layer goes as deep as the day's wave");
    }
    name_it();
  }

  void name_it() {
    std::string name = plain_name(material_.given);
    if (name.empty()) name = fmt::format("material_{}", values_.materials.size() + 1);
    const auto taken = [&](const std::string& wanted) {
      return std::any_of(values_.materials.begin(), values_.materials.end(),
                         [&](const ThermMaterial& m) { return m.name == wanted; });
    };
    std::string wanted = name;
    for (int i = 2; taken(wanted); ++i) wanted = fmt::format("{}_{}", name, i);
    material_.name = wanted;
  }

  void note(std::string text) { note_at(number_, std::move(text)); }
  void note_at(int line, std::string text) {
    (in_material_ ? material_.notes : values_.notes).push_back({line, std::move(text), false});
  }
  void warn(int line, std::string text) {
    material_.notes.push_back({line, std::move(text), true});
  }

  std::string_view rest_;
  FileIssues issues_;
  int number_ = 0;
  Token line_, pending_, start_;
  std::vector<Block> blocks_;
  bool in_material_ = false;
  std::string other_solver_;  ///< of the material, where it is not THERM
  std::set<Role> seen_;
  ThermMaterial material_;
  ThermValues values_;
};

}  // namespace

ThermValues parse_therm(std::string_view text, const std::string& name) {
  return ThermParser{text, name}.parse();
}

ThermValues read_therm(const std::filesystem::path& file) {
  const std::string text = read_bytes(file);
  return parse_therm(text, file.string());
}

}  // namespace nadir::sim
