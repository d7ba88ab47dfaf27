#pragma once

#include <tuple>

#include "approx/normalisation.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of normalised lobes.
inline auto normalisation_formulas() {
  using Lobes = Arguments;
  return std::tuple{
      Formula{"LambertLobe::constant", [](auto a) { return LambertLobe::constant(a); }, Lobes{{"1"}}, 4},
      Formula{"PhongLobe::constant", [](auto a) { return PhongLobe::constant(a); }, Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"PhongBrdfLobe::lobe", [](auto y, auto a) { return PhongBrdfLobe::lobe(y, a); },
              Lobes{{"0.25", "8"}}, 16},
      Formula{"PhongBrdfLobe::constant", [](auto a) { return PhongBrdfLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"BlinnPhongLobe::constant", [](auto a) { return BlinnPhongLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 8},
      Formula{"BlinnPhongBrdfLobe::lobe", [](auto y, auto a) { return BlinnPhongBrdfLobe::lobe(y, a); },
              Lobes{{"0.25", "8"}}, 16},
      Formula{"BlinnPhongBrdfLobe::constant", [](auto a) { return BlinnPhongBrdfLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 8},
      Formula{"BlinnPhongCheapLobe::constant", [](auto a) { return BlinnPhongCheapLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"MicrofacetLobe::lobe", [](auto y, auto a) { return MicrofacetLobe::lobe(y, a); },
              Lobes{{"0.25", "8"}}, 16},
      Formula{"MicrofacetLobe::constant", [](auto a) { return MicrofacetLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 4},
  };
}

}  // namespace shadefit::testing
