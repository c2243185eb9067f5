#include "sim/study/study_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/random.hpp"
#include "sim/files/png.hpp"
#include "sim/products/band_choice.hpp"
#include "sim/products/temperature_map.hpp"
#include "sim/products/tone_map.hpp"

namespace nadir::sim {
namespace {

constexpr std::uint64_t picture_stream = 0x7069637475726573ULL;

/// What one shot gave.
struct Shot {
  ArrayImage image;
  std::vector<double> own_error;  ///< by pixel, relative, of its own replicates; rms over bands
  double wall_s = 0.0;
};

std::size_t largest_array(const std::vector<ImageSize>& sizes) {
  std::size_t largest = 0;
  for (std::size_t a = 1; a < sizes.size(); ++a) {
    if (sizes[a].pixels() > sizes[largest].pixels()) largest = a;
  }
  return largest;
}

std::vector<PixelPlace> grid_places(std::size_t array, const ImageSize& size, int step) {
  std::vector<PixelPlace> places;
  for (int line = 0; line < size.lines; line += step) {
    for (int sample = 0; sample < size.samples; sample += step) {
      places.push_back({static_cast<int>(array), sample, line});
    }
  }
  return places;
}

ArrayImage blank_image(const sensor::DetectorArray& array, const ImageSize& size, int step) {
  ArrayImage image;
  image.name = array.name;
  image.samples = (size.samples + step - 1) / step;
  image.lines = (size.lines + step - 1) / step;
  for (const sensor::Band& band : array.bands) {
    BandImage plane;
    plane.name = band.name;
    plane.centre_um = spectral::centre(band.response).value;
    plane.fwhm_um = spectral::fwhm(band.response).value;
    plane.radiance.resize(image.pixels());
    plane.standard_error.resize(image.pixels());
    image.bands.push_back(std::move(plane));
  }
  return image;
}

/// Floors of the array's bands, of those that the study has; 0 for others.
std::vector<double> floors_of(const StudyHeader& header, const Reference& reference,
                              std::size_t array, std::size_t bands) {
  std::vector<double> floors(bands, 0.0);
  for (std::size_t b = 0; b < header.bands.size(); ++b) {
    if (header.bands[b].array_number == array) {
      floors[header.bands[b].band_number] = reference.floor[b];
    }
  }
  return floors;
}

/// Median over pixels of the error, rms over bands, relative to radiance or floor.
double median_error(const ArrayImage& image, const ArrayImage* truth,
                    const std::vector<double>& floors) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    double squares = 0.0;
    for (std::size_t b = 0; b < image.bands.size(); ++b) {
      const double radiance = (truth != nullptr ? *truth : image).bands[b].radiance[i];
      const double off = truth != nullptr ? image.bands[b].radiance[i] - radiance
                                          : double{image.bands[b].standard_error[i]};
      const double relative = off / std::max({radiance, floors[b], 1e-30});
      squares += relative * relative;
    }
    const double error = std::sqrt(squares / static_cast<double>(image.bands.size()));
    if (std::isfinite(error)) errors.push_back(error);
  }
  if (errors.empty()) return std::nan("");
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

/// The stretch of one picture, for all of them.
class Stretch {
 public:
  explicit Stretch(const ArrayImage& best) : choice_{choose_bands(best, {})} {
    if (choice_.look == Look::temperature) {
      range_ = temperature_range(best, temperatures_of(best.bands[choice_.bands[0]]));
    } else {
      curve_ = fit_tone_curve(best, choice_);
    }
  }
  [[nodiscard]] PngImage paint(const ArrayImage& image) const {
    PngImage png{image.samples, image.lines, 3, 8, {}, {}};
    if (choice_.look == Look::temperature) {
      append(png, temperature_map(temperatures_of(image.bands[choice_.bands[0]]), range_).pixels);
      return png;
    }
    append(png, tone_map(image, choice_, curve_).pixels);
    return png;
  }

 private:
  static void append(PngImage& png, const std::vector<Rgb>& pixels) {
    for (const Rgb& pixel : pixels) png.values.insert(png.values.end(), pixel.begin(), pixel.end());
  }
  BandChoice choice_;
  TemperatureRange range_;
  ToneCurve curve_;
};

std::string encoded(const PngImage& png, const std::filesystem::path& folder) {
  const auto file = folder / ".study-picture.png";
  write_png(file, png);
  std::ifstream stream{file, std::ios::binary};
  const std::vector<char> bytes{std::istreambuf_iterator<char>{stream}, {}};
  stream.close();
  std::filesystem::remove(file);
  std::vector<unsigned char> plain(bytes.begin(), bytes.end());
  return base64(plain);
}

}  // namespace

std::string base64(std::span<const unsigned char> bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned value = 0;
    for (std::size_t k = 0; k < 3; ++k) value = value << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? digits[value >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

void make_pictures(StudyWorld& world, const StudyResult& result, const StudyTime& time,
                   double until_s, const std::filesystem::path& folder, StudyJournal& journal) {
  const StudyHeader header = journal.record().header;
  const auto sizes = world.image_sizes();
  const std::size_t number = largest_array(sizes);
  const ImageSize size = sizes[number];
  const PicturePlan plan = plan_pictures(result, header, size, until_s - time());
  if (!plan.affordable) return;
  const sensor::DetectorArray& array = world.camera().arrays[number];
  const auto places = grid_places(number, size, plan.step);
  std::vector<Shot> shots;
  for (const PictureShot& shot : plan.shots) {
    const double start_s = time();
    const ProbeResult found = world.probe(
        shot.settings,
        {shot.replicates, shot.samples, mix(header.seed ^ picture_stream, shots.size()), 0},
        places);
    Shot taken{blank_image(array, size, plan.step), {}, time() - start_s};
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
      for (std::size_t b = 0; b < taken.image.bands.size(); ++b) {
        const Estimate& estimate = found.pixels[i].bands[b];
        taken.image.bands[b].radiance[i] = static_cast<float>(estimate.mean);
        taken.image.bands[b].standard_error[i] = static_cast<float>(estimate.standard_error);
      }
    }
    shots.push_back(std::move(taken));
  }
  const ArrayImage& best = shots.back().image;
  const Stretch stretch{best};
  const auto floors = floors_of(header, result.reference, number, best.bands.size());
  const double all = static_cast<double>(size.pixels()) / static_cast<double>(places.size());
  journal.set_array_shown(array.name);
  for (std::size_t s = 0; s < shots.size(); ++s) {
    const PictureShot& shot = plan.shots[s];
    const ArrayImage& image = shots[s].image;
    const bool last = s + 1 == shots.size();
    const double error = median_error(image, last ? nullptr : &best, floors);
    journal.add_picture({shot.label, readable(shot.settings), image.samples, image.lines, plan.step,
                         shot.paths(), std::isfinite(error) ? error : 0.0, shots[s].wall_s,
                         all * shots[s].wall_s, encoded(stretch.paint(image), folder)},
                        time());
  }
}

}  // namespace nadir::sim
