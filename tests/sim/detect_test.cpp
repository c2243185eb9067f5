#include "sim/run/detect.hpp"

#include <fstream>
#include <string>
#include <vector>

#include "camera_support.hpp"
#include "core/error.hpp"
#include "sim/files/envi.hpp"
#include "support/catch.hpp"

// `nadir detect`: digital numbers of radiance that lies in a run's folder.

namespace nadir::sim {
namespace {

constexpr const char* counting_array = R"(<global_shutter exposure_ms="2"/>
<optics f_number="4"/>
<photon_detector efficiency="0.5" read_noise_e="10" full_well_e="20000"/>
<band_box name="g" lo_um="0.5" hi_um="0.6"/>)";

/// A scenario with that array of 100 x 40 pixels, and radiance as a run would have written it.
std::filesystem::path rendered(const test::TemporaryFolder& folder, const std::string& array,
                               int samples = 100) {
  const auto scenario = folder / "scene.xml";
  std::ofstream{scenario} << test::with_array(array);
  const std::vector<float> radiance(static_cast<std::size_t>(samples) * 40, 12.0F);
  EnviHeader header;
  header.samples = samples;
  header.lines = 40;
  header.band_names = {"g"};
  header.wavelength_um = {0.55};
  header.fwhm_um = {0.1};
  write_envi(folder / "a_radiance.img", header, {std::span<const float>{radiance}});
  return scenario;
}

std::vector<std::uint16_t> numbers_in(const std::filesystem::path& image) {
  return std::get<std::vector<std::vector<std::uint16_t>>>(read_envi(image).planes).at(0);
}

std::string refusal(const std::filesystem::path& scenario, const std::filesystem::path& output) {
  Diagnostics diagnostics;
  try {
    (void)detect_again(scenario, output, 1, diagnostics);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("one render gives many noisy images", "[sim][sensor]") {
  const test::TemporaryFolder folder;
  const auto scenario = rendered(folder, counting_array);
  Diagnostics diagnostics;
  const auto first = detect_again(scenario, folder / "", 7, diagnostics);
  REQUIRE(first.size() == 1);
  CHECK(first[0].filename() == "a_dn_7.img");
  const auto numbers = numbers_in(first[0]);
  CHECK(numbers.size() == 4000);
  (void)detect_again(scenario, folder / "", 8, diagnostics);
  CHECK(numbers != numbers_in(folder / "a_dn_8.img"));
  (void)detect_again(scenario, folder / "", 7, diagnostics);
  CHECK(numbers == numbers_in(folder / "a_dn_7.img"));
  const EnviHeader header = read_envi(first[0]).header;
  REQUIRE(header.gains.size() == 1);
  CHECK(header.wavelength_um == std::vector<double>{0.55});
  double sum = 0.0;
  for (const auto number : numbers) sum += header.gains[0] * number + header.offsets[0];
  CHECK(sum / 4000.0 == Approx(12.0).epsilon(0.01));  // 5 % noise or less a pixel, 4000 of them
}

TEST_CASE("noise needs detectors, and radiance of the scenario's size", "[sim][sensor]") {
  const test::TemporaryFolder folder;
  const auto bare = rendered(folder, test::green_band);
  CHECK(refusal(bare, folder / "").find("no array of the camera has a detector") !=
        std::string::npos);
  const auto other = rendered(folder, counting_array, 99);
  CHECK(refusal(other, folder / "").find("expected 100 x 40 pixels") != std::string::npos);
  CHECK(refusal(other, folder / "nowhere").find("a_radiance") != std::string::npos);
}

}  // namespace nadir::sim
