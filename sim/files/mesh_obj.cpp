#include "sim/files/mesh_obj.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sim/files/text_tokens.hpp"
#include "sim/files/texture_seams.hpp"

namespace nadir::sim {
namespace {

// Statements that say nothing about the shape of polygons.
constexpr std::array passed_over{"vn",       "vp",       "s",   "mg",         "mtllib",
                                 "usemap",   "maplib",   "l",   "p",          "bevel",
                                 "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj"};
constexpr std::array free_form{"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",  "parm",
                               "trim",   "hole", "scrv", "sp",   "end",  "con",   "ctech", "stech"};

template <class List>
bool is_in(std::string_view word, const List& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// A corner of a face: its vertex from 0, its texture coordinate from 1, or 0 without one.
struct Corner {
  std::uint32_t vertex = 0, texture = 0;
};

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {}

  geometry::TriangleMesh parse() {
    while (next_statement()) {
      if (!tokens_.empty()) statement();
    }
    check_forward_references();
    if (mesh_.triangles.empty() && issues_.empty()) issues_.add("the file has no faces");
    issues_.throw_if_any();
    if (any_texture_) set_texture(mesh_, texture_, corner_texture_);
    return std::move(mesh_);
  }

 private:
  /// Splits the next line, and those that a backslash joins to it. False at the end of the file.
  bool next_statement() {
    tokens_.clear();
    if (rest_.empty()) return false;
    bool continued = true;
    while (continued && !rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++line_;
      std::string_view words = without_blanks(line);
      continued = words.ends_with('\\');
      if (continued) words.remove_suffix(1);
      split(words, line);
    }
    return true;
  }

  void split(std::string_view words, std::string_view line) {
    while (!(words = without_blanks(words)).empty() && words.front() != '#') {
      const std::string_view word = words.substr(0, words.find_first_of(" \t"));
      tokens_.push_back({word, line, line_});
      words.remove_prefix(word.size());
    }
  }

  void statement() {
    const std::string_view keyword = tokens_.front().text;
    if (keyword == "v") {
      const auto xyz = numbers(3, 3);
      if (const std::size_t count = tokens_.size() - 1; count == 5 || count > 7) wrong_count(3);
      mesh_.positions.push_back({xyz[0], xyz[1], xyz[2]});  // also a wrong one: the others count on
    } else if (keyword == "vt") {
      const auto uvw = numbers(2, 1);
      texture_.push_back({uvw[0], uvw[1]});
    } else if (keyword == "f") {
      face();
    } else if (keyword == "usemtl") {
      material_ = name();
    } else if (keyword == "g" || keyword == "o") {
      group_ = name();
    } else if (is_in(keyword, free_form)) {
      issues_.add(tokens_.front(), "free-form curves and surfaces are not read",
                  "export the model as polygons");
    } else if (!is_in(keyword, passed_over)) {
      unknown();
    }
  }

  void unknown() {
    std::vector<std::string> known{"v", "f", "usemtl", "g", "o"};
    known.insert(known.end(), passed_over.begin(), passed_over.end());
    const std::string word{tokens_.front().text};
    const std::string nearest = nearest_name(word, known);
    issues_.add(tokens_.front(), "\"" + word + "\" is no statement of an OBJ file",
                nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
  }

  /// What follows the keyword, blanks within it included.
  [[nodiscard]] std::string name() const {
    if (tokens_.size() < 2) return {};
    const char* begin = tokens_[1].text.data();
    const std::string_view last = tokens_.back().text;
    if (tokens_.back().line != tokens_[1].line) return std::string{tokens_[1].text};
    return {begin, last.data() + last.size()};
  }

  void wrong_count(std::size_t expected) {
    issues_.add(tokens_.front(), "expected " + std::to_string(expected) + " coordinates, found " +
                                     std::to_string(tokens_.size() - 1));
  }

  /// The first coordinates of the statement; all that follow must be numbers too.
  std::array<double, 3> numbers(std::size_t expected, std::size_t least) {
    const std::size_t count = tokens_.size() - 1;
    if (count < least) wrong_count(expected);
    std::array<double, 3> first{};
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = strict_number_in<double>(tokens_[i + 1].text);
      if (!value) {
        issues_.add(tokens_[i + 1],
                    "expected a finite number, found \"" + std::string{tokens_[i + 1].text} + "\"");
      } else if (i < first.size()) {
        first[i] = *value;
      }
    }
    return first;
  }

  void face() {
    if (tokens_.size() < 4) {
      issues_.add(tokens_.front(), "expected a face of at least 3 corners, found " +
                                       std::to_string(tokens_.size() - 1));
      return;
    }
    corners_.clear();
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      if (const auto vertex = corner(tokens_[i])) corners_.push_back(*vertex);
    }
    if (corners_.size() + 1 < tokens_.size()) return;
    const std::uint32_t part = this->part();
    for (std::size_t i = 2; i < corners_.size(); ++i) {
      const Corner &a = corners_[0], &b = corners_[i - 1], &c = corners_[i];
      mesh_.triangles.push_back({a.vertex, b.vertex, c.vertex});
      corner_texture_.push_back({a.texture, b.texture, c.texture});
      any_texture_ = any_texture_ || a.texture != 0 || b.texture != 0 || c.texture != 0;
      mesh_.parts.push_back(part);
    }
  }

