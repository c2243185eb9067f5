#pragma once

#include "atmosphere/table/air_table.hpp"
#include "core/error.hpp"
#include "ephemeris/illumination.hpp"
#include "sim/plan/camera_plan.hpp"

namespace nadir::sim {

/// Every body that lights the scene must be one that the table of the air was made for, at its
/// place in the sky and with its irradiance at the wavelengths that the camera sees; and no other
/// body's light may be in the table.
/// @throws InputError at `where`
void check_air_bodies(const atmosphere::AirTable& table, const ephemeris::Illumination& bodies,
                      const WavelengthRange& seen, const SourceLocation& where);

}  // namespace nadir::sim
