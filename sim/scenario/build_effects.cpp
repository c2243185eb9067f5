#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

EffectState effect_state(const std::string& name) {
  if (name == "on") return EffectState::on;
  return name == "off" ? EffectState::off : EffectState::automatic;
}

EffectsInput effects_of(const CheckedElement& element) {
  EffectsInput effects;
  for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
    effects.states[i] =
        effect_state(element.value<std::string>(std::string{radiometry::effect_names[i]}));
  }
  return effects;
}

}  // namespace

void build_effects(const BuildContext& context, const CheckedElement& root, Scenario& scenario) {
  if (const CheckedElement* element = root.child("effects")) {
    scenario.effects = effects_of(*element);
    scenario.effects.where = context.source.locate(element->offset);
  }
  if (const CheckedElement* element = root.child("accuracy")) {
    scenario.accuracy = {.relative = element->number("relative_percent") * 0.01,
                         .floor_radiance = element->find<double>("floor_radiance"),
                         .noise_fraction = element->number("noise_fraction"),
                         .effects_share = element->number("effects_share")};
  }
}

}  // namespace nadir::sim
