#include "thermal/solve/cell_store.hpp"

namespace nadir::thermal {

CellStore::~CellStore() {
  words_.for_each([](std::uint64_t, std::uint64_t word) {
    if ((word & cut_flag) != 0) delete &cut_facet(word);
  });
}

std::optional<CellGrid> CellStore::grid(std::uint64_t facet) const noexcept {
  const std::uint64_t word = words_.read(facet);
  if ((word & cut_flag) != 0) return cut_facet(word).grid;
  return std::nullopt;
}

bool CellStore::has(const CellOfFacet& cell) const noexcept {
  const std::uint64_t word = words_.read(cell.facet);
  if ((word & cut_flag) == 0) return of_side(word, cell.back).has_value();
  return of_side(cut_facet(word).words.read(cell.cell), cell.back).has_value();
}

std::atomic<std::uint64_t>& CellStore::word_of(const CellOfFacet& cell) {
  std::atomic<std::uint64_t>& word = words_.at(cell.facet);
  if (cell.grid.cells() == 1) return word;
  std::uint64_t known = word.load(std::memory_order_acquire);
  if (known == 0) {
    std::unique_ptr<CutFacet> fresh{new CutFacet{cell.grid, PagedWords{cell.grid.cells()}}};
    const std::uint64_t address = std::bit_cast<std::uint64_t>(fresh.get()) | cut_flag;
    if (word.compare_exchange_strong(known, address, std::memory_order_acq_rel)) {
      known = address;
      static_cast<void>(fresh.release());  // the destructor finds it by its word
    }
  }
  return cut_facet(known).words.at(cell.cell);
}

bool CellStore::store(const CellOfFacet& cell, float kelvin) {
  // Without a sign, whatever it is: a NaN with one would be taken for an address.
  const std::uint64_t bits = std::bit_cast<std::uint32_t>(kelvin) & 0x7FFFFFFFU;
  const int shift = cell.back ? 32 : 0;
  const std::uint64_t before = word_of(cell).fetch_or(bits << shift, std::memory_order_acq_rel);
  return ((before >> shift) & 0xFFFFFFFFU) == 0;
}

}  // namespace nadir::thermal
