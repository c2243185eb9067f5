#include "sim/scenario/build_context.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace nadir::sim {

void BuildContext::warn(std::size_t offset, const std::string& message) const {
  const SourceLocation at = source.locate(offset);
  diagnostics.warn(fmt::format("{}:{}:{}: {}", at.file, at.line, at.column, message));
}

void BuildContext::check_unique(const std::vector<const CheckedElement*>& elements,
                                const std::string& what) const {
  std::map<std::string, int> first_line;
  for (const CheckedElement* element : elements) {
    const auto name = element->find<std::string>("name");
    if (!name) continue;
    const auto [first, is_new] = first_line.emplace(*name, source.locate(element->offset).line);
    if (is_new) continue;
    mistake(element->where("name"),
            fmt::format("{} \"{}\" is there already, in line {}", what, *name, first->second));
  }
}

void MaterialNames::add(const std::string& name, std::size_t offset) { add(name, offset, false); }

void MaterialNames::add_map(const std::string& name, std::size_t offset) {
  add(name, offset, true);
}

void MaterialNames::add(const std::string& name, std::size_t offset, bool is_map) {
  complete_ &= !name.empty();
  index_.emplace(name, static_cast<int>(entries_.size()));
  entries_.push_back({name, offset, false, is_map, is_map ? maps_++ : materials_++});
}

int MaterialNames::resolve(const BuildContext& context, const CheckedElement& element,
                           const std::string& attribute) {
  const Entry* entry = find(context, element, attribute);
  if (entry == nullptr) return 0;
  return entry->is_map ? material_count_ + entry->number : entry->number;
}

std::optional<int> MaterialNames::resolve_material(const BuildContext& context,
                                                   const CheckedElement& element,
                                                   const std::string& attribute) {
  const Entry* entry = find(context, element, attribute);
  if (entry == nullptr) return std::nullopt;
  if (!entry->is_map) return entry->number;
  context.mistake(element.where(attribute),
                  fmt::format("\"{}\" is a map: here only a material will do", entry->name));
  return std::nullopt;
}

bool MaterialNames::is_map(const std::string& name) const {
  const auto found = index_.find(name);
  return found != index_.end() && entries_[static_cast<std::size_t>(found->second)].is_map;
}

std::optional<int> MaterialNames::number_of(const std::string& name) const {
  const auto found = index_.find(name);
  if (found == index_.end()) return std::nullopt;
  const Entry& entry = entries_[static_cast<std::size_t>(found->second)];
  return entry.is_map ? std::nullopt : std::optional{entry.number};
}

const MaterialNames::Entry* MaterialNames::find(const BuildContext& context,
                                                const CheckedElement& element,
                                                const std::string& attribute) {
  const auto name = element.find<std::string>(attribute);
  if (!name) return nullptr;
  if (const auto found = index_.find(*name); found != index_.end()) {
    Entry& entry = entries_[static_cast<std::size_t>(found->second)];
    entry.used = true;
    return &entry;
  }
  // After a material whose name was refused nobody knows which names are missing.
  if (!complete_) return nullptr;
  std::vector<std::string> declared;
  for (const Entry& entry : entries_) declared.push_back(entry.name);
  std::string hint = suggestion(*name, declared);
  if (std::find(library_names_.begin(), library_names_.end(), *name) != library_names_.end()) {
    hint = fmt::format("a library has it: write <material name=\"{}\"/> in <materials>", *name);
  } else if (const std::string near = nearest_name(*name, declared); !near.empty()) {
    entries_[static_cast<std::size_t>(index_.at(near))].used = true;  // no second complaint
  }
  context.mistake(element.where(attribute),
                  fmt::format("material \"{}\" is not declared in <materials>", *name), hint);
  return nullptr;
}

void MaterialNames::warn_of_unused(const BuildContext& context) const {
  for (const Entry& entry : entries_) {
    if (entry.used || !complete_) continue;
    context.warn(entry.offset, fmt::format("no object is made of material \"{}\"", entry.name));
  }
}

geometry::Geodetic build_geodetic(const CheckedElement& element) {
  return {element.number("latitude_deg"), element.number("longitude_deg"),
          element.number("height_m")};
}

}  // namespace nadir::sim
