#include "sim/run/tile_bytes.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace nadir::sim {
namespace {

// Numbers are stored as they lie in memory.
static_assert(std::endian::native == std::endian::little);

// A plane of the truth that the tables do not name would be lost.
static_assert(sizeof(TruthImage) ==
              (truth_planes.size() + place_planes.size() + 5) * sizeof(std::vector<float>));

struct NotATile : std::runtime_error {
  NotATile() : std::runtime_error{"not a tile"} {}
};

/// Both archives take the same calls, so that what is written is what is read.
class TileWriter {
 public:
  template <class Number>
  void number(const Number& value) {
    static_assert(std::is_arithmetic_v<Number>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void count(std::size_t value) { number(static_cast<std::uint64_t>(value)); }
  void text(const std::string& value) {
    count(value.size());
    bytes_ += value;
  }
  /// All first bytes of the numbers, then all second ones, ...: exponents beside exponents deflate
  /// to half, numbers as they are by a tenth.
  template <class Number>
  void plane(const std::vector<Number>& values) {
    count(values.size());
    const auto* source = reinterpret_cast<const char*>(values.data());
    bytes_.resize(bytes_.size() + values.size() * sizeof(Number));
    char* target = bytes_.data() + bytes_.size() - values.size() * sizeof(Number);
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
      for (std::size_t i = 0; i < values.size(); ++i) *target++ = source[i * sizeof(Number) + byte];
    }
  }
  template <class Item, class Each>
  void list(const std::vector<Item>& items, const Each& each) {
    count(items.size());
    for (const Item& item : items) each(item);
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class TileReader {
 public:
  explicit TileReader(std::string_view bytes) : rest_{bytes} {}

  template <class Number>
  void number(Number& value) {
    static_assert(std::is_arithmetic_v<Number>);
    std::memcpy(&value, next(sizeof value).data(), sizeof value);
  }
  void text(std::string& value) { value = next(count(1)); }
  template <class Number>
  void plane(std::vector<Number>& values) {
    values.resize(count(sizeof(Number)));
    const std::string_view source = next(values.size() * sizeof(Number));
    auto* target = reinterpret_cast<char*>(values.data());
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        target[i * sizeof(Number) + byte] = source[byte * values.size() + i];
      }
    }
  }
  template <class Item, class Each>
  void list(std::vector<Item>& items, const Each& each) {
    items.resize(count(sizeof(std::uint64_t)));  // the least that an item takes
    for (Item& item : items) each(item);
  }
  void finish() const {
    if (!rest_.empty()) throw NotATile{};
  }

 private:
  std::string_view next(std::size_t length) {
    if (length > rest_.size()) throw NotATile{};
    const std::string_view found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return found;
  }
  /// How many items follow; no more than the bytes that are left can hold.
  std::size_t count(std::size_t bytes_each) {
    std::uint64_t value = 0;
    number(value);
    if (value > rest_.size() / bytes_each) throw NotATile{};
    return static_cast<std::size_t>(value);
  }

  std::string_view rest_;
};

/// Member by member: another one in the struct does not compile before it has been thought of here.
template <class Archive, class Band>
void visit_tile_band(Archive& archive, Band& band) {
  auto& [name, centre_um, fwhm_um, radiance, standard_error, brightness, brightness_error, shares,
         bias, dn, electrons, noise] = band;
  static_cast<void>(dn);  // these three are the detectors'
  static_cast<void>(electrons);
  static_cast<void>(noise);
  archive.text(name);
  archive.number(centre_um);
  archive.number(fwhm_um);
  for (auto* plane : {&radiance, &standard_error, &brightness, &brightness_error, &shares.path,
                      &shares.emission, &bias}) {
    archive.plane(*plane);
  }
}

template <class Archive, class Truth>
void visit_tile_truth(Archive& archive, Truth& truth) {
  archive.plane(truth.material);
  archive.plane(truth.object);
  for (const auto& plane : truth_planes) archive.plane(truth.*plane.values);
  for (const auto& plane : place_planes) archive.plane(truth.*plane.values);
  archive.list(truth.fractions, [&](auto& fraction) { archive.plane(fraction); });
}

template <class Archive, class Image>
void visit_tile_image(Archive& archive, Image& image) {
  auto& [name, samples, lines, bands, truth, first_line, all_lines, paths, pixel_paths,
         first_sample] = image;
  archive.text(name);
  for (auto* value : {&samples, &lines, &first_line, &all_lines, &first_sample}) {
    archive.number(*value);
  }
  archive.number(paths);
  archive.plane(pixel_paths);
  archive.list(bands, [&](auto& band) { visit_tile_band(archive, band); });
  visit_tile_truth(archive, truth);
}

template <class Archive, class Record>
void visit_tile(Archive& archive, Record& record) {
  auto& [round, array, first_sample, first_line, samples, lines] = record.key;
  archive.number(round);
  archive.number(array);
  for (auto* value : {&first_sample, &first_line, &samples, &lines}) archive.number(*value);
  visit_tile_image(archive, record.pixels);
}

// Counters are nothing but numbers of 64 bits, so that a new one is stored without a line here.
constexpr std::size_t tile_counter_count = sizeof(radiometry::Counters) / sizeof(std::uint64_t);
static_assert(std::is_trivially_copyable_v<radiometry::Counters>);
using TileCounters = std::array<std::uint64_t, tile_counter_count>;

const std::vector<std::string>& names_numbered(const NameLists& lists, std::uint32_t number) {
  static const std::vector<std::string> none;
  if (number == 0) return none;
  const auto found = lists.find(number);
  if (found == lists.end()) throw NotATile{};
  return found->second;
}

}  // namespace

std::string to_bytes(const TileRecord& record, const TileNames& names) {
  TileWriter archive;
  visit_tile(archive, record);
  archive.number(names.materials);
  archive.number(names.objects);
  archive.count(tile_counter_count);
  for (const std::uint64_t value : std::bit_cast<TileCounters>(record.counters)) {
    archive.number(value);
  }
  return archive.take();
}

std::optional<TileRecord> tile_from_bytes(std::string_view bytes, const NameLists& lists) try {
  TileReader archive{bytes};
  TileRecord record;
  visit_tile(archive, record);
  TileNames names;
  archive.number(names.materials);
  archive.number(names.objects);
  std::uint64_t counted = 0;
  archive.number(counted);
  if (counted != tile_counter_count) return std::nullopt;
  TileCounters counters{};
  for (std::uint64_t& value : counters) archive.number(value);
  archive.finish();
  record.counters = std::bit_cast<radiometry::Counters>(counters);
  record.pixels.truth.material_names = names_numbered(lists, names.materials);
  record.pixels.truth.object_names = names_numbered(lists, names.objects);
  return record;
} catch (const NotATile&) {
  return std::nullopt;
}

std::string to_bytes(const std::vector<std::string>& names) {
  TileWriter archive;
  archive.list(names, [&](const std::string& name) { archive.text(name); });
  return archive.take();
}

std::optional<std::vector<std::string>> names_from_bytes(std::string_view bytes) try {
  TileReader archive{bytes};
  std::vector<std::string> names;
  archive.list(names, [&](std::string& name) { archive.text(name); });
  archive.finish();
  return names;
} catch (const NotATile&) {
  return std::nullopt;
}

}  // namespace nadir::sim
