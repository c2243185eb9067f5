#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/vec.hpp"
#include "geometry/earth.hpp"

namespace nadir::sim {

/// Rational polynomial coefficients (RPC00B): with latitude P, longitude L and height H less their
/// offsets and over their scales, each a polynomial of 20 terms
///
///     line   = line_off   + line_scale   N_l(P, L, H) / D_l(P, L, H)
///     sample = sample_off + sample_scale N_s(P, L, H) / D_s(P, L, H)
///
/// of the terms 1, L, P, H, LP, LH, PH, LL, PP, HH, PLH, LLL, LPP, LHH, LLP, PPP, PHH, LLH, PPH,
/// HHH. Source: STDI-0002, "The Compendium of Controlled Extensions for NITF", appendix E, RPC00B.
/// Offsets here count as everywhere in this program: (0.5, 0.5) is the centre of the first pixel.
struct Rpc {
  double line_off = 0.0, line_scale = 1.0;
  double sample_off = 0.0, sample_scale = 1.0;
  double latitude_off = 0.0, latitude_scale = 1.0;    // deg
  double longitude_off = 0.0, longitude_scale = 1.0;  // deg
  double height_off = 0.0, height_scale = 1.0;        // m
  std::array<double, 20> line_numerator{}, line_denominator{};
  std::array<double, 20> sample_numerator{}, sample_denominator{};
};

/// Where a place appears: x the sample, y the line.
[[nodiscard]] Vec2 image_of(const Rpc& rpc, const geometry::Geodetic& place);

/// A place of the image and one of the earth that appears there.
struct RpcPoint {
  Vec2 image;
  geometry::Geodetic place;
};

struct RpcFit {
  Rpc rpc;
  double rms_px = 0.0, largest_px = 0.0;  ///< distance between fit and `checks`
};

/// What 78 coefficients want at least.
inline constexpr std::size_t least_rpc_points = 100;

/// Fits the 78 coefficients to points that fill the image and a range of heights: least squares,
/// weighted anew with the denominator that the last turn found (Tao and Hu, "A comprehensive study
/// of the rational function model", PE&RS 67, 1347, 2001), and of the regularisations that serve
/// about as well the strongest, so that terms which the view does not need stay small.
/// @param points  at least `least_rpc_points`
/// @param checks  other points of the same view, which judge the fit
/// @return        none where no fit has denominators clear of zero, or points are too few
[[nodiscard]] std::optional<RpcFit> fit_rpc(const std::vector<RpcPoint>& points,
                                            const std::vector<RpcPoint>& checks);

}  // namespace nadir::sim
