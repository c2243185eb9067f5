#pragma once

#include "core/quantity.hpp"

namespace nadir::thermal {

/// What the heat balance works in: from the cold of space to where rock has long molten.
inline constexpr Kelvin least_temperature{2.7};
inline constexpr Kelvin greatest_temperature{2000.0};

}  // namespace nadir::thermal
