#pragma once

#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "sim/run/run_key.hpp"
#include "sim/run/tile_store.hpp"

namespace nadir::sim::support {

/// A tile with something different in every number of every plane that is stored, and every kind of
/// number that there is: NaN with a payload, infinities, -0, the least and the greatest.
class TileMaker {
 public:
  [[nodiscard]] TileRecord operator()(const TileKey& key) {
    TileRecord record;
    record.key = key;
    ArrayImage& image = record.pixels;
    image.name = "wide";
    image.samples = key.samples;
    image.lines = key.lines;
    image.first_sample = key.first_sample;
    image.first_line = key.first_line;
    image.all_lines = 4096;
    image.paths = 64;
    image.pixel_paths.assign(image.pixels(), 7);
    for (const char* name : {"green", "thermal"}) image.bands.push_back(band(name, image.pixels()));
    fill_truth(image.truth, image.pixels());
    std::uint64_t count = 1000 + key.round;
    auto& counters = record.counters;
    for (auto* counter : {&counters.primary_rays, &counters.target_rays, &counters.truth_rays,
                          &counters.bounce_limit_stops}) {
      *counter = ++count;
    }
    return record;
  }

 private:
  float next() {
    constexpr auto infinity = std::numeric_limits<float>::infinity();
    const float special[] = {std::bit_cast<float>(0x7FC0ABCDU),
                             infinity,
                             -infinity,
                             -0.0F,
                             std::numeric_limits<float>::denorm_min(),
                             std::numeric_limits<float>::max()};
    const unsigned n = number_++;
    return n % 5 == 0 ? special[(n / 5) % 6] : 0.1F * static_cast<float>(n);
  }
  void fill(std::vector<float>& plane, std::size_t pixels) {
    plane.resize(pixels);
    for (float& value : plane) value = next();
  }
  BandImage band(const char* name, std::size_t pixels) {
    BandImage image;
    image.name = name;
    image.centre_um = 1.0 / 3.0;
    image.fwhm_um = 0.1;
    for (auto* plane : {&image.radiance, &image.standard_error, &image.brightness_temperature,
                        &image.brightness_temperature_error, &image.shares.path,
                        &image.shares.emission, &image.bias}) {
      fill(*plane, pixels);
    }
    return image;
  }
  void fill_truth(TruthImage& truth, std::size_t pixels) {
    truth.material_names = {"grass", "tin"};
    truth.object_names = {"ball", "", "a \"shed\" with \n and \xC3\xA9"};
    truth.material.assign(pixels, 0xFFFFFFFFU);
    truth.object.assign(pixels, number_);
    for (const auto& plane : truth_planes) fill(truth.*plane.values, pixels);
    for (const auto& plane : place_planes) {
      auto& values = truth.*plane.values;
      values.resize(pixels);
      for (double& value : values) value = 1.0 / (1.0 + static_cast<double>(number_++));
    }
    truth.fractions.resize(3);
    for (auto& fraction : truth.fractions) fill(fraction, pixels);
  }
  unsigned number_ = 0;
};

inline RunKey some_key(std::uint64_t seed = 1) {
  RunKey key;
  key.physics = {{"version of nadir", "0.1.0"}, {"scenario", "abc"}, {"file \"ball.obj\"", "def"}};
  key.sampling = {{"samples", "4 x 2"}};
  key.seed = seed;
  key.scenario = "/somewhere/yard.xml";
  return key;
}

/// Planes as bits: NaN is NaN.
template <class Number>
bool same_bits(const std::vector<Number>& a, const std::vector<Number>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

}  // namespace nadir::sim::support
