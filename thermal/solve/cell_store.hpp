#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "thermal/exposure/surface_cell.hpp"

// Private to this folder.

namespace nadir::thermal {

/// Numbers by index, of which few are ever needed: pages come into being when one of theirs is
/// first written. Any thread may read and write at any time; what is written stands for ever.
class PagedWords {
 public:
  explicit PagedWords(std::uint64_t size)
      : size_{size}, pages_((size + page_size - 1) / page_size) {}  // all null
  ~PagedWords() {
    for (auto& page : pages_) delete[] page.load(std::memory_order_relaxed);
  }
  PagedWords(const PagedWords&) = delete;
  PagedWords& operator=(const PagedWords&) = delete;

  /// 0 where nothing has been written.
  [[nodiscard]] std::uint64_t read(std::uint64_t index) const noexcept {
    const Word* page = pages_[index / page_size].load(std::memory_order_acquire);
    return page == nullptr ? 0 : page[index % page_size].load(std::memory_order_acquire);
  }
  [[nodiscard]] std::atomic<std::uint64_t>& at(std::uint64_t index) {
    return page_at(index / page_size)[index % page_size];
  }
  /// Calls seen(index, word) for all that have been written.
  template <class Seen>
  void for_each(const Seen& seen) const {
    for (std::uint64_t number = 0; number < pages_.size(); ++number) {
      const Word* words = pages_[number].load(std::memory_order_acquire);
      const std::uint64_t count = words == nullptr ? 0 : length_of(number);
      for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t word = words[i].load(std::memory_order_acquire);
        if (word != 0) seen(number * page_size + i, word);
      }
    }
  }

 private:
  using Word = std::atomic<std::uint64_t>;
  static constexpr std::uint64_t page_size = 4096;

  /// The last page is as short as it may be: facets that are cut have tables of a few words.
  [[nodiscard]] std::uint64_t length_of(std::uint64_t page) const noexcept {
    return std::min(page_size, size_ - page * page_size);
  }
  Word* page_at(std::uint64_t number) {
    std::atomic<Word*>& slot = pages_[number];
    Word* page = slot.load(std::memory_order_acquire);
    if (page != nullptr) return page;
    auto fresh = std::make_unique<Word[]>(length_of(number));
    // Of two threads that bring a page one wins; the other one's is dropped.
    if (slot.compare_exchange_strong(page, fresh.get(), std::memory_order_acq_rel)) {
      return fresh.release();
    }
    return page;
  }

  std::uint64_t size_;
  std::vector<std::atomic<Word*>> pages_;
};

/// Which cell of a facet: its side and its piece.
struct CellOfFacet {
  std::uint64_t facet = 0;
  bool back = false;
  CellGrid grid;
  std::uint32_t cell = 0;
};

/// The temperatures of one material's cells.
///
/// A word for each facet: of a facet that is one cell, two floats, those of its outward and of its
/// other side; of one that is cut, the address of a table like this with a word for each of its
/// cells. Temperatures are positive, so that a float of 0 stands for what is not solved yet, and
/// the sign of the upper float tells an address.
class CellStore {
 public:
  /// @param facets  of the scene
  explicit CellStore(std::uint64_t facets) : words_{facets} {}
  ~CellStore();
  CellStore(const CellStore&) = delete;
  CellStore& operator=(const CellStore&) = delete;

  /// What has been stored for the cell at a hit: some loads, no lock.
  [[nodiscard]] std::optional<float> find(std::uint64_t facet, Vec2 uv, bool back) const noexcept {
    const std::uint64_t word = words_.read(facet);
    if ((word & cut_flag) == 0) return of_side(word, back);
    const CutFacet& cut = cut_facet(word);
    return of_side(cut.words.read(cut.grid.cell_at(uv)), back);
  }
  /// How the facet is cut, if that is known already.
  [[nodiscard]] std::optional<CellGrid> grid(std::uint64_t facet) const noexcept;
  [[nodiscard]] bool has(const CellOfFacet& cell) const noexcept;
  /// Whether the cell had no temperature before. All who store one for it store the same.
  bool store(const CellOfFacet& cell, float kelvin);
  /// Calls seen(CellOfFacet, float) for all cells that have a temperature, by facet, cell and side.
  /// A facet that is one cell comes with a grid that says just that, whatever its shape.
  template <class Seen>
  void for_each(const Seen& seen) const {
    words_.for_each([&](std::uint64_t facet, std::uint64_t word) {
      if ((word & cut_flag) == 0) return both_sides({facet, false, {}, 0}, word, seen);
      const CutFacet& cut = cut_facet(word);
      cut.words.for_each([&](std::uint64_t cell, std::uint64_t sides) {
        both_sides({facet, false, cut.grid, static_cast<std::uint32_t>(cell)}, sides, seen);
      });
    });
  }

 private:
  struct CutFacet {
    CellGrid grid;
    PagedWords words;
  };
  static constexpr std::uint64_t cut_flag = 1ULL << 63;

  static std::optional<float> of_side(std::uint64_t word, bool back) noexcept {
    const auto bits = static_cast<std::uint32_t>(back ? word >> 32 : word);
    if (bits == 0) return std::nullopt;
    return std::bit_cast<float>(bits);
  }
  template <class Seen>
  static void both_sides(CellOfFacet cell, std::uint64_t word, const Seen& seen) {
    for (const bool back : {false, true}) {
      cell.back = back;
      if (const auto kelvin = of_side(word, back)) seen(cell, *kelvin);
    }
  }
  static CutFacet& cut_facet(std::uint64_t word) noexcept {
    return *std::bit_cast<CutFacet*>(word & ~cut_flag);
  }
  std::atomic<std::uint64_t>& word_of(const CellOfFacet& cell);

  PagedWords words_;
};
static_assert(sizeof(void*) == 8, "addresses are kept in words of 64 bits");

}  // namespace nadir::thermal
