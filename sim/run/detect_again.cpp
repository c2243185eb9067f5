#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/error.hpp"
#include "sim/files/envi.hpp"
#include "sim/products/array_files.hpp"
#include "sim/products/product_checks.hpp"
#include "sim/run/detect.hpp"
#include "sim/run/load_camera_arrays.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

constexpr std::size_t strip_numbers = 1U << 20U;  // radiances in memory at a time: 4 MB

/// One array's files, as they are read and written.
class ArrayRerun {
 public:
  ArrayRerun(const sensor::DetectorArray& array, const std::filesystem::path& output,
             std::uint64_t seed)
      : array_{array},
        stem_{output / product_file_name(array.name)},
        file_{with_ending(stem_, fmt::format("_dn_{}.img", seed).c_str())},
        reader_{with_ending(stem_, "_radiance.img")},
        seed_{seed} {
    check();
  }

  std::filesystem::path run(DetectorStage& stage, std::size_t index) {
    const auto calibrations = stage.calibrations()[index];
    ArrayImage strip = empty_strip();
    std::unique_ptr<EnviWriter> writer;
    const std::size_t line_numbers = strip.bands.size() * static_cast<std::size_t>(array_.samples);
    const int most = static_cast<int>(std::max<std::size_t>(strip_numbers / line_numbers, 1));
    for (int first = 0; first < array_.lines; first += most) {
      read(strip, first, std::min(most, array_.lines - first));
      stage.apply(index, strip);
      if (!writer) writer = open(strip, calibrations);
      write(strip, *writer);
    }
    if (writer) writer->commit();
    return file_;
  }

 private:
  void check() const {
    const EnviHeader& header = reader_.header();
    const bool same_size = header.samples == array_.samples && header.lines == array_.lines &&
                           reader_.planes() == array_.bands.size();
    if (same_size && reader_.type() == EnviType::float32) return;
    throw InputError{InputIssue{
        {with_ending(stem_, "_radiance.img").string()},
        fmt::format("expected {} x {} pixels and {} bands of radiance, as array \"{}\" of the "
                    "scenario has them, found {} x {} and {}",
                    array_.samples, array_.lines, array_.bands.size(), array_.name, header.samples,
                    header.lines, reader_.planes()),
        {},
        {}}};
  }

  [[nodiscard]] ArrayImage empty_strip() const {
    ArrayImage strip;
    strip.name = array_.name;
    strip.samples = array_.samples;
    strip.all_lines = array_.lines;
    strip.bands.resize(array_.bands.size());
    for (std::size_t i = 0; i < array_.bands.size(); ++i)
      strip.bands[i].name = array_.bands[i].name;
    return strip;
  }

  void read(ArrayImage& strip, int first, int lines) {
    strip.first_line = first;
    strip.lines = lines;
    for (std::size_t band = 0; band < strip.bands.size(); ++band) {
      strip.bands[band].radiance.resize(strip.pixels());
      reader_.read(band, first, std::span{strip.bands[band].radiance});
    }
  }

  [[nodiscard]] std::unique_ptr<EnviWriter> open(
      const ArrayImage& strip, const std::vector<sensor::Calibration>& calibrations) const {
    const EnviHeader& radiance = reader_.header();
    EnviHeader header;
    header.samples = radiance.samples;
    header.lines = radiance.lines;
    header.description = fmt::format(
        "Digital numbers, seed of the noise {}; gain x number + offset is the radiance in "
        "W m-2 sr-1 um-1",
        seed_);
    header.sensor_type = radiance.sensor_type;
    header.acquisition_time = radiance.acquisition_time;
    header.data_units = "DN";
    header.more = line_times(array_);
    for (std::size_t band = 0; band < strip.bands.size(); ++band) {
      if (strip.bands[band].dn.empty()) continue;
      header.band_names.push_back(strip.bands[band].name);
      header.gains.push_back(calibrations[band].gain);
      header.offsets.push_back(calibrations[band].offset);
      if (band < radiance.wavelength_um.size()) {
        header.wavelength_um.push_back(radiance.wavelength_um[band]);
      }
      if (band < radiance.fwhm_um.size()) header.fwhm_um.push_back(radiance.fwhm_um[band]);
    }
    const std::size_t planes = header.band_names.size();
    return std::make_unique<EnviWriter>(file_, std::move(header), EnviType::uint16, planes);
  }

  static void write(const ArrayImage& strip, EnviWriter& writer) {
    std::size_t plane = 0;
    for (const BandImage& band : strip.bands) {
      if (!band.dn.empty()) writer.write(plane++, std::span<const std::uint16_t>{band.dn});
    }
  }

  const sensor::DetectorArray& array_;
  std::filesystem::path stem_, file_;
  EnviReader reader_;
  std::uint64_t seed_;
};

Camera camera_without_platform(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const Scenario scenario = read_scenario(file, diagnostics);
  InputFiles files;
  ErrorList errors;
  CameraArrays loaded = load_arrays(scenario.camera, files, errors);
  errors.throw_if_any();
  Camera camera;
  camera.arrays = std::move(loaded.arrays);
  camera.electronics = std::move(loaded.electronics);
  return camera;
}

}  // namespace

std::vector<std::filesystem::path> detect_again(const std::filesystem::path& scenario,
                                                const std::filesystem::path& output,
                                                std::uint64_t seed, Diagnostics& diagnostics) {
  const Camera camera = camera_without_platform(scenario, diagnostics);
  DetectorStage stage{camera, ProductsInput{}, seed};
  if (!stage.any()) {
    throw InputError{InputIssue{
        {scenario.string()}, "no array of the camera has a detector: there is no noise", {}, {}}};
  }
  // All are opened before any is written.
  std::vector<std::pair<std::size_t, ArrayRerun>> reruns;
  const auto calibrations = stage.calibrations();
  for (std::size_t i = 0; i < camera.arrays.size(); ++i) {
    if (!calibrations[i].empty())
      reruns.emplace_back(i, ArrayRerun{camera.arrays[i], output, seed});
  }
  std::vector<std::filesystem::path> written;
  for (auto& [index, rerun] : reruns) written.push_back(rerun.run(stage, index));
  return written;
}

}  // namespace nadir::sim
