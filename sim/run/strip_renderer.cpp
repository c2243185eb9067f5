#include "sim/run/strip_renderer.hpp"

#include <algorithm>
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

/// So many samples a replicate that a further round has as many as the former ones had on average.
int samples_again(const ArrayImage& known, std::size_t pixel, std::uint32_t round, int replicates) {
  const auto all = round * static_cast<unsigned>(replicates);
  return static_cast<int>(std::max(1U, known.paths_of(pixel) / all));
}

/// What pixels of a tile say about each other.
///
/// A pixel that met nothing rare has no way to know of it: where one path in 200 finds a furnace,
/// 64 paths see none in 7 pixels of 10, which end with small errors that are wrong. Others of the
/// tile saw it. Therefore no pixel gets fewer paths than the tile's pixels need on average, and its
/// error is stated no smaller than that of a pixel with this need. The mean of all needs is at most
/// added to every one of them, so that this costs no more than the pixels' own needs do.
void agree_with_neighbours(PixelRenderer& pixels, const std::vector<BandGoal>& goals,
                           ArrayImage& tile) {
  constexpr int most_passes = 3;  // what is sampled again may have seen more
  double least = 0.0;
  for (int pass = 0; pass < most_passes; ++pass) {
    least = std::max(least, mean_need(tile, goals));
    bool again = false;
    for (std::size_t pixel = 0; pixel < tile.pixels(); ++pixel) {
      if (tile.pixel_paths[pixel] >= least) continue;
      const auto width = static_cast<std::size_t>(tile.samples);
      pixels.render(tile.first_sample + static_cast<int>(pixel % width),
                    tile.first_line + static_cast<int>(pixel / width), tile, {{}, least});
      again = true;
    }
    if (!again) break;
  }
  for (std::size_t pixel = 0; pixel < tile.pixels(); ++pixel) {
    state_need(tile, pixel, goals, least);
  }
}

}  // namespace

std::uint64_t paths_in(const ArrayImage& image) {
  std::uint64_t paths = 0;
  for (std::size_t i = 0; i < image.pixels(); ++i) paths += image.paths_of(i);
  return paths;
}

StripRenderer::StripRenderer(const ArrayJob& job, const Strip& strip, const RenderOptions& options,
                             RenderProgress& progress)
    : job_{&job}, strip_{strip}, options_{&options}, progress_{&progress} {
  tiles_ = cut_into_tiles(static_cast<int>(job.number), job.array->samples, strip.lines, tile_edge);
  for (Tile& tile : tiles_) tile.first_line += strip.first_line;
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

ArrayImage StripRenderer::compute(const TileKey& key, const RoundOrder& order,
                                  radiometry::Counters& counters) const {
  const bool first = order.known == nullptr;
  ArrayImage image = blank_image(*job_, {key.first_sample, key.first_line, key.samples, key.lines},
                                 *options_, first);
  PixelRenderer pixels{
      *job_, *options_, {round_key(options_->seed, job_->number, order.round), first}};
  for (int line = key.first_line; line < key.first_line + key.lines; ++line) {
    for (int sample = key.first_sample; sample < key.first_sample + key.samples; ++sample) {
      PixelOrder wanted;
      if (!order.samples.empty()) {
        wanted.samples = order.samples[static_cast<std::size_t>(line - strip_.first_line) *
                                           static_cast<std::size_t>(job_->array->samples) +
                                       static_cast<std::size_t>(sample)];
      }
      pixels.render(sample, line, image, wanted);
    }
  }
  if (options_->goal != nullptr && order.samples.empty()) {
    agree_with_neighbours(pixels, options_->goal->bands[job_->number], image);
  }
  counters = pixels.counters();
  return image;
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
