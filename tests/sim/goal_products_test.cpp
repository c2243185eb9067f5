#include <numeric>

#include "scratch_folder.hpp"
#include "sim/files/envi.hpp"
#include "sim/files/exr.hpp"
#include "sim/products/write_products.hpp"
#include "support/catch.hpp"
#include "synthetic_array.hpp"

// What a picture sampled to a goal leaves beside the others' files.

namespace nadir::sim {
namespace {

using support::ScratchFolder;

ArrayImage sampled_to_goal() {
  ArrayImage image = support::synthetic_array(3, 4, {0.48, 10.9});
  image.pixel_paths.resize(image.pixels());
  std::iota(image.pixel_paths.begin(), image.pixel_paths.end(), 32U);
  for (BandImage& band : image.bands) {
    for (const float radiance : band.radiance) band.bias.push_back(0.5F * radiance);
  }
  return image;
}

ProductContext context_of_goal() {
  ProductContext context;
  context.scenario_name = "day";
  context.time_utc = "2026-06-21T16:00:00Z";
  context.version = "0.1.0";
  context.wanted.quick_look = false;
  context.wanted.statistics = true;
  return context;
}

void write_image(const ArrayImage& image, const ScratchFolder& folder) {
  ProductWriter writer{context_of_goal(), folder.path()};
  writer.take(image);
  (void)writer.finish();
}

}  // namespace

TEST_CASE("paths and systematic errors are files and channels of their own", "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage image = sampled_to_goal();
  write_image(image, folder);
  const EnviImage paths = read_envi(folder / "cam_paths.img");
  CHECK(std::get<std::vector<std::vector<std::uint32_t>>>(paths.planes).at(0) == image.pixel_paths);
  const EnviImage bias = read_envi(folder / "cam_bias.img");
  const auto& planes = std::get<std::vector<std::vector<float>>>(bias.planes);
  REQUIRE(planes.size() == 2);
  CHECK(planes[1] == image.bands[1].bias);
  CHECK(bias.header.data_units == "W m-2 sr-1 um-1");
  const ExrContents exr = read_exr(folder / "cam.exr");
  CHECK(std::get<std::vector<std::uint32_t>>(exr.channels.at("paths")) == image.pixel_paths);
  CHECK(std::get<std::vector<float>>(exr.channels.at("bias.B1")) == image.bands[0].bias);
  CHECK(!exr.attributes.contains("pathsPerPixel"));
}

TEST_CASE("a picture of equally many paths has one number of them", "[sim][products]") {
  const ScratchFolder folder;
  ArrayImage image = support::synthetic_array(3, 4, {0.48, 10.9});
  image.paths = 8;
  write_image(image, folder);
  CHECK(!std::filesystem::exists(folder / "cam_paths.img"));
  CHECK(!std::filesystem::exists(folder / "cam_bias.img"));
  CHECK(std::get<int>(read_exr(folder / "cam.exr").attributes.at("pathsPerPixel")) == 8);
}

TEST_CASE("a plane of paths that has not the image's size is refused", "[sim][products]") {
  const ScratchFolder folder;
  ArrayImage image = sampled_to_goal();
  image.pixel_paths.pop_back();
  CHECK_THROWS_AS(write_image(image, folder), std::invalid_argument);
}

}  // namespace nadir::sim
