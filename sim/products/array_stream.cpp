#include "sim/products/array_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/products/quick_look.hpp"

namespace nadir::sim {
namespace {

std::vector<std::string> names_of_bands(const ArrayImage& image) {
  std::vector<std::string> names;
  for (const BandImage& band : image.bands) names.push_back(band.name);
  return names;
}

/// The number from which on a detector's pixel counts as saturated: the converter's greatest, or
/// that of a full well, if it is less, without three standard deviations of what noise a full well
/// still has.
std::uint16_t saturated_from(const sensor::Detector& detector) {
  const sensor::Digitiser& digitiser = detector.digitiser;
  const double top = static_cast<double>((1U << static_cast<unsigned>(digitiser.bits)) - 1U);
  const auto* photons = std::get_if<sensor::PhotonDetector>(&detector.element);
  if (photons == nullptr) return static_cast<std::uint16_t>(top);
  const double black = digitiser.black_level_dn;
  const double dn_per_e = digitiser.gain_dn_e.value_or((top - black) / photons->full_well_e);
  const double noise_e = std::hypot(std::hypot(photons->read_noise_e, photons->line_noise_e),
                                    photons->flicker_noise_e, photons->dsnu_e);
  const double full = black + dn_per_e * (photons->full_well_e - 3.0 * noise_e);
  return static_cast<std::uint16_t>(std::clamp(std::floor(full), 1.0, top));
}

/// The same for the bands of an array; nothing where the camera is not known.
std::vector<std::optional<std::uint16_t>> top_numbers(const ArrayTask& task, std::size_t bands) {
  std::vector<std::optional<std::uint16_t>> tops(bands);
  if (task.array == nullptr) return tops;
  const auto& electronics = task.context->geometry->camera->electronics;
  if (task.number >= electronics.size()) return tops;
  const auto& own = electronics[task.number];
  for (std::size_t b = 0; b < std::min(bands, own.size()); ++b) {
    if (own[b].detector) tops[b] = saturated_from(*own[b].detector);
  }
  return tops;
}

}  // namespace

ArrayStream::ArrayStream(const ArrayImage& first, const ProductContext& context,
                         const std::filesystem::path& output_dir, std::size_t arrival)
    : context_{&context},
      task_{array_task(context, output_dir, first.name, arrival)},
      name_{first.name},
      samples_{first.samples},
      lines_{first.image_lines()},
      bands_{names_of_bands(first)},
      planes_{check_planes(first, context.wanted.truth)},
      summary_{first, top_numbers(task_, first.bands.size())} {
  const ProductsInput& wanted = context.wanted;
  if (wanted.quick_look) preview_.emplace(first, wanted.quick_look_bands);
  if (wanted.envi || wants_geo_products(context)) envi_.emplace(first, task_);
  if (wanted.exr) exr_.emplace(first, task_);
}

void ArrayStream::check_next(const ArrayImage& strip) const {
  const auto fail = [this](const std::string& what) {
    throw std::invalid_argument("array " + name_ + ": " + what);
  };
  if (strip.name != name_) {
    fail(fmt::format("lines of {} come after line {} of {}", strip.name, next_line_, lines_));
  }
  if (strip.first_line != next_line_) {
    fail(fmt::format("a strip begins with line {}, expected {}", strip.first_line, next_line_));
  }
  if (strip.samples != samples_ || (next_line_ > 0 && strip.all_lines != lines_)) {
    fail("its strips are not of one image");
  }
  if (strip.lines > lines_ - next_line_) {
    fail(fmt::format("{} lines come after line {} of {}", strip.lines, next_line_, lines_));
  }
  if (names_of_bands(strip) != bands_ ||
      check_planes(strip, context_->wanted.truth).filled != planes_.filled) {
    fail("its strips have not the same planes");
  }
}

void ArrayStream::take(const ArrayImage& strip) {
  check_next(strip);
  summary_.take(strip);
  if (preview_) preview_->take(strip);
  if (envi_) envi_->take(strip);
  if (exr_) exr_->take(strip);
  next_line_ += strip.lines;
}

void ArrayStream::check_complete() const {
  if (is_complete()) return;
  throw std::invalid_argument(
      fmt::format("array {} ends after line {} of {}", name_, next_line_, lines_));
}

void ArrayStream::write_quick_look(Finished& finished) {
  const ProductContext& context = *context_;
  const std::string& title = context.title.empty() ? context.scenario_name : context.title;
  const QuickLook look = quick_look(*preview_, {title, context.time_utc, "nadir " + context.version,
                                                context.wanted.quick_look_bands});
  const auto file = with_ending(task_.stem, ".png");
  write_png(file, look.picture);
  finished.files.push_back({"quick look", name_, file, std::filesystem::file_size(file)});
  finished.shown_as_wanted = look.bands_as_wanted;
}

ArrayStream::Finished ArrayStream::finish() {
  check_complete();
  Finished finished;
  finished.task = task_;
  if (envi_) envi_->finish(context_->wanted.envi ? finished.files : finished.temporary);
  if (exr_) exr_->finish(finished.files);
  finished.summary = summary_.finish();  // gives back its memory before the picture takes more
  envi_.reset();
  exr_.reset();
  if (preview_) write_quick_look(finished);
  preview_.reset();
  return finished;
}

}  // namespace nadir::sim
