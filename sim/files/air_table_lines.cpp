#include "sim/files/air_table_lines.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "sim/files/air_table_file.hpp"
#include "sim/files/hash.hpp"

namespace nadir::sim {
namespace {

class HeadReader {
 public:
  HeadReader(std::string_view bytes, const std::string& name)
      : bytes_{bytes}, rest_{bytes}, issues_{name} {}

  AirTableLines read() {
    first_line();
    AirTableLines lines;
    while (true) {
      const std::size_t start = bytes_.size() - rest_.size();
      const Token line = next("the file ends within its head: it is cut short");
      const std::size_t equals = line.text.find(" = ");
      // Lists may be empty: nothing follows the sign then.
      const bool empty = line.text.ends_with(" =");
      if (equals == std::string_view::npos && !empty) {
        fail(line, "expected \"key = value\", found " + start_in_quotes(line.text));
      }
      const std::size_t key = equals == std::string_view::npos ? line.text.size() - 2 : equals;
      const std::string_view value = line.text.substr(std::min(key + 3, line.text.size()));
      const AirTableEntry entry{line.text.substr(0, key), {value, line.line_text, line.line}};
      if (entry.key == "head_sha256") {
        check_head(entry, bytes_.substr(0, start));
        lines.payload = rest_;
        return lines;
      }
      lines.entries.push_back(entry);
    }
  }

 private:
  void first_line() {
    if (!rest_.starts_with(air_table_magic)) {
      issues_.add("this is no table of the air: its first line is not \"nadir air table 1\"");
      issues_.throw_if_any();
    }
    const Token line = next("the file ends within its first line");
    const std::string_view version = line.text.substr(air_table_magic.size());
    if (version != std::to_string(air_table_version)) {
      fail({version, line.line_text, line.line}, "a table of version " + start_in_quotes(version) +
                                                     "; this program reads version " +
                                                     std::to_string(air_table_version));
    }
  }

  Token next(const char* ended) {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) {
      issues_.add(ended);
      issues_.throw_if_any();
    }
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return {text, text, ++line_};
  }

  void check_head(const AirTableEntry& entry, std::string_view head) {
    const std::string digest = digest_bytes(head).sha256;
    if (entry.value.text == digest) return;
    issues_.add(entry.value, "the head was changed after it was written: its SHA-256 is not this",
                "if it was changed on purpose, write " + digest);
    issues_.throw_if_any();
  }

  [[noreturn]] void fail(const Token& at, const std::string& message) {
    issues_.add(at, message);
    issues_.throw_if_any();
    throw InputError{message};  // not reached
  }

  std::string_view bytes_, rest_;
  FileIssues issues_;
  int line_ = 0;
};

}  // namespace

AirTableLines air_table_lines(std::string_view bytes, const std::string& name) {
  return HeadReader{bytes, name}.read();
}

}  // namespace nadir::sim
