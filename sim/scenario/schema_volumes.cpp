#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// Of a plume a thousand times as opaque as soot in a nanometre; beyond it float lanes overflow.
SpectralType coefficient() { return {from_to(0.0, 1e12)}; }

ElementType volume() {
  ElementType type{
      .id = "volume",
      .name = "volume",
      .doc =
          "A shape filled with something that absorbs, scatters and emits: plume, fog, cloud, "
          "haze. Has one shape and at most one phase function; without one it scatters alike "
          "in all directions. Volumes that overlap add up.",
      .attributes =
          {required("name", NameType{}, "", "Unique among the volumes."),
           defaulted("absorption_per_m", coefficient(), "m^-1", "0",
                     "Absorption coefficient, at density 1."),
           defaulted("scattering_per_m", coefficient(), "m^-1", "0",
                     "Scattering coefficient, at density 1."),
           optional("density_grid", PathType{{".nrrd"}}, "", "density 1 everywhere",
                    "Factor on both coefficients, on a grid that fills the box; docs/formats.md."),
           optional("temperature_k", temperature(), "K", "0: it does not emit",
                    "Thermodynamic temperature."),
           optional("temperature_grid", PathType{{".nrrd"}}, "", "temperature_k everywhere",
                    "Temperature in K, on a grid that fills the box; its size may differ from the "
                    "density's.")},
      .content = Content::record,
      .children = {{"volume_box"},
                   {"volume_sphere"},
                   {"volume_cylinder"},
                   {"henyey_greenstein"},
                   {"rayleigh"},
                   {"phase_table"}}};
  for (Attribute& attribute : scene_placement()) type.attributes.push_back(std::move(attribute));
  return type;
}

std::vector<ElementType> shapes() {
  const NumberType size = above_to(0.0, 1e7);
  const VectorType place{coordinate(), false};
  return {{.id = "volume_box",
           .name = "box",
           .doc = "A box with sides along the volume's axes; the only shape that takes grids.",
           .attributes = {required("lo_m", place, "m", "Corner of least x, y, z."),
                          required("hi_m", place, "m", "Corner of greatest x, y, z.")}},
          {.id = "volume_sphere",
           .name = "sphere",
           .doc = "A ball around the volume's origin.",
           .attributes = {required("radius_m", size, "m", "Radius.")}},
          {.id = "volume_cylinder",
           .name = "cylinder",
           .doc = "A cylinder from base to top, closed at both ends.",
           .attributes = {required("radius_m", size, "m", "Radius."),
                          defaulted("base_m", place, "m", "0 0 0", "Centre of one end."),
                          required("top_m", place, "m", "Centre of the other end.")}}};
}

std::vector<ElementType> phase_functions() {
  return {
      {.id = "henyey_greenstein",
       .name = "henyey_greenstein",
       .doc = "The phase function of Henyey and Greenstein (1941).",
       .attributes = {required("g", SpectralType{{-1.0, 1.0, true, true}}, "",
                               "Mean cosine of the scattering angle: 0 even, towards 1 forward.")}},
      {.id = "rayleigh",
       .name = "rayleigh",
       .doc = "The phase function of particles much smaller than the wavelength."},
      {.id = "phase_table",
       .name = "phase_table",
       .doc = "A phase function from a table over scattering angle and wavelength.",
       .attributes = {required("file", PathType{{".csv"}}, "",
                               "The table; docs/formats.md. It is normalised.")}}};
}

}  // namespace

std::vector<ElementType> schema_of_volumes() {
  std::vector<ElementType> all = {{.id = "volumes",
                                   .name = "volumes",
                                   .doc = "What light goes through rather than ends at.",
                                   .content = Content::list,
                                   .children = {{"volume"}},
                                   .at_least = 1},
                                  volume()};
  for (ElementType& type : shapes()) all.push_back(std::move(type));
  for (ElementType& type : phase_functions()) all.push_back(std::move(type));
  return all;
}

}  // namespace nadir::sim
