// The shipped sunlight at the ground, and what it makes of shipped materials.
#include <filesystem>
#include <string>

#include "sim/files/spectrum_file.hpp"
#include "support/catch.hpp"
#include "thermal/surface/broadband_optics.hpp"

namespace {

using namespace nadir;
using namespace nadir::sim;
namespace fs = std::filesystem;

const fs::path shipped_sunlight = fs::path{NADIR_SOURCE_DIR} / "scenes" / "library";

spectral::Curve ground_sunlight() {
  return read_curve(shipped_sunlight / "illumination" / "sunlight_at_ground.csv", "",
                    SpectrumQuantity::irradiance, spectral::Outside::zero);
}

thermal::BroadbandOptics optics_of(const std::string& name) {
  materials::Material material;
  material.name = name;
  material.reflectance = read_curve(shipped_sunlight / "spectra" / (name + ".csv"), "",
                                    SpectrumQuantity::reflectance, spectral::Outside::hold);
  return thermal::broadband_optics(material, ground_sunlight());
}

}  // namespace

TEST_CASE("sunlight at the ground is the sun's less what the air takes", "[sim][library]") {
  const auto ground = ground_sunlight();
  const auto sun = read_curve(shipped_sunlight / "illumination" / "solar.csv", "",
                              SpectrumQuantity::irradiance, spectral::Outside::reject);
  const double mu = 2.0 / 3.0;
  const auto share = [&](double lo_um, double hi_um) {
    return ground.mean(Micrometres{lo_um}, Micrometres{hi_um}) /
           (mu * sun.mean(Micrometres{lo_um}, Micrometres{hi_um}));
  };
  CHECK(share(0.50, 0.60) == Approx(0.85).margin(0.05));  // haze and molecules
  CHECK(share(1.00, 1.06) == Approx(0.92).margin(0.04));  // a window
  CHECK(share(1.36, 1.41) < 0.05);                        // water
  CHECK(share(0.30, 0.31) < 0.1);                         // ozone
  // Half of all sunlight at the ground is visible or ultraviolet (ASTM G173: 0.51 below 0.75 um of
  // its direct light).
  CHECK(ground.mean(0.3_um, 0.75_um) * 0.45 / (ground.mean(0.3_um, 4.0_um) * 3.7) ==
        Approx(0.53).margin(0.03));
}

// Typical values: Oke, "Boundary Layer Climates" (1987), Incropera & DeWitt, ASHRAE: no two samples
// of such surfaces are alike, hence the wide margins.
TEST_CASE("shipped materials absorb sunlight and emit as handbooks say", "[sim][library]") {
  struct Case {
    const char* name;
    double absorptance, within, emissivity;
  };
  const auto one = GENERATE(Case{"asphalt_road", 0.90, 0.05, 0.95},        // albedo 0.05 to 0.20
                            Case{"concrete_weathered", 0.65, 0.10, 0.92},  // 0.10 to 0.35
                            Case{"brick_red", 0.68, 0.12, 0.93},           // 0.20 to 0.40
                            Case{"water", 0.95, 0.05, 0.985},              // 0.03 to 0.10
                            Case{"aluminium_polished", 0.10, 0.06, 0.03},
                            Case{"paint_black_on_metal", 0.96, 0.03, 0.92},
                            Case{"meadow_grass", 0.78, 0.08, 0.97},  // 0.16 to 0.30
                            Case{"sand", 0.60, 0.10, 0.92},          // 0.20 to 0.45
                            Case{"marble_white", 0.35, 0.15, 0.93});
  CAPTURE(one.name);
  const auto optics = optics_of(one.name);
  CHECK(optics.solar_absorptance == Approx(one.absorptance).margin(one.within));
  CHECK(optics.emissivity == Approx(one.emissivity).margin(0.05));
  // Spectra begin at 0.35 um and end at 14 um: 2 % of sunlight and half of a black body at 300 K
  // are not covered.
  CHECK(optics.solar_covered == Approx(0.98).margin(0.01));
  CHECK(optics.long_wave_covered == Approx(0.515).margin(0.03));
}
