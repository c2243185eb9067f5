// The complex refractive indices that ship under scenes/library/optics.
#include <filesystem>
#include <string>

#include "sim/files/spectrum_file.hpp"
#include "support/catch.hpp"

using namespace nadir;
using sim::SpectrumQuantity;
using spectral::Curve;
using spectral::Outside;

namespace {

namespace fs = std::filesystem;
const fs::path optics = fs::path{NADIR_SOURCE_DIR} / "scenes" / "library" / "optics";

struct Index {
  Curve n, k;
  explicit Index(const fs::path& file)
      : n{sim::read_curve(file, "n", SpectrumQuantity::refractive_index, Outside::reject)},
        k{sim::read_curve(file, "k", SpectrumQuantity::extinction_coefficient, Outside::reject)} {}

  /// Fresnel at normal incidence (Born & Wolf, section 14.2).
  [[nodiscard]] double reflectance(Micrometres at) const {
    const double a = n.at(at), b = k.at(at);
    return ((a - 1.0) * (a - 1.0) + b * b) / ((a + 1.0) * (a + 1.0) + b * b);
  }
};

double reflectance(const char* name, Micrometres at) {
  return Index{optics / (std::string{name} + ".csv")}.reflectance(at);
}

}  // namespace

TEST_CASE("every shipped refractive index is that of passive matter, to 14 um", "[sim][library]") {
  int files = 0;
  for (const auto& entry : fs::directory_iterator{optics}) {
    CAPTURE(entry.path().string());
    ++files;
    const Index index{entry.path()};
    CHECK(index.n.min_value() > 0.0);
    CHECK(index.k.min_value() >= 0.0);
    CHECK(index.n.covers(5.0_um, 14.0_um));
    CHECK(index.k.covers(5.0_um, 14.0_um));
  }
  CHECK(files == 12);
}

// Freshly evaporated mirrors, G. Hass in the American Institute of Physics Handbook, 3rd ed.
// (1972), table 6g. Films differ by up to 1 %; gold at its absorption edge by 3 %.
TEST_CASE("metals reflect as evaporated mirrors do", "[sim][library]") {
  CHECK(reflectance("aluminium", 0.55_um) == Approx(0.915).margin(0.01));
  CHECK(reflectance("aluminium", 0.85_um) == Approx(0.867).margin(0.01));  // the interband dip
  CHECK(reflectance("aluminium", 10.0_um) == Approx(0.987).margin(0.01));
  CHECK(reflectance("silver", 0.40_um) == Approx(0.956).margin(0.01));
  CHECK(reflectance("silver", 0.65_um) == Approx(0.988).margin(0.01));
  CHECK(reflectance("silver", 10.0_um) == Approx(0.995).margin(0.01));
  CHECK(reflectance("gold", 0.40_um) == Approx(0.387).margin(0.03));
  CHECK(reflectance("gold", 0.65_um) == Approx(0.955).margin(0.01));
  CHECK(reflectance("gold", 10.0_um) == Approx(0.994).margin(0.01));
}

// n = 1.339 at 0.5 um, 1.153 + 0.0968 i at 11 um (Hale & Querry, Appl. Opt. 12, 555, 1973).
TEST_CASE("water reflects 2 % of sunlight and less than 1 % at 11 um", "[sim][library]") {
  CHECK(reflectance("water", 0.5_um) == Approx(0.0209).margin(3e-4));
  CHECK(reflectance("water", 11.0_um) == Approx(0.0070).margin(1.5e-3));  // between the two authors
  CHECK(reflectance("ice", 0.5_um) == Approx(0.0183).margin(2e-4));       // n = 1.313
}
