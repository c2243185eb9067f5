#include "materials/library.hpp"

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using materials::Material;
using materials::MaterialLibrary;

namespace {

Material grey(const std::string& name) {
  Material material;
  material.name = name;
  material.reflectance = spectral::Curve::constant(0.5);
  return material;
}

}  // namespace

TEST_CASE("a library keeps its materials in the order in which they came", "[materials]") {
  MaterialLibrary library;
  CHECK(library.empty());
  CHECK(library.add(grey("sand")) == 0);
  CHECK(library.add(grey("asphalt_road")) == 1);
  CHECK(library.add(grey("Sand")) == 2);  // names are case-sensitive
  CHECK(library.size() == 3);
  CHECK(library.names() == std::vector<std::string>{"sand", "asphalt_road", "Sand"});
  CHECK(library[1].name == "asphalt_road");
  CHECK(library.index_of("Sand") == 2);
  CHECK(library.at("sand").name == "sand");
  CHECK(library.find("brick") == nullptr);
}

TEST_CASE("a library refuses what would be ambiguous", "[materials]") {
  MaterialLibrary library;
  library.add(grey("sand"));
  CHECK_THROWS_WITH(library.add(grey("sand")), "error: material \"sand\" is defined twice\n");
  CHECK_THROWS_WITH(library.add(grey("")), "error: a material has no name\n");
  CHECK(library.size() == 1);
}

TEST_CASE("an unknown material is answered with the nearest name", "[materials]") {
  MaterialLibrary library;
  library.add(grey("sand"));
  library.add(grey("asphalt_road"));
  CHECK(library.nearest("asfalt_road") == "asphalt_road");
  CHECK_THROWS_WITH(library.at("asfalt_road"),
                    "error: there is no material \"asfalt_road\"\n"
                    "    hint: did you mean \"asphalt_road\"?\n");
  CHECK_THROWS_WITH(library.index_of("granite"), "error: there is no material \"granite\"\n");
}
