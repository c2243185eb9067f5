#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "sim/files/mesh_ply.hpp"
#include "sim/files/texture_seams.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

// Temperatures that PLY files give vertex by vertex.

using namespace nadir;
using namespace nadir::sim;

namespace {

std::string values_header(const std::string& format, const std::string& property,
                          const std::string& type = "float") {
  return "ply\nformat " + format + " 1.0\nelement vertex 3\nproperty float x\nproperty " + type +
         " " + property + "\nproperty float y\nproperty float z\n" +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ascii_ply(const std::string& property) {
  return values_header("ascii", property) + "0 20 0 0\n1 20.5 0 0\n0 -3 1 0\n3 0 1 2\n";
}

template <class T>
void append(std::string& bytes, T value, bool big) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

/// Vertices with the values 280, 290.5 and 300.
template <class Value>
std::string binary_ply(const std::string& type, bool big) {
  std::string bytes =
      values_header(big ? "binary_big_endian" : "binary_little_endian", "temperature_k", type);
  const float corners[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double values[3] = {280.0, 290.5, 300.0};
  for (int i = 0; i < 3; ++i) {
    append(bytes, corners[i][0], big);
    append(bytes, static_cast<Value>(values[i]), big);
    append(bytes, corners[i][1], big);
    append(bytes, corners[i][2], big);
  }
  append(bytes, std::uint8_t{3}, big);
  for (const std::int32_t corner : {0, 1, 2}) append(bytes, corner, big);
  return bytes;
}

std::string ply_message(const std::string& text) {
  return support::message_of([&] { (void)parse_ply(text, "roof.ply"); });
}

}  // namespace

TEST_CASE("a PLY file's temperatures by vertex come in K whatever they are called",
          "[sim][mesh][temperature]") {
  const std::vector<float> as_written{20.0F, 20.5F, -3.0F};
  CHECK(parse_ply(ascii_ply("temperature_k"), "a.ply").vertex_values == as_written);
  CHECK(parse_ply(ascii_ply("temperature"), "a.ply").vertex_values == as_written);
  CHECK(parse_ply(ascii_ply("temperature_c"), "a.ply").vertex_values ==
        std::vector<float>{293.15F, 293.65F, 270.15F});
  const auto without = parse_ply(ascii_ply("quality"), "a.ply");
  CHECK(without.vertex_values.empty());
  CHECK(without.positions[1] == Vec3{1.0, 0.0, 0.0});
}

TEST_CASE("binary PLY files give temperatures by vertex in either byte order",
          "[sim][mesh][temperature]") {
  const bool big = GENERATE(false, true);
  const std::vector<float> expected{280.0F, 290.5F, 300.0F};
  CHECK(parse_ply(binary_ply<float>("float", big), "a.ply").vertex_values == expected);
  CHECK(parse_ply(binary_ply<double>("double", big), "a.ply").vertex_values == expected);
  CHECK(parse_ply(binary_ply<std::uint16_t>("ushort", big), "a.ply").vertex_values ==
        std::vector<float>{280.0F, 290.0F, 300.0F});
}

TEST_CASE("a temperature by vertex that is no number is a mistake with its place",
          "[sim][mesh][temperature]") {
  std::string text = ascii_ply("temperature_c");
  text.replace(text.find("20.5"), 4, "cold");
  CHECK(ply_message(text).find("roof.ply:12:3: error: in vertex 1, property temperature_c: "
                               "expected a finite temperature_c, found \"cold\"") == 0);
  text = ascii_ply("temperature_k");
  text.replace(text.find("20.5"), 4, "1e60");  // past the float that holds it
  CHECK(ply_message(text).find("expected a finite temperature_k") != std::string::npos);
}

TEST_CASE("a PLY file with two temperatures or a list of them is refused",
          "[sim][mesh][temperature]") {
  std::string text = ascii_ply("temperature_k");
  text.replace(text.find("property float z"), 16, "property float z\nproperty float temperature_c");
  CHECK(ply_message(text) ==
        "roof.ply: error: vertices have more than one temperature: temperature_k, temperature_c\n");
  CHECK(ply_message(values_header("ascii", "temperature_k", "list uchar float")) ==
        "roof.ply: error: the property temperature_k must not be a list\n");
}

TEST_CASE("a texture's seam repeats the values of its vertices", "[sim][mesh][temperature]") {
  geometry::TriangleMesh mesh = parse_ply(ascii_ply("temperature_k"), "a.ply");
  mesh.triangles.push_back({0, 1, 2});
  set_texture(mesh, {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.5}}, {{1, 2, 3}, {1, 4, 3}});
  REQUIRE(mesh.positions.size() == 4);
  CHECK(mesh.vertex_values == std::vector<float>{20.0F, 20.5F, -3.0F, 20.5F});
}
