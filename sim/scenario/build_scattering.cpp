#include <fmt/format.h>

#include <map>

#include "core/quantity.hpp"
#include "sim/scenario/build_material.hpp"

namespace nadir::sim {
namespace {

SpectralInput spectrum(const CheckedElement& element, const char* attribute) {
  return element.value<SpectralInput>(attribute);
}

struct Roughness {
  double x = 0.1, y = 0.1;
};

Roughness roughness(const BuildContext& context, const CheckedElement& element) {
  const bool one = element.gives("alpha");
  const bool x = element.gives("alpha_x"), y = element.gives("alpha_y");
  if (one ? x || y : !(x && y)) {
    context.mistake(element.offset, fmt::format("<{}> needs either alpha, or alpha_x and alpha_y",
                                                element.type->name));
  }
  const double both = element.find<double>("alpha").value_or(0.1);
  return {element.find<double>("alpha_x").value_or(both),
          element.find<double>("alpha_y").value_or(both)};
}

/// An attribute that means something only beside another.
void check_needs(const BuildContext& context, const CheckedElement& element, const char* attribute,
                 const char* needed) {
  if (!element.gives(attribute) || element.gives(needed)) return;
  context.mistake(element.where(attribute), fmt::format("{} of <{}> needs {} as well", attribute,
                                                        element.type->name, needed));
}

ScatteringInput lambertian(const BuildContext& /*context*/, const CheckedElement& /*element*/) {
  return materials::Lambertian{};
}
ScatteringInput oren_nayar(const BuildContext& /*context*/, const CheckedElement& element) {
  return materials::OrenNayar{element.number("slope_sigma_deg") * radians_per_degree};
}
ScatteringInput minnaert(const BuildContext& /*context*/, const CheckedElement& element) {
  return materials::Minnaert{element.number("k")};
}
ScatteringInput leaf(const BuildContext& /*context*/, const CheckedElement& /*element*/) {
  return materials::Leaf{};
}
ScatteringInput mirror(const BuildContext& context, const CheckedElement& element) {
  check_needs(context, element, "k", "n");
  return MirrorInput{element.find<SpectralInput>("n"), element.find<SpectralInput>("k")};
}
ScatteringInput clear_sheet(const BuildContext& context, const CheckedElement& element) {
  check_needs(context, element, "absorption", "n");
  return ClearSheetInput{element.find<SpectralInput>("n"),
                         element.find<SpectralInput>("absorption")};
}
ScatteringInput ward(const BuildContext& context, const CheckedElement& element) {
  const Roughness alpha = roughness(context, element);
  return WardInput{spectrum(element, "specular"), alpha.x, alpha.y, element.number("azimuth_deg")};
}
ScatteringInput microfacet(const BuildContext& context, const CheckedElement& element) {
  const Roughness alpha = roughness(context, element);
  MicrofacetInput model{element.value<std::string>("slopes") == "beckmann"
                            ? materials::SlopeDistribution::beckmann
                            : materials::SlopeDistribution::ggx,
                        alpha.x,
                        alpha.y,
                        element.number("azimuth_deg"),
                        spectrum(element, "n"),
                        spectrum(element, "k"),
                        element.flag("transmits")};
  const double* k = std::get_if<double>(&model.k.source);
  if (model.transmits && (k == nullptr || *k != 0.0)) {
    context.mistake(element.where("transmits"),
                    "a <microfacet> that transmits is of clear glass: k must be 0");
  }
  return model;
}
ScatteringInput priest_germer(const BuildContext& /*context*/, const CheckedElement& element) {
  return PriestGermerInput{spectrum(element, "n"), spectrum(element, "k"),
                           element.number("slope_sigma")};
}
ScatteringInput cox_munk(const BuildContext& /*context*/, const CheckedElement& element) {
  return CoxMunkInput{element.number("wind_speed_m_s"), element.number("wind_azimuth_deg"),
                      spectrum(element, "n"),           spectrum(element, "k"),
                      spectrum(element, "water_body"),  element.flag("foam")};
}
ScatteringInput ross_li(const BuildContext& /*context*/, const CheckedElement& element) {
  return RossLiInput{spectrum(element, "isotropic"), spectrum(element, "volumetric"),
                     spectrum(element, "geometric")};
}
ScatteringInput rahman_pinty_verstraete(const BuildContext& /*context*/,
                                        const CheckedElement& element) {
  return RahmanPintyVerstraeteInput{spectrum(element, "rho0"), spectrum(element, "k"),
                                    spectrum(element, "asymmetry"),
                                    element.find<SpectralInput>("rho_c")};
}
ScatteringInput hapke(const BuildContext& /*context*/, const CheckedElement& element) {
  HapkeInput model;
  model.single_scattering_albedo = spectrum(element, "single_scattering_albedo");
  model.rest.asymmetry_b = element.number("asymmetry_b");
  model.rest.asymmetry_c = element.number("asymmetry_c");
  model.rest.opposition_b0 = element.number("opposition_b0");
  model.rest.opposition_h = element.number("opposition_h");
  model.rest.mean_slope_rad = element.number("mean_slope_deg") * radians_per_degree;
  return model;
}
ScatteringInput measured(const BuildContext& /*context*/, const CheckedElement& element) {
  return MeasuredInput{element.value<std::filesystem::path>("file")};
}
ScatteringInput mixture(const BuildContext& /*context*/, const CheckedElement& /*element*/) {
  return MixtureInput{};
}

using Builder = ScatteringInput (*)(const BuildContext&, const CheckedElement&);

const std::map<std::string, Builder>& builders() {
  static const std::map<std::string, Builder> table{
      {"lambertian", lambertian},
      {"oren_nayar", oren_nayar},
      {"minnaert", minnaert},
      {"leaf", leaf},
      {"mirror", mirror},
      {"clear_sheet", clear_sheet},
      {"ward", ward},
      {"microfacet", microfacet},
      {"priest_germer", priest_germer},
      {"cox_munk", cox_munk},
      {"ross_li", ross_li},
      {"rahman_pinty_verstraete", rahman_pinty_verstraete},
      {"hapke", hapke},
      {"measured", measured},
      {"mixture", mixture}};
  return table;
}

/// Resolves mixtures depth first, each once.
class MixtureResolver {
 public:
  MixtureResolver(const BuildContext& context, const std::vector<const CheckedElement*>& elements,
                  const FindPart& find, std::vector<MaterialInput>& materials)
      : context_{context},
        elements_{elements},
        find_{find},
        materials_{materials},
        state_(materials.size(), State::untouched),
        shared_(materials.size()) {}

