#pragma once

#include <vector>

#include "fit/proof/certificate.hpp"

/// Certificates of every family, every kind of target and error.
namespace shadefit::testing {

inline std::vector<Subject> certified_subjects() {
  const auto lobe = [](const char* family, std::vector<std::pair<std::string, std::string>> parameters,
                       double exponent, Error error = Error::absolute) {
    return Subject{family, std::move(parameters), exponent, error, {}};
  };
  const auto fresnel = [](const char* family, std::vector<std::pair<std::string, std::string>> parameters,
                          const Surface& surface = {}, Error error = Error::absolute, Domain domain = {}) {
    return Subject{family, std::move(parameters), {0, surface}, error, domain};
  };
  Surface any;
  any.f0 = 0.25;
  const std::vector<std::pair<std::string, std::string>> pair{{"a", "-5.55473"}, {"b", "-6.98316"}};
  return {
      lobe("sg-offset", {{"x", "0.788"}}, 5),
      lobe("sg-offset", {{"x", "0x1.8p-1"}}, 37.5, Error::relative),
      lobe("sg-offset", {{"x", "0.25"}}, 0.5),
      lobe("phong-blinn", {{"x", "0x1.1412ab55349fap+2"}}, 5),
      lobe("sg-scaled", {{"A", "0x1.0c1a98e3a849fp+0"}, {"x", "0.5"}}, 5),
      fresnel("fresnel-quadratic", pair),
      fresnel("fresnel-quadratic", pair, any, Error::relative),
      fresnel("fresnel-quadratic", pair, exact_surface(0.6667)),
      fresnel("fresnel-quadratic", pair, exact_surface(0.25, 3.5), Error::relative),
      fresnel("fresnel-one-term", {{"A", "8.35"}}, exact_surface(1.5)),
      fresnel(
          "fresnel-cubic",
          {{"a", "-0x1.6129b66fcbd1p+2"}, {"b", "-0x1.58644bc7daaf8p+1"}, {"d", "-0x1.d1cc69e9c9c99p+2"}}),
      fresnel("fresnel-quartic", {{"a", "-0x1.af43f25b74f6ep+2"},
                                  {"b", "0x1.8f67217b7a49ep-3"},
                                  {"d", "-0x1.0389d83629f51p+2"},
                                  {"g", "-0x1.cc43ddf0fa925p+2"}}),
      fresnel("fresnel-fourth", {{"s", "0.9"}}, schlick_surface(1.5), Error::relative),
      fresnel("fresnel-square", {{"a", "0x1.1999999999999p+1"}, {"b", "-0x1.6eeeeeeeeeeefp+1"}}),
      fresnel("fresnel-rational", {{"a", "1.27"}}, schlick_surface(1.33), Error::absolute, {0.25, 0.75}),
  };
}

}  // namespace shadefit::testing
