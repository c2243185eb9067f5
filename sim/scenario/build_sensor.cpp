#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

struct Place {
  std::variant<geometry::Geodetic, Vec3> where;
  bool on_terrain = false;
};

/// The place inside <position> or <look_at>; nothing after a mistake.
std::optional<Place> build_place(const BuildContext& context, const CheckedElement& element,
                                 bool has_terrain) {
  if (const CheckedElement* geodetic = element.child("geodetic")) {
    return Place{build_geodetic(*geodetic), false};
  }
  const CheckedElement* local = element.child("local");
  if (local == nullptr) return std::nullopt;
  const Vec3 position{local->number("east_m"), local->number("north_m"), local->number("up_m")};
  const bool on_terrain = local->flag("on_terrain");
  if (on_terrain && !has_terrain) {
    context.mistake(local->where("on_terrain"),
                    fmt::format("<local> of <{}> counts from the terrain, but <geometry> has no "
                                "<terrain>",
                                element.type->name));
  }
  return Place{position, on_terrain};
}

bool same_place(const Place& a, const Place& b, const geometry::Geodetic& origin) {
  if (a.on_terrain != b.on_terrain) return false;
  const geometry::LocalFrame frame{origin};
  const auto local = [&](const Place& place) {
    const auto* geodetic = std::get_if<geometry::Geodetic>(&place.where);
    return geodetic != nullptr ? frame.enu(*geodetic) : std::get<Vec3>(place.where);
  };
  constexpr double nearest_m = 1e-3;  // a line of sight needs a length that rounding cannot turn
  return length(local(a) - local(b)) < nearest_m;
}

void build_attitude(const BuildContext& context, const CheckedElement& attitude, bool has_terrain,
                    Scenario& scenario) {
  PlatformInput& platform = scenario.platform;
  if (const CheckedElement* euler = attitude.child("euler")) {
    platform.attitude = PlatformInput::Euler{euler->number("yaw_deg"), euler->number("pitch_deg"),
                                             euler->number("roll_deg")};
  }
  const CheckedElement* look_at = attitude.child("look_at");
  if (look_at == nullptr) return;
  const auto target = build_place(context, *look_at, has_terrain);
  if (!target) return;
  platform.attitude =
      PlatformInput::LookAt{target->where, target->on_terrain, look_at->number("roll_deg")};
  const std::size_t before = context.issues.count();
  const Place camera{platform.position, platform.on_terrain};
  // After other mistakes the numbers may be placeholders that mean nothing.
  if (before == 0 && same_place(camera, *target, scenario.origin)) {
    context.mistake(look_at->offset, "<look_at> names the place where the camera itself is");
  }
}

BandInput build_band(const BuildContext& context, const CheckedElement& element) {
  BandInput band;
  band.name = element.value<std::string>("name");
  if (element.type->name == "band_box") {
    const auto lo = element.find<double>("lo_um"), hi = element.find<double>("hi_um");
    if (lo && hi && *lo >= *hi) {
      context.mistake(element.where("hi_um"),
                      fmt::format("band \"{}\" must end after it begins: lo_um is {}, hi_um {}",
                                  band.name, *lo, *hi));
    }
    band.response = BoxBand{lo.value_or(0.0), hi.value_or(0.0)};
  } else if (element.type->name == "band_gaussian") {
    const auto centre = element.find<double>("centre_um"), fwhm = element.find<double>("fwhm_um");
    if (centre && fwhm && *fwhm >= *centre) {
      context.mistake(element.where("fwhm_um"),
                      fmt::format("band \"{}\" is wider than its wavelength", band.name));
    }
    band.response = GaussianBand{centre.value_or(0.0), fwhm.value_or(0.0)};
  } else {
    const auto response = element.value<SpectralInput>("response");
    const auto* file = std::get_if<std::filesystem::path>(&response.source);
    band.response =
        TabulatedBand{file != nullptr ? *file : std::filesystem::path{}, response.column};
  }
  return band;
}

