#include "sim/files/exr.hpp"

#include <cstring>
#include <stdexcept>

#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "support/catch.hpp"
#include "synthetic_array.hpp"

using namespace nadir::sim;
using support::ScratchFolder;

TEST_CASE("an EXR keeps floats and ids bit by bit, and its attributes", "[sim][exr]") {
  const ScratchFolder folder;
  const std::vector<float> radiance{1.5F, 2.5e-30F, support::nan_value, 4.0F, 5e30F, -6.0F};
  const std::vector<std::uint32_t> ids{0, 1, 2, 4'294'967'295U, 16'777'217, 5};
  ExrImage image;
  image.samples = 3;
  image.lines = 2;
  image.channels = {{"radiance.B10", radiance}, {"truth.material", ids}};
  image.attributes = {{"bandNames", std::vector<std::string>{"B10"}},
                      {"wavelengthMicrometers", std::vector<float>{10.895F}},
                      {"scenario", std::string{"village"}},
                      {"count", 7}};
  write_exr(folder / "a.exr", image);
  CHECK(folder.entries() == 1);

  const ExrContents read = read_exr(folder / "a.exr");
  CHECK(read.samples == 3);
  CHECK(read.lines == 2);
  REQUIRE(read.channels.size() == 2);
  const auto& values = std::get<std::vector<float>>(read.channels.at("radiance.B10"));
  REQUIRE(values.size() == radiance.size());
  CHECK(std::memcmp(values.data(), radiance.data(), sizeof(float) * values.size()) == 0);
  CHECK(std::get<std::vector<std::uint32_t>>(read.channels.at("truth.material")) == ids);
  for (const auto& [name, value] : image.attributes) {
    CAPTURE(name);
    CHECK(read.attributes.at(name) == value);
  }
}

TEST_CASE("an EXR with a wrong size or a name twice is not written", "[sim][exr]") {
  const ScratchFolder folder;
  const std::vector<float> values(6, 1.0F);
  ExrImage image{3, 2, {{"a", values}, {"a", values}}, {}};
  CHECK_THROWS_AS(write_exr(folder / "a.exr", image), std::invalid_argument);
  image = {3, 3, {{"a", values}}, {}};
  CHECK_THROWS_AS(write_exr(folder / "a.exr", image), std::invalid_argument);
  CHECK(folder.entries() == 0);
}

TEST_CASE("an EXR that cannot be made or read says which", "[sim][exr]") {
  const ScratchFolder folder;
  const std::vector<float> values(1, 1.0F);
  const auto file = folder / "missing" / "a.exr";
  const std::string written = support::message_of([&] {
    write_exr(file, ExrImage{1, 1, {{"a", values}}, {}});
  });
  CHECK(written == "cannot create " + file.string() + ": No such file or directory");
  const std::string read = support::message_of([&] { static_cast<void>(read_exr(file)); });
  CHECK(read.starts_with("cannot read " + file.string() + ": "));
}
