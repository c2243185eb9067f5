#pragma once

#include <vector>

#include "atmosphere/transfer/ordinates.hpp"
#include "atmosphere/transfer/source_profile.hpp"

namespace nadir::atmosphere {

/// One layer as one azimuth mode sees it.
struct LayerOptics {
  double depth = 0.0;
  double emissivity = 1.0;      ///< 1 - omega
  std::vector<double> scatter;  ///< omega (2 l + 1) chi_l of the delta-scaled phase function
  bool like_below = false;      ///< the next layer scatters the same, but for rounding
};

/// One right-hand side of the equations.
struct ModeSource {
  /// By layer, empty where nothing is scattered or emitted: no source but that of the boundaries.
  const std::vector<SourceProfile>* profile = nullptr;
  /// The source in direction mu is sum_l scatter_l angular_l Lambda_l(mu), l from the order on;
  /// left empty it is the layer's emissivity.
  std::vector<double> angular;
  double top = 0.0, ground = 0.0;  ///< even radiance that comes in from above and from below
};

/// The diffuse field at the levels, by the moments that the source of scattering is made of:
///
///     F_l = 1/2 int Lambda_l(mu) I(mu) dmu,   J(mu) = sum_l scatter_l Lambda_l(mu) F_l,
///
/// with the scatter_l of the layer on either side.
struct ModeField {
  int degrees = 0;  ///< streams - order
  int sources = 0;
  std::vector<double> moment;    ///< [level][source][degree - order]
  std::vector<double> up, down;  ///< [level][source]: irradiances; in order 0 alone
  [[nodiscard]] const double* at(int level, int source) const noexcept {
    return moment.data() +
           static_cast<std::size_t>(level * sources + source) * static_cast<std::size_t>(degrees);
  }
};

/// Solves one azimuth mode for all sources.
///
/// With I+ and I- the radiances in the ordinates, sigma = sqrt(w mu) (I+ + I-) and
/// delta = sqrt(w mu) (I+ - I-), the equations of a layer are
///
///     sigma' = X- delta - q-,   delta' = X+ sigma - q+,   X+- = 1/mu - sum_l scatter_l p_l p_l^T,
///
/// over even l - m for X+ and odd for X-, p_l = sqrt(w / mu) Lambda_l: both symmetric and not
/// negative. With X- = L L^T and L^T X+ L = Q K^2 Q^T they fall into scalar pairs. The layer's
/// reflection R and transmission T follow from its even and odd solutions about its middle,
///
///     R = F - E,  T = 1 - E - F,  E = (1 + Ye)^-1 Ye,  F = (1 + Yo)^-1 Yo,
///     Ye = Z~ (K tanh K t/2) Z~^T,  Yo = Z (tanh(K t/2) / K) Z^T,  Z = L Q,  Z~ = L^-T Q,
///
/// which hold for all K >= 0 and all depths without a large number or a cancellation; what its own
/// sources send out likewise (SourceProfile). Layers are joined by adding.
/// Source: Nakajima & Tanaka, JQSRT 35, 13 (1986) for the symmetric form; Grant & Hunt, Proc. R.
/// Soc. A 313, 183 (1969) for adding; even and odd solutions as in Waterman, JOSA 71, 410 (1981).
[[nodiscard]] ModeField solve_mode(const Ordinates& ordinates, int order,
                                   const std::vector<LayerOptics>& layers,
                                   const std::vector<ModeSource>& sources);

}  // namespace nadir::atmosphere
