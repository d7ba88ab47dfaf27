#include <cmath>

#include "fit/proof/certificate.hpp"
#include "fit/proof/constants.hpp"

namespace shadefit {
namespace {

bool is_positive(double x) {
  return x > 0 && std::isfinite(x);
}

std::string fault_of_surface(const Surface& surface) {
  if (surface.f0 && surface.is_named()) return "a surface with an index of refraction has an f0 of its own";
  if (surface.f0 && !(0 <= *surface.f0 && *surface.f0 < 1))
    return "the f0 of the surface is not at least 0 and less than 1";
  if (!surface.is_named())
    return surface.is_exact() || surface.extinction != 0 ? "the surface has no index of refraction" : "";
  if (!is_positive(surface.ior)) return "the index of refraction is not greater than 0";
  if (!(surface.extinction >= 0 && std::isfinite(surface.extinction))) return "the extinction is negative";
  if (surface.ior == 1 && surface.extinction == 0)
    return "the index of refraction is 1 without extinction: nothing is reflected";
  if (!(normal_reflectance<double>(surface) < 1))
    return "the surface reflects all light at normal incidence: no reflectance is above f0";
  return "";
}

}  // namespace

std::string fault_of(const Subject& subject) {
  const FittableFamily* family = find_family(subject.family);
  if (family == nullptr) return "'" + subject.family + "' is not a family";
  const std::vector<std::string> known(family->parameters.begin(), family->parameters.end());
  if (std::string fault = fault_of_constants(subject.parameters, known, subject.family); !fault.empty())
    return fault;
  const Setting& setting = subject.setting;
  if (family->has_exponent() && !is_positive(setting.exponent)) return "the exponent is not greater than 0";
  if (!family->has_exponent() && setting.exponent != 0) return subject.family + " has no exponent";
  if (!family->is_fresnel() && setting.surface != Surface{})
    return subject.family + " is not a Fresnel form: it has no surface";
  if (std::string fault = fault_of_surface(setting.surface); !fault.empty()) return fault;
  const Domain& domain = subject.domain;
  if (!(0 <= domain.lower && domain.lower < domain.upper && domain.upper <= 1))
    return "the domain is not within [0, 1]";
  return "";
}

}  // namespace shadefit
