#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/files/air_runs.hpp"

namespace nadir::sim {

/// Runs of a tape7 (.tp7) of MODTRAN 4, 5 or 6, any number of them in a file: transmittance
/// (IEMSCT 0), radiance (1, 2) and direct solar irradiance (3).
///
/// Each run echoes its input cards, names its columns on a line that begins with FREQ, gives a row
/// a wavenumber and ends with -9999. Where it looks is in the echo: ITYPE in columns 6 to 10 of the
/// first line, H1, H2, ANGLE, RANGE, BETA, RO and LEN on the fifth line before the columns' names,
/// IPARM on the fourth; with IPARM = 2 also the azimuth from the sun and its zenith
/// angle, on the third (PARM1, PARM2). Other values of IPARM leave the azimuth open. Blank cells
/// (thermal runs) are told by the columns' right edges.
///
/// Layout after: pyradi (C. J. Willers), rymodtran.py and its sample files data/tape7-*;
/// G. P. Anderson et al., MODTRAN 4 user's manual (1999), cards 1 to 4. Units: W cm^-2 sr^-1 per
/// cm^-1.
/// @throws InputError with file and line
[[nodiscard]] AirRunSet read_modtran_tape7(const std::filesystem::path& file,
                                           const AirRunSettings& settings);

/// The same from text; `name` stands in messages.
[[nodiscard]] AirRunSet parse_modtran_tape7(std::string_view text, const std::string& name,
                                            const AirRunSettings& settings);

}  // namespace nadir::sim
