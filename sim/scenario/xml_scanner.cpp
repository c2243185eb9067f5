#include "sim/scenario/xml_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace nadir::sim {
namespace {

using std::string_view;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool starts_name(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' || byte >= 0x80;
}
bool continues_name(char c) {
  return starts_name(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// The Char production of XML 1.0.
bool is_xml_character(std::uint32_t code) {
  if (code < 0x20) return code == 0x9 || code == 0xA || code == 0xD;
  return code < 0xD800 || (code > 0xDFFF && code < 0xFFFE) || (code > 0xFFFF && code <= 0x10FFFF);
}

/// Bytes of the UTF-8 character at `text`'s start, and its code; 0 bytes where it is malformed.
struct Utf8Character {
  std::size_t bytes = 0;
  std::uint32_t code = 0;
};
Utf8Character utf8_character(string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {1, byte(0)};
  const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = byte(0) & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};  // no overlong forms
  return code < smallest[bytes] ? Utf8Character{} : Utf8Character{bytes, code};
}

class Scanner {
 public:
  explicit Scanner(const SourceText& source) : source_{source}, text_{source.text()} {}

  std::vector<ScannedElement> run() {
    check_characters();
    if (at("<?xml") && text_.size() > 5 && is_blank(text_[5])) declaration();
    while (!at_end()) {
      if (at("<")) {
        markup();
      } else {
        character_data();
      }
    }
    if (!open_.empty()) {
      const ScannedElement& element = elements_[open_.back()];
      fail(element.offset, "<" + element.name + "> is never closed",
           "close it with </" + element.name + "> or write <" + element.name + " .../>");
    }
    if (elements_.empty()) fail(0, "the file holds no XML element");
    return std::move(elements_);
  }

 private:
  [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const {
    throw InputError{source_.issue(offset, std::move(message), std::move(hint))};
  }
  [[nodiscard]] bool at_end() const { return pos_ >= text_.size(); }
  [[nodiscard]] bool at(string_view token) const {
    return text_.substr(pos_, token.size()) == token;
  }

  void check_characters() const {
    for (std::size_t i = 0; i < text_.size();) {
      const Utf8Character character = utf8_character(text_.substr(i));
      if (character.bytes == 0) fail(i, "this byte is not part of UTF-8 text");
      if (!is_xml_character(character.code)) {
        fail(i, "XML may not hold control character number " + std::to_string(character.code));
      }
      i += character.bytes;
    }
  }

  bool skip_blanks() {
    const std::size_t start = pos_;
    while (!at_end() && is_blank(text_[pos_])) ++pos_;
    return pos_ != start;
  }

  /// Moves past the next `token`; `start` and `what` tell what it should have closed.
  void skip_past(string_view token, std::size_t start, const char* what) {
    const std::size_t found = text_.find(token, pos_);
    if (found == string_view::npos) fail(start, std::string{what} + " is never closed");
    pos_ = found + token.size();
  }

  std::string name(const char* what) {
    const std::size_t start = pos_;
    if (at_end() || !starts_name(text_[pos_])) fail(pos_, std::string{"expected "} + what);
    while (!at_end() && continues_name(text_[pos_])) ++pos_;
    return std::string{text_.substr(start, pos_ - start)};
  }

  void markup() {
    if (at("<!--")) {
      comment();
    } else if (at("<![CDATA[")) {
      const std::size_t start = pos_;
      stray(start);
      skip_past("]]>", start, "this CDATA section");
    } else if (at("<!")) {
      fail(pos_, "only elements and comments may stand here",
           "document type declarations are not used in Nadir's files");
    } else if (at("<?")) {
      processing_instruction();
    } else if (at("</")) {
      end_tag();
    } else {
      start_tag();
    }
  }

  void comment() {
    const std::size_t start = pos_;
    pos_ += 4;
    const std::size_t dashes = text_.find("--", pos_);
    if (dashes == string_view::npos) fail(start, "this comment is never closed", "end it with -->");
    if (text_.substr(dashes, 3) != "-->") fail(dashes, "a comment may not hold --");
    pos_ = dashes + 3;
    comments_ = true;
  }

  void processing_instruction() {
    const std::size_t start = pos_;
    pos_ += 2;
    std::string target = name("the name of a processing instruction");
    for (char& c : target) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (target == "xml") fail(start, "the XML declaration may only stand at the file's very start");
    if (!elements_.empty() || comments_) {  // tinyxml2's rule, stricter than XML's
      fail(start, "processing instructions may only stand before the root and comments");
    }
    if (!at("?>") && !(pos_ < text_.size() && is_blank(text_[pos_]))) {
      fail(pos_, "expected a blank or ?>");
    }
    skip_past("?>", start, "this processing instruction");
  }

  void declaration() {
    pos_ = 5;
    const std::vector<string_view> known = {"version", "encoding", "standalone"};
    std::size_t next = 0;
    while (skip_blanks() && !at("?>")) {
      const std::size_t start = pos_;
      const std::string key = name("version, encoding or standalone");
      const string_view value = quoted_value(key);
      const auto found =
          std::find(known.begin() + static_cast<std::ptrdiff_t>(next), known.end(), key);
      const bool misplaced = found == known.end() || (next == 0 && key != "version");
      if (misplaced) fail(start, "the XML declaration may not hold \"" + key + "\" here");
      next = static_cast<std::size_t>(found - known.begin()) + 1;
      check_declared(key, value, start);
    }
    if (!at("?>") || next == 0) fail(pos_, "expected <?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    pos_ += 2;
  }

  void check_declared(const std::string& key, string_view value, std::size_t start) const {
    if (key == "version" && value != "1.0") fail(start, "expected XML version 1.0");
    if (key == "standalone" && value != "yes" && value != "no") fail(start, "expected yes or no");
    if (key != "encoding") return;
    std::string upper{value};
    for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (upper != "UTF-8" && upper != "US-ASCII") {
      fail(start, "the encoding is \"" + std::string{value} + "\", expected UTF-8");
    }
  }

  void start_tag() {
    const std::size_t start = pos_++;
    ScannedElement element;
    element.offset = start;
    element.name = name("the name of an element after <");
    if (open_.empty() && !elements_.empty()) {
      fail(start, "a second root element <" + element.name + ">; the first, <" + elements_[0].name +
                      ">, ends before it");
    }
    if (open_.size() >= deepest_element) fail(start, "elements are nested too deeply");
    while (skip_blanks() && !at("/>") && !at(">")) attribute(element);
    const bool closed = at("/>");
    if (!closed && !at(">")) {
      fail(pos_, "expected a blank, > or /> in the tag <" + element.name + ">");
    }
    pos_ += closed ? 2 : 1;
    elements_.push_back(std::move(element));
    if (!closed) open_.push_back(elements_.size() - 1);
  }

  void attribute(ScannedElement& element) {
    const std::size_t start = pos_;
    std::string key = name("the name of an attribute, > or />");
    const auto same = [&](const ScannedAttribute& other) { return other.name == key; };
    if (std::any_of(element.attributes.begin(), element.attributes.end(), same)) {
      fail(start, "<" + element.name + "> has attribute \"" + key + "\" twice");
    }
    static_cast<void>(quoted_value(key));
    element.attributes.push_back({std::move(key), start});
  }

  string_view quoted_value(const std::string& key) {
    skip_blanks();
    if (!at("=")) fail(pos_, "expected = after the attribute's name \"" + key + "\"");
    ++pos_;
    skip_blanks();
    if (!at("\"") && !at("'")) fail(pos_, "expected \"...\" as the value of \"" + key + "\"");
    const char quote = text_[pos_];
    const std::size_t start = pos_++;
    while (!at_end() && text_[pos_] != quote) {
      if (text_[pos_] == '<') {
        fail(pos_, "the value of \"" + key + "\" holds <", "close the quotation or write &lt;");
      }
      if (text_[pos_] == '&') {
        reference();
      } else {
        ++pos_;
      }
    }
    if (at_end()) fail(start, "the value of \"" + key + "\" is never closed");
    return text_.substr(start + 1, pos_++ - start - 1);
  }

  void end_tag() {
    const std::size_t start = pos_;
    pos_ += 2;
    const std::string closing = name("the name of an element after </");
    if (open_.empty()) fail(start, "</" + closing + "> closes nothing");
    const ScannedElement& element = elements_[open_.back()];
    if (element.name != closing) {
      fail(start, "</" + closing + "> where </" + element.name + "> is due for <" + element.name +
                      "> of line " + std::to_string(source_.locate(element.offset).line));
    }
    skip_blanks();
    if (!at(">")) fail(pos_, "expected > to end </" + closing);
    ++pos_;
    open_.pop_back();
  }

  void character_data() {
    while (!at_end() && text_[pos_] != '<') {
      if (at("]]>")) fail(pos_, "]]> may not stand in text");
      if (!is_blank(text_[pos_])) stray(pos_);
      if (text_[pos_] == '&') {
        reference();
      } else {
        ++pos_;
      }
    }
  }

  void stray(std::size_t offset) {
    if (open_.empty()) fail(offset, "text outside the root element");
    std::optional<std::size_t>& first = elements_[open_.back()].stray_text;
    if (!first) first = offset;
  }

  /// &lt; &gt; &amp; &quot; &apos; &#10; &#xA;
  void reference() {
    const std::size_t start = pos_;
    const std::size_t end = text_.find(';', start);
    const std::size_t longest = 12;  // &#x0010FFFF; and a few zeros more
    const string_view body = end == string_view::npos || end - start > longest
                                 ? string_view{}
                                 : text_.substr(start + 1, end - start - 1);
    const bool named =
        body == "lt" || body == "gt" || body == "amp" || body == "quot" || body == "apos";
    if (!named && !is_character_reference(body)) {
      fail(start, "& starts no known character entity", "write &amp; for the character &");
    }
    pos_ = end + 1;
  }

  static bool is_character_reference(string_view body) {
    if (!body.starts_with('#')) return false;
    const bool hexadecimal = body.starts_with("#x");
    const string_view digits = body.substr(hexadecimal ? 2 : 1);
    std::uint32_t code = 0;
    const char* end = digits.data() + digits.size();
    const auto result = std::from_chars(digits.data(), end, code, hexadecimal ? 16 : 10);
    return result.ec == std::errc{} && result.ptr == end && is_xml_character(code);
  }

  const SourceText& source_;
  string_view text_;
  std::size_t pos_ = 0;
  bool comments_ = false;  // whether there was one
  std::vector<ScannedElement> elements_;
  std::vector<std::size_t> open_;  // indices into elements_
};

}  // namespace

std::vector<ScannedElement> scan_xml(const SourceText& source) { return Scanner{source}.run(); }

}  // namespace nadir::sim
