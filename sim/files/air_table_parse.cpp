#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "sim/files/air_table_file.hpp"
#include "sim/files/air_table_layout.hpp"
#include "sim/files/air_table_lines.hpp"
#include "sim/files/hash.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;

/// More of one thing than any table has: a changed head must not ask for all the memory.
constexpr std::size_t most = 1'000'000;

/// Where an array lies.
struct ArrayPlace {
  Token line;
  std::string_view type, shape;
  std::size_t offset = 0;
};

class TableReader {
 public:
  TableReader(const AirTableLines& lines, const std::string& name)
      : name_{name}, payload_{lines.payload}, issues_{name} {
    for (const AirTableEntry& entry : lines.entries) sort_in(entry);
    issues_.throw_if_any();
  }

  AirTableFile read() {
    check_payload();
    AirTableFile file;
    read_head(file);
    refuse_unknown();
    issues_.throw_if_any();
    for_each_array(file.table, [this](const std::string& name, auto& values,
                                      const AirShape& shape) { array(name, values, shape); });
    check_arrays();
    issues_.throw_if_any();
    check_values(file.table);
    return file;
  }

 private:
  void sort_in(const AirTableEntry& entry) {
    if (entry.key == "note") {
      notes_.push_back(entry.value);
    } else if (entry.key == "lane") {
      lanes_.push_back(entry.value);
    } else if (entry.key == "array") {
      array_line(entry.value);
    } else if (!keys_.emplace(entry.key, entry.value).second) {
      issues_.add(entry.value,
                  "the key " + start_in_quotes(entry.key) + " stands here a second time");
    }
  }

  static std::vector<Token> words(const Token& value) {
    std::vector<Token> result;
    std::string_view rest = value.text;
    while (true) {
      rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
      if (rest.empty()) return result;
      const std::string_view word = rest.substr(0, rest.find(' '));
      result.push_back({word, value.line_text, value.line});
      rest.remove_prefix(word.size());
    }
  }

  void array_line(const Token& value) {
    const std::vector<Token> word = words(value);
    const auto offset =
        word.size() == 4 ? strict_number_in<std::size_t>(word[3].text) : std::nullopt;
    if (!offset) {
      issues_.add(value,
                  "expected name, type, shape and offset, found " + start_in_quotes(value.text));
    } else if (!arrays_
                    .emplace(word[0].text, ArrayPlace{word[0], word[1].text, word[2].text, *offset})
                    .second) {
      issues_.add(word[0],
                  "the array " + start_in_quotes(word[0].text) + " stands here a second time");
    }
  }

  std::optional<Token> take(const std::string& key) {
    known_.push_back(key);
    const auto found = keys_.find(key);
    if (found == keys_.end()) {
      issues_.add("the head has no \"" + key + "\"");
      return std::nullopt;
    }
    return found->second;
  }

  double number_of(const Token& word) {
    const auto number = strict_number_in<double>(word.text);
    if (!number) issues_.add(word, "expected a number, found " + start_in_quotes(word.text));
    return number.value_or(0.0);
  }
  double number(const std::string& key) {
    const auto token = take(key);
    return token ? number_of(*token) : 0.0;
  }
  std::size_t count(const std::string& key) {
    const auto token = take(key);
    if (!token) return 0;
    const auto number = strict_number_in<std::size_t>(token->text);
    if (!number || *number > most) {
      issues_.add(*token,
                  "expected a count of 0 to 1000000, found " + start_in_quotes(token->text));
      return 0;
    }
    return *number;
  }
  std::vector<double> numbers(const std::string& key) {
    std::vector<double> result;
    if (const auto token = take(key)) {
      for (const Token& word : words(*token)) result.push_back(number_of(word));
    }
    return result;
  }
  std::string text(const Token& token) {
    std::string result;
    for (std::size_t i = 0; i < token.text.size(); ++i) {
      char c = token.text[i];
      if (c == '\\' && i + 1 < token.text.size()) {
        c = token.text[++i];
        if (c == 'n') c = '\n';
        if (c == 'r') c = '\r';
      }
      result += c;
    }
    return result;
  }
  std::string text(const std::string& key) {
    const auto token = take(key);
    return token ? text(*token) : std::string{};
  }