  /// v, v/vt, v//vn or v/vt/vn.
  std::optional<Corner> corner(const Token& token) {
    std::string_view fields[3];
    std::string_view left = token.text;
    int count = 0;
    for (bool more = true; more && count < 3; ++count) {
      const std::size_t slash = left.find('/');
      fields[count] = left.substr(0, slash);
      more = slash != std::string_view::npos;
      left.remove_prefix(more ? slash + 1 : left.size());
      if (more && count == 2) count = 3;  // a third slash
    }
    const auto vertex = strict_number_in<std::int64_t>(fields[0]);
    const bool good = vertex && *vertex != 0 && count <= 3 && is_reference(fields[1]) &&
                      is_reference(fields[2]) && !token.text.ends_with('/');
    if (good) {
      const auto position = resolved(token, *vertex, mesh_.positions.size(), "vertex ");
      const auto number = strict_number_in<std::int64_t>(fields[1]);
      if (!number || !position)
        return position ? std::optional{Corner{*position, 0}} : std::nullopt;
      const auto texture = resolved(token, *number, texture_.size(), "texture coordinate of ");
      if (!texture) return std::nullopt;
      return Corner{*position, *texture + 1};
    }
    issues_.add(token, "expected a corner such as 7, 7/2, 7//3 or 7/2/3, found \"" +
                           std::string{token.text} + "\"");
    return std::nullopt;
  }

  static bool is_reference(std::string_view field) {
    return field.empty() || strict_number_in<std::int64_t>(field).value_or(0) != 0;
  }

  /// Counted from 0. @param there  how many there are so far
  std::optional<std::uint32_t> resolved(const Token& token, std::int64_t index, std::size_t there,
                                        const char* what) {
    const auto count = static_cast<std::int64_t>(there);
    if (index < -count || index > std::int64_t{0xFFFFFFFE}) {
      out_of_range(token, count, what);
      return std::nullopt;
    }
    if (index > count) forward_.push_back({token, index, what});
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
  }

  void out_of_range(const Token& token, std::int64_t count, const char* what) {
    const bool is_vertex = what[0] == 'v';
    issues_.add(token, what +
                           std::string{token.text.substr(
                               0, is_vertex ? token.text.find('/') : token.text.size())} +
                           " does not exist: there are " + std::to_string(count));
  }

  /// Faces may name vertices and texture coordinates that come later in the file.
  void check_forward_references() {
    for (const auto& [token, index, what] : forward_) {
      const auto count =
          static_cast<std::int64_t>(what[0] == 'v' ? mesh_.positions.size() : texture_.size());
      if (index > count) out_of_range(token, count, what);
    }
  }

  std::uint32_t part() {
    const std::string& own = !material_.empty() ? material_ : group_;
    const std::string name = own.empty() ? "default" : own;
    if (name != part_name_ || mesh_.part_names.empty()) {
      const auto next = static_cast<std::uint32_t>(mesh_.part_names.size());
      const auto [entry, is_new] = part_numbers_.try_emplace(name, next);
      if (is_new) mesh_.part_names.push_back(name);
      part_name_ = name;
      part_ = entry->second;
    }
    return part_;
  }

  struct ForwardReference {
    Token token;
    std::int64_t index;
    const char* what;
  };

  std::string_view rest_;
  FileIssues issues_;
  int line_ = 0;
  std::vector<Token> tokens_;
  std::vector<Corner> corners_;
  std::vector<Vec2> texture_;
  std::vector<CornerTexture> corner_texture_;
  bool any_texture_ = false;
  std::vector<ForwardReference> forward_;
  std::string material_, group_, part_name_;
  std::map<std::string, std::uint32_t> part_numbers_;
  std::uint32_t part_ = 0;
  geometry::TriangleMesh mesh_;
};

}  // namespace

geometry::TriangleMesh parse_obj(std::string_view text, const std::string& name) {
  return ObjParser{text, name}.parse();
}

geometry::TriangleMesh read_obj(const std::filesystem::path& file) {
  return parse_obj(read_bytes(file), file.string());
}

}  // namespace nadir::sim
