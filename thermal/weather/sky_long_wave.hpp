#pragma once

namespace nadir::thermal {

// Long-wave radiation of the sky from what a station measures two metres above the ground, for
// weather that has no record of it: E = eps sigma T^4, eps by one of the published fits. They were
// made over land within some 1500 m of the sea, and miss measured half-hours by 20 to 30 W m^-2
// (Flerchinger et al. 2009, doi:10.1029/2008WR007394).

/// Emissivity of a clear sky; T in K, e in hPa.
enum class ClearSkyFormula {
  brutsaert,  ///< 1.24 (e/T)^(1/7): Brutsaert (1975), doi:10.1029/WR011i003p00742
  swinbank,   ///< 5.31e-13 T^6 W m^-2: Swinbank (1963), doi:10.1002/qj.49708938105; dry or damp
  idso,       ///< 0.70 + 5.95e-5 e exp(1500/T): Idso (1981), doi:10.1029/WR017i002p00295
  prata,      ///< 1 - (1 + w) exp(-(1.2 + 3 w)^(1/2)), w = 46.5 e/T: Prata (1996),
              ///< doi:10.1002/qj.49712253306
};

/// What clouds over a fraction c of the sky make of the emissivity eps of the clear one.
enum class CloudFormula {
  unsworth_monteith,  ///< (1 - 0.84 c) eps + 0.84 c: (1975), doi:10.1002/qj.49710142703
  sugita_brutsaert,   ///< (1 + 0.0496 c^2.45) eps: (1993), doi:10.1029/92WR02352
};

/// The pair that Flerchinger et al. found among the best.
struct SkyFormula {
  ClearSkyFormula clear = ClearSkyFormula::prata;
  CloudFormula clouds = CloudFormula::unsworth_monteith;
};

/// Air at a station.
struct StationAir {
  double temperature_k = 288.15;
  double vapour_pressure_hpa = 10.0;  ///< >= 0
  double cloud_fraction = 0.0;        ///< 0 to 1; what is beyond counts as the nearer end
};

/// Emissivity of the sky, 0 to 1: where a fit would lead out of it, 1. Brutsaert's goes to 0 with
/// the last of the vapour; the others do not.
[[nodiscard]] double sky_emissivity(const SkyFormula& formula, const StationAir& air) noexcept;
/// On a level plane, W m^-2.
[[nodiscard]] double sky_long_wave_w_m2(const SkyFormula& formula, const StationAir& air) noexcept;

}  // namespace nadir::thermal
