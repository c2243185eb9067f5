#include "materials/library.hpp"

#include <utility>

#include "core/error.hpp"

namespace nadir::materials {

// Libraries hold tens to hundreds of materials and are searched while a scenario is read: a linear
// search keeps the order without a second container.
const Material* MaterialLibrary::find(const std::string& name) const noexcept {
  for (const Material& material : materials_) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

std::size_t MaterialLibrary::add(Material material) {
  if (material.name.empty()) throw InputError{"a material has no name"};
  if (find(material.name) != nullptr) {
    throw InputError{"material \"" + material.name + "\" is defined twice"};
  }
  materials_.push_back(std::move(material));
  return materials_.size() - 1;
}

std::size_t MaterialLibrary::index_of(const std::string& name) const {
  const Material* material = find(name);
  if (material == nullptr) {
    const std::string near = nearest(name);
    throw InputError{InputIssue{{},
                                "there is no material \"" + name + "\"",
                                near.empty() ? "" : "did you mean \"" + near + "\"?",
                                {}}};
  }
  return static_cast<std::size_t>(material - materials_.data());
}

const Material& MaterialLibrary::at(const std::string& name) const {
  return materials_[index_of(name)];
}

std::vector<std::string> MaterialLibrary::names() const {
  std::vector<std::string> all;
  for (const Material& material : materials_) all.push_back(material.name);
  return all;
}

std::string MaterialLibrary::nearest(const std::string& name) const {
  return nearest_name(name, names());
}

}  // namespace nadir::materials
