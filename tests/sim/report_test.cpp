#include "sim/products/report.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/diagnostics.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/envi.hpp"
#include "sim/files/exr.hpp"
#include "sim/products/running_summary.hpp"
#include "sim/products/write_products.hpp"
#include "support/catch.hpp"
#include "synthetic_array.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::content_of;
using support::nan_value;
using support::ScratchFolder;
using support::synthetic_array;

TEST_CASE("a summary counts what is not a number and leaves it out of the rest", "[sim][report]") {
  ArrayImage image = synthetic_array(2, 2, {0.6, 10.9});
  image.bands[0].radiance = {1.0F, 3.0F, nan_value, -4.0F};
  image.bands[0].standard_error = {0.1F, 0.6F, 0.1F, 0.1F};
  const ArraySummary summary = summarise(image);
  CHECK(summary.surface_share == 0.5);
  CHECK(summary.invalid_pixels == 1);
  const BandSummary& band = summary.bands.at(0);
  CHECK(band.invalid_pixels == 1);
  CHECK(band.negative_pixels == 1);
  CHECK(band.radiance.least == -4.0);
  CHECK(band.radiance.mean == 0.0);
  CHECK(band.radiance.greatest == 3.0);
  // 10 % and 20 %; the others have no relative error. 1e-7: the planes are floats.
  CHECK(band.median_relative_error == Approx(0.15).epsilon(1e-7));
  CHECK(band.p95_relative_error == Approx(0.195).epsilon(1e-7));
  CHECK(std::isnan(band.brightness_temperature.mean));
  CHECK(summary.bands.at(1).brightness_temperature.least == 280.0);
}

TEST_CASE("a report's keys stand in their order and odd numbers become null", "[sim][report]") {
  RunReport report;
  report.version = "0.1.0";
  report.started_utc = "2026-06-21T16:00:00Z";
  report.finished_utc = "2026-06-21T16:00:09Z";
  report.scenario_file = "day.xml";
  report.scenario_name = "day";
  report.options = {{"seed", std::int64_t{7}}, {"quiet", true}, {"accuracy", 0.5}};
  report.settings = {{"solver", std::string{"generic"}}};
  report.inputs = {{"mesh", "a.obj", 3, "ab"}};
  report.stages = {{"trace", 1.5, nan_value}};
  report.counters = {{"rays_full", 10}, {"rays_direct", 5}};
  report.warnings = {"a \"quoted\" \xFF byte"};
  report.peak_memory_bytes = 1024;
  CHECK(to_json(report) == R"({
  "format": "nadir run report 1",
  "version": "0.1.0",
  "started_utc": "2026-06-21T16:00:00Z",
  "finished_utc": "2026-06-21T16:00:09Z",
  "scenario": {
    "file": "day.xml",
    "name": "day",
    "title": "",
    "time_utc": ""
  },
  "options": {
    "seed": 7,
    "quiet": true,
    "accuracy": 0.5
  },
  "settings": {
    "solver": "generic"
  },
  "inputs": [
    {
      "role": "mesh",
      "path": "a.obj",
      "bytes": 3,
      "sha256": "ab"
    }
  ],
  "stages": [
    {
      "name": "trace",
      "wall_s": 1.5,
      "cpu_s": null
    }
  ],
  "counters": {
    "rays_direct": 5,
    "rays_full": 10
  },
  "peak_memory_bytes": 1024,
  "arrays": [],
  "warnings": [
    "a \"quoted\" )"
                           "\xEF\xBF\xBD"
                           R"( byte"
  ],
  "products": []
}
)");
}

TEST_CASE("a report holds the summary of every band", "[sim][report]") {
  RunReport report;
  report.arrays = {summarise(synthetic_array(2, 2, {0.6, 10.9}))};
  const std::string json = to_json(report);
  CHECK(json.find(R"("relative_standard_error": {)") != std::string::npos);
  CHECK(json.find(R"("invalid_pixels": 0)") != std::string::npos);
  // Only the thermal band has a brightness temperature.
  const auto first = json.find("brightness_temperature_k");
  CHECK(first != std::string::npos);
  CHECK(json.find("brightness_temperature_k", first + 1) == std::string::npos);
}

TEST_CASE("digital numbers are summed up, and saturated ones counted where that is known",
          "[sim][report]") {
  ArrayImage image = synthetic_array(2, 2, {0.6, 0.7});
  image.bands[0].dn = {0, 4095, 4094, 11};
  const ArraySummary unknown = summarise(image);
  REQUIRE(unknown.bands.at(0).dn);
  CHECK_FALSE(unknown.bands[0].dn->saturated_pixels);
  CHECK_FALSE(unknown.bands.at(1).dn);

  RunningSummary running{image, {4095, std::nullopt}};
  running.take(image);
  RunReport report;
  report.arrays = {running.finish()};
  CHECK(to_json(report).find(R"(          "dn": {
            "min": 0.0,
            "mean": 2050.0,
            "max": 4095.0,
            "zero_pixels": 1,
            "saturated_pixels": 1
          })") != std::string::npos);
}

TEST_CASE("percentiles of a decimated summary are those of the kept pixels, the rest is of all",
          "[sim][report]") {
  ArrayImage image = synthetic_array(4, 4, {0.6});
  BandImage& band = image.bands[0];
  std::fill(band.radiance.begin(), band.radiance.end(), 1.0F);
  std::fill(band.standard_error.begin(), band.standard_error.end(), 0.5F);
  // Every second sample of every second line.
  for (const std::size_t kept : {0U, 2U, 8U, 10U}) band.standard_error[kept] = 0.25F;
  band.radiance[5] = 9.0F;
  RunningSummary running{image, {}, 4};
  running.take(image);
  const ArraySummary summary = running.finish();
  CHECK(summary.bands.at(0).p95_relative_error == 0.25);
  CHECK(summary.bands[0].radiance.greatest == 9.0);
  CHECK(summary.bands[0].radiance.mean == 1.5);
}