ArrayInput build_array(const BuildContext& context, const CheckedElement& element) {
  ArrayInput array{element.value<std::string>("name"), element.value<int>("samples"),
                   element.value<int>("lines"),        element.number("pitch_um"),
                   element.number("offset_x_um"),      element.number("offset_y_um"),
                   element.number("ground_pitch_m"),   element.number("offset_x_m"),
                   element.number("offset_y_m"),       {}};
  std::vector<const CheckedElement*> bands;
  for (const CheckedElement& band : element.children) {
    bands.push_back(&band);
    array.bands.push_back(build_band(context, band));
  }
  context.check_unique(bands, "band");
  return array;
}

/// One band, or three of the same array.
void check_quick_look(const BuildContext& context, const CheckedElement& products,
                      const Scenario& scenario) {
  const std::vector<std::string>& wanted = scenario.products.quick_look_bands;
  if (wanted.empty() || scenario.camera.arrays.empty()) return;
  const std::size_t offset = products.where("quick_look_bands");
  if (wanted.size() == 2) context.mistake(offset, "a quick look has one band or three, not two");
  std::vector<std::string> known;
  bool together = false;
  for (const ArrayInput& array : scenario.camera.arrays) {
    const auto has = [&](const std::string& name) {
      return std::any_of(array.bands.begin(), array.bands.end(),
                         [&](const BandInput& band) { return band.name == name; });
    };
    together |= std::all_of(wanted.begin(), wanted.end(), has);
    for (const BandInput& band : array.bands) known.push_back(band.name);
  }
  bool all_known = true;
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    context.mistake(offset, fmt::format("the camera has no band \"{}\"", name),
                    suggestion(name, known));
    all_known = false;
  }
  if (all_known && !together) {
    context.mistake(offset, "the bands of a quick look must be bands of one array");
  }
}

}  // namespace

void build_platform(const BuildContext& context, const CheckedElement& element,
                    Scenario& scenario) {
  const bool has_terrain = std::any_of(
      scenario.geometry.begin(), scenario.geometry.end(),
      [](const GeometryInput& part) { return std::holds_alternative<TerrainInput>(part); });
  scenario.platform.where = context.source.locate(element.offset);
  const CheckedElement* position = element.child("position");
  if (position != nullptr) {
    if (const auto place = build_place(context, *position, has_terrain)) {
      scenario.platform.position = place->where;
      scenario.platform.on_terrain = place->on_terrain;
    }
  }
  if (const CheckedElement* attitude = element.child("attitude")) {
    build_attitude(context, *attitude, has_terrain, scenario);
  }
}

void build_camera(const BuildContext& context, const CheckedElement& element, Scenario& scenario) {
  if (element.children.empty()) return;
  const CheckedElement& projection = element.children.front();
  scenario.camera.orthographic = projection.type->name == "orthographic";
  scenario.camera.focal_length_mm = projection.number("focal_length_mm");
  std::vector<const CheckedElement*> arrays;
  for (const CheckedElement& array : projection.children) {
    arrays.push_back(&array);
    scenario.camera.arrays.push_back(build_array(context, array));
  }
  context.check_unique(arrays, "array");
}

void build_results(const BuildContext& context, const CheckedElement& root, Scenario& scenario) {
  if (const CheckedElement* sampling = root.child("sampling")) {
    scenario.sampling = {sampling->value<int>("replicates"),
                         sampling->value<int>("samples_per_replicate"),
                         sampling->value<int>("wavelengths_per_band")};
  }
  if (const CheckedElement* products = root.child("products")) {
    scenario.products = {products->flag("envi"),
                         products->flag("exr"),
                         products->flag("quick_look"),
                         products->flag("truth"),
                         products->flag("truth_temperature"),
                         products->value<std::vector<std::string>>("quick_look_bands")};
    check_quick_look(context, *products, scenario);
    if (scenario.products.truth_temperature && !scenario.products.truth) {
      context.mistake(
          products->where("truth_temperature"),
          "truth_temperature=\"true\" asks for a plane that truth=\"false\" leaves out");
    }
  }
}

}  // namespace nadir::sim
