#include "sim/scenario/source_text.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace nadir::sim {

SourceText::SourceText(std::string file, std::string text)
    : file_{std::move(file)}, text_{std::move(text)}, line_starts_{0} {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
}

SourceLocation SourceText::locate(std::size_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = after - line_starts_.begin();
  return {file_, static_cast<int>(line), static_cast<int>(offset - *std::prev(after)) + 1};
}

std::string SourceText::line(int number) const {
  const auto index = static_cast<std::size_t>(number) - 1;
  const std::size_t start = line_starts_[index];
  const bool last = index + 1 == line_starts_.size();
  const std::size_t end = last ? text_.size() : line_starts_[index + 1] - 1;
  std::string text = text_.substr(start, end - start);
  if (text.ends_with('\r')) text.pop_back();
  // Bytes that a terminal would act on show as '?': the width stays.
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t') || byte == 0x7F) c = '?';
  }
  return text;
}

InputIssue SourceText::issue(std::size_t offset, std::string message, std::string hint) const {
  const SourceLocation where = locate(offset);
  return {where, std::move(message), std::move(hint), line(where.line)};
}

SourceText read_source_text(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = 64U << 20U;  // an XML file of this size is a mistake
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw InputError{InputIssue{{name, 0, 0}, "the file does not exist", {}, {}}};
  }
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InputError{InputIssue{{name, 0, 0}, "this is not a file", {}, {}}};
  }
  if (std::filesystem::file_size(file, error) > largest || error) {
    throw InputError{InputIssue{{name, 0, 0}, "the file is larger than 64 MB", {}, {}}};
  }
  std::ifstream stream{file, std::ios::binary};
  std::string text{std::istreambuf_iterator<char>{stream}, std::istreambuf_iterator<char>{}};
  if (!stream) throw InputError{InputIssue{{name, 0, 0}, "the file cannot be read", {}, {}}};
  return SourceText{name, std::move(text)};
}

}  // namespace nadir::sim
