#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/quantity.hpp"
#include "thermal/conduction/column.hpp"
#include "thermal/conduction/depth_grid.hpp"
#include "thermal/conduction/layers.hpp"
#include "thermal/exposure/exposure.hpp"
#include "thermal/surface/surface_balance.hpp"
#include "thermal/weather/weather.hpp"

namespace nadir::thermal {

/// How the heat balance is solved.
struct HeatSettings {
  double step_s = 600.0;         ///< 1 s to 6 h; shortened until a day is a whole number of steps
  double resolution_m = 1.0;     ///< facets are cut into cells no longer than this
  double indirect_factor = 8.0;  ///< cells seen by way of other surfaces alone are longer by this
  double history_s = 86400.0;    ///< of the weather's own record before the picture, rounded up to
                                 ///< whole steps, at least 24 hours; before that its first 24 hours
                                 ///< repeat until nothing changes
  double spin_up_k = 0.05;       ///< a day this near to the one that repeats for ever will do
  int spin_up_days = 30;         ///< at most
  GridSettings grid;
  ExposureSettings exposure;
};

/// A material whose temperature is solved.
struct HeatMaterial {
  LayerStack layers;
  SurfaceProperties surface;
};

/// How warm a surface is as others see it: its own place is not asked for.
struct FollowsAir {
  double offset_k = 0.0;
};
/// Between a level open place of its kind and one in the shade.
struct OfItsHeatBalance {
  std::optional<std::uint32_t> whose;  ///< index of a material with a heat balance; none: its own
};
struct SurroundingSurface {
  double solar_reflectance = 0.2;
  double emissivity = 0.95;
  std::variant<Kelvin, FollowsAir, OfItsHeatBalance> temperature = FollowsAir{};
};

/// Everything that the heat balance of a scene needs but its geometry.
struct HeatModel {
  Weather weather;  ///< covers history_s before the picture, 24 hours at least
  SunTrack sun;     ///< at least 24 hours; earlier days have the shadows of its first 24 hours
  std::vector<std::optional<HeatMaterial>> materials;  ///< by index of hits' material
  std::vector<SurroundingSurface> surroundings;        ///< likewise; maps of materials after them
  SurroundingSurface ground_about;                     ///< beyond the scene's edge
  HeatSettings settings;
};

/// @throws InputError that names what is missing or out of range
void check(const HeatModel& model);
/// A material alone, in words that do not say which it is.
/// @throws InputError for figures out of range, whatever make_grid refuses, and where nothing could
///         ever take the sun's heat away
void check(const HeatMaterial& material, const GridSettings& grid = {});

/// How warm a surface of the material may become, so that nobody need look for the emission of
/// warmer ones. The sun alone makes it 400 K at most, or more of a bright metal whose film is a
/// given one too thin to cool it; heat released within adds as radiation,
///
///     eps sigma T^4 = eps sigma T_sun^4 + heat,
///
/// and neither counts where what lies behind the layers is warmer. No more than 2000 K.
[[nodiscard]] Kelvin warmest_of(const HeatMaterial& material);

}  // namespace nadir::thermal
