#include <deque>

#include "sim/files/exr.hpp"
#include "sim/products/array_files.hpp"

namespace nadir::sim {
namespace {

/// What a strip's channels point to where they are computed.
struct ExrRoom {
  std::deque<std::vector<float>> shares;
  std::deque<std::vector<std::uint32_t>> ids;
};

/// Channels of a strip. The same planes give the same channels in the same order.
struct ExrStrip {
  std::vector<ExrChannel> channels;
  ExrRoom room;

  void add(const std::string& name, const std::vector<float>& plane) {
    if (!plane.empty()) channels.push_back({name, std::span<const float>{plane}});
  }
  void add(const std::string& name, const std::vector<std::uint32_t>& plane) {
    if (!plane.empty()) channels.push_back({name, std::span<const std::uint32_t>{plane}});
  }
  void add_wider(const std::string& name, const std::vector<std::uint16_t>& plane) {
    add(name, room.ids.emplace_back(plane.begin(), plane.end()));
  }
};

void add_shares_to(ExrStrip& strip, const BandImage& band) {
  if (band.shares.path.empty() || band.shares.emission.empty()) return;
  const auto share = [&](const char* layer, LightShare part) {
    strip.add(layer + band.name, light_share(band, part, strip.room.shares.emplace_back()));
  };
  share("path_share.", LightShare::path);
  share("emission_share.", LightShare::emission);
  share("reflection_share.", LightShare::reflection);
}

void add_truth_to(ExrStrip& strip, const TruthImage& truth, bool fractions) {
  strip.add("truth.material", truth.material);
  strip.add("truth.object", truth.object);
  for (const auto& plane : truth_planes) {
    strip.add(std::string{"truth."} + plane.key, truth.*plane.values);
  }
  if (!fractions) return;
  const std::vector<std::string> names = names_with_sky(truth.material_names);
  for (std::size_t i = 0; i < truth.fractions.size(); ++i) {
    strip.add("fraction." + names.at(i), truth.fractions[i]);
  }
}

void fill_strip(ExrStrip& strip, const ArrayImage& image, const ProductsInput& wanted) {
  for (const BandImage& band : image.bands) {
    strip.add("radiance." + band.name, band.radiance);
    strip.add("error." + band.name, band.standard_error);
    strip.add("bias." + band.name, band.bias);
    strip.add_wider("dn." + band.name, band.dn);
    strip.add("noise." + band.name, band.noise);
    if (wanted.electrons) strip.add("electrons." + band.name, band.electrons);
    if (wanted.statistics) add_shares_to(strip, band);
  }
  strip.add("paths", image.pixel_paths);
  if (wanted.truth) add_truth_to(strip, image.truth, wanted.fractions);
}

using Attributes = std::map<std::string, ExrAttribute>;

void add_calibration(Attributes& attributes, const ArrayImage& image, const ArrayTask& task) {
  std::vector<std::string> bands;
  std::vector<float> gains, offsets;
  for (std::size_t b = 0; b < image.bands.size(); ++b) {
    const sensor::Calibration* calibration = calibration_of(task, b);
    if (image.bands[b].dn.empty() || calibration == nullptr) continue;
    bands.push_back(image.bands[b].name);
    // A float's step is 6e-8 of the gain: at the greatest number, 0.004 of a number.
    gains.push_back(static_cast<float>(calibration->gain));
    offsets.push_back(static_cast<float>(calibration->offset));
  }
  if (bands.empty()) return;
  attributes["dnBandNames"] = bands;
  attributes["dnGain"] = gains;
  attributes["dnOffset"] = offsets;
}

Attributes attributes_of(const ArrayImage& image, const ArrayTask& task) {
  const ProductContext& context = *task.context;
  std::vector<std::string> names;
  std::vector<float> wavelength_um, fwhm_um;
  for (const BandImage& band : image.bands) {
    names.push_back(band.name);
    wavelength_um.push_back(static_cast<float>(band.centre_um));
    fwhm_um.push_back(static_cast<float>(band.fwhm_um));
  }
  Attributes attributes = {{"array", image.name},
                           {"bandNames", names},
                           {"wavelengthMicrometers", wavelength_um},
                           {"fwhmMicrometers", fwhm_um},
                           {"radianceUnits", std::string{"W m-2 sr-1 um-1"}},
                           {"scenario", context.scenario_name},
                           {"acquisitionTimeUtc", context.time_utc},
                           {"software", "nadir " + context.version}};
  add_calibration(attributes, image, task);
  const bool alike = image.pixel_paths.empty();  // else they are a channel
  if (context.wanted.statistics && alike)
    attributes["pathsPerPixel"] = static_cast<int>(image.paths);
  if (!context.wanted.truth) return attributes;
  attributes["materialNames"] = names_with_sky(image.truth.material_names);
  if (!image.truth.object.empty()) {
    attributes["objectNames"] = names_with_sky(image.truth.object_names);
  }
  return attributes;
}

}  // namespace

struct ArrayExr::State {
  std::string array;
  std::filesystem::path file;
  ProductsInput wanted;
  std::unique_ptr<ExrWriter> writer;
};

ArrayExr::ArrayExr(const ArrayImage& first, const ArrayTask& task)
    : state_{std::make_unique<State>()} {
  State& s = *state_;
  s.array = first.name;
  s.file = with_ending(task.stem, ".exr");
  s.wanted = task.context->wanted;
  ExrStrip strip;
  fill_strip(strip, first, s.wanted);
  ExrWriter::Layout layout{first.samples, first.image_lines(), {}, attributes_of(first, task)};
  for (const auto& [name, values] : strip.channels) {
    layout.channels.push_back({name, values.index() == 1});
  }
  s.writer = std::make_unique<ExrWriter>(s.file, layout);
}

ArrayExr::~ArrayExr() = default;
ArrayExr::ArrayExr(ArrayExr&&) noexcept = default;
ArrayExr& ArrayExr::operator=(ArrayExr&&) noexcept = default;

void ArrayExr::take(const ArrayImage& image) {
  ExrStrip strip;
  fill_strip(strip, image, state_->wanted);
  std::vector<ExrValues> values;
  for (const auto& [name, plane] : strip.channels) values.push_back(plane);
  state_->writer->write(values);
}

void ArrayExr::finish(std::vector<ProductFile>& written) {
  State& s = *state_;
  s.writer->commit();
  written.push_back({"exr", s.array, s.file, std::filesystem::file_size(s.file)});
}

}  // namespace nadir::sim
