#include "atmosphere/particles/haze_profile.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {
namespace {

using Extinction = std::vector<double>;

/// Where the tables' heights and true ones meet: LOWTRAN's 6 km, and 1 km of air at least.
double meeting_km(double ground_km) { return std::max(6.0, ground_km + 1.0); }

Extinction mixed(const Extinction& a, const Extinction& b, double share_of_b) {
  Extinction result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.push_back(a[i] + share_of_b * (b[i] - a[i]));
  }
  return result;
}

/// Linear in 1 / visibility between the two visibilities.
double share(double visibility_km, double a_km, double b_km) {
  return (1.0 / visibility_km - 1.0 / a_km) / (1.0 / b_km - 1.0 / a_km);
}

/// Extinction of particles at the ground, km^-1: Koschmieder's law less the air's own scattering.
/// Source: Kneizys et al., AFGL-TR-88-0177 (1988), section on visibility.
double koschmieder(double visibility_km) { return 3.912 / visibility_km - 0.01159; }

/// What is left of the haze of 50 km visibility.
double thinning(double visibility_km) {
  if (visibility_km <= 50.0) return 1.0;
  return std::max(0.0, koschmieder(visibility_km) / koschmieder(50.0));
}

Extinction boundary_layer(const ParticleTables& tables, double visibility_km) {
  constexpr std::array<int, 5> tabulated{50, 23, 10, 5, 2};
  std::size_t i = 0;
  while (i + 2 < tabulated.size() && visibility_km < tabulated[i + 1]) ++i;
  const int a = tabulated[i], b = tabulated[i + 1];
  return mixed(tables.haze.at("boundary_" + std::to_string(a)),
               tables.haze.at("boundary_" + std::to_string(b)),
               share(std::min(visibility_km, 50.0), a, b));
}

Extinction troposphere(const ParticleTables& tables, const std::string& season,
                       double visibility_km) {
  return mixed(tables.haze.at("tropospheric_" + season + "_50"),
               tables.haze.at("tropospheric_" + season + "_23"),
               share(std::clamp(visibility_km, 23.0, 50.0), 50.0, 23.0));
}

std::string name_of(Season season) {
  return season == Season::spring_summer ? "spring_summer" : "autumn_winter";
}

std::string name_of(Volcanic state) {
  switch (state) {
    case Volcanic::moderate:
      return "moderate";
    case Volcanic::high:
      return "high";
    case Volcanic::extreme:
      return "extreme";
    default:
      return "background";
  }
}

/// Integral over part of the way between two heights, exponential, or linear where one end is 0.
/// @param part  0 to 1, from the lower end
double partial(double lower, double upper, double part) {
  if (lower <= 0.0 || upper <= 0.0) return part * (lower + 0.5 * part * (upper - lower));
  const double fall = std::log(upper / lower);
  const double grown = fall * part;
  // expm1(x) / x, 1 at 0
  return lower * part * (std::abs(grown) < 1e-12 ? 1.0 : std::expm1(grown) / grown);
}

/// Integral from the ground of the tables up to a height.
double depth_to(const std::vector<double>& height_km, const Extinction& extinction, double to_km) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < height_km.size() && height_km[i] < to_km; ++i) {
    const double thickness = height_km[i + 1] - height_km[i];
    const double part = std::min(1.0, (to_km - height_km[i]) / thickness);
    sum += thickness * partial(extinction[i], extinction[i + 1], part);
  }
  return sum;
}

}  // namespace

double squeezed_km(double table_km, double ground_km) noexcept {
  const double meeting = meeting_km(ground_km);
  if (table_km >= meeting) return table_km;
  return ground_km + table_km * (meeting - ground_km) / meeting;
}

HazeProfile::HazeProfile(const ParticleTables& tables, const Aerosol& aerosol, double visibility_km,
                         double ground_height_m)
    : tables_{tables}, ground_km_{1e-3 * ground_height_m} {
  const std::string season = name_of(aerosol.season), state = name_of(aerosol.volcanic);
  extinction_[0] = boundary_layer(tables, visibility_km);
  extinction_[1] = troposphere(tables, season, visibility_km);
  extinction_[2] = tables.haze.at("stratospheric_" + season + "_" + state);
  // the upper air knows no "high": LOWTRAN takes that of moderate eruptions for it
  extinction_[3] = tables.haze.at("upper_" + (state == "high" ? "moderate" : state));
  for (const std::size_t region : {0U, 1U}) {
    for (double& value : extinction_[region]) value *= thinning(visibility_km);
  }
}

double HazeProfile::depth_below(int region, double height_m) const {
  const Extinction& extinction = extinction_[static_cast<std::size_t>(region)];
  const double height_km = 1e-3 * height_m, meeting = meeting_km(ground_km_);
  const double squeeze = (meeting - ground_km_) / meeting;
  if (height_km <= meeting) {
    return squeeze * depth_to(tables_.height_km, extinction, (height_km - ground_km_) / squeeze);
  }
  const double below = depth_to(tables_.height_km, extinction, meeting);
  return depth_to(tables_.height_km, extinction, height_km) - below * (1.0 - squeeze);
}

double HazeProfile::column() const {
  double sum = 0.0;
  for (int region = 0; region < regions; ++region) {
    sum += depth_below(region, 1e3 * tables_.height_km.back());
  }
  return sum;
}

double visibility_of_depth(const ParticleTables& tables, const Aerosol& aerosol,
                           double ground_height_m) {
  const double wanted = aerosol.optical_depth_550.value_or(0.0);
  const auto column = [&](double inverse_km) {
    return HazeProfile{tables, aerosol, 1.0 / inverse_km, ground_height_m}.column();
  };
  double low = 1.0 / HazeProfile::clean_air_km, high = 1e3;  // 1 / km
  if (!(wanted >= column(low) && wanted <= column(high))) {
    throw InputError{"the haze cannot have an optical depth of " + number_text(wanted) +
                     " at 0.55 um: the air above 10 km alone has " + number_text(column(low)) +
                     ", fog with a view of 1 m " + number_text(column(high))};
  }
  for (int i = 0; i < 60; ++i) {  // the geometric mean: 60 halvings end at rounding
    const double middle = std::sqrt(low * high);
    (column(middle) <= wanted ? low : high) = middle;
  }
  return 1.0 / low;
}

}  // namespace nadir::atmosphere
