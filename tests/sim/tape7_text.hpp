#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "air_slab.hpp"

// Runs of the slab in the layout of a tape7.

namespace nadir::sim::support {

struct Look {
  int type = 3;  // ITYPE
  double h1_km = 0.0, h2_km = 0.0, zenith_deg = 0.0, range_km = 0.0, azimuth_deg = 0.0;
};

/// The echo of the cards, as MODTRAN 5 prints it.
inline std::string cards(const Look& look, int iemsct) {
  std::string text =
      printed("T F 6%5d%5d    1    6    6    6    6    6    6    1    0    0   0.000   0.00\n",
              look.type, iemsct);
  text += "    1    1    1    0    0    0  23.00000   0.00000   0.00000   0.00000   0.00000\n";
  text += " -99.000 -99.000 -99.000\n";
  text += " -99.00000 -99.00000 -99.00000  1.416445  0.000736 ! H2O & O3 COLUMNS [GM/CM2]\n";
  text += "   361976 U S STANDARD   \n";
  text += printed("%10.5f%10.5f%10.5f%10.5f   0.00000   0.00000    0        0.00000\n", look.h1_km,
                  look.h2_km, look.zenith_deg, look.range_km);
  const bool sun = iemsct == 2;
  text += sun ? "    2    2    1    0\n" : "  -99  -99  -99  -99\n";
  text +=
      sun ? printed(
                "%10.5f  36.86990   0.00000   0.00000   0.00000   0.00000   0.00000   0.00000\n",
                look.azimuth_deg)
          : " -99.00000 -99.00000 -99.00000 -99.00000 -99.00000 -99.00000   0.00000 -99.00000\n";
  text += "    1000.0   10000.0       1.0       1.0NW              \n";
  return text + "    0   0    0.000  0    0.000  0    1.000\n";
}

inline const char* const names5 =
    "    FREQ  TOT_TRANS  PTH_THRML  THRML_SCT  SURF_EMIS   SOL_SCAT  SING_SCAT  GRND_RFLT  "
    "DRCT_RFLT  TOTAL_RAD  REF_SOL  SOL@OBS   DEPTH DIR_EM    TOA_SUN BBODY_T[K]\n";

inline double slant(const Look& look) { return std::cos(look.zenith_deg * degree); }

/// The slab seen along the look, thermal and solar; a ground of radiance 2 behind it where it looks
/// down.
inline std::string radiance_run(const Slab& slab, const Look& look) {
  std::string text = cards(look, 2) + names5;
  for (std::size_t i = 0; i < slab.nu.size(); ++i) {
    const double nu = slab.nu[i], mu = slant(look), t = slab.transmittance(i, mu);
    const double thermal = per_cm(slab.emitted(i, mu), nu);
    const double solar = per_cm(slab.scattered(i, mu, look.azimuth_deg), nu);
    const double ground = mu < 0.0 ? per_cm(2.0 * t, nu) : 0.0;
    const double toa = per_cm(slab.sun[i], nu), down = slab.transmittance(i, slab.sun_mu);
    text += printed(
        "%8.2f%11.8f%11.4E%11.4E%11.4E%11.4E%11.4E%11.4E%11.4E%11.4E%9.2E%9.2E%8.3f%7.4f%11.4E%11."
        "3f\n",
        nu, t, thermal, 0.3 * thermal, 0.0, solar, 0.5 * solar, ground, 0.0,
        thermal + solar + ground, toa * down * t, toa * down, slab.depth[i], 1.0, toa, 250.0);
  }
  return text + " -9999.\n";
}

/// Thermal runs leave the sun's cells blank.
inline std::string thermal_run(const Slab& slab, const Look& look) {
  std::string text = cards(look, 1) + names5;
  for (std::size_t i = 0; i < slab.nu.size(); ++i) {
    const double mu = slant(look), thermal = per_cm(slab.emitted(i, mu), slab.nu[i]);
    text += printed("%8.2f%11.8f%11.4E%11.4E%11.4E%22s%11.4E%11s%11.4E%18s%8.3f%7.4f%11s%11.3f\n",
                    slab.nu[i], slab.transmittance(i, mu), thermal, 0.0, 0.0, "", 0.0, "", thermal,
                    "", 0.3, 1.0, "", 250.0);
  }
  return text + " -9999.\n";
}

/// Direct solar irradiance: four names, five numbers.
inline std::string direct_run(const Slab& slab, double h1_km) {
  std::string text = cards({3, h1_km, 100.0, 36.86990, 0.0, 0.0}, 3);
  text += "    FREQ   TRANS     SOL TR  SOLAR\n";
  for (std::size_t i = 0; i < slab.nu.size(); ++i) {
    const double t = slab.transmittance(i, slab.sun_mu), toa = per_cm(slab.sun[i], slab.nu[i]);
    text += printed("%8.2f%8.4f%9.2E%9.2E%71.3E\n", slab.nu[i], t, toa * t, toa, -std::log(t));
  }
  return text + " -9999.\n";
}

/// A sky from the ground and a view down from 10 km, three azimuths each.
inline std::string grid_of(const Slab& slab) {
  std::string text = direct_run(slab, 0.0);
  for (const double zenith : {0.0, 30.0, 60.0}) {
    for (const double azimuth : {0.0, 90.0, 180.0}) {
      if (zenith == 0.0 && azimuth > 0.0) continue;  // means nothing in the zenith
      text += radiance_run(slab, {3, 0.0, 100.0, zenith, 0.0, azimuth});
      text += radiance_run(slab, {3, 10.0, 0.0, 180.0 - zenith, 0.0, azimuth});
    }
  }
  return text;
}

}  // namespace nadir::sim::support
