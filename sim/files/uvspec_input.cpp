#include "sim/files/uvspec_input.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

using Words = std::vector<Token>;

class Input {
 public:
  Input(const NamedText& input, double top_m) : issues_{input.name}, top_m_{top_m} {
    std::string_view rest = input.text;
    int line = 0;
    while (!rest.empty()) {
      const std::string_view text = take_line(rest);
      take_words({text.substr(0, text.find('#')), text, ++line});
    }
  }

  UvspecInput read() {
    source();
    refuse();
    UvspecInput& in = result_;
    in.sun_zenith_deg = number("sza", 0.0);
    in.sun_phi_deg = number("phi0", 0.0);
    in.umu = numbers("umu");
    in.phi_deg = numbers("phi");
    levels();
    ground();
    unit();
    if (const Words* words = find("output_user")) {
      for (const Token& word : *words) in.columns.emplace_back(word.text);
    }
    issues_.throw_if_any();
    return std::move(result_);
  }

 private:
  void take_words(const Token& line) {
    Words words;
    std::string_view rest = line.text;
    while (true) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
      if (rest.empty()) break;
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
      words.push_back({word, line.line_text, line.line});
      rest.remove_prefix(word.size());
    }
    if (words.empty()) return;
    const Token key = words.front();
    words.erase(words.begin());
    options_[key.text] = {key, std::move(words)};
  }

  [[nodiscard]] const Words* find(std::string_view key) const {
    const auto found = options_.find(key);
    return found == options_.end() ? nullptr : &found->second.second;
  }
  [[nodiscard]] const Token& key(std::string_view name) const {
    return options_.find(name)->second.first;
  }

  std::optional<double> number_of(const Token& word) {
    const auto value = strict_number_in<double>(word.text);
    if (!value) {
      issues_.add(word, "expected a number, found \"" + std::string{word.text} + "\"");
    }
    return value;
  }
  double number(std::string_view name, double otherwise) {
    const Words* words = find(name);
    if (words == nullptr) return otherwise;
    if (words->size() == 1) return number_of(words->front()).value_or(otherwise);
    issues_.add(key(name), "expected one number after it");
    return otherwise;
  }
  std::vector<double> numbers(std::string_view name) {
    std::vector<double> values;
    if (const Words* words = find(name)) {
      for (const Token& word : *words) values.push_back(number_of(word).value_or(0.0));
    }
    return values;
  }

  void source() {
    const Words* words = find("source");
    if (words == nullptr || words->empty()) {
      issues_.add("the input has no line \"source solar\" or \"source thermal\"");
      return;
    }
    const std::string_view kind = words->front().text;
    result_.thermal = kind == "thermal";
    if (kind != "solar" && kind != "thermal") {
      issues_.add(words->front(), "expected solar or thermal");
    }
  }

  void refuse() {
    if (find("include") != nullptr) {
      issues_.add(key("include"), "included files are not followed: put their lines here");
    }
    if (find("output_quantity") != nullptr) {
      issues_.add(key("output_quantity"), "a table needs radiances: leave this line out");
    }
    if (find("zout_sea") != nullptr) {
      issues_.add(key("zout_sea"), "give levels above the ground, by zout");
    }
  }

  /// Kilometres above the ground, or its names for ground and top.
  void levels() {
    const double altitude_m = number("altitude", 0.0) * 1e3;
    const Words* words = find("zout");
    if (words == nullptr) result_.level_m.push_back(altitude_m);
    if (words == nullptr) return;
    for (const Token& word : *words) {
      if (word.text == "TOA" || word.text == "toa") {
        result_.level_m.push_back(top_m_);
      } else if (word.text == "SUR" || word.text == "sur" || word.text == "surface") {
        result_.level_m.push_back(altitude_m);
      } else if (const auto height = number_of(word)) {
        result_.level_m.push_back(altitude_m + *height * 1e3);
      }
    }
    for (std::size_t i = 1; i < result_.level_m.size(); ++i) {
      if (result_.level_m[i] <= result_.level_m[i - 1]) {
        issues_.add(key("zout"), "the levels do not ascend");
        return;
      }
    }
  }

  void ground() {
    // 50 K: at 14 um a 1e-6th of what air at 220 K emits.
    constexpr double cold_k = 50.0;
    result_.cold_ground = number("sur_temperature", 300.0) <= cold_k;
    result_.black_ground = number("albedo", 0.0) == 0.0;
    for (const auto& [name, option] : options_) {
      const bool reflects =
          name.starts_with("albedo_") || name.starts_with("brdf_") || name.starts_with("bpdf_");
      if (reflects) result_.black_ground = false;
    }
  }

  void unit() {
    UvspecUnit unit = result_.thermal ? UvspecUnit::per_cm : UvspecUnit::per_nm;
    const Words* process = find("output_process");
    const bool said = process != nullptr && process->size() == 1;
    if (said && process->front().text == "per_nm") {
      unit = UvspecUnit::per_nm;
    } else if (said && process->front().text == "per_cm-1") {
      unit = UvspecUnit::per_cm;
    } else if (process != nullptr) {
      issues_.add(key("output_process"), "expected per_nm or per_cm-1: a table is spectral");
    } else {
      bands();
    }
    result_.unit = unit;
  }

  /// Without output_process some schemes give sums over bands.
  void bands() {
    static const std::set<std::string_view> summed{"kato",          "kato2",       "kato2.96",
                                                   "katoandwandji", "avhrr_kratz", "fu"};
    const Words* scheme = find("mol_abs_param");
    if (scheme != nullptr && !scheme->empty() && summed.contains(scheme->front().text)) {
      issues_.add(scheme->front(), "this scheme gives sums over bands: add output_process per_nm");
    }
    if (!result_.thermal) return;
    if (find("thermal_bands_file") != nullptr) {
      issues_.add(key("thermal_bands_file"),
                  "this gives sums over bands: add output_process per_nm");
    }
    const Words* width = find("thermal_bandwidth");
    if (width == nullptr) return;
    if (width->size() == 2 && width->back().text == "nm") {
      issues_.add(width->back(), "expected a bandwidth in cm-1, or output_process per_nm");
    } else if (!width->empty()) {
      result_.band_cm = number_of(width->front()).value_or(1.0);
    }
    if (!(result_.band_cm > 0.0)) issues_.add(key("thermal_bandwidth"), "expected one above 0");
  }

  FileIssues issues_;
  double top_m_;
  std::map<std::string_view, std::pair<Token, Words>> options_;
  UvspecInput result_;
};

}  // namespace

UvspecInput parse_uvspec_input(const NamedText& input, double top_m) {
  return Input{input, top_m}.read();
}

}  // namespace nadir::sim
