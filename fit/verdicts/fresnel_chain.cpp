#include "fit/verdicts/fresnel_chain.hpp"

#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

/// Of a published curve or of a refit; without a family of Schlick's formula.
FresnelLink link(const OpticalConstants& constants, const FittableFamily* family, std::string_view published,
                 const std::vector<double>& parameters, Status status) {
  const double ior = constant<double>(constants.ior), extinction = constant<double>(constants.extinction);
  const Surface exact = exact_surface(ior, extinction);
  FresnelLink result{&constants, normal_reflectance<double>(exact), family, published, parameters, status, {},
                     {}};
  if (status != Status::converged) return result;
  if (family == nullptr) {
    result.from_exact = schlick_against_exact(ior, extinction);
  } else {
    result.from_schlick = family->reflectance_error(schlick_surface(ior, extinction), parameters);
    result.from_exact = family->reflectance_error(exact, parameters);
  }
  return result;
}

void append_links(std::vector<FresnelLink>& chain, const OpticalConstants& constants,
                  const std::vector<const FittableFamily*>& families) {
  chain.push_back(link(constants, nullptr, "", {}, Status::converged));
  const Surface exact =
      exact_surface(constant<double>(constants.ior), constant<double>(constants.extinction));
  for (const FittableFamily* family : families) {
    for (const Published* number : numbers_of(family->info)) {
      // a curve of several parameters is named by its first
      if (number->parameter != family->parameters.front()) continue;
      chain.push_back(
          link(constants, family, number->id, published_parameters(*family, *number), Status::converged));
    }
    const Fit fit = family->fit({0, exact}, {});
    chain.push_back(link(constants, family, "", fit.parameters, fit.status));
  }
}

}  // namespace

std::vector<FresnelLink> fresnel_chain(const std::vector<const FittableFamily*>& families) {
  std::vector<FresnelLink> chain;
  if (families.empty()) return chain;
  for (const OpticalConstants& constants : dielectrics) append_links(chain, constants, families);
  for (const OpticalConstants& constants : metals) append_links(chain, constants, families);
  return chain;
}

}  // namespace shadefit
