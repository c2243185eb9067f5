#include "sim/files/exr.hpp"

#include <algorithm>
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

TEST_CASE("an EXR written in strips has the bytes of one written at once", "[sim][exr]") {
  const ScratchFolder folder;
  constexpr int samples = 5, lines = 41;  // more than two blocks of 16 lines
  std::vector<float> values;
  std::vector<std::uint32_t> ids;
  for (unsigned i = 0; i < samples * lines; ++i) {
    values.push_back(0.1F * static_cast<float>(i * i % 97));
    ids.push_back(i / 3);
  }
  write_exr(folder / "whole.exr", {samples, lines, {{"b", values}, {"a", ids}}, {{"count", 7}}});
  ExrWriter writer{folder / "strips.exr",
                   {samples, lines, {{"b", false}, {"a", true}}, {{"count", 7}}}};
  for (std::size_t line = 0; line < lines;) {
    const std::size_t count = std::min<std::size_t>(7, lines - line);
    const std::size_t from = line * samples, size = count * samples;
    writer.write({std::span<const float>{values}.subspan(from, size),
                  std::span<const std::uint32_t>{ids}.subspan(from, size)});
    line += count;
  }
  CHECK(folder.entries() == 2);  // one of them the temporary
  CHECK_FALSE(std::filesystem::exists(folder / "strips.exr"));
  writer.commit();
  CHECK(support::content_of(folder / "strips.exr") == support::content_of(folder / "whole.exr"));
}

TEST_CASE("an EXR refuses strips that do not fit and gets no name without its lines",
          "[sim][exr]") {
  const ScratchFolder folder;
  {
    ExrWriter writer{folder / "a.exr", {2, 3, {{"a", false}}, {}}};
    const std::vector<float> two(4), half(3), all(6);
    const std::vector<std::uint32_t> ids(2);
    writer.write({two});
    CHECK_THROWS_AS(writer.write({all}), std::invalid_argument);
    CHECK_THROWS_AS(writer.write({half}), std::invalid_argument);
    CHECK_THROWS_AS(writer.write({ids}), std::invalid_argument);
    CHECK_THROWS_AS(writer.write({two, two}), std::invalid_argument);
    CHECK(support::message_of([&] { writer.commit(); }) ==
          (folder / "a.exr").string() + " has 2 of 3 lines");
  }
  CHECK(folder.entries() == 0);
}