  void resolve(std::size_t i) {
    if (state_[i] != State::untouched) return;
    state_[i] = State::open;
    const CheckedElement* element = elements_[i]->child("mixture");
    auto* mixture = std::get_if<MixtureInput>(&materials_[i].scattering);
    if (element != nullptr && mixture != nullptr) fill(i, *element, *mixture);
    state_[i] = State::done;
  }

 private:
  enum class State { untouched, open, done };

  void fill(std::size_t i, const CheckedElement& element, MixtureInput& mixture) {
    double sum = 0.0;
    for (const CheckedElement& part : element.children) {
      sum += part.number("weight");
      const auto found = find_(part);
      if (!found) continue;
      if (state_[*found] == State::open) {
        context_.mistake(
            part.where("material"),
            fmt::format("the mixture \"{}\" would contain itself", materials_[i].name));
        continue;
      }
      resolve(*found);
      if (!shared_[*found]) {
        shared_[*found] = std::make_shared<const MaterialInput>(materials_[*found]);
      }
      mixture.parts.push_back({part.number("weight"), shared_[*found]});
    }
    // Binding refuses mixtures that gain energy, which depends on the parts.
    if (std::abs(sum - 1.0) > 1e-6) {
      context_.warn(element.offset, fmt::format("the weights of the mixture \"{}\" sum to {:.6g}, "
                                                "not to 1",
                                                materials_[i].name, sum));
    }
  }

  const BuildContext& context_;
  const std::vector<const CheckedElement*>& elements_;
  const FindPart& find_;
  std::vector<MaterialInput>& materials_;
  std::vector<State> state_;
  std::vector<std::shared_ptr<const MaterialInput>> shared_;
};

struct BringsSpectra {
  bool operator()(const materials::Lambertian& /*model*/) const { return false; }
  bool operator()(const materials::OrenNayar& /*model*/) const { return false; }
  bool operator()(const materials::Minnaert& /*model*/) const { return false; }
  bool operator()(const materials::Leaf& /*model*/) const { return false; }
  bool operator()(const WardInput& /*model*/) const { return false; }
  bool operator()(const PriestGermerInput& /*model*/) const { return false; }
  bool operator()(const MirrorInput& model) const { return model.n.has_value(); }
  bool operator()(const ClearSheetInput& model) const { return model.n.has_value(); }
  template <class Other>
  bool operator()(const Other& /*model*/) const {
    return true;
  }
};

}  // namespace

bool brings_spectra(const ScatteringInput& scattering) {
  return std::visit(BringsSpectra{}, scattering);
}

const CheckedElement* scattering_element(const CheckedElement& material) {
  for (const CheckedElement& child : material.children) {
    if (builders().contains(child.type->name)) return &child;
  }
  return nullptr;
}

std::optional<ScatteringInput> build_scattering(const BuildContext& context,
                                                const CheckedElement& material) {
  std::optional<ScatteringInput> model;
  const CheckedElement* first = scattering_element(material);
  for (const CheckedElement& child : material.children) {
    const auto builder = builders().find(child.type->name);
    if (builder == builders().end()) continue;
    if (&child != first) {
      context.mistake(child.offset,
                      fmt::format("a material has one scattering model; <{}> stands in line {} "
                                  "already",
                                  first->type->name, context.source.locate(first->offset).line),
                      "<mixture> adds the scattering of several materials");
    }
    ScatteringInput built = builder->second(context, child);
    if (!model) model = std::move(built);
  }
  return model;
}

void resolve_mixtures(const BuildContext& context,
                      const std::vector<const CheckedElement*>& elements, const FindPart& find,
                      std::vector<MaterialInput>& materials) {
  MixtureResolver resolver{context, elements, find, materials};
  for (std::size_t i = 0; i < materials.size(); ++i) resolver.resolve(i);
}

}  // namespace nadir::sim
