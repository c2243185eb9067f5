#include "sim/files/mesh_obj.hpp"

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using ObjTriangle = std::array<std::uint32_t, 3>;

namespace {

constexpr const char* obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<InputIssue> obj_issues_of(const std::string& text) {
  try {
    (void)parse_obj(text, "house.obj");
  } catch (const InputError& error) {
    return error.issues();
  }
  return {};
}

void check_issue(const std::string& text, int line, int column, const std::string& message) {
  CAPTURE(text);
  const auto issues = obj_issues_of(text);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].where.file == "house.obj");
  CHECK(issues[0].where.line == line);
  CHECK(issues[0].where.column == column);
  CHECK(issues[0].message == message);
}

}  // namespace

TEST_CASE("an OBJ file gives its vertices and fans of its polygons") {
  const auto mesh = parse_obj(
      std::string{obj_square} + "v 0.5 1.5 -2e-3\nf 1 2 3\nf 1 2 3 4\nf 1 2 3 5 4\n", "a.obj");
  REQUIRE(mesh.positions.size() == 5);
  CHECK(mesh.positions[4] == Vec3{0.5, 1.5, -2e-3});
  const std::vector<ObjTriangle> expected{{0, 1, 2}, {0, 1, 2}, {0, 2, 3},
                                          {0, 1, 2}, {0, 2, 4}, {0, 4, 3}};
  CHECK(mesh.triangles == expected);
  CHECK(mesh.part_names == std::vector<std::string>{"default"});
  CHECK(mesh.parts == std::vector<std::uint32_t>(6, 0));
}

TEST_CASE("OBJ corners come in four forms and count from either end") {
  const std::string text =
      std::string{obj_square} +
      "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\n"
      "f -4 -3 -2\nv 9 9 9\nf -5//-1 -4//-1 -3//-1\n";
  const auto mesh = parse_obj(text, "a.obj");
  CHECK(mesh.triangles == std::vector<ObjTriangle>(5, ObjTriangle{0, 1, 2}));
}

TEST_CASE("OBJ parts are named by material, else by group, else default") {
  const std::string text =
      std::string{obj_square} +
      "f 1 2 3\ng wall\nf 1 2 3\nusemtl red tile\nf 1 2 3\ng roof\nf 1 2 3\n"
      "usemtl Material#2\nf 1 2 3\nusemtl red tile\nf 1 2 3\nusemtl\nf 1 2 3\n";
  const auto mesh = parse_obj(text, "a.obj");
  CHECK(mesh.part_names ==
        std::vector<std::string>{"default", "wall", "red tile", "Material#2", "roof"});
  CHECK(mesh.parts == std::vector<std::uint32_t>{0, 1, 2, 2, 3, 2, 4});
}

TEST_CASE("OBJ comments, continued lines, line ends and other statements are no obstacle") {
  const std::string text =
      "# a house\r\nmtllib a.mtl\r\no house\r\ns off\r\nv 0 0 \\\r\n 0 # corner\r\nv 1 0 0 1.0\r\n"
      "\tv  1 1 0 0.5 0.5 0.5\r\n\r\nvp 1 2\r\nl 1 2\r\nf 1 \\\r\n2 \\\r\n3\r\nf 2 3 1";
  const auto mesh = parse_obj(text, "a.obj");
  CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  CHECK(mesh.triangles == std::vector<ObjTriangle>{{0, 1, 2}, {1, 2, 0}});
  CHECK(mesh.part_names == std::vector<std::string>{"house"});
}

TEST_CASE("OBJ faces may name vertices that come later") {
  const auto mesh = parse_obj(std::string{"f 1 2 3\n"} + obj_square, "a.obj");
  CHECK(mesh.triangles == std::vector<ObjTriangle>{{0, 1, 2}});
}

TEST_CASE("every mistake in an OBJ file has its place") {
  const std::string face = "f 1 2 3\n";
  const std::string good = obj_square + face;
  for (const std::string number : {"1.5x", "1,5", "nan", "inf", "1e999", "0x10", "+1", "--1"}) {
    check_issue(good + "v 0 " + number + " 0\n", 6, 5,
                "expected a finite number, found \"" + number + "\"");
  }
  check_issue(good + "v 1 2\n", 6, 1, "expected 3 coordinates, found 2");
  check_issue(good + "f 1 2\n", 6, 1, "expected a face of at least 3 corners, found 2");
  check_issue(good + "f 1 2 5\n", 6, 7, "vertex 5 does not exist: there are 4");
  check_issue(good + "f 1 -5 2\n", 6, 5, "vertex -5 does not exist: there are 4");
  for (const std::string corner : {"0", "1.5", "2/", "2/x", "2//", "/2", "1/1/1/1", "2//0", "a"}) {
    check_issue(good + "f 1 2 " + corner + "\n", 6, 7,
                "expected a corner such as 7, 7/2, 7//3 or 7/2/3, found \"" + corner + "\"");
  }
  check_issue(good + "usemlt roof\n", 6, 1, "\"usemlt\" is no statement of an OBJ file");
  CHECK(obj_issues_of(good + "usemlt roof\n")[0].hint == "did you mean \"usemtl\"?");
  check_issue(good + "surf 0 1 0 1\n", 6, 1, "free-form curves and surfaces are not read");
  check_issue(good + "v 0 0 \\\n  bad\n", 7, 3, "expected a finite number, found \"bad\"");
}

TEST_CASE("an OBJ error reads like a compiler's") {
  try {
    (void)parse_obj(std::string{obj_square} + "f 1 2 9\n", "house.obj");
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(std::string{error.what()} ==
          "house.obj:5:7: error: vertex 9 does not exist: there are 4\n"
          "    5 | f 1 2 9\n"
          "      |       ^\n");
  }
}

TEST_CASE("a file full of mistakes shows twenty and counts the rest") {
  std::string text = obj_square;
  for (int i = 0; i < 50; ++i) text += "v x 0 0\n";
  const auto issues = obj_issues_of(text + "f 1 2 3\n");
  REQUIRE(issues.size() == 21);
  CHECK(issues[19].where.line == 24);
  CHECK(issues[20].message == "and 30 more mistakes");
}

TEST_CASE("an OBJ file without faces or that is not there is an error") {
  CHECK(obj_issues_of(obj_square)[0].message == "the file has no faces");
  CHECK(obj_issues_of("")[0].message == "the file has no faces");
  CHECK_THROWS_AS(read_obj("/nowhere/house.obj"), InputError);
  CHECK_THROWS_AS(read_obj("/"), InputError);
}
