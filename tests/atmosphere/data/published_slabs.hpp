#pragma once

#include <array>

namespace nadir::atmosphere::test {

/// Radiances and irradiances of homogeneous slabs over a black ground, as test problems 1 to 3 of
/// DISORT list them (Stamnes, Tsay & Laszlo, "DISORT, a general-purpose Fortran program for
/// discrete-ordinate-method radiative transfer ...", NASA report, 2000; file DISOTEST), there
/// compared with
///   1  van de Hulst, "Multiple Light Scattering" (1980), table 12: isotropic scattering,
///   2  Sweigart, Astrophys. J. Suppl. 22, 1 (1970), table 1: Rayleigh scattering,
///   3  van de Hulst (1980), table 35: Henyey-Greenstein scattering with g = 0.75.
struct PublishedSlab {
  const char* name;
  double depth, omega;
  double beam;                   ///< irradiance across its way; 0: even light of 1 from above
  double down, up;               ///< diffuse irradiance: down at the bottom, up at the top
  std::array<double, 3> top;     ///< radiance up at the top, for mu[3] to mu[5]
  std::array<double, 3> bottom;  ///< radiance down at the bottom, for mu[0] to mu[2]
};

inline constexpr double beam_hulst = 31.4159265358979;  // pi / mu0
inline constexpr double beam_sweigart = 3.14159265358979;

inline constexpr std::array<double, 6> mu_hulst{-1.0, -0.5, -0.1, 0.1, 0.5, 1.0};
inline constexpr double mu0_hulst = 0.1;
inline constexpr std::array<double, 6> mu_sweigart{-0.981986, -0.538263, -0.018014,
                                                   0.018014,  0.538263,  0.981986};
inline constexpr double mu0_sweigart = 0.080442;  // azimuth 0

inline constexpr std::array<PublishedSlab, 6> isotropic_slabs{{
    {"1a",
     0.03125,
     0.2,
     beam_hulst,
     7.94108e-2,
     7.99451e-2,
     {1.17771e-1, 2.64170e-2, 1.34041e-2},
     {1.33826e-2, 2.63324e-2, 1.15898e-1}},
    {"1b",
     0.03125,
     1.0,
     beam_hulst,
     4.20233e-1,
     4.22922e-1,
     {6.22884e-1, 1.39763e-1, 7.09192e-2},
     {7.08109e-2, 1.39337e-1, 6.13458e-1}},
    {"1c",
     0.03125,
     0.99,
     0.0,
     3.04897,
     9.06556e-2,
     {1.33177e-1, 2.99879e-2, 1.52233e-2},
     {9.84447e-1, 9.69363e-1, 8.63946e-1}},
    {"1d",
     32.0,
     0.2,
     beam_hulst,
     0.0,
     2.59686e-1,
     {2.62972e-1, 9.06967e-2, 5.02853e-2},
     {0.0, 0.0, 0.0}},
    {"1e",
     32.0,
     1.0,
     beam_hulst,
     6.76954e-2,
     3.07390,
     {1.93321, 1.02732, 7.97199e-1},
     {2.71316e-2, 1.87805e-2, 1.16385e-2}},
    {"1f",
     32.0,
     0.99,
     0.0,
     4.60048e-3,
     2.49618,
     {8.77510e-1, 8.15136e-1, 7.52715e-1},
     {1.86840e-3, 1.26492e-3, 7.79281e-4}},
}};

inline constexpr std::array<PublishedSlab, 4> rayleigh_slabs{{
    {"2a",
     0.2,
     0.5,
     beam_sweigart,
     4.41791e-2,
     5.35063e-2,
     {1.61796e-1, 2.11501e-2, 7.86713e-3},
     {7.71897e-3, 2.00778e-2, 2.57685e-2}},
    {"2b",
     0.2,
     1.0,
     beam_sweigart,
     1.06123e-1,
     1.25561e-1,
     {3.47678e-1, 4.87120e-2, 1.89387e-2},
     {1.86027e-2, 4.64061e-2, 6.77603e-2}},
    {"2c",
     5.0,
     0.5,
     beam_sweigart,
     2.51683e-4,
     6.24730e-2,
     {1.62566e-1, 2.45786e-2, 1.01498e-2},
     {1.70004e-4, 3.97168e-5, 1.32472e-5}},
    {"2d",
     5.0,
     1.0,
     beam_sweigart,
     2.68008e-2,
     2.25915e-1,
     {3.64010e-1, 8.26993e-2, 4.92370e-2},
     {1.05950e-2, 7.69337e-3, 3.79276e-3}},
}};

inline constexpr std::array<PublishedSlab, 6> henyey_greenstein_slabs{{
    {"3a",
     1.0,
     0.2,
     beam_hulst,
     4.70303e-2,
     1.69951e-1,
     {4.86923e-1, 5.08802e-2, 1.03351e-2},
     {7.88518e-3, 2.22081e-2, 2.90003e-3}},
    {"3b",
     1.0,
     1.0,
     beam_hulst,
     1.31455,
     1.82690,
     {3.72886, 6.32069e-1, 1.51211e-1},
     {2.13998e-1, 5.84010e-1, 3.77162e-1}},
    {"3c",
     1.0,
     0.99,
     0.0,
     2.49660,
     5.83122e-1,
     {5.66618e-1, 2.32213e-1, 7.60274e-2},
     {9.11175e-1, 7.44031e-1, 4.03607e-1}},
    {"3d",
     8.0,
     0.2,
     beam_hulst,
     1.99813e-5,
     1.70062e-1,
     {4.86926e-1, 5.09190e-2, 1.03691e-2},
     {2.07944e-5, 9.76964e-7, 1.88004e-7}},
    {"3e",
     8.0,
     1.0,
     beam_hulst,
     5.91973e-1,
     2.54962,
     {3.85776, 8.68015e-1, 3.79793e-1},
     {2.36362e-1, 1.64357e-1, 9.15016e-2}},
    {"3f",
     8.0,
     0.99,
     0.0,
     1.01167,
     1.68750,
     {7.57316e-1, 5.87262e-1, 4.33051e-1},
     {4.16334e-1, 2.75956e-1, 1.51785e-1}},
}};

/// Chandrasekhar's H function for isotropic scattering, from a solution of its integral equation in
/// double precision (agrees with Chandrasekhar, "Radiative Transfer" (1950), table XI).
inline constexpr std::array<double, 5> h_mu{0.10, 0.25, 0.50, 0.75, 1.00};
struct PublishedH {
  double omega;
  std::array<double, 5> h;
};
inline constexpr std::array<PublishedH, 5> h_isotropic{{
    {0.2, {1.025618, 1.043955, 1.061177, 1.071567, 1.078645}},
    {0.8, {1.138808, 1.266322, 1.413263, 1.518169, 1.598220}},
    {0.95, {1.195232, 1.400740, 1.671788, 1.891785, 2.077124}},
    {0.999, {1.240425, 1.526165, 1.958687, 2.365660, 2.756073}},
    {1.0, {1.247350, 1.547326, 2.012779, 2.463460, 2.907811}},
}};

}  // namespace nadir::atmosphere::test
