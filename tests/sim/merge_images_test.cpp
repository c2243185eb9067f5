#include "sim/run/merge_images.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "core/statistics.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

/// Pixels of one thermal band.
ArrayImage image_of(std::vector<float> radiance, std::vector<float> error, std::uint32_t paths) {
  ArrayImage image;
  image.samples = static_cast<int>(radiance.size());
  image.lines = 1;
  image.paths = paths;
  image.bands.resize(1);
  BandImage& band = image.bands[0];
  band.brightness_temperature.assign(radiance.size(), 300.0F);
  band.brightness_temperature_error.assign(radiance.size(), 1.0F);
  band.shares.path = radiance;
  band.shares.emission = radiance;
  band.dn.assign(radiance.size(), 7);
  band.radiance = std::move(radiance);
  band.standard_error = std::move(error);
  return image;
}

const spectral::BandQuadrature ten_um{{Micrometres{10.0}}, {1.0}};

}  // namespace

TEST_CASE("images of equally many paths merge into their plain mean", "[sim][merge]") {
  ArrayImage image = image_of({1.0F, 5.0F}, {0.3F, 0.0F}, 32);
  merge(image, image_of({2.0F, 7.0F}, {0.4F, 0.0F}, 32), {&ten_um, 1});
  const BandImage& band = image.bands[0];
  CHECK(band.radiance == std::vector<float>{1.5F, 6.0F});
  CHECK(band.shares.path == std::vector<float>{1.5F, 6.0F});
  CHECK(band.standard_error[0] == Approx(0.25).epsilon(1e-6));  // floats
  CHECK(band.standard_error[1] == 0.0F);
  CHECK(image.pixel_paths.empty());
  CHECK(image.paths == 64);
  CHECK(band.dn.empty());  // the detector has to count again
}

TEST_CASE("the merged brightness temperature is that of the merged radiance", "[sim][merge]") {
  ArrayImage image = image_of({1.0F}, {0.1F}, 100);
  merge(image, image_of({9.0F}, {0.1F}, 300), {&ten_um, 1});
  const double expected =
      spectral::band_brightness_temperature(ten_um, SpectralRadiance{7.0}).value;
  CHECK(image.bands[0].radiance[0] == Approx(7.0).epsilon(1e-7));
  CHECK(image.bands[0].brightness_temperature[0] == Approx(expected).epsilon(1e-6));
  // Without the band's wavelengths it is merged like the radiance.
  ArrayImage blind = image_of({1.0F}, {0.1F}, 100);
  ArrayImage other = image_of({9.0F}, {0.1F}, 300);
  other.bands[0].brightness_temperature[0] = 320.0F;
  merge(blind, other, {});
  CHECK(blind.bands[0].brightness_temperature[0] == Approx(315.0).epsilon(1e-6));
}

TEST_CASE("a pixel without paths changes nothing, and takes all from the other", "[sim][merge]") {
  ArrayImage image = image_of({1.0F, 0.0F}, {0.1F, 0.0F}, 0);
  image.pixel_paths = {16, 0};
  ArrayImage other = image_of({0.0F, 4.0F}, {0.0F, 0.2F}, 0);
  other.pixel_paths = {0, 32};
  merge(image, other, {&ten_um, 1});
  CHECK(image.bands[0].radiance == std::vector<float>{1.0F, 4.0F});
  CHECK(image.bands[0].standard_error == std::vector<float>{0.1F, 0.2F});
  CHECK(image.bands[0].brightness_temperature[0] == 300.0F);
  CHECK(image.pixel_paths == std::vector<std::uint32_t>{16, 32});
}

TEST_CASE("the order of merging does not matter", "[sim][merge]") {
  const auto part = [](float radiance, float error, std::uint32_t paths) {
    return image_of({radiance}, {error}, paths);
  };
  ArrayImage forth = part(1.0F, 0.3F, 10), back = part(6.0F, 0.1F, 70);
  merge(forth, part(4.0F, 0.2F, 20), {});
  merge(forth, part(6.0F, 0.1F, 70), {});
  merge(back, part(4.0F, 0.2F, 20), {});
  merge(back, part(1.0F, 0.3F, 10), {});
  // Two roundings to float each way.
  CHECK(forth.bands[0].radiance[0] == Approx(back.bands[0].radiance[0]).epsilon(3e-7));
  CHECK(forth.bands[0].standard_error[0] == Approx(back.bands[0].standard_error[0]).epsilon(3e-7));
}

TEST_CASE("two independent halves of unequal size merge into the right error", "[sim][merge]") {
  // Uniform paths, 16 replicates of 4 and of 12. The squared deviation of a merged pixel over its
  // stated variance has the mean 1 + 2 / (nu - 2) or so: with nu near 25, 1.09 (F distribution).
  Rng rng{3};
  constexpr int pixels = 20000;
  const auto half = [&](int paths) {
    std::vector<float> mean, error;
    for (int i = 0; i < pixels; ++i) {
      Welford spread;
      for (int r = 0; r < 16; ++r) {
        double sum = 0.0;
        for (int p = 0; p < paths; ++p) sum += rng.next();
        spread.add(sum / paths);
      }
      mean.push_back(static_cast<float>(spread.mean()));
      error.push_back(static_cast<float>(spread.estimate().standard_error));
    }
    return image_of(std::move(mean), std::move(error), static_cast<std::uint32_t>(16 * paths));
  };
  ArrayImage image = half(4);
  merge(image, half(12), {});
  double ratio = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const double error = image.bands[0].standard_error[i];
    const double off = image.bands[0].radiance[i] - 0.5;
    ratio += off * off / (error * error) / pixels;
    variance += error * error / pixels;
  }
  // Mean of 256 uniform numbers: variance 1 / 12 / 256, stated without bias to 0.2 %.
  CHECK(variance == Approx(1.0 / 3072.0).epsilon(0.01));
  CHECK(ratio == Approx(1.09).epsilon(0.05));  // 20,000 draws of a variance about 2.6: 1.1 %
}

TEST_CASE("images of other pixels or bands are refused", "[sim][merge]") {
  ArrayImage image = image_of({1.0F}, {0.1F}, 8);
  CHECK_THROWS_AS(merge(image, image_of({1.0F, 2.0F}, {0.1F, 0.1F}, 8), {}), std::invalid_argument);
  ArrayImage shifted = image_of({1.0F}, {0.1F}, 8);
  shifted.first_line = 16;
  CHECK_THROWS_AS(merge(image, shifted, {}), std::invalid_argument);
}

}  // namespace nadir::sim
