#include "radiometry/lit_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/frame.hpp"
#include "radiometry/air_effects.hpp"
#include "radiometry/emission_rule.hpp"
#include "radiometry/leaf_effect.hpp"
#include "spectral/coverage.hpp"
#include "spectral/planck.hpp"

namespace nadir::radiometry {
namespace {

using spectral::Spectrum;

constexpr std::uint32_t map_choice = 0x6D61;  // purpose of the random number that a map draws with

/// Whether light of a body is simulated.
bool reflects(const ephemeris::LightSource& body, EffectSet effects) {
  return effects.has(body.name == "moon" ? Effect::lunar_reflection : Effect::solar_reflection);
}

std::vector<Target> targets_above_horizon(const ephemeris::Illumination& illumination,
                                          const atmosphere::BoundAtmosphere& air,
                                          const spectral::Lanes& lanes, EffectSet effects) {
  std::vector<Target> targets;
  std::uint32_t number = 0;
  for (const ephemeris::LightSource& body : illumination) {
    const double sin_radius = std::sin(body.angular_radius.value);
    if (body.direction_enu.z <= -sin_radius) continue;   // the whole disc is below
    if (!(body.irradiance.max_value() > 0.0)) continue;  // a dark body costs no rays
    const std::uint32_t own = number++;
    if (!reflects(body, effects)) continue;
    const double cos_radius = std::cos(body.angular_radius.value);
    // E is what falls on a plane normal to the direction of the disc's centre, E = L pi sin^2 r for
    // a disc of radiance L; directions are drawn uniformly over its solid angle 2 pi (1 - cos r).
    // Their ratio is 1 + 5e-6 for the sun, but 1.17 for a disc of 45 degrees.
    const auto spread = static_cast<float>(2.0 / (1.0 + cos_radius));
    const double disc = std::numbers::pi * sin_radius * sin_radius;
    const auto per_disc = static_cast<float>(1.0 / disc);
    const Spectrum outside =
        spectral::mean_at_all(body.irradiance, lanes, "the " + body.name + "'s irradiance");
    const Spectrum irradiance = outside * air.direct_transmittance(body.direction_enu);
    targets.push_back({body.direction_enu, sin_radius, cos_radius, disc * 2.0 / (1.0 + cos_radius),
                       irradiance * spread, irradiance * per_disc, outside * per_disc, own});
  }
  return targets;
}

/// Lamps or volumes, where their effect is simulated.
template <class Thing>
const std::vector<Thing>& wanted(const std::vector<Thing>& things, EffectSet effects,
                                 Effect effect) {
  static const std::vector<Thing> none;
  return effects.has(effect) ? things : none;
}

/// Whether a surface of that temperature is seen to emit at any lane.
bool counts_somewhere(Kelvin temperature, const std::vector<Target>& targets,
                      const spectral::Lanes& lanes) {
  for (int lane = 0; lane < lanes.count(); ++lane) {
    double irradiance = 0.0;
    for (const Target& target : targets) {
      irradiance += target.solid_angle * static_cast<double>(target.outside[lane]);
    }
    if (emission_counts(temperature, lanes[lane], SpectralIrradiance{irradiance})) return true;
  }
  return false;
}

}  // namespace

void resolve_map(const SceneDescription& scene, geometry::Hit& hit, const Sampler& numbers) {
  if (hit.material < scene.materials.size()) return;
  const materials::MaterialMap& map = scene.maps[hit.material - scene.materials.size()];
  const bool draped = map.frame.by == materials::MapFrame::By::ground;
  const Vec2 place = draped ? Vec2{hit.position.x, hit.position.y} : hit.texture;
  hit.material = map.at(place, numbers.number(map_choice));
}

LitScene::LitScene(const SceneDescription& scene, spectral::Lanes lanes, Diagnostics& diagnostics,
                   EffectSet effects)
    : scene_{&scene},
      lanes_{std::move(lanes)},
      effects_{effects},
      air_{scene.atmosphere, lanes_, air_parts(effects)},
      targets_{targets_above_horizon(scene.illumination, air_, lanes_, effects)},
      sky_{air_},
      volumes_{wanted(scene.volumes, effects, Effect::volumes), lanes_},
      lamps_{wanted(scene.lamps, effects, Effect::lamps), lanes_},
      shadows_{effects.has(Effect::shadows)},
      interreflects_{effects.has(Effect::interreflection)},
      emits_{effects.has(Effect::surface_emission)} {
  bind_materials(diagnostics);
  if (emits_) bind_temperatures();
}

void LitScene::bind_materials(Diagnostics& diagnostics) {
  const SceneDescription& scene = *scene_;
  for (const materials::Material& material : scene.materials) {
    materials_.push_back(materials::bind(material, lanes_, diagnostics));
  }
  if (!effects_.has(Effect::leaf_transmission)) {
    std::vector<materials::BoundMaterial> opaque =
        without_leaf_transmission({scene.materials, materials_, lanes_});
    if (!opaque.empty()) {
      whole_ = std::move(materials_);
      materials_ = std::move(opaque);
    }
  }
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    if (scene.method == Method::generic) {
      plans_.emplace_back(materials_[i], scene.materials[i].solver.value_or(scene.solver));
    }
    has_sheets_ |= materials_[i].traits.straight;
  }
}

