#include <sys/resource.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/envi.hpp"
#include "sim/files/exr.hpp"
#include "sim/products/write_products.hpp"
#include "support/catch.hpp"
#include "synthetic_array.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::content_of;
using support::full_array;
using support::ScratchFolder;
using support::strip_of;
using support::synthetic_array;

namespace {

/// All that can be asked for without a place on the earth.
ProductContext everything() {
  ProductContext context;
  context.scenario_name = "day";
  context.time_utc = "2026-06-21T16:00:00Z";
  context.version = "0.1.0";
  context.wanted.electrons = context.wanted.statistics = context.wanted.fractions = true;
  context.calibrations = {{{0.1, -1.0 / 3.0}, {0.2, 0.0}, {0.3, 7.0}, {1.0, 0.0}}};
  return context;
}

ProductWriter::Written write_in_strips(const ArrayImage& image, const ProductContext& context,
                                       const std::filesystem::path& folder, int strip_lines) {
  ProductWriter writer{context, folder};
  for (int line = 0; line < image.lines; line += strip_lines) {
    writer.take(strip_of(image, line, std::min(strip_lines, image.lines - line)));
  }
  return writer.finish();
}

template <class Number>
std::vector<std::vector<Number>> planes_of(const std::filesystem::path& file) {
  return std::get<std::vector<std::vector<Number>>>(read_envi(file).planes);
}

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

TEST_CASE("strips give the files that the whole image gives", "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage image = full_array(3, 5000);
  const auto whole = write_products({image}, everything(), folder / "whole");
  const auto strips = write_in_strips(image, everything(), folder / "strips", 64);
  REQUIRE(strips.files.size() == whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CAPTURE(whole[i].path);
    CHECK(strips.files[i].kind == whole[i].kind);
    CHECK(strips.files[i].bytes == whole[i].bytes);
    CHECK(content_of(strips.files[i].path) == content_of(whole[i].path));
  }
}

TEST_CASE("the summary of strips is that of the whole image", "[sim][products]") {
  const ScratchFolder folder;
  ProductContext context = everything();
  context.wanted.envi = context.wanted.exr = context.wanted.quick_look = false;
  const ArrayImage image = full_array(7, 50);
  const auto written = write_in_strips(image, context, folder.path(), 9);
  CHECK(written.files.empty());
  REQUIRE(written.summaries.size() == 1);
  RunReport whole, strips;
  whole.arrays = {summarise(image)};
  strips.arrays = written.summaries;
  CHECK(to_json(strips) == to_json(whole));
}

TEST_CASE("every plane of an image stands in its file", "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage image = full_array(4, 3);
  const auto written = write_products({image}, everything(), folder.path());
  std::set<std::string> names;
  for (const ProductFile& file : written) names.insert(file.path.filename().string());
  for (const char* product : {"radiance", "error", "truth", "material", "object", "fractions",
                              "place", "temperature", "dn", "noise", "electrons", "effects"}) {
    CAPTURE(product);
    CHECK(names.contains(std::string{"cam_"} + product + ".img"));
    CHECK(names.contains(std::string{"cam_"} + product + ".hdr"));
  }
  CHECK(names.size() == 26);  // and cam.exr, cam.png

  const auto truth = planes_of<float>(folder / "cam_truth.img");
  REQUIRE(truth.size() == truth_planes.size());
  CHECK(truth.back() == image.truth.sky_view);
  CHECK(planes_of<std::uint32_t>(folder / "cam_object.img").at(0) == image.truth.object);
  const EnviImage place = read_envi(folder / "cam_place.img");
  CHECK(place.header.band_names ==
        std::vector<std::string>{"latitude (deg)", "longitude (deg)", "height (m)", "time (s)"});
  CHECK(planes_of<double>(folder / "cam_place.img").at(1) == image.truth.longitude_deg);
  const auto temperature = planes_of<float>(folder / "cam_temperature.img");
  CHECK(temperature ==
        std::vector<std::vector<float>>{image.bands[3].brightness_temperature,
                                        image.bands[3].brightness_temperature_error});
  CHECK(planes_of<float>(folder / "cam_fractions.img") == image.truth.fractions);
  CHECK(planes_of<float>(folder / "cam_electrons.img").at(2) == image.bands[2].electrons);
  CHECK(planes_of<float>(folder / "cam_noise.img").at(1) == image.bands[1].noise);
}

TEST_CASE("digital numbers have the scale that leads back to radiance", "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage image = full_array(4, 3);
  static_cast<void>(write_products({image}, everything(), folder.path()));
  const EnviImage dn = read_envi(folder / "cam_dn.img");
  // Three bands have a detector; the fourth's calibration is not theirs.
  CHECK(dn.header.band_names == std::vector<std::string>{"B1", "B2", "B3"});
  CHECK(dn.header.gains == std::vector<double>{0.1, 0.2, 0.3});
  CHECK(dn.header.offsets == std::vector<double>{-1.0 / 3.0, 0.0, 7.0});
  CHECK(std::get<std::vector<std::vector<std::uint16_t>>>(dn.planes).at(1) == image.bands[1].dn);
  const ExrContents exr = read_exr(folder / "cam.exr");
  CHECK(std::get<std::vector<std::uint32_t>>(exr.channels.at("dn.B2")) ==
        std::vector<std::uint32_t>(image.bands[1].dn.begin(), image.bands[1].dn.end()));
  CHECK(std::get<std::vector<float>>(exr.attributes.at("dnGain")) ==
        std::vector<float>{0.1F, 0.2F, 0.3F});
}

TEST_CASE("shares of the light add up to one", "[sim][products]") {
  const ScratchFolder folder;
  ArrayImage image = full_array(4, 3);
  image.bands[0].radiance[5] = 0.0F;
  static_cast<void>(write_products({image}, everything(), folder.path()));
  const EnviImage effects = read_envi(folder / "cam_effects.img");
  CHECK(effects.header.band_names.at(4) == "B1 emission");
  const auto& planes = std::get<std::vector<std::vector<float>>>(effects.planes);
  REQUIRE(planes.size() == 12);
  CHECK(planes[0][0] == 0.25F);
  CHECK(planes[4][0] == 0.5F);
  CHECK(planes[8][0] == 0.25F);
  CHECK(std::isnan(planes[0][5]));  // no light, no shares
  CHECK(content_of(folder / "cam_effects.hdr").find("paths per pixel = 8\n") != std::string::npos);
}

TEST_CASE("planes that cost much are written only where they are wanted", "[sim][products]") {
  const ScratchFolder folder;
  ProductContext context = everything();
  context.wanted = {};
  context.wanted.exr = context.wanted.quick_look = false;
  static_cast<void>(write_products({full_array(4, 3)}, context, folder.path()));
  for (const char* product : {"fractions", "electrons", "effects"}) {
    CAPTURE(product);
    CHECK_FALSE(std::filesystem::exists(folder / (std::string{"cam_"} + product + ".img")));
  }
  CHECK(std::filesystem::exists(folder / "cam_dn.img"));
}

TEST_CASE("line times stand in the headers of arrays that have them", "[sim][products]") {
  const ScratchFolder folder;
  Camera camera;
  sensor::DetectorArray array;
  array.name = "cam";
  array.timing.scan = sensor::Pushbroom{-0.125, 0.0004};
  array.timing.exposure_s = 0.0003;
  camera.arrays = {array};
  const ProductGeometry geometry{&camera,
                                 geometry::LocalFrame{{46.0, 7.0, 0.0}},
                                 ephemeris::Instant::parse_utc("2026-06-21T16:00:00Z"),
                                 {},
                                 {},
                                 0.0};
  ProductContext context = everything();
  context.geometry = &geometry;
  context.wanted.sidecars = context.wanted.exr = context.wanted.quick_look = false;
  static_cast<void>(write_products({full_array(4, 3)}, context, folder.path()));
  CHECK(
      content_of(folder / "cam_radiance.hdr")
          .ends_with("first line time s = -0.125\nline period s = 0.0004\nexposure s = 0.0003\n"));
}

TEST_CASE("strips that do not follow each other are refused", "[sim][products]") {
  const ScratchFolder folder;
  const ArrayImage image = full_array(4, 6);
  ProductContext context = everything();
  context.wanted.quick_look = false;
  const auto message = [&](const ArrayImage& next) {
    ProductWriter writer{context, folder.path()};
    writer.take(strip_of(image, 0, 2));
    return support::message_of([&] { writer.take(next); });
  };
  CHECK(message(strip_of(image, 3, 2)) == "array cam: a strip begins with line 3, expected 2");
  CHECK(message(strip_of(image, 0, 2)) == "array cam: a strip begins with line 0, expected 2");
  ArrayImage other = strip_of(image, 2, 2);
  other.name = "other";
  CHECK(message(other) == "array cam: lines of other come after line 2 of 6");
  ArrayImage bare = strip_of(image, 2, 2);
  bare.bands[1].dn.clear();
  CHECK(message(bare) == "array cam: its strips have not the same planes");
  ArrayImage wider = strip_of(image, 2, 2);
  wider.all_lines = 7;
  CHECK(message(wider) == "array cam: its strips are not of one image");
  ArrayImage late = strip_of(image, 2, 4);
  late.name = "late";
  ProductWriter writer{context, folder.path()};
  CHECK(support::message_of([&] { writer.take(late); }) == "array late begins with line 2, not 0");
  CHECK(folder.entries() == 0);  // nothing half done stays
}

TEST_CASE("an array that ends early is not written", "[sim][products]") {
  const ScratchFolder folder;
  {
    ProductWriter writer{everything(), folder.path()};
    writer.take(strip_of(full_array(4, 6), 0, 5));
    CHECK(support::message_of([&] { static_cast<void>(writer.finish()); }) ==
          "array cam ends after line 5 of 6");
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("arrays follow each other, each under its own name", "[sim][products]") {
  const ScratchFolder folder;
  ProductContext context = everything();
  context.wanted.exr = context.wanted.quick_look = false;
  ArrayImage second = synthetic_array(4, 3, {0.5});
  second.name = "second";
  ProductWriter writer{context, folder.path()};
  writer.take(full_array(4, 3));
  writer.take(strip_of(second, 0, 2));
  writer.take(strip_of(second, 2, 1));
  CHECK(support::message_of([&] { writer.take(second); }) ==
        "two arrays would write the files of second");
  const auto written = writer.finish();
  REQUIRE(written.summaries.size() == 2);
  CHECK(written.summaries[1].name == "second");
  CHECK(std::filesystem::exists(folder / "second_truth.img"));
}

// What lies in memory is a strip, EXR's blocks and a preview of at most 4 million pixels, which the
// first pass fills. Radiance and error of the second are 480 million bytes: in memory, they would
// raise the peak by more than 200 million. 20 million is room for the allocator's own ways.
TEST_CASE("memory does not grow with the number of lines", "[.][slow][sim][products]") {
  const ScratchFolder folder;
  ProductContext context = everything();
  context.wanted.exr = false;
  context.wanted.truth = false;
  constexpr int samples = 1000, strip_lines = 100;
  ArrayImage strip = synthetic_array(samples, strip_lines, {0.48, 0.56, 0.655});
  const auto pass = [&](int lines) {
    ProductWriter writer{context, folder / std::to_string(lines)};
    strip.all_lines = lines;
    for (strip.first_line = 0; strip.first_line < lines; strip.first_line += strip_lines) {
      writer.take(strip);
    }
    static_cast<void>(writer.finish());
    return peak_kilobytes();
  };
  const long shorter = pass(4000), longer = pass(20'000);
  CAPTURE(shorter, longer);
  CHECK(longer - shorter < 20'000);
}
