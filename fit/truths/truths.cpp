#include "fit/truths/truths.hpp"

#include <algorithm>

namespace shadefit {

std::span<const Truth> truths() {
  static const std::vector<Truth> all{
      {"ggx_albedo", {"c", "alpha"}, ""},
      {"ggx_albedo_separable", {"c", "alpha"}, ""},
      {"ggx_albedo_k", {"c", "alpha"}, ""},
      {"ggx_bias", {"c", "alpha"}, ""},
      {"ggx_bias_separable", {"c", "alpha"}, ""},
      {"ggx_bias_k", {"c", "alpha"}, ""},
      {"ggx_scale", {"c", "alpha"}, "ggx_albedo(c, alpha) - ggx_bias(c, alpha)"},
      {"ggx_scale_separable",
       {"c", "alpha"},
       "ggx_albedo_separable(c, alpha) - ggx_bias_separable(c, alpha)"},
      {"ggx_scale_k", {"c", "alpha"}, "ggx_albedo_k(c, alpha) - ggx_bias_k(c, alpha)"},
      {"charlie_albedo", {"c", "alpha"}, ""},
      {"imageworks_sheen_albedo", {"c", "alpha"}, ""},

      {"burley_albedo",
       {"c", "r"},
       "1 + (r - 1/2)*(1/21 + (1 - c)^5) + r c (1/84 + 2/3*(1 - c)^5)"
       " + (1 - c)^5*((r - 1/2)^2/21 + (r - 1/2)*r c/42 + r^2*(11/504 - c^2/56))"},
      // With s, the sine of the angle whose cosine is c.
      {"oren_nayar_part", {"c", "s"}, "s*(acos(c) - s c) + 2/3*s*(c (1 + s + s^2)/(1 + s))"},
      {"oren_nayar_albedo",
       {"c", "r"},
       "1 - 0.5 r^2/(r^2 + 0.33)"
       " + 0.45 r^2/(r^2 + 0.09)*oren_nayar_part(c, sqrt((1 - c)*(1 + c)))/pi"},
      {"fon_albedo",
       {"c", "r"},
       "(1 + r*(oren_nayar_part(c, sqrt((1 - c)*(1 + c))) - 2/3*sqrt((1 - c)*(1 + c)))/pi)"
       "/(1 + r*(1/2 - 2/(3 pi)))"},
      {"fon_average", {"r"}, "(1 + r*(2/3 - 28/(15 pi)))/(1 + r*(1/2 - 2/(3 pi)))"},
      {"eon_albedo",
       {"c", "r", "rho"},
       "rho fon_albedo(c, r)"
       " + rho^2*fon_average(r)*(1 - fon_albedo(c, r))/(1 - rho (1 - fon_average(r)))"},

      {"fresnel_average",
       {"n"},
       "1/2 + (n - 1)*(3 n + 1)/(6 (n + 1)^2) - 2 n^3*(n^2 + 2 n - 1)/((n^2 + 1)*(n^4 - 1))"
       " + n^2*(n^2 - 1)^2/(n^2 + 1)^3*log((n - 1)/(n + 1))"
       " + 8 n^4*(n^4 + 1)/((n^2 + 1)*(n^4 - 1)^2)*log(n)"},
      // With p = a^2 + b^2 and a, where (a + i b)^2 = (n + i k)^2 - s^2.
      {"conductor_of_parts",
       {"c", "p", "a"},
       "(p + c^2 - 2 a c)/(p + c^2 + 2 a c)"
       "*(1 + (c^2*p + (1 - c^2)^2 - 2 a c (1 - c^2))/(c^2*p + (1 - c^2)^2 + 2 a c (1 - c^2)))/2"},
      {"conductor_length", {"c", "n", "k"}, "sqrt((n^2 - k^2 - 1 + c^2)^2 + 4 n^2*k^2)"},
      {"conductor_reflectance",
       {"c", "n", "k"},
       "conductor_of_parts(c, conductor_length(c, n, k),"
       " sqrt((conductor_length(c, n, k) + n^2 - k^2 - 1 + c^2)/2))"},
      {"conductor_average", {"n", "k"}, "integral(2 t conductor_reflectance(t, n, k), t, 0, 1)"},

      {"hg", {"c", "g"}, "(1 - g^2)/(4 pi (1 + g^2 - 2 g c)^1.5)"},
  };
  return all;
}

const Truth* find_truth(std::string_view name) {
  const auto found = std::ranges::find(truths(), name, &Truth::name);
  return found == truths().end() ? nullptr : &*found;
}

}  // namespace shadefit
