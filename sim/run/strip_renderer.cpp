#include "sim/run/strip_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "sim/run/merge_images.hpp"
#include "sim/run/pixel_needs.hpp"

namespace nadir::sim {
namespace {

/// Tiles in an order that is drawn once for all: where time runs out, what was not reached lies
/// scattered.
std::vector<Tile> shuffled(std::vector<Tile> tiles) {
  for (std::size_t i = tiles.size(); i > 1; --i) {
    std::swap(tiles[i - 1], tiles[mix(0x7469'6C65ULL, i) % i]);
  }
  return tiles;
}

/// Small enough to keep all processors busy to the end, large enough that a tile outweighs its
/// solvers' construction: 16 pixels, fewer in small images, where each pixel may get many paths.
int edge_of_tiles(const sensor::DetectorArray& array) {
  constexpr double enough_tiles = 128.0;
  const double pixels = static_cast<double>(array.samples) * array.lines;
  int edge = tile_edge;
  while (edge > 2 && pixels / (edge * edge) < enough_tiles) edge /= 2;
  return edge;
}

/// So many samples a replicate that a further round has as many as the former ones had on average.
int samples_again(const ArrayImage& known, std::size_t pixel, std::uint32_t round, int replicates) {
  const auto all = round * static_cast<unsigned>(replicates);
  return static_cast<int>(std::max(1U, known.paths_of(pixel) / all));
}

/// Samples the pixels of a tile to their goal, in which they learn from each other.
///
/// A pixel that met nothing rare has no way to know of it: where one path in 2000 finds a furnace,
/// 64 paths see none in 97 pixels of 100, which end with small errors that are wrong. Others of the
/// tile saw it. Therefore all pixels are looked at with equally many paths, after which the mean of
/// what they seem to need is unbiased, however unevenly it was found; no pixel gets fewer paths
/// than that, nor is its error stated smaller than that of a pixel with this need. It costs at most
/// as much again as the pixels' own needs.
class TileToGoal {
 public:
  TileToGoal(PixelRenderer& pixels, const ArrayJob& job, const SamplingGoal& goal, ArrayImage& tile)
      : pixels_{&pixels}, job_{&job}, goal_{&goal}, goals_{&goal.bands[job.number]}, tile_{&tile} {}

  void sample() {
    const double least = look();
    for (std::size_t i = 0; i < tile_->pixels(); ++i) {
      const double paths = tile_->pixel_paths[i];
      // The planes' floats round: 1e-6 is no need.
      const bool met = paths_needed(*tile_, i, *goals_) <= paths * (1.0 + 1e-6);
      if (!met || paths < least) render(i, {.least_paths = least});
      state_need(*tile_, i, *goals_, {least, job_->plan.quadratures});
    }
  }

 private:
  /// Looks with more and more paths until the mean need is not far beyond them: far beyond, it is
  /// that of a few pixels with large needs, each cut off at the most that it would be given.
  double look() const {
    constexpr double far_beyond = 8.0, share_of_need = 0.25;
    double samples = first_look(*goal_, tile_->pixels());
    for (;;) {
      for (std::size_t i = 0; i < tile_->pixels(); ++i) {
        render(i, {.least_paths = samples * goal_->replicates,
                   .most_samples = static_cast<int>(samples)});
      }
      const double most = static_cast<double>(goal_->most_samples) * goal_->replicates;
      const double need = mean_need(*tile_, *goals_, most) / goal_->replicates;
      if (!(need > far_beyond * samples)) return need * goal_->replicates;
      samples = std::floor(share_of_need * need);
    }
  }
  void render(std::size_t pixel, const PixelOrder& order) const {
    const auto width = static_cast<std::size_t>(tile_->samples);
    pixels_->render(tile_->first_sample + static_cast<int>(pixel % width),
                    tile_->first_line + static_cast<int>(pixel / width), *tile_, order);
  }

  PixelRenderer* pixels_;
  const ArrayJob* job_;
  const SamplingGoal* goal_;
  const std::vector<BandGoal>* goals_;
  ArrayImage* tile_;
};

}  // namespace

int first_look(const SamplingGoal& goal, std::size_t pixels) {
  // Small tiles make up for it: of what one path in 250 finds, some is seen.
  constexpr double least_paths_of_tile = 1024.0;
  const double each = least_paths_of_tile / (static_cast<double>(pixels) * goal.replicates);
  const int samples = std::max(static_cast<int>(std::ceil(each)), goal.first_samples);
  return std::min(samples, std::max(1, goal.most_samples));
}

std::uint64_t paths_in(const ArrayImage& image) {
  std::uint64_t paths = 0;
  for (std::size_t i = 0; i < image.pixels(); ++i) paths += image.paths_of(i);
  return paths;
}

std::vector<Tile> tiles_of(const sensor::DetectorArray& array, const Strip& strip) {
  auto tiles = cut_into_tiles(0, array.samples, strip.lines, edge_of_tiles(array));
  for (Tile& tile : tiles) tile.first_line += strip.first_line;
  return tiles;
}

StripRenderer::StripRenderer(const ArrayJob& job, const Strip& strip, const RenderOptions& options,
                             RenderProgress& progress)
    : job_{&job}, strip_{strip}, options_{&options}, progress_{&progress} {
  tiles_ = tiles_of(*job.array, strip);
  if (options.time != nullptr) tiles_ = shuffled(std::move(tiles_));
}

std::size_t StripRenderer::pixels() const {
  return static_cast<std::size_t>(job_->array->samples) * static_cast<std::size_t>(strip_.lines);
}

void StripRenderer::count(const radiometry::Counters& counters) {
  const std::scoped_lock lock{progress_->mutex};
  progress_->counters += counters;
  ++progress_->done;
  if (options_->progress && options_->time == nullptr) {
    options_->progress(progress_->done, progress_->all);
  }
}

std::size_t StripRenderer::pixel_of(int sample, int line) const {
  return static_cast<std::size_t>(line - strip_.first_line) *
             static_cast<std::size_t>(job_->array->samples) +
         static_cast<std::size_t>(sample);
}

ArrayImage StripRenderer::compute(const TileKey& key, const RoundOrder& order,
                                  radiometry::Counters& counters) const {
  const bool first = order.known == nullptr;
  ArrayImage image = blank_image(*job_, {key.first_sample, key.first_line, key.samples, key.lines},
                                 *options_, first);
  PixelRenderer pixels{
      *job_, *options_, {round_key(options_->seed, job_->number, order.round), first}};
  if (options_->goal != nullptr && order.samples.empty()) {
    TileToGoal{pixels, *job_, *options_->goal, image}.sample();
  } else {
    render_as_ordered(pixels, order, image);
  }
  counters = pixels.counters();
  return image;
}

void StripRenderer::render_as_ordered(PixelRenderer& pixels, const RoundOrder& order,
                                      ArrayImage& image) const {
  for (int line = image.first_line; line < image.first_line + image.lines; ++line) {
    for (int sample = image.first_sample; sample < image.first_sample + image.samples; ++sample) {
      PixelOrder wanted;
      if (!order.samples.empty()) {
        wanted.samples = order.samples[static_cast<std::size_t>(line - strip_.first_line) *
                                           static_cast<std::size_t>(job_->array->samples) +
                                       static_cast<std::size_t>(sample)];
      }
      pixels.render(sample, line, image, wanted);
    }
  }
}

ArrayImage StripRenderer::tile(const Tile& tile, const RoundOrder& order) {
  const TileKey key{order.round,       static_cast<std::uint32_t>(job_->number),
                    tile.first_sample, tile.first_line,
                    tile.samples,      tile.lines};
  TileStore* const store = options_->store;
  if (store != nullptr) {
    if (auto kept = store->find(key)) {
      count(kept->counters);
      return std::move(kept->pixels);
    }
  }
  TileRecord record{key, {}, {}};
  if (!order.only_kept && !(order.give_up && order.give_up())) {
    record.pixels = compute(key, order, record.counters);
    computed_paths_ += paths_in(record.pixels);
    if (store != nullptr) store->keep(record);
  }
  count(record.counters);
  return std::move(record.pixels);
}

ArrayImage StripRenderer::render_round(const RoundOrder& order) {
  ArrayImage image = blank_image(*job_, {0, strip_.first_line, job_->array->samples, strip_.lines},
                                 *options_, order.known == nullptr);
  const bool with_blanks = order.only_kept || order.give_up;
  if (with_blanks && image.pixel_paths.empty()) image.pixel_paths.resize(image.pixels());
  for_each_tile(tiles_, options_->threads, [&](const Tile& part) {
    const ArrayImage done = tile(part, order);
    if (!done.bands.empty()) paste(image, done);  // tiles do not overlap
  });
  return image;
}

ArrayImage StripRenderer::render() {
  ArrayImage image = render_round({});
  for (std::uint32_t round = 1; round < options_->rounds.end; ++round) {
    RoundOrder order{round, &image, {}, round < options_->rounds.kept, {}};
    if (options_->goal != nullptr) {
      for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
        order.samples.push_back(samples_again(image, pixel, round, options_->goal->replicates));
      }
    }
    const ArrayImage more = render_round(order);
    merge(image, more, job_->plan.quadratures);
  }
  state_bias(image, job_->number, *options_);
  return image;
}

void state_bias(ArrayImage& image, std::size_t array, const RenderOptions& options) {
  if (options.bias == nullptr || options.goal == nullptr) return;
  for (std::size_t b = 0; b < image.bands.size(); ++b) {
    BandImage& band = image.bands[b];
    const double relative = (*options.bias)[array][b];
    const double floor = options.goal->bands[array][b].floor_radiance;
    band.bias.resize(band.radiance.size());
    for (std::size_t i = 0; i < band.bias.size(); ++i) {
      const double level = std::max(static_cast<double>(band.radiance[i]), floor);
      band.bias[i] = static_cast<float>(relative * level);
    }
  }
}

}  // namespace nadir::sim
