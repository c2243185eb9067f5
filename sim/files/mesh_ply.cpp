#include "sim/files/mesh_ply.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/constants.hpp"
#include "sim/files/ply_header.hpp"

namespace nadir::sim {
namespace {

using ply::Element, ply::Format, ply::Header, ply::Property, ply::Type;

/// Numbers of the body one after the other. All types fit a double without loss.
class AsciiSource {
 public:
  explicit AsciiSource(const Header& header) : rest_{header.body}, line_number_{header.lines} {}

  /// NaN for a word that is no number; nothing at the end of the file.
  std::optional<double> next(Type /*type*/) {
    while ((line_left_ = without_blanks(line_left_)).empty()) {
      if (rest_.empty()) return std::nullopt;
      line_ = line_left_ = take_line(rest_);
      ++line_number_;
    }
    last_ = {line_left_.substr(0, line_left_.find_first_of(" \t")), line_, line_number_};
    line_left_.remove_prefix(last_.text.size());
    return strict_number_in<double>(last_.text).value_or(std::nan(""));
  }

  void complain(FileIssues& issues, const std::string& message) const {
    issues.add(last_, message + ", found \"" + std::string{last_.text.substr(0, 40)} + "\"");
  }

 private:
  std::string_view rest_, line_, line_left_;
  int line_number_;
  Token last_;
};

class BinarySource {
 public:
  BinarySource(const Header& header, std::string_view file)
      : rest_{header.body},
        size_{file.size()},
        swap_{(header.format == Format::big_endian) != (std::endian::native == std::endian::big)} {}

  std::optional<double> next(Type type) {
    const std::size_t size = ply::size_of(type);
    if (rest_.size() < size) return std::nullopt;
    last_ = size_ - rest_.size();
    unsigned char bytes[8];
    std::memcpy(bytes, rest_.data(), size);
    rest_.remove_prefix(size);
    if (swap_) std::reverse(bytes, bytes + size);
    return value(type, bytes);
  }

  void complain(FileIssues& issues, const std::string& message) const {
    issues.add("byte " + std::to_string(last_ + 1) + ": " + message);
  }

 private:
  template <class Number>
  static double as(const unsigned char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
  }

  static double value(Type type, const unsigned char* bytes) {
    switch (type) {
      case Type::int8:
        return as<std::int8_t>(bytes);
      case Type::uint8:
        return as<std::uint8_t>(bytes);
      case Type::int16:
        return as<std::int16_t>(bytes);
      case Type::uint16:
        return as<std::uint16_t>(bytes);
      case Type::int32:
        return as<std::int32_t>(bytes);
      case Type::uint32:
        return as<std::uint32_t>(bytes);
      case Type::float32:
        return as<float>(bytes);
      case Type::float64:
        break;
    }
    return as<double>(bytes);
  }

  std::string_view rest_;
  std::size_t size_, last_ = 0;
  bool swap_;
};

bool has_property(const Element& element, std::string_view name, bool list) {
  return std::any_of(element.properties.begin(), element.properties.end(), [&](const Property& p) {
    return p.name == name && p.list_count.has_value() == list;
  });
}

/// What a file calls its texture coordinates.
struct TextureNames {
  std::string_view u, v;
};

std::optional<TextureNames> texture_names(const Element& vertex) {
  for (const TextureNames& names :
       {TextureNames{"s", "t"}, TextureNames{"u", "v"}, TextureNames{"texture_u", "texture_v"}}) {
    if (has_property(vertex, names.u, false) && has_property(vertex, names.v, false)) return names;
  }
  return std::nullopt;
}

/// What a file calls a temperature of its vertices; the plain name counts as K.
constexpr std::array<std::string_view, 3> temperature_names{"temperature_k", "temperature_c",
                                                            "temperature"};

std::string_view temperature_name(const Element& vertex) {
  for (const std::string_view name : temperature_names) {
    if (has_property(vertex, name, false)) return name;
  }
  return {};
}

/// The file ends before its header says.
struct Truncated {};

template <class Source>
class BodyReader {
 public:
  BodyReader(Source source, const Header& header, FileIssues& issues)
      : source_{std::move(source)}, header_{&header}, issues_{&issues} {}

  geometry::TriangleMesh read() {
    for (const Element& element : header_->elements) {
      if (element.name != "vertex") continue;
      vertices_ = element.count;
      texture_names_ = texture_names(element);
      temperature_name_ = temperature_name(element);
    }
    mesh_.part_names = {"default"};
    try {
      for (const Element& element : header_->elements) read_element(element);
    } catch (const Truncated&) {
    }
    if (mesh_.triangles.empty() && issues_->empty()) issues_->add("the file has no faces");
    issues_->throw_if_any();
    mesh_.parts.assign(mesh_.triangles.size(), 0);
    return std::move(mesh_);
  }

 private:
  void read_element(const Element& element) {
    // Nothing to read, so that a huge count cannot keep us here.
    if (element.properties.empty()) return;
    for (std::uint64_t row = 0; row < element.count; ++row) {
      vertex_ = {};
      for (const Property& property : element.properties) {
        where_ = {&element, &property, row};
        if (element.name == "vertex") {
          read_vertex_property(property);
        } else {
          read_property(property, element.name == "face");
        }
      }
      if (element.name != "vertex") continue;
      mesh_.positions.push_back(vertex_.position);
      if (texture_names_) mesh_.texture.push_back(vertex_.texture);
      if (!temperature_name_.empty()) mesh_.vertex_values.push_back(vertex_.kelvin);
    }
  }

