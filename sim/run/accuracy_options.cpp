#include "sim/run/accuracy_options.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/error.hpp"

namespace nadir::sim {
namespace {

constexpr double longest_s = 366.0 * 86400.0;

/// Reads a text from its front, blanks skipped.
class FrontReader {
 public:
  explicit FrontReader(std::string_view text) : rest_{text} { skip_blanks(); }

  [[nodiscard]] bool done() const { return rest_.empty(); }
  /// A number without sign; NaN where there is none.
  double number() {
    double value = NAN;
    if (rest_.empty() || (rest_.front() != '.' && (rest_.front() < '0' || rest_.front() > '9'))) {
      return value;
    }
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) return NAN;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    skip_blanks();
    return value;
  }
  /// Letters (and %) up to what is something else.
  std::string_view word() {
    std::size_t size = 0;
    const auto letter = [](char c) { return c == '%' || (c >= 'a' && c <= 'z'); };
    while (size < rest_.size() && letter(rest_[size])) ++size;
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(size);
    skip_blanks();
    return found;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t'))
      rest_.remove_prefix(1);
  }
  std::string_view rest_;
};

[[noreturn]] void refuse(const std::string& text, const std::string& expected) {
  throw InputError{fmt::format("expected {}, found \"{}\"", expected, text)};
}

struct TimeUnit {
  std::string_view name;
  double seconds;
};
constexpr std::array<TimeUnit, 3> time_units{{{"h", 3600.0}, {"min", 60.0}, {"s", 1.0}}};

/// Seconds; NaN for what is no duration.
double seconds_of(const std::string& text) {
  FrontReader reader{text};
  double sum = 0.0;
  std::size_t next = 0;  // unit that may come
  if (reader.done()) return NAN;
  while (!reader.done()) {
    const double value = reader.number();
    const std::string_view unit = reader.word();
    if (unit.empty()) return next == 0 && reader.done() ? value : NAN;
    while (next < time_units.size() && time_units[next].name != unit) ++next;
    if (next == time_units.size()) return NAN;
    sum += value * time_units[next++].seconds;
  }
  return sum;
}

}  // namespace

double parse_accuracy(const std::string& text) {
  const std::string expected = "an accuracy above 0 and at most 100 %, as 1% or 0.01";
  FrontReader reader{text};
  const double value = reader.number();
  const std::string_view unit = reader.word();
  if (!reader.done() || !(unit.empty() || unit == "%")) refuse(text, expected);
  const double relative = unit.empty() ? value : 0.01 * value;
  if (!(relative > 0.0 && relative <= 1.0)) refuse(text, expected);
  return relative;
}

double parse_duration(const std::string& text) {
  const double seconds = seconds_of(text);
  if (!(seconds > 0.0 && seconds <= longest_s)) {
    refuse(text, "a time above 0 and at most a year, as 60s, 10min, 1h30min or 90 (seconds)");
  }
  return seconds;
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "-";
  if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 3600) {
    return whole % 60 == 0 ? fmt::format("{} min", whole / 60)
                           : fmt::format("{} min {} s", whole / 60, whole % 60);
  }
  const long long minutes = std::llround(seconds / 60.0);
  return minutes % 60 == 0 ? fmt::format("{} h", minutes / 60)
                           : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace nadir::sim
