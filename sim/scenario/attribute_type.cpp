#include "sim/scenario/attribute_type.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "sim/scenario/strict_number.hpp"

namespace nadir::sim {
namespace {

constexpr std::string_view blanks = " \t\r\n";

bool within(const NumberType& type, double value) {
  return (type.above ? value > type.min : value >= type.min) &&
         (type.below ? value < type.max : value <= type.max);
}

std::optional<double> number_within(const NumberType& type, std::string_view text) {
  const std::optional<double> value = strict_number(text);
  return value && within(type, *value) ? value : std::nullopt;
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> list;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    list.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return list;
}

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_name(std::string_view text) {
  const auto allowed = [](char c) { return is_letter_or_digit(c) || c == '.' || c == '-'; };
  return !text.empty() && is_letter_or_digit(text[0]) &&
         std::all_of(text.begin(), text.end(), allowed);
}

/// Without regard to the case of ASCII letters; something must stand before the suffix.
bool has_suffix(std::string_view text, std::string_view suffix) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const auto same = [&](char a, char b) { return lower(a) == lower(b); };
  return text.size() > suffix.size() &&
         std::equal(suffix.begin(), suffix.end(), text.end() - static_cast<long>(suffix.size()),
                    same);
}

/// `file.csv` or `file.csv#column`.
std::optional<SpectralInput> spectrum_column(std::string_view text) {
  const std::size_t hash = text.find('#');
  const std::string_view file = text.substr(0, hash);
  if (!has_suffix(file, ".csv")) return std::nullopt;
  if (hash == std::string_view::npos) return SpectralInput{std::filesystem::path{file}, {}};
  const std::string_view column = text.substr(hash + 1);
  if (column.empty() || column.find('#') != std::string_view::npos) return std::nullopt;
  return SpectralInput{std::filesystem::path{file}, std::string{trimmed(column)}};
}

/// One function a type. Nothing means: the text is not what `expectation` says.
struct Parser {
  std::string_view text;  // trimmed

  std::optional<AttributeValue> operator()(const NumberType& type) const {
    const auto value = number_within(type, text);
    return value ? std::optional<AttributeValue>{*value} : std::nullopt;
  }
  std::optional<AttributeValue> operator()(const IntegerType& type) const {
    const auto value = strict_integer(text);
    if (!value || *value < type.min || *value > type.max) return std::nullopt;
    return *value;
  }
  std::optional<AttributeValue> operator()(const VectorType& type) const {
    std::vector<double> numbers;
    for (const std::string_view word : words(text)) {
      const auto value = number_within(type.component, word);
      if (!value) return std::nullopt;
      numbers.push_back(*value);
    }
    if (type.one_for_all && numbers.size() == 1) return Vec3{numbers[0], numbers[0], numbers[0]};
    if (numbers.size() != 3) return std::nullopt;
    return Vec3{numbers[0], numbers[1], numbers[2]};
  }
  std::optional<AttributeValue> operator()(const TextType& /*type*/) const {
    if (text.empty()) return std::nullopt;
    return std::string{text};
  }
  std::optional<AttributeValue> operator()(const NameType& /*type*/) const {
    if (!is_name(text)) return std::nullopt;
    return std::string{text};
  }
  std::optional<AttributeValue> operator()(const NamesType& type) const {
    const auto list = words(text);
    const bool named = std::all_of(list.begin(), list.end(), is_name);
    if (!named || list.empty() || list.size() > static_cast<std::size_t>(type.most)) {
      return std::nullopt;
    }
    return std::vector<std::string>(list.begin(), list.end());
  }
  std::optional<AttributeValue> operator()(const EnumerationType& type) const {
    const auto found = std::find(type.values.begin(), type.values.end(), text);
    if (found == type.values.end()) return std::nullopt;
    return *found;
  }
  std::optional<AttributeValue> operator()(const PathType& type) const {
    const auto fits = [&](const std::string& suffix) { return has_suffix(text, suffix); };
    const bool any = type.suffixes.empty() && !text.empty();
    if (!any && std::none_of(type.suffixes.begin(), type.suffixes.end(), fits)) return std::nullopt;
    return std::filesystem::path{text};
  }
  std::optional<AttributeValue> operator()(const SpectralType& type) const {
    if (const auto value = number_within(type.number, text)) return SpectralInput{*value, {}};
    return (*this)(ColumnType{});
  }
  std::optional<AttributeValue> operator()(const ColumnType& /*type*/) const {
    const auto column = spectrum_column(text);
    return column ? std::optional<AttributeValue>{*column} : std::nullopt;
  }
  std::optional<AttributeValue> operator()(const InstantType& /*type*/) const {
    return ephemeris::Instant::parse_utc(text);
  }
};

struct Expectation {
  std::string operator()(const NumberType& t) const { return "a number " + bounds(t); }
  std::string operator()(const IntegerType& t) const {
    return fmt::format("a whole number from {} to {}", t.min, t.max);
  }
  std::string operator()(const VectorType& t) const {
    return (t.one_for_all ? "one number or three, each " : "three numbers, each ") +
           bounds(t.component);
  }
  std::string operator()(const TextType& /*t*/) const { return "a text"; }
  std::string operator()(const NameType& /*t*/) const {
    return "a name of letters, digits and _ . -";
  }
  std::string operator()(const NamesType& t) const {
    return fmt::format("1 to {} names with blanks between them", t.most);
  }
  std::string operator()(const EnumerationType& t) const {
    return fmt::format("{}", fmt::join(t.values, " or "));
  }
  std::string operator()(const PathType& t) const {
    return t.suffixes.empty() ? "a file" : fmt::format("a file *{}", fmt::join(t.suffixes, ", *"));
  }
  std::string operator()(const SpectralType& t) const {
    return (*this)(t.number) + ", or " + (*this)(ColumnType{});
  }
  std::string operator()(const ColumnType& /*t*/) const {
    return "a spectrum file *.csv or *.csv#column";
  }
  std::string operator()(const InstantType& /*t*/) const {
    return "a time in UTC such as 2026-06-21T16:00:00Z";
  }

  static std::string bounds(const NumberType& t) {
    if (!t.above && !t.below) {
      return fmt::format("from {} to {}", number_text(t.min), number_text(t.max));
    }
    return fmt::format("{} {} and {} {}", t.above ? "above" : "at least", number_text(t.min),
                       t.below ? "below" : "at most", number_text(t.max));
  }
};

}  // namespace

ParsedAttribute parse_attribute(const AttributeType& type, std::string_view text) {
  try {
    if (auto value = std::visit(Parser{trimmed(text)}, type)) return {std::move(*value), {}};
  } catch (const InputError& error) {  // a time of the right form that does not exist
    return {error.issues().front().message, {}};
  }
  constexpr std::size_t longest = 60;  // a value may be a pasted page: its beginning will do
  const std::string_view more = text.size() > longest ? "..." : "";
  ParsedAttribute wrong{
      fmt::format("\"{}{}\", expected {}", text.substr(0, longest), more, expectation(type)), {}};
  if (const auto* closed = std::get_if<EnumerationType>(&type)) {
    wrong.hint = nearest_name(std::string{text}, closed->values);
  }
  return wrong;
}

std::string expectation(const AttributeType& type) { return std::visit(Expectation{}, type); }

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  if (std::abs(value) < 1e6) return text;
  text = fmt::format("{:e}", value);  // 1.000000e+09 -> 1e9; the table has round numbers only
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.ends_with('.')) mantissa.pop_back();
  return mantissa + "e" + std::to_string(std::stoi(text.substr(e + 1)));
}

}  // namespace nadir::sim
