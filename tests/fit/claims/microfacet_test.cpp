#include "approx/microfacet.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <string>

#include "approx/normalisation.hpp"
#include "fit/claims/microfacet_integrals.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/decimal100.hpp"

namespace shadefit {
namespace {

using testing::is_close;

const std::array widths{1e-4, 0.01, 0.09, 0.25, 0.5, 0.81, 1.0};

TEST(Microfacet, DistributionsAreTheirTextbookFormulas) {
  for (const double alpha_ : {0.1, 0.25, 0.81}) {
    const Decimal50 a = alpha_, p = pi<Decimal50>();
    for (const double cos2_ : {1.0, 0.9375, 0.5, 0.0625}) {
      const Decimal50 c2 = cos2_, t2 = 1 / c2 - 1;
      const MicrofacetNormal<double> m{cos2_, 1 - cos2_};
      const std::string where = std::to_string(alpha_) + " " + std::to_string(cos2_);
      const Decimal50 s = 2 / (a * a) - 2;
      // The exponent, up to 198, multiplies the rounding of log(cos); further out both are below any double.
      if (cos2_ >= 0.5) {
        EXPECT_TRUE(is_close(where, (s + 2) / (2 * p) * pow(sqrt(c2), s), blinn_phong_distribution(m, alpha_),
                             1e-11));
        EXPECT_TRUE(is_close(where, exp(Decimal50(-t2 / (a * a))) / (p * a * a * c2 * c2),
                             beckmann_distribution(m, alpha_), 1e-11));
      }
      const Decimal50 e = c2 * (a * a - 1) + 1;
      EXPECT_TRUE(is_close(where, a * a / (p * e * e), ggx_distribution(m, alpha_), 1e-14));
      EXPECT_TRUE(is_close(where, (a * a - 1) / (p * log(Decimal50(a * a))) / e, gtr1_distribution(m, alpha_),
                           1e-14));
    }
  }
}

// The Blinn-Phong distribution is the lobe of the row norm-ndf with its constant.
TEST(Microfacet, BlinnPhongIsTheNormalisedLobe) {
  for (const double alpha : {0.1, 0.5}) {
    const double exponent = blinn_phong_exponent(alpha), c = 0.96875;
    const double lobe = std::pow(c, exponent) * DistributionLobe::constant(exponent);
    EXPECT_NEAR(blinn_phong_distribution(MicrofacetNormal<double>{c * c, 1 - c * c}, alpha) / lobe, 1, 1e-13);
  }
}

TEST(Microfacet, AtWidthOneThreeOfThemAreUniform) {
  for (const double cos2 : {1.0, 0.7, 0.01}) {
    const MicrofacetNormal<double> m{cos2, 1 - cos2};
    EXPECT_NEAR(blinn_phong_distribution(m, 1.0), 1 / pi<double>(), 1e-16);
    EXPECT_NEAR(ggx_distribution(m, 1.0), 1 / pi<double>(), 1e-16);
    EXPECT_NEAR(gtr1_distribution(m, 1.0), 1 / pi<double>(), 1e-16);
  }
}

// On both sides of the choice: the series at alpha = 1, the quotient from the next double on.
TEST(Microfacet, TheFactorOfGtr1KeepsItsDigitsBesideOne) {
  EXPECT_EQ(gtr1_factor(1.0), 1);
  EXPECT_EQ(gtr1_factor(Decimal50(1)), 1);
  for (const double alpha :
       {std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0), 1 - 1e-8, 1 + 1e-8, 1 - 1e-3, 0.5, 1e-4}) {
    const Decimal100 a = alpha, x = a * a - 1;
    EXPECT_TRUE(is_close(std::to_string(alpha), Decimal50(x / log1p(x)), gtr1_factor(alpha), 1e-15));
  }
  // 1 + x/2 has the derivative of the quotient: alpha = 1 + h gives 1 + h.
  using Jet = ceres::Jet<double, 1>;
  EXPECT_EQ(gtr1_factor(Jet(1.0, 0)).v[0], 1);
}

// erf from its Maclaurin series, 2/sqrt(pi) sum (-1)^n x^(2n+1)/(n! (2n+1)), in 100 digits.
Decimal100 erfc_by_series(const Decimal100& x) {
  Decimal100 sum = 0, term = x;
  for (int n = 0; n < 400; ++n) {
    sum += term / (2 * n + 1);
    term *= -x * x / (n + 1);
  }
  return 1 - 2 / sqrt(pi<Decimal100>()) * sum;
}

TEST(Erfc, AgreesWithItsSeries) {
  for (const char* text : {"-3", "-0.5", "0", "0.125", "1", "2.5", "5"}) {
    const Decimal50 truth(erfc_by_series(constant<Decimal100>(text)));
    EXPECT_TRUE(is_close(text, truth, erfc(constant<Decimal50>(text)), 1e-46));
    EXPECT_TRUE(is_close(text, truth, Decimal50(erfc(constant<double>(text))), 1e-15));
    EXPECT_TRUE(is_close(text, truth, Decimal50(erfc(constant<Decimal100>(text))), 1e-48));
  }
  using Jet = ceres::Jet<double, 1>;
  EXPECT_NEAR(erfc(Jet(0.0, 0)).v[0], -2 / std::sqrt(pi<double>()), 1e-15);
}

TEST(Microfacet, LambdasAtTheirLimits) {
  EXPECT_EQ(beckmann_lambda(0.0), 0);
  EXPECT_EQ(ggx_lambda(0.0), 0);
  // at a grazing view both grow like the slope: over 2 sqrt(pi), and over 2
  EXPECT_NEAR(beckmann_lambda(1e9) / 1e9, 1 / (2 * std::sqrt(pi<double>())), 1e-9);
  EXPECT_NEAR(ggx_lambda(1e9) / 1e9, 0.5, 1e-9);
  // and at a flat one GGX's like slope^2/4, which the form with 1 - sqrt would lose
  EXPECT_NEAR(ggx_lambda(1e-9) / 1e-18, 0.25, 1e-15);
  EXPECT_EQ(smith_masking(0.0), 1);
}

TEST(MicrofacetIntegrals, EveryDistributionCoversTheSurface) {
  for (const auto* name : {"blinn-phong", "beckmann", "ggx", "gtr1"}) {
    const Distribution& d = distribution_of(name);
    for (const double alpha : widths) {
      const TwoWays area = integrate_projected_area(d, alpha, 1e-13);
      EXPECT_NEAR(area.by_slope.value, 1, 1e-13) << alpha;
      EXPECT_NEAR(area.by_cosine.value, 1, 1e-13) << alpha;
      EXPECT_LT(area.error(), 1e-11) << alpha;
      EXPECT_GE(area.error(), std::abs(area.value() - 1)) << alpha << ": the estimate is sound";
    }
  }
}

TEST(MicrofacetIntegrals, SmithsOwnMaskingIsExact) {
  for (const auto* name : {"beckmann", "ggx"}) {
    const Distribution &d = distribution_of(name), &g = masking_of(name);
    for (const double alpha : widths) {
      for (const double degrees : {0.0, 0.01, 30.0, 45.0, 80.0, 89.99}) {
        const View view(degrees);
        const double factor = masking(g, view, alpha) / view.direction.cosine;
        const TwoWays area = integrate_visible_area(d, alpha, view, 1e-13);
        EXPECT_NEAR(area.by_slope.value * factor, 1, 1e-12) << alpha << " " << degrees;
        EXPECT_NEAR(area.by_cosine.value * factor, 1, 1e-12) << alpha << " " << degrees;
      }
    }
  }
}

// The visible area of a uniform distribution, 1/pi on the hemisphere: the projected area of half a unit
// sphere seen from theta is pi (1 + cos)/2, by the ellipse that its rim projects to.
TEST(MicrofacetIntegrals, TheVisibleAreaOfAHemisphereIsKnown) {
  for (const double degrees : {0.0, 20.0, 60.0, 89.9}) {
    const View view(degrees);
    for (const auto* name : {"blinn-phong", "ggx", "gtr1"}) {
      const TwoWays area = integrate_visible_area(distribution_of(name), 1, view, 1e-13);
      EXPECT_NEAR(area.by_slope.value, (1 + view.direction.cosine) / 2, 1e-13) << degrees;
      EXPECT_NEAR(area.by_cosine.value, (1 + view.direction.cosine) / 2, 1e-13) << degrees;
    }
  }
}

// Seen from the horizon half of every circle faces v: the visible area is 2 * integral of D sin^2 dtheta, for
// Blinn-Phong a Beta function, B(3/2, (s+1)/2)/(pi alpha^2). From e above the horizon it is e/2 more: half of
// the projected area turns by e towards v. (What e^2 adds is below 1e-17.)
TEST(MicrofacetIntegrals, TheVisibleAreaFromTheHorizonIsABetaFunction) {
  const View view(89.9999999);
  for (const double alpha_ : {0.1, 0.5, 0.81, 1.0}) {
    const Decimal50 a = alpha_, s = 2 / (a * a) - 2, half = Decimal50(1) / 2;
    const Decimal50 beta = boost::math::tgamma(Decimal50(3 * half)) *
                           boost::math::tgamma(Decimal50((s + 1) * half)) /
                           boost::math::tgamma(Decimal50(s * half + 2));
    const Decimal50 expected = beta / (pi<Decimal50>() * a * a) + view.elevation / 2;
    for (const Integral& area :
         {integrate_visible_area(distribution_of("blinn-phong"), alpha_, view, 1e-13).by_slope,
          integrate_visible_area(distribution_of("blinn-phong"), alpha_, view, 1e-13).by_cosine})
      EXPECT_TRUE(is_close(std::to_string(alpha_), expected, Decimal50(area.value), 1e-13));
  }
}

TEST(MicrofacetIntegrals, NamesAreRead) {
  for (const auto* name : {"blinn-phong", "beckmann", "ggx", "gtr1"})
    EXPECT_EQ(distribution_of(name).name, name);
  EXPECT_EQ(masking_of("ggx").name, "ggx");
  EXPECT_THROW(distribution_of("phong"), std::invalid_argument);
  EXPECT_THROW(masking_of("gtr1"), std::invalid_argument);
}

}  // namespace
}  // namespace shadefit
