#pragma once

#include "approx/normalisation.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of normalised lobes.
template <class Visit>
void normalisation_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{"LambertLobe::constant", [](auto a) { return LambertLobe::constant(a); }, Lobes{{"1"}}, 4});
  visit(Formula{"PhongLobe::constant", [](auto a) { return PhongLobe::constant(a); }, Lobes{{"0.5"}, {"8"}},
                4});
  visit(Formula{"PhongBrdfLobe::lobe", [](auto y, auto a) { return PhongBrdfLobe::lobe(y, a); },
                Lobes{{"0.25", "8"}}, 16});
  visit(Formula{"PhongBrdfLobe::constant", [](auto a) { return PhongBrdfLobe::constant(a); },
                Lobes{{"0.5"}, {"8"}}, 4});
  visit(Formula{"BlinnPhongLobe::constant", [](auto a) { return BlinnPhongLobe::constant(a); },
                Lobes{{"0.5"}, {"8"}}, 8});
  visit(Formula{"BlinnPhongBrdfLobe::lobe", [](auto y, auto a) { return BlinnPhongBrdfLobe::lobe(y, a); },
                Lobes{{"0.25", "8"}}, 16});
  visit(Formula{"BlinnPhongBrdfLobe::constant", [](auto a) { return BlinnPhongBrdfLobe::constant(a); },
                Lobes{{"0.5"}, {"8"}}, 8});
  visit(Formula{"BlinnPhongCheapLobe::constant", [](auto a) { return BlinnPhongCheapLobe::constant(a); },
                Lobes{{"0.5"}, {"8"}}, 4});
  visit(Formula{"MicrofacetLobe::lobe", [](auto y, auto a) { return MicrofacetLobe::lobe(y, a); },
                Lobes{{"0.25", "8"}}, 16});
  visit(Formula{"MicrofacetLobe::constant", [](auto a) { return MicrofacetLobe::constant(a); },
                Lobes{{"0.5"}, {"8"}}, 4});
}

}  // namespace shadefit::testing
