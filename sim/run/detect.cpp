#include "sim/run/detect.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sim/run/error_list.hpp"

namespace nadir::sim {
namespace {

struct DetectorChannel {
  std::optional<sensor::SignalChain> chain;  ///< none: radiance is all that is wanted
  bool counts_electrons = false;
};
struct DetectorChannels {
  std::vector<DetectorChannel> bands;
  int samples = 0;
  int next_line = 0;
};

bool has_chain(const DetectorChannel& channel) { return channel.chain.has_value(); }

template <class Number>
std::span<Number> plane_line(std::vector<Number>& plane, std::size_t line, std::size_t samples) {
  return plane.empty() ? std::span<Number>{} : std::span{plane}.subspan(line * samples, samples);
}

void expose(DetectorChannel& channel, bool electrons, const ArrayImage& strip, BandImage& band) {
  if (band.radiance.size() != strip.pixels()) {
    throw std::invalid_argument{"band " + band.name + " has not the strip's size"};
  }
  band.dn.assign(strip.pixels(), 0);
  band.noise.assign(strip.pixels(), 0.0F);
  band.electrons.assign(electrons && channel.counts_electrons ? strip.pixels() : 0, 0.0F);
  const auto samples = static_cast<std::size_t>(strip.samples);
  for (std::size_t line = 0; line < static_cast<std::size_t>(strip.lines); ++line) {
    channel.chain->expose(std::span{std::as_const(band.radiance)}.subspan(line * samples, samples),
                          {.dn = plane_line(band.dn, line, samples),
                           .electrons = plane_line(band.electrons, line, samples),
                           .noise = plane_line(band.noise, line, samples)});
  }
}

DetectorChannels detector_channels(const Camera& camera, std::size_t index, std::uint64_t seed,
                                   ErrorList& errors) {
  const sensor::DetectorArray& array = camera.arrays[index];
  DetectorChannels channels{std::vector<DetectorChannel>(array.bands.size()), array.samples};
  if (index >= camera.electronics.size()) return channels;
  const std::vector<BandElectronics>& electronics = camera.electronics[index];
  for (std::size_t band = 0; band < std::min(array.bands.size(), electronics.size()); ++band) {
    const auto& detector = electronics[band].detector;
    if (!detector) continue;
    DetectorChannel& channel = channels.bands[band];
    errors.attempt("detector of band " + array.bands[band].name + " of array " + array.name, {},
                   [&] {
                     channel.chain.emplace(array, band, *detector, seed);
                     channel.counts_electrons =
                         std::holds_alternative<sensor::PhotonDetector>(detector->element);
                   });
  }
  return channels;
}

}  // namespace

struct DetectorStage::State {
  std::vector<DetectorChannels> arrays;
  bool electrons = false;
};

DetectorStage::DetectorStage(const Camera& camera, const ProductsInput& wanted, std::uint64_t seed)
    : state_{std::make_unique<State>()} {
  state_->electrons = wanted.electrons;
  ErrorList errors;
  for (std::size_t i = 0; i < camera.arrays.size(); ++i) {
    state_->arrays.push_back(detector_channels(camera, i, seed, errors));
  }
  errors.throw_if_any();
}
DetectorStage::~DetectorStage() = default;
DetectorStage::DetectorStage(DetectorStage&&) noexcept = default;
DetectorStage& DetectorStage::operator=(DetectorStage&&) noexcept = default;

void DetectorStage::apply(std::size_t array, ArrayImage& strip) {
  DetectorChannels& channels = state_->arrays.at(array);
  if (strip.first_line != channels.next_line || strip.samples != channels.samples ||
      strip.bands.size() != channels.bands.size()) {
    throw std::invalid_argument{"a strip of array " + strip.name +
                                " does not follow the former one or is not the array's"};
  }
  for (std::size_t band = 0; band < strip.bands.size(); ++band) {
    if (!has_chain(channels.bands[band])) continue;
    expose(channels.bands[band], state_->electrons, strip, strip.bands[band]);
  }
  channels.next_line += strip.lines;
}

bool DetectorStage::any() const noexcept {
  return std::any_of(state_->arrays.begin(), state_->arrays.end(), [](const auto& array) {
    return std::any_of(array.bands.begin(), array.bands.end(), has_chain);
  });
}

bool DetectorStage::complete(std::size_t array) const noexcept {
  const auto& bands = state_->arrays[array].bands;
  return !bands.empty() && std::all_of(bands.begin(), bands.end(), has_chain);
}

std::vector<std::vector<sensor::Calibration>> DetectorStage::calibrations() const {
  std::vector<std::vector<sensor::Calibration>> all;
  for (const DetectorChannels& array : state_->arrays) {
    auto& found = all.emplace_back();
    if (std::none_of(array.bands.begin(), array.bands.end(), has_chain)) continue;
    for (const DetectorChannel& channel : array.bands) {
      found.push_back(channel.chain ? channel.chain->calibration() : sensor::Calibration{});
    }
  }
  return all;
}

}  // namespace nadir::sim
