#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "radiometry/lamps/light_tree.hpp"

// Part of LightTree; not for others.

namespace nadir::radiometry {

/// Builds the hierarchy from the top: a set of lamps is halved, and its halves again, until there
/// are eight sets; each that holds more than one lamp becomes a node of its own.
class LightTreeBuilder {
 public:
  explicit LightTreeBuilder(const std::vector<LightTreeItem>& items);
  [[nodiscard]] LightTree build();

 private:
  /// Part of `order_`, and what bounds it.
  struct Part {
    std::size_t begin = 0, end = 0;
    LightTreeItem bound;

    [[nodiscard]] std::size_t size() const noexcept { return end - begin; }
  };
  struct Split {
    double cost = 0.0;
    int axis = 0;
    double place = 0.0;  ///< coordinate of box centres that parts them
    bool found = false;
  };

  struct Bins;

  [[nodiscard]] Part part(std::size_t begin, std::size_t end) const;
  [[nodiscard]] Split best_split(const Part& whole) const;
  void try_axis(const Part& whole, int axis, Split& best) const;
  [[nodiscard]] std::vector<Part> halved(const Part& whole);
  [[nodiscard]] std::vector<Part> cut_up(const Part& whole);
  void add_node(const Part& whole, LightTree::Link parent);
  void fill(LightTree::Node& node, std::size_t slot, const LightTreeItem& bound) const;

  std::vector<LightTreeItem> items_;
  std::vector<std::uint32_t> order_;
  double heaviest_ = 0.0;
  LightTree tree_;
};

}  // namespace nadir::radiometry
