#include "sim/files/mesh_ply.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using PlyTriangle = std::array<std::uint32_t, 3>;

namespace {

std::vector<InputIssue> ply_issues_of(const std::string& bytes) {
  try {
    (void)parse_ply(bytes, "tree.ply");
  } catch (const InputError& error) {
    return error.issues();
  }
  return {};
}

std::string ply_header(const std::string& format, const std::string& coordinate = "float",
                       const std::string& count = "uchar", const std::string& index = "int") {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex 4\nproperty " +
         coordinate + " x\nproperty " + coordinate + " y\nproperty uchar red\nproperty " +
         coordinate + " z\nelement edge 1\nproperty list uchar float weights\n" +
         "element face 2\nproperty list " + count + " " + index +
         " vertex_indices\nproperty short flags\nend_header\n";
}

constexpr const char* ascii_body =
    "0 0 7 0\n1 0 7 0\n1 1 7 0.5\n0 1 7 0\n2 0.5 0.25\n3 0 1 2 -1\n4 0 1 2 3 -1\n";

template <class T>
void put(std::string& bytes, T value, bool big) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

template <class Coordinate, class Count, class Index>
std::string binary_body(bool big) {
  std::string bytes;
  const double xyz[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  for (const auto& p : xyz) {
    put(bytes, static_cast<Coordinate>(p[0]), big);
    put(bytes, static_cast<Coordinate>(p[1]), big);
    put(bytes, std::uint8_t{7}, big);
    put(bytes, static_cast<Coordinate>(p[2]), big);
  }
  put(bytes, std::uint8_t{1}, big);
  put(bytes, 0.5F, big);
  for (const int corners : {3, 4}) {
    put(bytes, static_cast<Count>(corners), big);
    for (int i = 0; i < corners; ++i) put(bytes, static_cast<Index>(i), big);
    put(bytes, std::int16_t{-1}, big);
  }
  return bytes;
}

void check_mesh(const geometry::TriangleMesh& mesh, double height = 0.5) {
  CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, height}, {0, 1, 0}});
  CHECK(mesh.triangles == std::vector<PlyTriangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.part_names == std::vector<std::string>{"default"});
  CHECK(mesh.parts.size() == 3);
}

}  // namespace

TEST_CASE("an ASCII PLY file gives its mesh and passes over what it has besides") {
  check_mesh(parse_ply(ply_header("ascii") + ascii_body, "a.ply"));
}

TEST_CASE("a binary PLY file gives its mesh in either byte order and any types") {
  const bool big = GENERATE(false, true);
  const std::string format = big ? "binary_big_endian" : "binary_little_endian";
  check_mesh(
      parse_ply(ply_header(format) + binary_body<float, std::uint8_t, std::int32_t>(big), "a"));
  check_mesh(parse_ply(ply_header(format, "double", "uint", "ushort") +
                           binary_body<double, std::uint32_t, std::uint16_t>(big),
                       "a"));
  check_mesh(parse_ply(ply_header(format, "float64", "int16", "uint32") +
                           binary_body<double, std::int16_t, std::uint32_t>(big),
                       "a"));
  check_mesh(parse_ply(ply_header(format, "short", "char", "uchar") +
                           binary_body<std::int16_t, std::int8_t, std::uint8_t>(big),
                       "a"),
             0.0);  // 0.5 as an integer
}

TEST_CASE("a PLY header may end its lines as Windows does and call the list vertex_index") {
  std::string text = ply_header("ascii");
  text.replace(text.find("vertex_indices"), 14, "vertex_index");
  std::string windows;
  for (const char c : text + ascii_body)
    windows += c == '\n' ? std::string{"\r\n"} : std::string{c};
  check_mesh(parse_ply(windows, "a.ply"));
}

TEST_CASE("a PLY file that is cut off says where, wherever it is cut") {
  const std::string whole =
      ply_header("binary_little_endian") + binary_body<float, std::uint8_t, std::int32_t>(false);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK(ply_issues_of(whole.substr(0, size)).size() >= 1);
  }
  const auto last = ply_issues_of(whole.substr(0, whole.size() - 1));
  REQUIRE(last.size() == 1);
  CHECK(last[0].where.file == "tree.ply");
  CHECK(last[0].message == "the file ends too early: in face 1, property flags, of 2");
  const std::string ascii = ply_header("ascii") + ascii_body;
  CHECK(ply_issues_of(ascii.substr(0, ascii.size() - 4))[0].message ==
        "the file ends too early: in face 1, property flags, of 2");
}

TEST_CASE("a PLY header that promises too much costs no memory") {
  std::string text = ply_header("binary_little_endian");
  text.replace(text.find("vertex 4"), 8, "vertex 4000000000");
  CHECK(ply_issues_of(text + "abc")[0].message ==
        "the file ends too early: in vertex 0, property x, of 4000000000");
}

TEST_CASE("every mistake in an ASCII PLY file has its place") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string body = ascii_body;
    return ply_header("ascii") + body.replace(body.find(from), from.size(), to);
  };
  auto issues = ply_issues_of(with("1 1 7 0.5", "1 nan 7 0.5"));
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].where.line == 17);
  CHECK(issues[0].where.column == 3);
  CHECK(issues[0].message ==
        "in vertex 2, property y: expected a finite coordinate y, found \"nan\"");
  issues = ply_issues_of(with("3 0 1 2", "3 0 1 4"));
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].where.line == 20);
  CHECK(issues[0].where.column == 7);
  CHECK(ply_issues_of(with("3 0 1 2", "3 0 1 1.5")).size() == 1);
  CHECK(ply_issues_of(with("3 0 1 2", "3 0 1 -1")).size() == 1);
  CHECK(ply_issues_of(with("3 0 1 2", "2 0 1")).size() == 1);
  CHECK(ply_issues_of(with("3 0 1 2", "x 0 1 2")).size() == 1);
}

TEST_CASE("a binary PLY file names the byte of a mistake") {
  std::string body = binary_body<float, std::uint8_t, std::int32_t>(false);
  const float bad = std::numeric_limits<float>::infinity();
  std::memcpy(body.data() + 4, &bad, 4);
  const std::string head = ply_header("binary_little_endian");
  const auto issues = ply_issues_of(head + body);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].message == "byte " + std::to_string(head.size() + 5) +
                                 ": in vertex 0, property y: expected a finite coordinate y");
}

TEST_CASE("mistakes in a PLY header are all found, with line and column") {
  const auto issues = ply_issues_of(
      "ply\nformat ascii 1.1\nelement vertex four\nelement face 1\nproperty list float int "
      "vertex_indices\nproperty real x\nelements\nend_header\n");
  REQUIRE(issues.size() == 5);
  CHECK(issues[0].where.line == 2);
  CHECK(issues[0].where.column == 14);
  CHECK(issues[1].where.line == 3);
  CHECK(issues[2].where.line == 5);
  CHECK(issues[3].message == "unknown type \"real\"");
  CHECK(issues[4].where.line == 7);
  CHECK(ply_issues_of("solid stl\n")[0].message ==
        "this is no PLY file: its first line is not \"ply\"");
  CHECK(ply_issues_of("ply\nformat ascii 1.0\nend_header\n").size() == 2);
  CHECK_THROWS_AS(read_ply("/nowhere/tree.ply"), InputError);
}
