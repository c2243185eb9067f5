#include "sim/files/envi.hpp"

#include <stdexcept>

#include "core/error.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir::sim;
using support::content_of;
using support::ScratchFolder;

namespace {

const std::vector<float> first{1.5F, -2.0F, 3.25e-9F, 4.0F, 5.0F, 6.0F};
const std::vector<float> second{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F};

EnviHeader envi_header() {
  EnviHeader h;
  h.samples = 3;
  h.lines = 2;
  h.description = "radiance, at the aperture";
  h.sensor_type = "array oli";
  h.acquisition_time = "2026-06-21T16:00:00Z";
  h.data_units = "W m-2 sr-1 um-1";
  h.band_names = {"blue", "green"};
  h.wavelength_um = {0.4825891, 1.0 / 3.0};
  h.fwhm_um = {0.06, 0.057};
  return h;
}

std::vector<std::span<const float>> planes() { return {first, second}; }

}  // namespace

TEST_CASE("an ENVI image reads back bit by bit with its header", "[sim][envi]") {
  const ScratchFolder folder;
  const auto file = folder / "a.b_radiance.img";
  write_envi(file, envi_header(), planes());
  CHECK(folder.entries() == 2);

  const EnviImage read = read_envi(file);
  const auto& values = std::get<std::vector<std::vector<float>>>(read.planes);
  CHECK(values == std::vector<std::vector<float>>{first, second});
  CHECK(read.header.samples == 3);
  CHECK(read.header.lines == 2);
  CHECK(read.header.description == "radiance, at the aperture");
  CHECK(read.header.acquisition_time == "2026-06-21T16:00:00Z");
  CHECK(read.header.data_units == "W m-2 sr-1 um-1");
  CHECK(read.header.band_names == envi_header().band_names);
  CHECK(read.header.wavelength_um == envi_header().wavelength_um);  // exact: shortest digits
  CHECK(read.header.fwhm_um == envi_header().fwhm_um);
}

TEST_CASE("an ENVI image lies band after band in little endian", "[sim][envi]") {
  const ScratchFolder folder;
  write_envi(folder / "x.img", envi_header(), planes());
  const std::string bytes = content_of(folder / "x.img");
  REQUIRE(bytes.size() == 48);
  CHECK(bytes.substr(0, 4) == std::string("\x00\x00\xC0\x3F", 4));   // 1.5
  CHECK(bytes.substr(24, 4) == std::string("\xCD\xCC\xCC\x3D", 4));  // 0.1, first of band 2
}

TEST_CASE("an ENVI header says what readers look for", "[sim][envi]") {
  const ScratchFolder folder;
  write_envi(folder / "x.img", envi_header(), planes());
  CHECK(content_of(folder / "x.hdr") ==
        "ENVI\n"
        "description = {radiance, at the aperture}\n"
        "samples = 3\nlines = 2\nbands = 2\n"
        "header offset = 0\nfile type = ENVI Standard\ndata type = 4\n"
        "interleave = bsq\nbyte order = 0\n"
        "sensor type = array oli\n"
        "acquisition time = 2026-06-21T16:00:00Z\n"
        "data units = W m-2 sr-1 um-1\n"
        "z plot titles = {Wavelength (um), W m-2 sr-1 um-1}\n"
        "band names = {blue, green}\n"
        "wavelength units = Micrometers\n"
        "wavelength = {0.4825891, 0.3333333333333333}\n"
        "fwhm = {0.06, 0.057}\n");
}

