#include "core/error.hpp"
#include "sim/files/mesh_obj.hpp"
#include "sim/files/mesh_ply.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

// Texture coordinates as mesh files hold them.

namespace nadir::sim {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string corners = "vt 0 0\nvt 1 0 0.5\nvt 1 1\nvt 0.25\n";

TEST_CASE("OBJ texture coordinates follow the vertices that faces give them to", "[sim][mesh]") {
  const auto mesh = parse_obj(square + corners + "f 1/1 2/2 3/3 4/4\n", "a.obj");
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.texture == std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.25, 0.0}});
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("an OBJ vertex at a seam is repeated once for each texture coordinate", "[sim][mesh]") {
  const auto mesh = parse_obj(
      square + corners + "f 1/1 2/2 3/3\nf 1/2 3/3 4/4\nf 1/-3/9 3/3/9 4/4/9\nf 1/3 2/2 3/3\n",
      "a.obj");
  REQUIRE(mesh.positions.size() == 6);
  CHECK(mesh.positions[4] == mesh.positions[0]);
  CHECK(mesh.positions[5] == mesh.positions[0]);
  CHECK(mesh.texture.size() == 6);
  CHECK(mesh.texture[4] == Vec2{1.0, 0.0});
  CHECK(mesh.texture[5] == Vec2{1.0, 1.0});
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {4, 2, 3}, {4, 2, 3}, {5, 1, 2}});
}

TEST_CASE("an OBJ file whose faces name no texture has none", "[sim][mesh]") {
  const auto mesh = parse_obj(square + corners + "f 1 2 3\nf 1//1 2//1 3//1\n", "a.obj");
  CHECK(mesh.texture.empty());
  CHECK(mesh.positions.size() == 4);
}

TEST_CASE("OBJ faces without texture beside others with it have the coordinates 0 0",
          "[sim][mesh]") {
  const auto mesh = parse_obj(square + corners + "f 2/2 3/3 4/4\nf 1 2 3\n", "a.obj");
  REQUIRE(mesh.positions.size() == 6);
  CHECK(mesh.triangles[1] == Triangle{0, 4, 5});
  CHECK(mesh.texture[4] == Vec2{});
}

TEST_CASE("OBJ texture coordinates that are missing or no numbers are mistakes", "[sim][mesh]") {
  const auto message = [](const std::string& text) {
    return support::message_of([&] { (void)parse_obj(text, "a.obj"); });
  };
  CHECK(message(square + corners + "f 1/1 2/2 3/5\n") ==
        "a.obj:9:11: error: texture coordinate of 3/5 does not exist: there are 4\n"
        "    9 | f 1/1 2/2 3/5\n      |           ^\n");
  CHECK(message(square + corners + "f 1/1 2/2 3/-5\n").find("texture coordinate of 3/-5") !=
        std::string::npos);
  CHECK(message(square + "vt\nf 1 2 3\n").find("expected 2 coordinates, found 0") !=
        std::string::npos);
  CHECK(message(square + "vt 0 nan\nf 1 2 3\n").find("expected a finite number, found \"nan\"") !=
        std::string::npos);
  // Later in the file is early enough.
  CHECK(parse_obj(square + "f 1/1 2/2 3/3\n" + corners, "a.obj").texture[1] == Vec2{1.0, 0.0});
}

std::string ply(const std::string& u, const std::string& v) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float " + u +
         "\nproperty float y\nproperty float z\nproperty float " + v +
         "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0.5 0 0 0.25\n1 1.5 0 0 0.75\n0 2.5 1 0 -1\n3 0 1 2\n";
}

TEST_CASE("PLY texture coordinates have any of three pairs of names", "[sim][mesh]") {
  const std::vector<Vec2> expected{{0.5, 0.25}, {1.5, 0.75}, {2.5, -1.0}};
  CHECK(parse_ply(ply("s", "t"), "a.ply").texture == expected);
  CHECK(parse_ply(ply("u", "v"), "a.ply").texture == expected);
  CHECK(parse_ply(ply("texture_u", "texture_v"), "a.ply").texture == expected);
  CHECK(parse_ply(ply("u", "t"), "a.ply").texture.empty());
  CHECK(parse_ply(ply("quality", "value"), "a.ply").texture.empty());
}

TEST_CASE("a PLY texture coordinate that is not finite is a mistake with its place",
          "[sim][mesh]") {
  std::string text = ply("u", "v");
  text.replace(text.find("1.5"), 3, "inf");
  const auto message = support::message_of([&] { (void)parse_ply(text, "a.ply"); });
  CHECK(
      message.find("a.ply:13:3: error: in vertex 1, property u: expected a finite coordinate u") !=
      std::string::npos);
}

}  // namespace
}  // namespace nadir::sim
