#include "core/error.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace nadir {
namespace {

std::string format_all(const std::vector<InputIssue>& issues) {
  std::string text;
  for (const InputIssue& issue : issues) text += format_issue(issue);
  return text;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Edit distance with exchanged neighbours as one edit (optimal string alignment: Damerau, Comm.
/// ACM 7(3), 171, 1964), blind to the case of ASCII letters.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> two_back(b.size() + 1), back(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  const auto same = [&](std::size_t i, std::size_t j) { return lower(a[i]) == lower(b[j]); };
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_back.swap(back);
    back.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = back[j - 1] + (same(i - 1, j - 1) ? 0 : 1);
      row[j] = std::min({back[j] + 1, row[j - 1] + 1, substituted});
      if (i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1)) {
        row[j] = std::min(row[j], two_back[j - 2] + 1);
      }
    }
  }
  return row.back();
}

/// What stands under the text before the caret: blanks, tabs where the text has tabs, and nothing
/// for the later bytes of a UTF-8 character, so that the caret ends up in its column.
std::string caret_indent(const std::string& line, int column) {
  std::string indent;
  for (const char c : line.substr(0, static_cast<std::size_t>(column) - 1)) {
    const bool continues_character = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    if (!continues_character) indent += c == '\t' ? '\t' : ' ';
  }
  return indent;
}

std::string format_location(const SourceLocation& at) {
  if (at.file.empty()) return {};
  std::string text = at.file + ":";
  if (at.line > 0) text += std::to_string(at.line) + ":";
  if (at.line > 0 && at.column > 0) text += std::to_string(at.column) + ":";
  return text + " ";
}

/// The source line behind its number, and a second line with the caret.
std::string format_source(const InputIssue& issue) {
  const std::string number = issue.where.line > 0 ? std::to_string(issue.where.line) : "";
  std::string text = "    " + number + " | " + issue.source_line + "\n";
  if (issue.where.column > 0) {
    text += "    " + std::string(number.size(), ' ') + " | " +
            caret_indent(issue.source_line, issue.where.column) + "^\n";
  }
  return text;
}

}  // namespace

std::string format_issue(const InputIssue& issue) {
  std::string text = format_location(issue.where) + "error: " + issue.message + "\n";
  if (!issue.source_line.empty()) text += format_source(issue);
  if (!issue.hint.empty()) text += "    hint: " + issue.hint + "\n";
  return text;
}

InputError::InputError(InputIssue issue) : InputError{std::vector<InputIssue>{std::move(issue)}} {}

InputError::InputError(std::string message)
    : InputError{InputIssue{{}, std::move(message), {}, {}}} {}

InputError::InputError(std::vector<InputIssue> issues)
    : std::runtime_error{format_all(issues)}, issues_{std::move(issues)} {}

InputError InputError::located(const SourceLocation& where, const std::string& source_line) const {
  std::vector<InputIssue> placed = issues_;
  for (InputIssue& issue : placed) {
    if (!issue.where.file.empty()) continue;
    issue.where = where;
    issue.source_line = source_line;
  }
  return InputError{std::move(placed)};
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::min(name.size(), std::max<std::size_t>(1, name.size() / 3) + 1);
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace nadir
