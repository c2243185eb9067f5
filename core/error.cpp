#include "core/error.hpp"

#include <algorithm>
#include <numeric>

namespace nadir {
namespace {

std::string format_all(const std::vector<InputIssue>& issues) {
  std::string text;
  for (const InputIssue& issue : issues) text += format_issue(issue);
  return text;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string format_issue(const InputIssue& issue) {
  std::string text;
  const SourceLocation& at = issue.where;
  if (!at.file.empty()) {
    text += at.file + ":";
    if (at.line > 0) text += std::to_string(at.line) + ":";
    if (at.line > 0 && at.column > 0) text += std::to_string(at.column) + ":";
    text += " ";
  }
  text += "error: " + issue.message + "\n";
  if (!issue.source_line.empty()) {
    const std::string number = std::to_string(at.line);
    text += "    " + number + " | " + issue.source_line + "\n";
    if (at.column > 0) {
      std::string indent = issue.source_line.substr(0, static_cast<std::size_t>(at.column) - 1);
      for (char& c : indent) c = c == '\t' ? '\t' : ' ';  // tabs keep the caret in its column
      text += "    " + std::string(number.size(), ' ') + " | " + indent + "^\n";
    }
  }
  if (!issue.hint.empty()) text += "    hint: " + issue.hint + "\n";
  return text;
}

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
  std::size_t best_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
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