TEST_CASE("every product is written under its name", "[sim][products]") {
  const ScratchFolder folder;
  ProductContext context;
  context.scenario_name = "day";
  context.time_utc = "2026-06-21T16:00:00Z";
  context.version = "0.1.0";
  const auto written =
      write_products({synthetic_array(6, 4, {0.48, 0.56, 0.655})}, context, folder / "out");
  std::set<std::string> names;
  for (const ProductFile& file : written) {
    names.insert(file.path.filename().string());
    CHECK(file.bytes == std::filesystem::file_size(file.path));
    CHECK(file.array == "cam");
  }
  CHECK(names == std::set<std::string>{"cam_radiance.img", "cam_radiance.hdr", "cam_error.img",
                                       "cam_error.hdr", "cam_truth.img", "cam_truth.hdr",
                                       "cam_material.img", "cam_material.hdr", "cam.exr",
                                       "cam.png"});
  std::size_t on_disc = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator{folder / "out"}) {
    ++on_disc;
  }
  CHECK(on_disc == names.size());
}

TEST_CASE("products hold the planes of the image", "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage image = synthetic_array(6, 4, {0.48, 10.9});
  ProductContext context;
  context.wanted.quick_look = false;
  static_cast<void>(write_products({image}, context, folder.path()));
  const EnviImage error = read_envi(folder / "cam_error.img");
  const auto& planes = std::get<std::vector<std::vector<float>>>(error.planes);
  CHECK(planes.at(1) == image.bands[1].standard_error);
  CHECK(error.header.wavelength_um == std::vector<double>{0.48, 10.9});

  const EnviImage truth = read_envi(folder / "cam_truth.img");
  const auto& shadow = std::get<std::vector<std::vector<float>>>(truth.planes).at(3);
  CHECK(truth.header.nan_is_no_data);
  CHECK(std::isnan(shadow.front()));
  CHECK(shadow.back() == 0.25F);

  const EnviImage material = read_envi(folder / "cam_material.img");
  CHECK(std::get<std::vector<std::vector<std::uint32_t>>>(material.planes).at(0) ==
        image.truth.material);
  CHECK(material.header.class_names == std::vector<std::string>{"sky", "grass", "roof_ tiled"});

  const ExrContents exr = read_exr(folder / "cam.exr");
  CHECK(exr.channels.size() == 9);
  CHECK(std::get<std::vector<float>>(exr.channels.at("radiance.B2")) == image.bands[1].radiance);
  CHECK(std::get<std::vector<std::uint32_t>>(exr.channels.at("truth.material")) ==
        image.truth.material);
}

TEST_CASE("products that are not wanted are not written", "[sim][products]") {
  const ScratchFolder folder;
  ProductContext context;
  context.wanted.exr = context.wanted.quick_look = context.wanted.truth = false;
  const auto written = write_products({synthetic_array(6, 4, {0.5})}, context, folder.path());
  CHECK(written.size() == 4);
  CHECK(folder.entries() == 4);
}

TEST_CASE("the same images give the same bytes", "[sim][products]") {
  const ScratchFolder folder;
  const std::vector<ArrayImage> images{synthetic_array(6, 4, {0.48, 0.56, 0.655})};
  const auto first = write_products(images, {}, folder / "a");
  const auto second = write_products(images, {}, folder / "b");
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CAPTURE(first[i].path);
    CHECK(content_of(first[i].path) == content_of(second[i].path));
  }
}

TEST_CASE("the user is told of invalid pixels and of bands that are not there", "[sim][products]") {
  const ScratchFolder folder;
  Diagnostics diagnostics;
  ProductContext context;
  context.wanted.envi = context.wanted.exr = false;
  context.diagnostics = &diagnostics;
  context.wanted.quick_look_bands = {"B9"};
  ArrayImage image = synthetic_array(6, 4, {0.48, 0.56});
  image.bands[1].radiance[3] = nan_value;
  static_cast<void>(write_products({image}, context, folder.path()));
  CHECK(diagnostics.messages() ==
        std::vector<std::string>{
            "array cam: 1 of 2 bands hold pixels whose radiance is no finite number",
            "no array has the bands wanted for the quick look; each shows bands of its own"});
}

TEST_CASE("images that cannot become products are refused before anything is written",
          "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage good = synthetic_array(6, 4, {0.5});
  ArrayImage cut = good;
  cut.name = "cut";
  cut.truth.range_m.pop_back();
  CHECK(support::message_of([&] {
          static_cast<void>(write_products({good, cut}, {}, folder.path()));
        }) == "array cut: range has 23 values for 24 pixels");
  ArrayImage twin = good;
  CHECK(support::message_of([&] {
          static_cast<void>(write_products({good, twin}, {}, folder.path()));
        }) == "two arrays would write the files of cam");
  CHECK(folder.entries() == 0);
}

TEST_CASE("an array's name cannot lead out of the folder", "[sim][products]") {
  const ScratchFolder folder;
  ProductContext context;
  context.wanted.envi = context.wanted.quick_look = false;
  ArrayImage image = synthetic_array(6, 4, {0.5});
  image.name = "../a b";
  const auto written = write_products({image}, context, folder.path());
  CHECK(written.at(0).path == folder / "_._a_b.exr");
}
