#include "sim/files/lunar_table.hpp"

#include <array>

#include "core/error.hpp"
#include "sim/files/spectrum_file.hpp"

namespace nadir::sim {
namespace {

using ephemeris::LunarBand;

InputError mistake(const SpectrumFile& file, const std::string& problem) {
  InputIssue issue;
  issue.where.file = file.path;
  issue.message = problem;
  return InputError{std::move(issue)};
}

const SpectrumColumn& full_column(const SpectrumFile& file, const std::string& name,
                                  const SpectrumColumn& first) {
  const SpectrumColumn& column = file.column(name);
  if (column.wavelength_um != first.wavelength_um) {
    throw mistake(file, "column \"" + name + "\" has not the wavelengths of column \"" +
                            first.name + "\": every band needs every coefficient");
  }
  return column;
}

ephemeris::LunarModel model_in(const SpectrumFile& file) {
  if (file.quantity != SpectrumQuantity::parameter) {
    throw mistake(file, "the moon's reflectance needs a spectrum file of the quantity parameter");
  }
  const SpectrumColumn& first = file.column("a0");
  ephemeris::LunarModel model;
  for (const double um : first.wavelength_um) model.bands.push_back({Micrometres{um}, {}, {}, {}});
  const auto fill = [&](const std::string& name, auto&& coefficient) {
    const SpectrumColumn& column = full_column(file, name, first);
    for (std::size_t i = 0; i < model.bands.size(); ++i) {
      coefficient(model.bands[i]) = column.value[i];
    }
  };
  for (std::size_t i = 0; i < 4; ++i) {
    fill("a" + std::to_string(i), [i](LunarBand& band) -> double& { return band.a[i]; });
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i + 1);
    fill("b" + number, [i](LunarBand& band) -> double& { return band.b[i]; });
    fill("d" + number, [i](LunarBand& band) -> double& { return band.d[i]; });
  }
  fill("smoothing", [](LunarBand& band) -> double& { return band.smoothing; });
  return ephemeris::checked(std::move(model));
}

}  // namespace

ephemeris::LunarModel parse_lunar_model(std::string_view text, const std::string& path) {
  return model_in(parse_spectrum(text, path));
}

ephemeris::LunarModel read_lunar_model(const std::filesystem::path& path) {
  return model_in(read_spectrum_file(path));
}

}  // namespace nadir::sim