  void check_payload() {
    const std::size_t bytes = [this] {
      const auto token = take("payload_bytes");
      return token ? strict_number_in<std::size_t>(token->text).value_or(0) : 0;
    }();
    const auto digest = take("payload_sha256");
    issues_.throw_if_any();
    if (payload_.size() != bytes) {
      issues_.add("the head promises " + std::to_string(bytes) + " bytes of numbers, " +
                  std::to_string(payload_.size()) + " follow it" +
                  (payload_.size() < bytes ? ": the file is cut short" : ""));
    } else if (digest->text != digest_bytes(payload_).sha256) {
      issues_.add(*digest,
                  "the numbers were changed after they were written: their SHA-256 is "
                  "not this");
    }
    issues_.throw_if_any();
  }

  void read_head(AirTableFile& file) {
    AirTable& table = file.table;
    table.made_by = text("made_by");
    for (const Token& note : notes_) table.notes.push_back(text(note));
    if (keys_.contains("inputs")) file.inputs = text("inputs");
    table.interpolation_error = number("interpolation_error");
    table.top_m = number("top_m");
    table.ground_m = number("ground_m");
    table.kinds = static_cast<int>(count("kinds"));
    table.phase_grid.resize(count("angles"));
    lanes(table, count("lanes"));
    bodies(table, count("bodies"));
    view("sky.", table.sky);
    const std::size_t views = count("views");
    for (std::size_t i = 0; i < views && issues_.empty(); ++i) {
      view("view." + std::to_string(i) + ".", table.views.emplace_back());
    }
  }

  void lanes(AirTable& table, std::size_t expected) {
    if (expected != lanes_.size()) {
      issues_.add("the head promises " + std::to_string(expected) + " lanes and lists " +
                  std::to_string(lanes_.size()));
    }
    for (const Token& line : lanes_) {
      const std::vector<Token> word = words(line);
      const auto term = word.size() == 5 ? strict_number_in<int>(word[3].text) : std::nullopt;
      if (!term) {
        issues_.add(line,
                    "expected wavelength, interval from and to, term (a whole number) and "
                    "weight, found " +
                        start_in_quotes(line.text));
        continue;
      }
      table.lanes.push_back({number_of(word[0]),
                             {number_of(word[1]), number_of(word[2]), *term},
                             number_of(word[4])});
    }
  }

  void bodies(AirTable& table, std::size_t expected) {
    for (std::size_t i = 0; i < expected && issues_.empty(); ++i) {
      const std::string prefix = "body." + std::to_string(i) + ".";
      AirTable::Body& body = table.bodies.emplace_back();
      body.name = text(prefix + "name");
      body.zenith_rad = number(prefix + "zenith_rad");
      body.azimuth_rad = number(prefix + "azimuth_rad");
    }
  }

  void view(const std::string& prefix, AirTable::View& view) {
    view.height_m = number(prefix + "height_m");
    view.zenith_rad = numbers(prefix + "zenith_rad");
    view.azimuth_rad = numbers(prefix + "azimuth_rad");
    view.share = numbers(prefix + "share");
  }

  /// A key that nobody asked for: a slip of the pen, or of a later version.
  void refuse_unknown() {
    if (!issues_.empty()) return;  // after another mistake not all are asked for
    known_.insert(known_.end(), {"inputs", "note", "lane", "array"});
    for (const auto& [key, value] : keys_) {
      if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      const std::string near = nearest_name(std::string{key}, known_);
      issues_.add({value.line_text, value.line_text, value.line},
                  "the key " + start_in_quotes(key) + " is not known",
                  near.empty() ? "" : "did you mean \"" + near + "\"?");
    }
  }

