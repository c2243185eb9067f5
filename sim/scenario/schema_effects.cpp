#include <array>

#include "radiometry/effect.hpp"
#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// What each effect is, in the order of the enumeration.
constexpr std::array<const char*, radiometry::effect_count> effect_docs{
    "The sun's light on surfaces and volumes, and its disc.",
    "The moon's light on surfaces and volumes, and its disc.",
    "All lamps.",
    "Light of sun, moon and night sky that the air scatters onto surfaces.",
    "What surfaces emit by their temperature.",
    "What the air emits onto surfaces.",
    "What the air scatters into the lines of sight.",
    "What the air emits into the lines of sight.",
    "What the air takes away along the lines of sight.",
    "Light that more than one surface has reflected or emitted and another reflected.",
    "Light through leaves and other diffusing sheets.",
    "Clouds, plumes and smoke.",
    "Shadows of sun, moon and lamps.",
    "Bending of the lines of sight, where the atmosphere says refraction=\"true\".",
    "Eclipses of the sun and of the moon.",
    "Motion and jitter of the sensor during the exposure.",
    "Spread of the optics and of detectors wider than the pixel.",
    "Noise of the digital numbers.",
    "Temperatures from the heat balance. Off: surfaces to be solved have the air's temperature."};

ElementType effects() {
  ElementType type{
      .id = "effects",
      .name = "effects",
      .doc =
          "Which effects are simulated. auto: simulated unless a stated bound shows that the "
          "picture stays within its accuracy without. on and off always hold."};
  for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
    type.attributes.push_back(defaulted(std::string{radiometry::effect_names[i]},
                                        EnumerationType{{"auto", "on", "off"}}, "", "auto",
                                        effect_docs[i]));
  }
  return type;
}

}  // namespace

std::vector<ElementType> schema_of_effects() {
  constexpr bool above = true, below = true;
  return {
      effects(),
      {.id = "accuracy",
       .name = "accuracy",
       .doc = "How much error a pixel may have: relative_percent of its radiance, or of the floor "
              "where it is darker.",
       .attributes =
           {defaulted("relative_percent", above_to(0.0, 100.0), "%", "1",
                      "Of a band's radiance. nadir run --accuracy takes its place."),
            optional("floor_radiance", above_to(0.0, 1e12), "W m^-2 sr^-1 um^-1",
                     "from the sensor's noise, or the scene's darkest surfaces",
                     "Darker pixels need no smaller error than this radiance."),
            defaulted("noise_fraction", above_to(0.0, 1000.0), "", "0.5",
                      "Where a band has a detector and no floor is stated: an error of this share "
                      "of its noise is worth no more work."),
            defaulted("effects_share", NumberType{0.0, 1.0, !above, below}, "", "0.25",
                      "Share of the budget that all effects left out may use up.")}},
  };
}

}  // namespace nadir::sim