void LitScene::bind_temperatures() {
  const thermal::TemperatureField& field = scene_->temperature;
  PlanckTable::Reach reach{Kelvin{1e9}, Kelvin{0.0}};
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto constant = field.constant(i);
    const bool counts = !constant && counts_somewhere(field.warmest_expected(i), targets_, lanes_);
    varies_.push_back(counts);
    black_body_.push_back(spectral::planck(lanes_, constant.value_or(Kelvin{0.0})));
    even_emission_.push_back(materials_[i].own_emissivity * black_body_.back());
    if (!counts) continue;
    reach = {std::min(reach.coldest, field.range(i).coldest),
             std::max(reach.hottest, field.range(i).hottest)};
  }
  if (reach.hottest > Kelvin{0.0}) planck_.emplace(lanes_, reach);
}

Spectrum LitScene::black_body(const geometry::Hit& hit) const {
  if (!emits_) return Spectrum{lanes_.count()};
  if (!varies_[hit.material]) return black_body_[hit.material];
  return planck_->at(scene_->temperature.at(hit).value);
}

const Spectrum* LitScene::even_emission(const geometry::Hit& hit, Spectrum& scratch) const {
  const materials::BoundMaterial& material = materials_[hit.material];
  if (!material.constant_emissivity) return nullptr;
  if (!varies_[hit.material]) return &even_emission_[hit.material];
  scratch = material.own_emissivity * planck_->at(scene_->temperature.at(hit).value);
  return &scratch;
}

std::optional<geometry::Hit> LitScene::intersect(const geometry::Ray& ray,
                                                 const Sampler& numbers) const {
  auto hit = scene_->geometry.intersect(ray);
  if (!hit) return hit;
  resolve_map(*scene_, *hit, numbers);
  hit->indirect = true;
  return hit;
}

Vec3 direction_in_disc(const Target& target, Vec2 u) noexcept {
  // Uniform in solid angle over the cap: the cosine is uniform between cos(radius) and 1. Written
  // with 1 - cos = sin^2 / (1 + cos), which keeps its digits for a disc of a quarter degree.
  const double height = target.sin_radius * target.sin_radius / (1.0 + target.cos_radius);
  const double below_one = u.x * height;
  const double sine = std::sqrt(below_one * (2.0 - below_one));
  const double phi = 2.0 * std::numbers::pi * u.y;
  return frame_about(target.direction)
      .to_world({sine * std::cos(phi), sine * std::sin(phi), 1.0 - below_one});
}

}  // namespace nadir::radiometry
