#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "materials/material.hpp"

namespace nadir::materials {

/// The materials of a run, in the order in which they were added. No two share a name.
class MaterialLibrary {
 public:
  /// @return the material's index
  /// @throws InputError for an empty name, or one that is there already
  std::size_t add(Material material);

  /// The material of that name, or null. Valid until the next `add`.
  [[nodiscard]] const Material* find(const std::string& name) const noexcept;
  /// @throws InputError with the nearest name as the hint
  [[nodiscard]] const Material& at(const std::string& name) const;
  /// @throws InputError with the nearest name as the hint
  [[nodiscard]] std::size_t index_of(const std::string& name) const;

  [[nodiscard]] const Material& operator[](std::size_t index) const { return materials_[index]; }
  [[nodiscard]] std::size_t size() const noexcept { return materials_.size(); }
  [[nodiscard]] bool empty() const noexcept { return materials_.empty(); }
  [[nodiscard]] auto begin() const noexcept { return materials_.begin(); }
  [[nodiscard]] auto end() const noexcept { return materials_.end(); }

  [[nodiscard]] std::vector<std::string> names() const;
  /// The name that the user may have meant, or empty.
  [[nodiscard]] std::string nearest(const std::string& name) const;

 private:
  std::vector<Material> materials_;
};

}  // namespace nadir::materials
