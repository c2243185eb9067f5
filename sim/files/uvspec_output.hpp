#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/files/air_runs.hpp"

namespace nadir::sim {

struct UvspecSettings {
  /// What the extraterrestrial spectrum of solar runs is in: W, or else mW, m^-2 nm^-1. The spectra
  /// that come with libRadtran are in mW.
  bool watts = false;
};

/// Output of libRadtran's uvspec, and the input file that it was made from.
///
/// Input: `source`, `sza`, `phi0`, `umu`, `phi`, `zout`, `altitude`, `albedo`, `output_user`,
/// `output_process`, `thermal_bandwidth`, `sur_temperature` are looked at, others passed over;
/// what would give another meaning to the output (`include`, `output_quantity`, reflecting ground
/// where a direction looks down, fluxes per band) is a mistake. Output: with `output_user` a row a
/// wavelength and level, where `uu` stands for radiances umu by umu, phi fastest; without it
/// DISORT's blocks, for each wavelength and level
///
///     lambda edir edn eup uavgdir uavgdn uavgup
///                     phi(0) ... phi(m)
///     umu(0) u0u      uu ...
///
/// umu is negative where the eye looks up; phi = phi0 looks towards the sun. Solar radiance in
/// (m)W m^-2 nm^-1 sr^-1, thermal in W m^-2 sr^-1 per cm^-1 (divided by `thermal_bandwidth`), or
/// what `output_process per_nm` or `per_cm-1` says. Transmittances are those of the sun's beam
/// between the levels, for plane-parallel air: give solar runs the levels `0`, the eye's and `TOA`.
/// The lowest level is the ground, at `altitude`.
///
/// Source: B. Mayer et al., libRadtran user's guide, edition 2.0.2 (2017), sections 3.1.5 and 6.
/// @throws InputError with file and line
[[nodiscard]] AirRunSet read_uvspec(const std::filesystem::path& input,
                                    const std::filesystem::path& output,
                                    const AirRunSettings& settings, const UvspecSettings& uvspec);

struct NamedText {
  std::string name;
  std::string_view text;
};
/// The same from text.
[[nodiscard]] AirRunSet parse_uvspec(const NamedText& input, const NamedText& output,
                                     const AirRunSettings& settings, const UvspecSettings& uvspec);

}  // namespace nadir::sim
