#include "sim/files/point_spread_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

constexpr std::string_view point_spread_mark = "# nadir-point-spread: 1";
constexpr std::string_view spread_pitch_key = "pitch_um";
constexpr std::array<std::string_view, 5> spread_remarks{"title", "source", "licence", "made-by",
                                                         "note"};
constexpr double most_pitch_um = 1e9;
constexpr double least_um = 0.1, most_um = 100.0;  // wavelengths; nm or Angstrom lie far outside
constexpr double spread_sum_tolerance = 1e-3;      // as sensor::PointSpread; rounding of the file

/// Six digits: a sum's rounding errors tell nothing.
std::string six_digits(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, 6)
                       .ptr;
  return {buffer.data(), end};
}

class PointSpreadReader {
 public:
  PointSpreadReader(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  sensor::TabulatedSpread read() {
    if (without_blanks(next()) != point_spread_mark) {
      issues_.add(token(whole_), "expected \"" + std::string{point_spread_mark} + "\", found " +
                                     start_in_quotes(whole_));
      issues_.throw_if_any();
    }
    while (!rest_.empty()) read_line(without_blanks(next()));
    finish_slice();
    if (spread_.pitch_m <= 0.0 && !pitch_refused_) {
      issues_.add("the table has no line \"# pitch_um: ...\"");
    }
    if (spread_.slices.empty()) issues_.add("the table has no \"wavelength_um, ...\"");
    issues_.throw_if_any();
    return std::move(spread_);
  }

 private:
  std::string_view next() {
    whole_ = take_line(rest_);
    ++line_;
    return whole_;
  }
  [[nodiscard]] Token token(std::string_view text) const { return {text, whole_, line_}; }

  void read_line(std::string_view text) {
    if (text.empty()) return;
    if (text.front() == '#') {
      read_key(without_blanks(text.substr(1)));
    } else if (text.starts_with("wavelength_um")) {
      finish_slice();
      begin_slice(text);
    } else if (spread_.slices.empty()) {
      issues_.add(token(text), "expected \"wavelength_um, ...\" before the first weights");
      issues_.throw_if_any();  // every line of another kind of file would be one
    } else {
      read_weights(text);
    }
  }

  void read_key(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return;  // a remark
    const std::string_view key = without_blanks(text.substr(0, colon));
    const std::string_view value = without_blanks(text.substr(colon + 1));
    if (std::find(spread_remarks.begin(), spread_remarks.end(), key) != spread_remarks.end())
      return;
    if (key != spread_pitch_key) {
      std::vector<std::string> known{spread_remarks.begin(), spread_remarks.end()};
      known.emplace_back(spread_pitch_key);
      const std::string near = nearest_name(std::string{key}, known);
      issues_.add(token(key), "unknown key \"" + std::string{key} + "\"",
                  near.empty() ? "" : "did you mean \"" + near + "\"?");
      pitch_refused_ |= near == spread_pitch_key;
      return;
    }
    const auto pitch = strict_number_in<double>(value);
    if (!pitch || *pitch <= 0.0 || *pitch > most_pitch_um) {
      pitch_refused_ = true;
      issues_.add(token(value),
                  "expected a number above 0 for pitch_um, found \"" + std::string{value} + "\"");
      return;
    }
    constexpr double metres_per_um = 1e-6;
    spread_.pitch_m = *pitch * metres_per_um;
  }

  void begin_slice(std::string_view text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view cell =
        comma < text.size() ? without_blanks(text.substr(comma + 1)) : text.substr(text.size());
    const auto wavelength = strict_number_in<double>(cell);
    heading_ = token(text);
    if (!wavelength || *wavelength < least_um || *wavelength > most_um) {
      issues_.add(token(cell.empty() ? text : cell),
                  "expected a wavelength from 0.1 to 100 um, found \"" + std::string{cell} + "\"");
    } else if (!spread_.slices.empty() && *wavelength <= spread_.slices.back().wavelength_um) {
      issues_.add(token(cell), "wavelengths must ascend: " + std::string{cell} + " follows " +
                                   nadir::number_text(spread_.slices.back().wavelength_um));
    }
    spread_.slices.push_back({wavelength.value_or(0.0), {}});
    rows_ = 0;
    sound_ = true;
  }

  void read_weights(std::string_view text) {
    std::vector<double>& weights = spread_.slices.back().weights;
    int columns = 0;
    for (std::size_t begin = 0; begin <= text.size(); ++columns) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      std::string_view cell = without_blanks(text.substr(begin, end - begin));
      if (cell.empty()) cell = text.substr(begin, 0);  // keeps its place
      weights.push_back(weight(cell));
      begin = end + 1;
    }
    ++rows_;
    if (spread_.columns == 0) spread_.columns = columns;
    if (columns == spread_.columns) return;
    sound_ = false;
    issues_.add(token(text), "expected " + std::to_string(spread_.columns) + " weights, found " +
                                 std::to_string(columns));
  }

  double weight(std::string_view cell) {
    const auto value = strict_number_in<double>(cell);
    if (value && *value >= 0.0) return *value;
    sound_ = false;
    issues_.add(token(cell), "expected a weight of 0 or more, found \"" + std::string{cell} + "\"");
    return 0.0;
  }

  /// Checks the slice that ends here as a whole, unless something in it is wrong already.
  void finish_slice() {
    if (spread_.slices.empty() || !sound_) return;
    const sensor::TabulatedSpread::Slice& slice = spread_.slices.back();
    if (spread_.rows == 0) spread_.rows = rows_;
    if (rows_ != spread_.rows || rows_ == 0) {
      issues_.add(heading_, rows_ == 0 ? "no weights follow"
                                       : "expected " + std::to_string(spread_.rows) +
                                             " rows of weights, found " + std::to_string(rows_));
      return;
    }
    double sum = 0.0;
    for (const double value : slice.weights) sum += value;
    if (std::abs(sum - 1.0) <= spread_sum_tolerance) return;
    issues_.add(heading_,
                "the weights of this wavelength sum to " + six_digits(sum) + ", not to 1");
  }

  std::string_view rest_, whole_;
  FileIssues issues_;
  sensor::TabulatedSpread spread_;
  Token heading_;  // of the slice
  int line_ = 0, rows_ = 0;
  bool sound_ = true, pitch_refused_ = false;
};

}  // namespace

sensor::TabulatedSpread parse_point_spread(std::string_view text, const std::string& name) {
  return PointSpreadReader{text, name}.read();
}

sensor::TabulatedSpread read_point_spread(const std::filesystem::path& file) {
  return parse_point_spread(read_bytes(file), file.string());
}

}  // namespace nadir::sim