  template <class Number>
  void array(const std::string& name, std::vector<Number>& values, const AirShape& shape) {
    const std::size_t count = count_of(shape);
    if (count == 0) return values.clear();
    known_arrays_.push_back(name);
    const auto found = arrays_.find(name);
    if (found == arrays_.end()) {
      values.clear();
      if (!may_lack(name)) issues_.add("the head lists no array \"" + name + "\"");
      return;
    }
    const ArrayPlace& place = found->second;
    std::string expected;
    for (const AirAxis& axis : shape) {
      expected += (expected.empty() ? "" : "x") + std::to_string(axis.size);
    }
    if (place.shape != expected) {
      return issues_.add(place.line, "the array " + start_in_quotes(name) + " is said to be " +
                                         std::string{place.shape} + ", by the axes it is " +
                                         expected);
    }
    if (place.type == "float32") {
      copy<float>(place, count, values);
    } else if (place.type == "float64") {
      copy<double>(place, count, values);
    } else {
      issues_.add(place.line,
                  "expected type float32 or float64, found " + start_in_quotes(place.type));
    }
  }

  template <class Stored, class Number>
  void copy(const ArrayPlace& place, std::size_t count, std::vector<Number>& values) {
    const std::size_t bytes = count * sizeof(Stored);
    if (place.offset > payload_.size() || bytes > payload_.size() - place.offset) {
      return issues_.add(place.line, "the array reaches past the end of the numbers");
    }
    used_.emplace_back(place.offset, bytes);
    const char* const from = payload_.data() + place.offset;
    values.resize(count);
    if constexpr (std::is_same_v<Stored, Number>) {
      std::memcpy(values.data(), from, bytes);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        Stored stored;
        std::memcpy(&stored, from + i * sizeof stored, sizeof stored);
        values[i] = static_cast<Number>(stored);
      }
    }
  }

  void check_arrays() {
    for (const auto& [name, place] : arrays_) {
      if (std::find(known_arrays_.begin(), known_arrays_.end(), name) != known_arrays_.end()) {
        continue;
      }
      const std::string near = nearest_name(std::string{name}, known_arrays_);
      issues_.add(place.line, "the array " + start_in_quotes(name) + " is not one of this table",
                  near.empty() ? "" : "did you mean \"" + near + "\"?");
    }
    std::sort(used_.begin(), used_.end());
    std::size_t end = 0;
    bool gapless = true;
    for (const auto& [offset, bytes] : used_) {
      gapless = gapless && offset == end;
      end = offset + bytes;
    }
    if (issues_.empty() && !(gapless && end == payload_.size())) {
      issues_.add("the arrays overlap or leave gaps between them");
    }
  }

  /// Numbers that no table has; the array's line is looked for only where something is wrong.
  void check_values(const AirTable& table) {
    try {
      check(table);
    } catch (const InputError& error) {
      for_each_array(table, [this](const std::string& name, const auto& values, const AirShape&) {
        const auto bad = std::find_if(values.begin(), values.end(),
                                      [](auto value) { return !std::isfinite(value); });
        if (bad == values.end()) return;
        issues_.add(arrays_.at(name).line, "value " + std::to_string(bad - values.begin()) +
                                               " of the array is not a finite number");
      });
      issues_.throw_if_any();
      throw error.located({name_, 1, 1}, air_table_magic + std::to_string(air_table_version));
    }
  }

  std::string name_;
  std::string_view payload_;
  FileIssues issues_;
  std::map<std::string_view, Token> keys_;
  std::map<std::string_view, ArrayPlace> arrays_;
  std::vector<Token> notes_, lanes_;
  std::vector<std::string> known_, known_arrays_;
  std::vector<std::pair<std::size_t, std::size_t>> used_;  // offset and bytes of arrays
};

}  // namespace

AirTableFile parse_air_table(std::string_view bytes, const std::string& name) {
  const AirTableLines lines = air_table_lines(bytes, name);
  return TableReader{lines, name}.read();
}

}  // namespace nadir::sim