TEST_CASE("ids keep their numbers and their classes' names", "[sim][envi]") {
  const ScratchFolder folder;
  const std::vector<std::uint32_t> ids{0, 1, 2, 4'000'000'000, 1, 0};
  EnviHeader h = envi_header();
  h.wavelength_um = h.fwhm_um = {};
  h.data_units = {};
  h.band_names = {"material"};
  h.class_names = {"sky", "roof, {tiled}", "grass"};
  write_envi(folder / "m.img", h, std::vector<std::span<const std::uint32_t>>{ids});

  const EnviImage read = read_envi(folder / "m.img");
  CHECK(std::get<std::vector<std::vector<std::uint32_t>>>(read.planes).at(0) == ids);
  // Commas and braces would cut the list.
  CHECK(read.header.class_names == std::vector<std::string>{"sky", "roof_ _tiled_", "grass"});
}

TEST_CASE("an ENVI image whose sizes disagree is not written", "[sim][envi]") {
  const ScratchFolder folder;
  EnviHeader wrong = envi_header();
  wrong.lines = 3;
  CHECK_THROWS_AS(write_envi(folder / "x.img", wrong, planes()), std::invalid_argument);
  wrong = envi_header();
  wrong.wavelength_um = {0.5};
  CHECK_THROWS_AS(write_envi(folder / "x.img", wrong, planes()), std::invalid_argument);
  CHECK(folder.entries() == 0);
}

TEST_CASE("a cut ENVI image and a wrong header are refused", "[sim][envi]") {
  const ScratchFolder folder;
  const auto file = folder / "x.img";
  write_envi(file, envi_header(), planes());
  std::filesystem::resize_file(file, 47);
  CHECK(support::message_of([&] {
          static_cast<void>(read_envi(file));
        }).find("has 47 bytes, its header promises 48") != std::string::npos);

  std::string text = content_of(folder / "x.hdr");
  text.replace(text.find("samples = 3"), 11, "samples = 3x");
  std::ofstream{folder / "x.hdr"} << text;
  try {
    static_cast<void>(read_envi(file));
    FAIL("a wrong number was accepted");
  } catch (const nadir::InputError& error) {
    REQUIRE(error.issues().size() == 1);
    CHECK(error.issues()[0].where.line == 3);
    CHECK(error.issues()[0].message == "\"samples\" is \"3x\", expected a whole number");
  }
}

TEST_CASE("an ENVI image written in strips has the bytes of one written at once", "[sim][envi]") {
  const ScratchFolder folder;
  write_envi(folder / "whole.img", envi_header(), planes());
  {
    EnviWriter writer{folder / "strips.img", envi_header(), EnviType::float32, 2};
    for (const int line : {0, 1}) {
      for (std::size_t plane = 0; plane < 2; ++plane) {
        writer.write(plane, planes()[plane].subspan(3 * static_cast<std::size_t>(line), 3));
      }
    }
    CHECK(folder.entries() == 3);  // whole.img, whole.hdr and the temporary
    CHECK_FALSE(std::filesystem::exists(folder / "strips.img"));
    writer.commit();
  }
  CHECK(content_of(folder / "strips.img") == content_of(folder / "whole.img"));
  CHECK(content_of(folder / "strips.hdr") == content_of(folder / "whole.hdr"));
}

TEST_CASE("planes of an ENVI image may come one before the other", "[sim][envi]") {
  const ScratchFolder folder;
  EnviWriter writer{folder / "x.img", envi_header(), EnviType::float32, 2};
  writer.write(1, planes()[1]);
  writer.write(0, planes()[0]);
  writer.commit();
  CHECK(std::get<0>(read_envi(folder / "x.img").planes) ==
        std::vector<std::vector<float>>{first, second});
}

TEST_CASE("an ENVI image that lacks lines gets no name, and more lines are refused",
          "[sim][envi]") {
  const ScratchFolder folder;
  {
    EnviWriter writer{folder / "x.img", envi_header(), EnviType::float32, 2};
    writer.write(0, planes()[0]);
    CHECK_THROWS_AS(writer.write(0, planes()[0].subspan(0, 3)), std::invalid_argument);
    CHECK_THROWS_AS(writer.write(1, planes()[0].subspan(0, 2)), std::invalid_argument);
    const std::vector<double> other(3, 0.0);
    CHECK_THROWS_AS(writer.write(1, other), std::invalid_argument);
    writer.write(1, planes()[0].subspan(0, 3));
    CHECK(support::message_of([&] { writer.commit(); }) ==
          (folder / "x.img").string() + " has 1 of 2 lines");
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("doubles and short numbers keep their bits and their scale", "[sim][envi]") {
  const ScratchFolder folder;
  EnviHeader h = envi_header();
  h.gains = {0.1, 1.0 / 3.0};
  h.offsets = {-0.5, 0.0};
  const std::vector<std::uint16_t> low{0, 1, 4095, 65535, 7, 8}, high{6, 5, 4, 3, 2, 1};
  write_envi(folder / "dn.img", h, std::vector<std::span<const std::uint16_t>>{low, high});
  const EnviImage numbers = read_envi(folder / "dn.img");
  CHECK(std::get<std::vector<std::vector<std::uint16_t>>>(numbers.planes) ==
        std::vector<std::vector<std::uint16_t>>{low, high});
  CHECK(numbers.header.gains == h.gains);  // exact: shortest digits
  CHECK(numbers.header.offsets == h.offsets);
  CHECK(content_of(folder / "dn.hdr").find("data type = 12\n") != std::string::npos);

  const std::vector<double> latitude{46.123456789012345, -89.9, 0.0, 1.0, 2.0, 1e-300};
  h = envi_header();
  h.band_names = {"latitude (deg)"};
  h.wavelength_um = h.fwhm_um = {};
  write_envi(folder / "place.img", h, std::vector<std::span<const double>>{latitude});
  CHECK(std::get<std::vector<std::vector<double>>>(read_envi(folder / "place.img").planes).at(0) ==
        latitude);
}

TEST_CASE("some lines of an ENVI plane can be read alone", "[sim][envi]") {
  const ScratchFolder folder;
  write_envi(folder / "x.img", envi_header(), planes());
  EnviReader reader{folder / "x.img"};
  CHECK(reader.planes() == 2);
  CHECK(reader.type() == EnviType::float32);
  std::vector<float> line(3);
  reader.read(1, 1, std::span{line});
  CHECK(line == std::vector<float>{0.4F, 0.5F, 0.6F});
  reader.read(0, 0, std::span{line});
  CHECK(line == std::vector<float>{1.5F, -2.0F, 3.25e-9F});
  CHECK_THROWS_AS(reader.read(1, 2, std::span{line}), std::invalid_argument);
  CHECK_THROWS_AS(reader.read(2, 0, std::span{line}), std::invalid_argument);
  std::vector<double> wider(3);
  CHECK_THROWS_AS(reader.read(0, 0, std::span{wider}), std::invalid_argument);
}
