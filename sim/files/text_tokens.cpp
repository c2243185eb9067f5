#include "sim/files/text_tokens.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "core/text.hpp"

namespace nadir::sim {
namespace {

constexpr std::size_t most_issues = 20;

}  // namespace

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  // A folder opens, but does not read.
  if (!stream || std::filesystem::is_directory(file)) {
    throw InputError{InputIssue{{file.string(), 0, 0}, "the file cannot be read", {}, {}}};
  }
  std::string bytes;
  std::error_code unknown;
  if (const auto size = std::filesystem::file_size(file, unknown); !unknown) bytes.reserve(size);
  bytes.assign(std::istreambuf_iterator<char>{stream}, {});
  return bytes;
}

std::string_view take_line(std::string_view& rest) {
  const std::size_t end = rest.find_first_of("\r\n");
  const std::string_view line = rest.substr(0, end);
  if (end == std::string_view::npos) {
    rest = {};
    return line;
  }
  const bool pair = rest[end] == '\r' && end + 1 < rest.size() && rest[end + 1] == '\n';
  rest.remove_prefix(end + (pair ? 2 : 1));
  return line;
}

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

void FileIssues::add(const Token& at, std::string message, std::string hint) {
  const auto column = at.text.data() - at.line_text.data() + 1;
  keep({{file_, at.line, static_cast<int>(column)},
        std::move(message),
        std::move(hint),
        std::string{at.line_text}});
}

std::string start_in_quotes(std::string_view text) { return in_quotes(text.substr(0, 60)); }

void FileIssues::add(std::string message) { keep({{file_, 0, 0}, std::move(message), {}, {}}); }

void FileIssues::keep(InputIssue issue) {
  if (issues_.size() < most_issues) {
    issues_.push_back(std::move(issue));
  } else {
    ++left_out_;
  }
}

void FileIssues::throw_if_any() const {
  if (issues_.empty()) return;
  std::vector<InputIssue> all = issues_;
  if (left_out_ > 0) {
    all.push_back({{file_, 0, 0}, "and " + std::to_string(left_out_) + " more mistakes", {}, {}});
  }
  throw InputError{std::move(all)};
}

}  // namespace nadir::sim
