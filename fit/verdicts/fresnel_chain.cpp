#include "fit/verdicts/fresnel_chain.hpp"

#include <algorithm>

#include "approx/ledger/catalogue.hpp"
#include "fit/verdicts/published_curve.hpp"

namespace shadefit {
namespace {

Surface surface_of(const OpticalConstants& constants, Surface::Formula formula) {
  return {formula, constant<double>(constants.ior), constant<double>(constants.extinction)};
}

FresnelLink link(const OpticalConstants& constants, const FittableFamily& family, std::string_view published,
                 const std::vector<double>& parameters, Status status) {
  const Surface exact = surface_of(constants, Surface::Formula::exact);
  FresnelLink result{
      &constants, normal_reflectance<double>(exact), &family, published, parameters, status, {}, {}};
  if (status != Status::converged) return result;
  result.from_schlick =
      family.reflectance_error(surface_of(constants, Surface::Formula::schlick), parameters);
  result.from_exact = family.reflectance_error(exact, parameters);
  return result;
}

void append_links(std::vector<FresnelLink>& chain, const OpticalConstants& constants,
                  const std::vector<const FittableFamily*>& families) {
  const Surface exact = surface_of(constants, Surface::Formula::exact);
  chain.push_back({&constants,
                   normal_reflectance<double>(exact),
                   nullptr,
                   "",
                   {},
                   Status::converged,
                   {},
                   schlick_against_exact(exact.ior, exact.extinction)});
  for (const FittableFamily* family : families) {
    for (const Published& published : published_constants) {
      // a curve of several parameters is named by its first
      if (published.family != family->info.id || published.parameter != family->parameters.front()) continue;
      chain.push_back(link(constants, *family, published.id, published_parameters(*family, published),
                           Status::converged));
    }
    const Fit fit = family->fit({0, exact}, {});
    chain.push_back(link(constants, *family, "", fit.parameters, fit.status));
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
