#include "fit/verdicts/fresnel_chain.hpp"

#include <gtest/gtest.h>

#include <set>

#include "fit/catalogue/family.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit {
namespace {

const std::vector<FresnelLink>& chain() {
  static const auto links =
      fresnel_chain({find_family("fresnel-one-term"), find_family("fresnel-quadratic")});
  return links;
}

const FresnelLink& link_of(std::string_view ior, std::string_view family, std::string_view published) {
  for (const FresnelLink& link : chain()) {
    const std::string id = link.family == nullptr ? "schlick" : link.family->id;
    if (link.surface->ior == ior && id == family && link.published == published) return link;
  }
  throw std::logic_error("no such link");
}

// The headline: the error of Schlick's formula is ten times the error of the published pair against Schlick's
// formula, and the cheapest form is more accurate than both.
TEST(FresnelChain, SchlickIsFartherFromTheTruthThanTheCheapestForm) {
  const auto from_exact = [](std::string_view family, std::string_view published) {
    return link_of("1.5", family, published).from_exact.absolute.magnitude;
  };
  EXPECT_NEAR(from_exact("schlick", ""), 0.0357, 0.00005);
  EXPECT_NEAR(from_exact("fresnel-quadratic", "fresnel-quadratic-a"), 0.0387, 0.00005);
  EXPECT_NEAR(from_exact("fresnel-one-term", "fresnel-one-term"), 0.0071, 0.00005);
  EXPECT_NEAR(from_exact("fresnel-quadratic", ""), 0.0053, 0.00005);
}

// Each extremum against the error at a hundred cosines in 50 digits: as large as any, and taken where it is
// said to be.
TEST(FresnelChain, ErrorsAreTheLargest) {
  for (const FresnelLink& link : chain()) {
    if (link.family == nullptr || link.status != Status::converged) continue;
    const Decimal50 n(std::string(link.surface->ior)), k(std::string(link.surface->extinction));
    const auto error = [&](const Decimal50& c) {
      const Decimal50 f0 = conductor_reflectance_at_normal(n, k);
      const Decimal50 p(link.parameters[0]);
      const Decimal50 form = link.parameters.size() == 1
                                 ? fresnel_one_term(c, p)
                                 : fresnel_quadratic(c, p, Decimal50(link.parameters[1]));
      return abs(Decimal50(schlick_reflectance(f0, form) - conductor_reflectance(c, n, k)))
          .convert_to<double>();
    };
    const double largest = link.from_exact.absolute.magnitude;
    // e' is 0 there, but the place is known to 1e-8, and an end is exact
    EXPECT_NEAR(error(Decimal50(link.from_exact.absolute.at.cos_theta)), largest, 1e-14);
    for (int i = 0; i <= 100; ++i) EXPECT_LE(error(Decimal50(i) / 100), largest + 1e-14) << i;
  }
}

TEST(FresnelChain, HoldsEverySurfaceAndCurve) {
  EXPECT_EQ(chain().size(), (dielectrics.size() + metals.size()) * 6U);
  std::set<std::string_view> materials;
  for (const FresnelLink& link : chain()) {
    materials.insert(link.surface->material);
    EXPECT_GT(link.f0, 0);
    EXPECT_LT(link.f0, 1);
    EXPECT_GE(link.from_schlick.relative.magnitude, link.from_schlick.absolute.magnitude) << "F is at most 1";
  }
  EXPECT_EQ(materials, (std::set<std::string_view>{"aluminium", "copper", "dielectric", "gold"}));
  EXPECT_TRUE(fresnel_chain({}).empty());
}

// Codes have no derivative to go by; between their samples they may be no larger.
TEST(FresnelChain, CodesAreTheLargest) {
  for (const FresnelLink& link : chain()) {
    if (link.published != "fresnel-one-term") continue;
    const double n = constant<double>(link.surface->ior), k = constant<double>(link.surface->extinction);
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double c = i / 20000.0;
      const double form = schlick_reflectance(link.f0, fresnel_one_term(c, link.parameters[0]));
      largest =
          std::max(largest, 255 * std::abs(srgb_encode(form) - srgb_encode(conductor_reflectance(c, n, k))));
    }
    EXPECT_GE(link.from_exact.srgb_codes, largest * (1 - 1e-12))
        << link.surface->material << link.surface->wavelength;
    EXPECT_LE(link.from_exact.srgb_codes, largest * (1 + 1e-6))
        << link.surface->material << link.surface->wavelength;
  }
}

TEST(FresnelChain, CodesAreOfTheDisplay) {
  // a constant 1 against Schlick on glass: at normal incidence F = 0.04 is code 56.2 of 255
  const auto error = reflectance_error(schlick_surface(1.5), "1 + 0 c");
  EXPECT_NEAR(error.absolute.magnitude, 0.96, 1e-12);
  EXPECT_NEAR(error.relative.magnitude, 24, 1e-10);
  EXPECT_NEAR(error.srgb_codes, 255 - 255 * (1.055 * std::pow(0.04, 1 / 2.4) - 0.055), 1e-9);
}

}  // namespace
}  // namespace shadefit
