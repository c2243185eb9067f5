#include "sim/files/ies_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/quantity.hpp"
#include "radiometry/lamps/intensity_shape.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

using Numbers = std::vector<double>;

/// Blanks, commas and the end-of-file mark of DOS part numbers.
constexpr std::string_view separators = " \t,\x1A";

/// Up to the line TILT=, then numbers in a fixed order, wherever lines end.
class IesParser {
 public:
  IesParser(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  IesFile parse() {
    read_labels();
    read_counts();
    IesFile file;
    file.lamp_lumens = lamps_ > 0.0 && lumens_per_lamp_ > 0.0 ? lamps_ * lumens_per_lamp_ : 0.0;
    factor_ *= not_negative("the ballast factor");
    const double photometric = not_negative("the ballast-lamp photometric factor");
    if (has_photometric_factor_) factor_ *= photometric;
    file.watts = not_negative("the input watts");
    Numbers vertical = angles(vertical_count_, "vertical"),
            horizontal = angles(horizontal_count_, "horizontal");
    check_vertical(vertical);
    Numbers candela;
    for (std::size_t i = 0; i < vertical.size() * horizontal.size(); ++i) {
      candela.push_back(factor_ * not_negative("a candela value"));
    }
    if (next()) fail("the file goes on after its last candela value");
    close_circle(horizontal, candela, vertical.size());
    file.candela = {std::move(vertical), std::move(horizontal), std::move(candela)};
    for (double& angle : file.candela.vertical_rad) angle *= radians_per_degree;
    for (double& angle : file.candela.horizontal_rad) angle *= radians_per_degree;
    file.lumens = radiometry::integral(file.candela);
    if (!(file.lumens > 0.0)) fail("the luminaire gives no light: all its candela values are 0");
    return file;
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) {
    issues_.add(token_, message, hint);
    issues_.throw_if_any();
    throw InputError{message};  // not reached
  }

  void read_labels() {
    bool first = true;
    while (!rest_.empty()) {
      take();
      const std::string_view text = without_blanks(line_);
      if (first) {
        // Editions before 2002 give a second ballast factor where later ones keep a place free.
        has_photometric_factor_ = text.find("2002") == std::string_view::npos &&
                                  text.find("2019") == std::string_view::npos;
        first = false;
      }
      if (!text.starts_with("TILT=")) continue;
      token_ = {text, line_, line_number_};
      line_ = {};
      if (without_blanks(text.substr(5)) != "NONE") {
        fail("expected TILT=NONE, found \"" + std::string{text} + "\"",
             "light that depends on the luminaire's tilt is not supported");
      }
      return;
    }
    fail("no line begins with TILT=: not a photometric file of IES LM-63");
  }

  void read_counts() {
    lamps_ = number("the number of lamps");
    lumens_per_lamp_ = number("the lumens of a lamp");
    factor_ = not_negative("the candela multiplier");
    vertical_count_ = count("vertical angles", 2);
    horizontal_count_ = count("horizontal angles", 1);
    if (number("the photometric type") != 1.0) {
      fail("expected photometric type 1 (C), found " + std::string{token_.text});
    }
    for (const char* what : {"the type of units", "the width", "the length", "the height"}) {
      (void)number(what);
    }
  }

  void take() {
    line_ = take_line(rest_);
    whole_line_ = line_;
    ++line_number_;
  }

  bool next() {
    while (true) {
      const std::size_t begin = line_.find_first_not_of(separators);
      if (begin != std::string_view::npos) {
        line_.remove_prefix(begin);
        const std::size_t end = std::min(line_.find_first_of(separators), line_.size());
        token_ = {line_.substr(0, end), whole_line_, line_number_};
        line_.remove_prefix(end);
        return true;
      }
      if (rest_.empty()) return false;
      take();
    }
  }

  double number(const std::string& what) {
    if (!next()) fail("the file ends where " + what + " is expected");
    std::string_view text = token_.text;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto value = strict_number_in<double>(text);
    if (!value) fail("expected " + what + ", found \"" + std::string{token_.text} + "\"");
    return *value;
  }
  double not_negative(const std::string& what) {
    const double value = number(what);
    if (value < 0.0) fail(what + " is negative");
    return value;
  }
  std::size_t count(const std::string& what, int least) {
    constexpr double most = 10000.0;
    const double value = number("the number of " + what);
    if (value < least || value > most || value != std::floor(value)) {
      fail("the number of " + what + " must be a whole number from " + std::to_string(least) +
           " to 10000");
    }
    return static_cast<std::size_t>(value);
  }

  Numbers angles(std::size_t how_many, const std::string& kind) {
    Numbers list;
    for (std::size_t i = 0; i < how_many; ++i) {
      list.push_back(number("a " + kind + " angle"));
      if (i > 0 && !(list[i - 1] < list[i])) fail("the " + kind + " angles must ascend");
    }
    if (kind == "horizontal" && how_many > 1) check_horizontal(list);
    return list;
  }

  void check_vertical(const Numbers& list) {
    if (list.front() < 0.0 || list.back() > 180.0) {
      fail("vertical angles of type C lie from 0 to 180 degrees");
    }
  }
  void check_horizontal(const Numbers& list) {
    const double first = list.front(), last = list.back();
    const bool whole = first == 0.0 && (last == 90.0 || last == 180.0 || last == 360.0);
    if (whole || (first == 90.0 && last == 270.0)) return;
    fail("horizontal angles must reach from 0 to 90, 180 or 360 degrees, or from 90 to 270");
  }

  /// Angles from 90 to 270 mean that both sides of that plane are alike: adds the other side.
  static void close_circle(Numbers& horizontal, Numbers& candela, std::size_t rows) {
    if (horizontal.size() == 1) horizontal = {0.0};
    if (horizontal.front() != 90.0) return;
    struct Column {
      double angle;
      Numbers values;
    };
    std::vector<Column> half;
    for (std::size_t j = 0; j < horizontal.size(); ++j) {
      const auto begin = candela.begin() + static_cast<std::ptrdiff_t>(j * rows);
      half.push_back({horizontal[j], {begin, begin + static_cast<std::ptrdiff_t>(rows)}});
    }
    const auto beyond = std::find_if(half.begin(), half.end(),
                                     [](const Column& column) { return column.angle >= 180.0; });
    if (beyond->angle != 180.0) {  // the seam of the new circle needs a column
      const Column &lo = *(beyond - 1), &hi = *beyond;
      const double t = (180.0 - lo.angle) / (hi.angle - lo.angle);
      Column middle{180.0, lo.values};
      for (std::size_t i = 0; i < rows; ++i) {
        middle.values[i] += t * (hi.values[i] - lo.values[i]);
      }
      half.insert(beyond, middle);
    }
    std::vector<Column> circle = half;
    for (const Column& column : half) {
      if (column.angle > 90.0 && column.angle <= 180.0) {
        circle.push_back({180.0 - column.angle, column.values});
      }
      if (column.angle >= 180.0 && column.angle < 270.0) {
        circle.push_back({540.0 - column.angle, column.values});
      }
    }
    std::sort(circle.begin(), circle.end(),
              [](const Column& a, const Column& b) { return a.angle < b.angle; });
    horizontal.clear();
    candela.clear();
    for (const Column& column : circle) {
      horizontal.push_back(column.angle);
      candela.insert(candela.end(), column.values.begin(), column.values.end());
    }
  }

  std::string_view rest_, line_, whole_line_;
  FileIssues issues_;
  Token token_;
  int line_number_ = 0;
  bool has_photometric_factor_ = true;
  double lamps_ = 0.0, lumens_per_lamp_ = 0.0, factor_ = 1.0;
  std::size_t vertical_count_ = 0, horizontal_count_ = 0;
};

}  // namespace

IesFile parse_ies(std::string_view text, const std::string& name) {
  return IesParser{text, name}.parse();
}

IesFile read_ies(const std::filesystem::path& file) {
  return parse_ies(read_bytes(file), file.string());
}

}  // namespace nadir::sim
