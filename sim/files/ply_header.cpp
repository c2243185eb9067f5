#include "sim/files/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace nadir::sim::ply {
namespace {

constexpr std::array<std::pair<std::string_view, Type>, 16> type_names{
    {{"char", Type::int8},
     {"int8", Type::int8},
     {"uchar", Type::uint8},
     {"uint8", Type::uint8},
     {"short", Type::int16},
     {"int16", Type::int16},
     {"ushort", Type::uint16},
     {"uint16", Type::uint16},
     {"int", Type::int32},
     {"int32", Type::int32},
     {"uint", Type::uint32},
     {"uint32", Type::uint32},
     {"float", Type::float32},
     {"float32", Type::float32},
     {"double", Type::float64},
     {"float64", Type::float64}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, FileIssues& issues) : rest_{bytes}, issues_{&issues} {}

  Header parse() {
    if (!next() || words_.front().text != "ply") {
      issues_->add("this is no PLY file: its first line is not \"ply\"");
      issues_->throw_if_any();
    }
    while (next() && words_.front().text != "end_header") line();
    if (words_.empty()) issues_->add("the header has no end: \"end_header\" is missing");
    if (!has_format_) issues_->add("the header has no line \"format\"");
    issues_->throw_if_any();
    header_.body = rest_;
    header_.lines = line_number_;
    return std::move(header_);
  }

 private:
  /// False, with no words, at the end of the file.
  bool next() {
    words_.clear();
    while (words_.empty() && !rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++line_number_;
      std::string_view left = line;
      while (!(left = without_blanks(left)).empty()) {
        words_.push_back({left.substr(0, left.find_first_of(" \t")), line, line_number_});
        left.remove_prefix(words_.back().text.size());
      }
    }
    return !words_.empty();
  }

  void line() {
    const std::string_view keyword = words_.front().text;
    if (keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format") {
      format();
    } else if (keyword == "element") {
      element();
    } else if (keyword == "property") {
      property();
    } else {
      issues_->add(words_.front(),
                   "expected format, element, property, comment or end_header, found \"" +
                       std::string{keyword.substr(0, 40)} + "\"");
    }
  }

  void format() {
    has_format_ = true;
    const std::string_view name = words_.size() > 1 ? words_[1].text : "";
    if (name == "binary_little_endian") {
      header_.format = Format::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = Format::big_endian;
    } else if (name != "ascii") {
      issues_->add(words_.back(), "expected ascii, binary_little_endian or binary_big_endian");
    }
    if (words_.size() != 3 || words_[2].text != "1.0") {
      issues_->add(words_.back(), "expected version 1.0 of the format");
    }
  }

  void element() {
    const auto count = words_.size() == 3 ? strict_number_in<std::uint64_t>(words_[2].text)
                                          : std::optional<std::uint64_t>{};
    if (!count) {
      issues_->add(words_.back(), "expected \"element\", a name and a count");
      return;
    }
    header_.elements.push_back({std::string{words_[1].text}, *count, {}});
  }

  void property() {
    if (header_.elements.empty()) {
      issues_->add(words_.front(), "a property before the first element");
      return;
    }
    const bool is_list = words_.size() == 5 && words_[1].text == "list";
    if (!is_list && words_.size() != 3) {
      issues_->add(words_.back(), "expected \"property\", a type and a name");
      return;
    }
    Property property;
    property.name = words_.back().text;
    property.type = type(words_[words_.size() - 2]);
    if (is_list) {
      property.list_count = type(words_[2]);
      if (*property.list_count >= Type::float32) {
        issues_->add(words_[2], "the count of a list must have an integer type");
      }
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  Type type(const Token& word) {
    const auto found = std::find_if(type_names.begin(), type_names.end(),
                                    [&](const auto& entry) { return entry.first == word.text; });
    if (found != type_names.end()) return found->second;
    issues_->add(word, "unknown type \"" + std::string{word.text} + "\"");
    return Type::float32;
  }

  std::string_view rest_;
  FileIssues* issues_;
  std::vector<Token> words_;
  Header header_;
  int line_number_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

Header parse_header(std::string_view bytes, FileIssues& issues) {
  return HeaderParser{bytes, issues}.parse();
}

}  // namespace nadir::sim::ply
