#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// What a ray needs to know of the air, tabulated at some wavelengths: the neutral form in which
/// our own solver and tables from elsewhere alike hand over the air. Plain data; docs/air-tables.md
/// says how rays look it up, docs/air-table-format.md describes its file.
///
/// Light of a body that was scattered once keeps the phase functions apart, because they are
/// narrow, from what is smooth over directions:
///
///     L = sum over bodies { sum over kinds P_k(Theta) A_k(theta, u) + M(theta, phi, u) }
///         + E(theta, u) + G H(theta, u)
///
/// with Theta the angle between the direction looked in and the body, theta the zenith angle of
/// the direction looked in, phi the azimuth from the body, E what does not come from a body (the
/// air's emission, scattered; night sky), G the mean radiance of the ground about, H what an even
/// ground of radiance 1 adds to the path (not what comes straight). All per unit of nothing: A, M
/// and E are radiances at the body's stated irradiance, W m^-2 sr^-1 um^-1 (A over sr^-1 of P).
///
/// In `sky` these four are whole radiances. In `views` they are divided by 1 - T, with T =
/// exp(-extinction * measure) the transmittance of the same way: sources, which vary slowly along
/// the way and have a limit where it is short. Where T = 1 they are that limit, or 0.
///
/// Every array runs over lanes fastest.
struct AirTable {
  struct Lane {
    double wavelength_um = 0.0;
    spectral::AbsorptionLane absorption{};
    double weight = 1.0;  ///< of the term among those of its wavelength; they sum to 1
  };
  struct Body {
    std::string name;                      ///< "sun", "moon"
    double zenith_rad = 0.0;               ///< at the scene
    double azimuth_rad = 0.0;              ///< clockwise from north
    std::vector<float> irradiance;         ///< outside the air, by lane, W m^-2 um^-1
    std::vector<float> transmittance;      ///< from outside the air to the scene, by lane
    std::vector<float> ground_irradiance;  ///< direct and diffuse on the level, black ground
  };
  /// What is seen along directions from one height, to given shares of the way.
  struct View {
    double height_m = 0.0;            ///< of whoever looks, above sea level, ground_m to top_m
    std::vector<double> zenith_rad;   ///< ascending, local to that height; those below the horizon,
                                      ///< acos(horizon_mu()), end on the ground. Where there are
                                      ///< nodes on both sides, the horizon itself appears twice:
                                      ///< seen from just above and from just below
    std::vector<double> azimuth_rad;  ///< 0 to pi from a body; one entry where it does not matter
    std::vector<double> share;        ///< ascending, the last is 1: air_measure_m() of the piece of
                                      ///< the way over that of the whole way, way_to_end_m().
                                      ///< Before the first all is as at the first
    std::vector<float> extinction;  ///< [zenith][share][lane]: optical depth per metre of measure,
                                    ///< from the eye to there
    std::vector<float> first;       ///< [body][kind][zenith][share][lane]: A
    std::vector<float> smooth;      ///< [body][azimuth][zenith][share][lane]: M, may be negative
    std::vector<float> even;        ///< [zenith][share][lane]: E
    std::vector<float> ground;      ///< [zenith][share][lane]: H
    std::vector<float> night;  ///< [zenith][share][lane]: what of E comes from outside the air or
                               ///< from towns, the rest being emitted by it. May be empty: nothing

    /// Places along the ways: the entries of `extinction` for one lane.
    [[nodiscard]] std::size_t places() const { return zenith_rad.size() * share.size(); }
  };

  std::vector<Lane> lanes;             ///< ascending in wavelength, interval and term
  double top_m = 0.0, ground_m = 0.0;  ///< of the air; the ground that the scene stands on
  std::vector<Body> bodies;
  int kinds = 0;                   ///< of scatterers whose first scattering is kept apart
  std::vector<double> phase_grid;  ///< ascending: sqrt(sin(Theta / 2)), 0 to 1, even steps; may be
                                   ///< empty where there are no kinds
  std::vector<float> phase;        ///< [kind][angle][lane], sr^-1
  View sky;                        ///< from the ground, share = {1}
  std::vector<View> views;         ///< from the sensor, ascending heights, or none: then paths
                                   ///< change nothing. Eyes above the top are looked up at the top
  // The ground's part: all by lane.
  std::vector<float> spherical_albedo;         ///< of the air from below, below 1
  std::vector<float> even_ground_irradiance;   ///< what E brings to a black level ground
  std::vector<float> night_ground_irradiance;  ///< the night's part of that; may be empty: nothing
  std::vector<float> night_top;  ///< radiance of the night sky in the zenith outside the air; what
                                 ///< is seen of it is in E. May be empty
  // How it was made.
  std::string made_by;               ///< program and settings, one line
  std::vector<std::string> notes;    ///< what a user should know
  double interpolation_error = 0.0;  ///< largest relative error found by probing between nodes
};

/// The ground about the scene, which lights the air from below.
struct GroundLight {
  std::vector<float> reflectance;  ///< by lane of the table
  std::vector<float> emission;     ///< radiance, by lane of the table, W m^-2 sr^-1 um^-1
};

/// Sizes agree, axes ascend, the horizon is where it belongs, values are finite, none negative that
/// may not be.
/// @throws InputError that names the part
void check(const AirTable& table);

}  // namespace nadir::atmosphere