  void read_vertex_property(const Property& property) {
    if (property.list_count) return read_property(property, false);
    const double value = number(property.type);
    if (!temperature_name_.empty() && property.name == temperature_name_) {
      return set_temperature(value);
    }
    double* const target = property.name == "x"   ? &vertex_.position.x
                           : property.name == "y" ? &vertex_.position.y
                           : property.name == "z" ? &vertex_.position.z
                                                  : texture_target(property.name);
    if (!target) return;
    *target = value;
    if (!std::isfinite(value)) complain("expected a finite coordinate " + property.name);
  }

  double* texture_target(const std::string& name) {
    if (!texture_names_) return nullptr;
    if (name == texture_names_->u) return &vertex_.texture.x;
    return name == texture_names_->v ? &vertex_.texture.y : nullptr;
  }

  void set_temperature(double value) {
    if (temperature_name_ == "temperature_c") value += si::zero_celsius;
    vertex_.kelvin = static_cast<float>(value);
    if (!std::isfinite(vertex_.kelvin)) {
      complain("expected a finite " + std::string{temperature_name_});
    }
  }

  void read_property(const Property& property, bool of_face) {
    if (!property.list_count) {
      (void)number(property.type);
      return;
    }
    const bool is_polygon =
        of_face && (property.name == "vertex_indices" || property.name == "vertex_index");
    const double count = number(*property.list_count);
    if (!(count >= 0.0) || count != std::floor(count)) {
      complain("expected the length of a list");
      throw Truncated{};  // where the next number begins is not known
    }
    if (is_polygon && count < 3.0) complain("expected a face of at least 3 corners");
    polygon_.clear();
    for (double i = 0.0; i < count; ++i) {
      const double index = number(property.type);
      if (is_polygon) corner(index);
    }
    if (is_polygon) cut_polygon();
  }

  void corner(double index) {
    if (index >= 0.0 && index < static_cast<double>(vertices_) && index == std::floor(index)) {
      polygon_.push_back(static_cast<std::uint32_t>(index));
    } else {
      complain("expected a vertex from 0 to " + std::to_string(vertices_) + " - 1");
      polygon_good_ = false;
    }
  }

  void cut_polygon() {
    for (std::size_t i = 2; polygon_good_ && i < polygon_.size(); ++i) {
      mesh_.triangles.push_back({polygon_[0], polygon_[i - 1], polygon_[i]});
    }
    polygon_good_ = true;
  }

  double number(Type type) {
    if (const auto value = source_.next(type)) return *value;
    issues_->add("the file ends too early: in " + place() + ", of " +
                 std::to_string(where_.element->count));
    throw Truncated{};
  }

  void complain(const std::string& message) {
    source_.complain(*issues_, "in " + place() + ": " + message);
  }

  [[nodiscard]] std::string place() const {
    return where_.element->name + " " + std::to_string(where_.row) + ", property " +
           where_.property->name;
  }

  struct Where {
    const Element* element = nullptr;
    const Property* property = nullptr;
    std::uint64_t row = 0;
  };

  Source source_;
  const Header* header_;
  FileIssues* issues_;
  std::uint64_t vertices_ = 0;
  std::optional<TextureNames> texture_names_;
  std::string_view temperature_name_;  ///< empty where vertices have none
  struct Vertex {
    Vec3 position;
    Vec2 texture;
    float kelvin = 0.0F;
  } vertex_;  ///< that is being read
  Where where_;
  std::vector<std::uint32_t> polygon_;
  bool polygon_good_ = true;
  geometry::TriangleMesh mesh_;
};

void check_temperatures(const Element& vertex, FileIssues& issues) {
  std::string found;
  int count = 0;
  for (const Property& property : vertex.properties) {
    const auto& names = temperature_names;
    if (std::find(names.begin(), names.end(), property.name) == names.end()) continue;
    found += (count++ == 0 ? "" : ", ") + property.name;
    if (property.list_count) issues.add("the property " + property.name + " must not be a list");
  }
  if (count > 1) issues.add("vertices have more than one temperature: " + found);
}

void check_elements(const Header& header, FileIssues& issues) {
  bool vertices = false, faces = false;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") {
      vertices = has_property(element, "x", false) && has_property(element, "y", false) &&
                 has_property(element, "z", false);
      if (element.count > 0xFFFFFFFEU) issues.add("more than 4294967294 vertices");
      check_temperatures(element, issues);
    }
    if (element.name == "face") {
      faces = has_property(element, "vertex_indices", true) ||
              has_property(element, "vertex_index", true);
    }
  }
  if (!vertices) issues.add("there is no element vertex with the properties x, y and z");
  if (!faces) issues.add("there is no element face with the list vertex_indices or vertex_index");
  issues.throw_if_any();
}

}  // namespace

geometry::TriangleMesh parse_ply(std::string_view bytes, const std::string& name) {
  FileIssues issues{name};
  const Header header = ply::parse_header(bytes, issues);
  check_elements(header, issues);
  if (header.format == Format::ascii) {
    return BodyReader{AsciiSource{header}, header, issues}.read();
  }
  return BodyReader{BinarySource{header, bytes}, header, issues}.read();
}

geometry::TriangleMesh read_ply(const std::filesystem::path& file) {
  return parse_ply(read_bytes(file), file.string());
}

}  // namespace nadir::sim
