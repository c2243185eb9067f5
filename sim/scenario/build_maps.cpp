#include <fmt/format.h>

#include <set>

#include "sim/scenario/build_material.hpp"

namespace nadir::sim {
namespace {

constexpr const char* edges[] = {"west_m", "south_m", "east_m", "north_m"};

/// Attributes that only the other kind of drape has.
void refuse(const BuildContext& context, const CheckedElement& element, const char* attribute,
            const char* other) {
  if (!element.gives(attribute)) return;
  context.mistake(element.where(attribute),
                  fmt::format("{} is for maps with drape=\"{}\"", attribute, other));
}

GroundDrape ground(const BuildContext& context, const CheckedElement& element) {
  refuse(context, element, "size_u", "texture");
  refuse(context, element, "size_v", "texture");
  std::vector<std::string> missing;
  for (const char* edge : edges) {
    if (!element.gives(edge)) missing.emplace_back(edge);
  }
  if (missing.size() == std::size(edges)) return {};
  if (!missing.empty()) {
    context.mistake(element.offset, fmt::format("<{}> lacks {}: give all four edges or none",
                                                element.type->name, missing.front()));
    return {};
  }
  const GroundArea area{element.number("west_m"), element.number("south_m"),
                        element.number("east_m"), element.number("north_m")};
  if (!(area.west_m < area.east_m)) {
    context.mistake(element.where("east_m"), "east_m must be greater than west_m");
  }
  if (!(area.south_m < area.north_m)) {
    context.mistake(element.where("north_m"), "north_m must be greater than south_m");
  }
  return {area};
}

TextureDrape texture(const BuildContext& context, const CheckedElement& element) {
  for (const char* edge : edges) refuse(context, element, edge, "ground");
  return {element.find<double>("size_u").value_or(1.0),
          element.find<double>("size_v").value_or(1.0)};
}

class MapBuilder {
 public:
  MapBuilder(const BuildContext& context, MaterialNames& names, Scenario& scenario)
      : context_{context}, names_{names}, scenario_{scenario} {}

  void material_map(const CheckedElement& element) {
    MaterialMapInput map = map_data(element);
    const std::string kind =
        element.children.empty() ? std::string{} : element.children.front().type->name;
    for (const CheckedElement& child : element.children) {
      if (child.type->name == kind) continue;
      context_.mistake(child.offset, "a map holds either choices or fractions, not both");
    }
    if (kind == "fraction") {
      map.rule = fractions(element);
    } else {
      map.rule = choices(element);
    }
    scenario_.maps.push_back(std::move(map));
  }

  void contrast_map(const CheckedElement& element) {
    MaterialMapInput map = map_data(element);
    ContrastInput rule{element.value<int>("band"),
                       element.number("band_low_um"),
                       element.number("band_high_um"),
                       element.value<int>("half_window_pixels"),
                       {}};
    if (element.gives("band_high_um") && !(rule.band_low_um < rule.band_high_um)) {
      context_.mistake(element.where("band_high_um"),
                       "band_high_um must be greater than band_low_um");
    }
    const auto base = names_.resolve_material(context_, element);
    if (base) rule.materials = add_spectra(element, static_cast<std::size_t>(*base));
    map.rule = std::move(rule);
    scenario_.maps.push_back(std::move(map));
  }

 private:
  MaterialMapInput map_data(const CheckedElement& element) const {
    MaterialMapInput map;
    map.name = element.value<std::string>("name");
    map.raster = element.value<std::filesystem::path>("raster");
    map.place = build_map_place(context_, element);
    map.where = context_.source.locate(element.offset);
    return map;
  }

  ChoicesInput choices(const CheckedElement& element) {
    ChoicesInput rule{element.find<int>("band").value_or(1), {}};
    std::set<double> known;
    for (const CheckedElement& child : element.children) {
      if (child.type->name != "choice") continue;
      const auto value = child.find<double>("value");
      if (value && !known.insert(*value).second) {
        context_.mistake(child.where("value"),
                         fmt::format("the value {} has a choice already", *value));
      }
      const int material = names_.resolve_material(context_, child).value_or(0);
      rule.choices.push_back({value.value_or(0.0), material});
    }
    return rule;
  }

  FractionsInput fractions(const CheckedElement& element) {
    FractionsInput rule;
    if (element.gives("band")) {
      context_.mistake(element.where("band"), "band is for choices; each fraction names its own");
    }
    std::set<int> known;
    for (const CheckedElement& child : element.children) {
      if (child.type->name != "fraction") continue;
      const auto band = child.find<int>("band");
      if (band && !known.insert(*band).second) {
        context_.mistake(child.where("band"), fmt::format("band {} has a material already", *band));
      }
      const int material = names_.resolve_material(context_, child).value_or(0);
      rule.fractions.push_back({band.value_or(1), material});
    }
    return rule;
  }

  /// A material for each spectrum, alike in all else. Their names cannot be those of others.
  std::vector<int> add_spectra(const CheckedElement& element, std::size_t base) {
    if (brings_spectra(scenario_.materials[base].scattering)) {
      context_.mistake(element.where("material"),
                       "the scattering model of this material brings its own spectra, so that "
                       "there is none to choose");
    }
    std::vector<int> added;
    for (const CheckedElement& child : element.children) {
      MaterialInput material = scenario_.materials[base];
      material.name = fmt::format("{}#{}", element.value<std::string>("name"), added.size() + 1);
      material.reflectance = child.find<SpectralInput>("reflectance");
      material.emissivity.reset();  // follows from the reflectance
      if (child.gives("transmittance")) {
        material.transmittance = child.find<SpectralInput>("transmittance");
      }
      material.where = context_.source.locate(child.offset);
      if (auto mistake = energy_mistake(material); !mistake.empty()) {
        context_.mistake(child.offset, std::move(mistake));
      }
      added.push_back(static_cast<int>(scenario_.materials.size()));
      scenario_.materials.push_back(std::move(material));
    }
    return added;
  }

  const BuildContext& context_;
  MaterialNames& names_;
  Scenario& scenario_;
};

}  // namespace

MapPlaceInput build_map_place(const BuildContext& context, const CheckedElement& element) {
  MapPlaceInput place;
  const bool by_texture = element.value<std::string>("drape") == "texture";
  if (by_texture) {
    place.drape = texture(context, element);
  } else {
    place.drape = ground(context, element);
  }
  const auto repeats = element.find<std::string>("repeats");
  place.repeats = repeats ? *repeats == "true" : by_texture;
  return place;
}

void build_maps(const BuildContext& context, const CheckedElement& element, MaterialNames& names,
                Scenario& scenario) {
  MapBuilder builder{context, names, scenario};
  for (const CheckedElement& child : element.children) {
    if (child.type->name == "material_map") builder.material_map(child);
    if (child.type->name == "contrast_map") builder.contrast_map(child);
  }
}

}  // namespace nadir::sim
