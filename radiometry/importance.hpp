#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/vec.hpp"
#include "materials/bound_material.hpp"
#include "radiometry/quad_hemisphere.hpp"

namespace nadir::radiometry {

/// What a table of importances asks about a surface. Local frame as for scattering.
struct ImportanceSource {
  /// Lane mean of f(wi, wo) |cos(wi)|, in sr^-1, without deltas.
  std::function<double(Vec3 wi, Vec3 wo)> scattered;
  /// A direction where `scattered` may be large for this view, number 0, 1, ... below likely_count,
  /// so that no lobe slips through between the points of a quad. May be empty: the mirror
  /// direction, the one straight through and the one straight back are tried at any rate.
  std::function<std::optional<Vec3>(Vec3 wo, int number)> likely;
  bool transmits = false;
  /// False: turning wi and wo together about z changes nothing, nor does a mirror at a plane
  /// through z.
  bool anisotropic = false;

  static constexpr int likely_count = 8;
};

/// How the quads of a table lie around a view direction, in the local frame: they are counted from
/// the azimuth of the view, and those of opaque materials lie on its side.
struct QuadTurn {
  double cosine = 1.0, sine = 0.0;  ///< of the azimuth that quads are turned by
  double side = 1.0;                ///< -1: seen from behind

  /// The direction (of QuadHemisphere::direction) as wi for this view.
  [[nodiscard]] Vec3 operator()(Vec3 quad_direction) const noexcept {
    return {cosine * quad_direction.x - sine * quad_direction.y,
            sine * quad_direction.x + cosine * quad_direction.y, side * quad_direction.z};
  }
  /// The inverse.
  [[nodiscard]] Vec3 back(Vec3 wi) const noexcept {
    return {cosine * wi.x + sine * wi.y, cosine * wi.y - sine * wi.x, side * wi.z};
  }
};

/// Peakedness above which a lobe is too narrow for quads.
///
/// With samples spread evenly over a quad whose largest value is R times its mean, the variance of
/// one sample is at most (R - 1) times the squared mean; a lobe that lies within one quad fills
/// 1 / R of it. The cosine alone never exceeds R = 2 (at the rim, where it grows from 0). Measured
/// on GGX lobes (F = 1) with 10 x 20 quads: roughness 0.3 and more: 1; 0.2: 4.5; 0.15: 9.0; 0.1:
/// 32; 0.05: 74. A rough roof (Ward, 0.15) had twice the efficiency when sampled by its lobe at
/// every number of quads that was tried, also where this ratio was 4 to 6.
inline constexpr double lobe_is_narrow = 4.0;

/// How much each quad matters for each view direction: the lane-averaged, unpolarised reflectance
/// (and transmittance) f |cos| of the material, brute-force mean over points of the quad, tabulated
/// when the scene is lit and stored as a low-rank non-negative factorisation V ~ W H. Where it is
/// used an importance never decides a value, only where samples go; a floor keeps every quad
/// reachable.
///
/// Quads 0 .. count - 1 are those of the hemisphere around +z; the next `count`, around -z, are
/// there only for materials that transmit. Quads are counted from the azimuth of wo, so that lobes
/// stay in their quads whatever it is. Opaque materials look alike from both sides: for a view from
/// below their quads are mirrored in z. `turn` does both. Deltas (mirrors, clear sheets) are left
/// out.
///
/// Points of a quad: two; quads that matter and vary get up to 4 x 4, and cells around the
/// directions where a lobe is expected are cut further until the lobe is resolved. Views: steps in
/// the square root of the cosine, so that they are dense towards grazing; between them W is
/// interpolated linearly.
/// Source: Lawrence, Rusinkiewicz & Ramamoorthi, "Efficient BRDF Importance Sampling Using a
/// Factored Representation", ACM TOG 23(3), 496 (2004); Lee & Seung, Nature 401, 788 (1999).
class ImportanceTable {
 public:
  /// @param tolerance  relative root-mean-square error of the factorisation that decides its rank,
  ///                   each view counting alike; the rank is at most 16 whatever it says
  ImportanceTable(const materials::BoundMaterial& material, const QuadHemisphere& quads,
                  double tolerance = 0.05);
  ImportanceTable(const ImportanceSource& source, const QuadHemisphere& quads,
                  double tolerance = 0.05);

  /// Whether a few views show already that the lobes are too narrow for quads: a table, which is
  /// dear for just these materials, would be made in vain.
  [[nodiscard]] static bool plainly_narrow(const materials::BoundMaterial& material,
                                           const QuadHemisphere& quads);

  [[nodiscard]] int quads() const noexcept { return quads_; }  ///< of both sides together
  [[nodiscard]] int views() const noexcept { return sides_ * mus_ * azimuths_; }
  [[nodiscard]] int rank() const noexcept { return rank_; }
  [[nodiscard]] double error() const noexcept { return error_; }  ///< reached, relative rms
  /// Largest ratio of the maximum to the mean of f |cos| within a quad that matters (carries 5 % of
  /// its view), over views of cosine 0.1 and more: a lobe narrower than a quad makes it large, and
  /// quads are then the wrong tool; see lobe_is_narrow. 1 where no quad matters that much, as for
  /// diffuse materials.
  [[nodiscard]] double peakedness() const noexcept { return peakedness_; }
  [[nodiscard]] std::size_t memory_bytes() const noexcept {
    return (views_.size() + parts_.size()) * sizeof(float);
  }

  [[nodiscard]] QuadTurn turn(Vec3 wo) const noexcept;
  /// Writes the importance of all quads, in sr^-1 (the mean of f |cos| over the quad and the
  /// lanes), for a view direction (local frame). Each is at least 2 % of their mean; all are 0
  /// where the surface scatters nothing. No allocation.
  void importance(Vec3 wo, double* of_quads) const noexcept;

 private:
  static constexpr int rank_limit = 16;

  /// Tabulated views around a view direction and their shares.
  struct Blend {
    std::array<std::size_t, 4> view{};
    std::array<double, 4> share{};
  };
  [[nodiscard]] Vec3 view_direction(int view) const noexcept;
  [[nodiscard]] Blend blend(Vec3 wo) const noexcept;
  void tabulate(const ImportanceSource& source, const QuadHemisphere& quads, double tolerance);

  bool transmits_ = false, anisotropic_ = false;
  int quads_ = 0, rank_ = 0;
  int sides_ = 1, mus_ = 0, azimuths_ = 1;
  double error_ = 0.0, peakedness_ = 1.0;
  std::vector<float> views_, parts_;  // W and H
  std::vector<float> part_means_;     // of the rows of H
};

}  // namespace nadir::radiometry
