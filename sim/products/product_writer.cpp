#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "sim/products/array_stream.hpp"
#include "sim/products/geo_products.hpp"
#include "sim/products/write_products.hpp"

namespace nadir::sim {
namespace {

void tell_of_invalid_pixels(const ArraySummary& array, Diagnostics& diagnostics) {
  const auto invalid =
      std::count_if(array.bands.begin(), array.bands.end(),
                    [](const BandSummary& band) { return band.invalid_pixels > 0; });
  if (invalid == 0) return;
  diagnostics.warn(
      fmt::format("array {}: {} of {} bands hold pixels whose radiance is no finite number",
                  array.name, invalid, array.bands.size()));
}

void append_files(std::vector<ProductFile>& files, const std::vector<ProductFile>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

}  // namespace

struct ProductWriter::State {
  ProductContext context;
  std::filesystem::path output_dir;
  std::set<std::string> names;  // of files, by array
  std::unique_ptr<ArrayStream> open;
  std::vector<ArrayStream::Finished> arrays;

  void begin(const ArrayImage& first);
  void close();
  [[nodiscard]] bool shown_as_wanted() const {
    return std::any_of(arrays.begin(), arrays.end(),
                       [](const auto& array) { return array.shown_as_wanted; });
  }
};

void ProductWriter::State::begin(const ArrayImage& first) {
  check_first_strip(first);
  const std::string name = product_file_name(first.name);
  if (names.contains(name)) {
    throw std::invalid_argument("two arrays would write the files of " + name);
  }
  open = std::make_unique<ArrayStream>(first, context, output_dir, arrays.size());
  names.insert(name);
}

void ProductWriter::State::close() {
  arrays.push_back(open->finish());
  open.reset();
  if (context.diagnostics != nullptr) {
    tell_of_invalid_pixels(arrays.back().summary, *context.diagnostics);
  }
}

ProductWriter::ProductWriter(ProductContext context, std::filesystem::path output_dir)
    : state_{new State{std::move(context), std::move(output_dir), {}, {}, {}}} {
  std::filesystem::create_directories(state_->output_dir);
}

ProductWriter::~ProductWriter() = default;

void ProductWriter::take(const ArrayImage& strip) {
  State& s = *state_;
  if (!s.open) s.begin(strip);
  s.open->take(strip);
  if (s.open->is_complete()) s.close();
}

ProductWriter::Written ProductWriter::finish() {
  State& s = *state_;
  if (s.open) s.open->check_complete();
  Written written;
  for (ArrayStream::Finished& array : s.arrays) {
    append_files(written.files, array.files);
    if (wants_geo_products(s.context)) {
      append_files(written.files,
                   write_geo_products(s.context, array.task.number, array.task.stem, array.files));
    }
    for (const ProductFile& file : array.temporary) std::filesystem::remove(file.path);
    written.summaries.push_back(std::move(array.summary));
  }
  // With several arrays it is enough that one has the bands: the others show their own.
  if (!s.arrays.empty() && !s.shown_as_wanted() && s.context.diagnostics != nullptr) {
    s.context.diagnostics->warn(
        "no array has the bands wanted for the quick look; each shows bands of its own");
  }
  s.arrays.clear();
  return written;
}

}  // namespace nadir::sim
