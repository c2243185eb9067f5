#include "sim/scenario/strict_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace nadir::sim {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_sign(std::string_view text) {
  const bool sign = text.starts_with('+') || text.starts_with('-');
  return text.substr(sign ? 1 : 0);
}

std::size_t leading_digits(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) -
                                  text.begin());
}

/// digits [. digits] [e [sign] digits], with a digit before or after the point.
bool has_decimal_form(std::string_view text) {
  const std::size_t whole = leading_digits(text);
  text.remove_prefix(whole);
  std::size_t decimals = 0;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    decimals = leading_digits(text);
    text.remove_prefix(decimals);
  }
  if (whole + decimals == 0) return false;
  if (text.empty()) return true;
  if (text[0] != 'e' && text[0] != 'E') return false;
  const std::string_view exponent = without_sign(text.substr(1));
  return !exponent.empty() && leading_digits(exponent) == exponent.size();
}

/// For a text of decimal form that no double holds: whether it is too small rather than too large.
bool is_tiny(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  // Power of ten of the first digit; a double's range ends near 1e-324 and 1e308.
  double power = static_cast<double>(point) - static_cast<double>(first);
  if (e != std::string_view::npos) {
    const bool negative = text.substr(e + 1).starts_with('-');
    double exponent = 0.0;
    for (const char c : without_sign(text.substr(e + 1))) exponent = exponent * 10.0 + (c - '0');
    power += negative ? -exponent : exponent;
  }
  return power < 0.0;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> strict_number(std::string_view text) {
  const std::string_view body = without_sign(text);
  if (!has_decimal_form(body)) return std::nullopt;
  double value = 0.0;
  const auto result = std::from_chars(body.data(), body.data() + body.size(), value);
  if (result.ec == std::errc::result_out_of_range) {
    if (!is_tiny(body)) return std::nullopt;
    value = 0.0;
  } else if (result.ec != std::errc{} || result.ptr != body.data() + body.size()) {
    return std::nullopt;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return text.starts_with('-') ? -value : value;
}

std::optional<int> strict_integer(std::string_view text) {
  const std::string_view digits = without_sign(text);
  if (digits.empty() || leading_digits(digits) != digits.size()) return std::nullopt;
  long long value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ec != std::errc{}) return std::nullopt;
  if (text.starts_with('-')) value = -value;
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max()) {
    return std::nullopt;
  }
  return static_cast<int>(value);
}

}  // namespace nadir::sim
