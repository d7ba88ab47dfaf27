#include <gtest/gtest.h>

#include "approx/encoding.hpp"
#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/normalisation.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/records/optical_constants.hpp"
#include "tests/accuracy.hpp"
#include "tests/decimal100.hpp"

namespace shadefit {
namespace {

using testing::is_close;

TEST(Ruler, SeesOneTolerance) {
  EXPECT_TRUE(is_close("", 1, Decimal50("1.0000000000000999"), 1e-13));
  EXPECT_FALSE(is_close("", 1, Decimal50("1.0000000000001001"), 1e-13));
  EXPECT_FALSE(is_close("", 0, Decimal50("1e-12"), 1e-13));
}

// The robust rearrangements equal the plain formulas in 50 digits, over the domain and beyond the useful
// offsets.
TEST(Lobe, RobustFormsAreThePlainOnes) {
  for (const char* k : {"0.1", "1", "5", "37.5", "2048"}) {
    for (const char* c : {"0.001", "0.3", "0.5", "0.50001", "0.9", "0.9999"}) {
      for (const char* x : {"0", "0.775", "1"}) {
        const Decimal100 K(k), C(c), X(x), Y = 1 - C;
        const std::string where = std::string(k) + " " + c + " " + x;
        const Decimal100 ratio = lobe_log_ratio(C, Y, K);
        const Decimal100 difference = gaussian_lobe(C, K, X) - power_lobe(C, K);
        const double tolerance = 1e-45;  // 100 digits less what the plain difference cancels at k = 2048
        EXPECT_TRUE(
            is_close(where, Decimal50(power_lobe(C, K)), Decimal50(power_lobe_near_peak(Y, K)), tolerance));
        EXPECT_TRUE(is_close(where, Decimal50(gaussian_lobe(C, K, X)),
                             Decimal50(gaussian_lobe_near_peak(Y, K, X)), tolerance));
        const Decimal100 base = gaussian_lobe(C, K, Decimal100(0)), change = -X * Y;
        EXPECT_TRUE(is_close(where, Decimal50(difference), Decimal50(lobe_error(base, change, expm1(ratio))),
                             tolerance));
        const Decimal100 A("1.0625");
        const Decimal100 scaled = scaled_gaussian_lobe(C, K, A, X) - power_lobe(C, K);
        EXPECT_TRUE(is_close(where, Decimal50(scaled),
                             Decimal50(scaled_lobe_error(base, A, change, expm1(ratio))), tolerance));
      }
    }
  }
}

TEST(PhongBlinn, RobustFormsAreThePlainOnes) {
  for (const char* rho : {"0.1", "1", "7.3", "64", "2048"}) {
    for (const char* c : {"0.001", "0.3", "0.5", "0.9", "0.9999"}) {
      for (const char* x : {"4", "4.2", "6"}) {
        const Decimal100 K(rho), C(c), X(x), Y = 1 - C;
        const std::string where = std::string(rho) + " " + c + " " + x;
        const Decimal100 remainder = log1p_remainder(Decimal100(-Y / 2));
        const Decimal100 ratio = phong_blinn_log_ratio(lobe_log_ratio(C, Y, K), remainder, K);
        const Decimal100 variable = K * log_half_cosine(Y, remainder);
        // cos(theta/2) = sqrt((1 + cos(theta))/2)
        const Decimal100 blinn = pow(sqrt(Decimal100((1 + C) / 2)), Decimal100(X * K));
        const Decimal100 difference = blinn - power_lobe(C, K);
        const double tolerance = 1e-45;
        EXPECT_TRUE(is_close(where, Decimal50(blinn), Decimal50(blinn_lobe(Y, K, X)), tolerance));
        EXPECT_TRUE(is_close(where, Decimal50(blinn), Decimal50(blinn_lobe_of_cosine(C, K, X)), tolerance));
        const Decimal100 base = exp(Decimal100(4 * variable)), change = (X - 4) * variable;
        // right to the rounding of the base; form and target may both be nearly zero
        EXPECT_TRUE(is_close(where, Decimal50(1 + difference / base),
                             Decimal50(1 + lobe_error(base, change, expm1(ratio)) / base), tolerance));
      }
    }
  }
}

TEST(PhongBlinn, TheLawHasItsClosedForms) {
  EXPECT_EQ(factor_law(1.0).limit, 4);
  EXPECT_EQ(factor_law(1.0).slope, 1.5) << "4 + 3/(2 rho) in the cosine measures";
  EXPECT_EQ(factor_law(0.5).slope, 1.25) << "4 + 5/(4 rho) in the angle";
}

template <class T>
T offset_error(const T& cos_theta, const T& one_minus_cos, const T& exponent, const T& offset) {
  const T ratio = lobe_log_ratio(cos_theta, one_minus_cos, exponent);
  return lobe_error(gaussian_lobe_near_peak(one_minus_cos, exponent, integer<T>(0)),
                    -(offset * one_minus_cos), expm1(ratio));
}

// In double the robust error keeps its digits; the plain difference has lost log10(k) of them.
TEST(Lobe, TheErrorKeepsItsDigitsAtTheSharpestLobes) {
  for (const double k : {1e2, 1e4, 1e6}) {
    for (const double t : {0.1, 0.5, 3.4, 20.0}) {
      const double y = t / k;
      const Decimal100 K(k), Y(y), C = 1 - Y;
      const Decimal50 truth(offset_error(C, Y, K, Decimal100("0.75")));
      const double computed = offset_error(1 - y, y, k, 0.75);
      // exp(-t) multiplies the rounding of t by t <= 20, the bracket by at most 8 where t^2/2 and x t cancel
      EXPECT_TRUE(
          is_close(std::to_string(k) + " " + std::to_string(t), truth, Decimal50(computed), 64 * 0x1p-53));
    }
  }
}

TEST(Lobe, AtTheHorizonTheErrorIsTheGaussianItself) {
  EXPECT_DOUBLE_EQ(offset_error(0.0, 1.0, 5.0, 0.5), std::exp(-5.5));
  EXPECT_EQ(gaussian_lobe(1.0, 8.0, 0.775), 1) << "the peak is 1";
  EXPECT_EQ(power_lobe(1.0, 8.0), 1);
}

TEST(OffsetLaw, HasItsClosedForms) {
  const auto cosine = offset_law<Decimal50>(1, 0);
  EXPECT_EQ(cosine.limit, Decimal50(3) / 4);
  EXPECT_EQ(cosine.slope, Decimal50(13) / 64);
  const auto angle = offset_law<Decimal50>(Decimal50("0.5"), Decimal50("0.25"));
  EXPECT_EQ(angle.limit, Decimal50(5) / 8);
  EXPECT_TRUE(is_close("angle", Decimal50(185) / 768, angle.slope, 1e-48));
  // c dc = (1 - y) dy: the law of the cosine-weighted measure
  EXPECT_TRUE(is_close("cosine-weighted", Decimal50(-11) / 64, offset_law<Decimal50>(1, -1).slope, 1e-48));
}

TEST(Fresnel, Landmarks) {
  EXPECT_EQ(schlick_weight(0.0), 1) << "grazing: everything is reflected";
  EXPECT_EQ(schlick_weight(1.0), 0) << "normal incidence: f0";
  EXPECT_EQ(schlick_weight(0.5), 1.0 / 32);
  EXPECT_EQ(schlick_reflectance(0.04, 0.0), 0.04);
  EXPECT_EQ(schlick_reflectance(0.04, 1.0), 1);
  EXPECT_EQ(fresnel_one_term(0.0, 8.35), 1);
  EXPECT_EQ(fresnel_quadratic(0.0, -5.55473, -6.98316), 1);
  EXPECT_EQ(fresnel_cubic(0.5, 0.0, -5.5, -7.0), fresnel_quadratic(0.5, -5.5, -7.0));
  EXPECT_EQ(fresnel_quartic(0.5, 0.0, 0.0, -5.5, -7.0), fresnel_quadratic(0.5, -5.5, -7.0));
  EXPECT_EQ(fresnel_fourth(0.5, 1.0), 1.0 / 16);
  for (const double c : {0.0, 1.0}) {
    EXPECT_EQ(fresnel_square(c, 2.2, -2.9), 1 - c) << "exact at both ends";
    EXPECT_EQ(fresnel_rational(c, 1.26), 1 - c) << "exact at both ends";
  }
}

// Born and Wolf 1999: the landmarks of Fresnel's equations.
TEST(Dielectric, Landmarks) {
  EXPECT_NEAR(dielectric_reflectance(1.0, 1.5), 0.04, 1e-16) << "normal incidence";
  EXPECT_EQ(dielectric_reflectance(0.0, 1.5), 1) << "grazing";
  EXPECT_NEAR(reflectance_at_normal(1.5), reflectance_at_normal(1 / 1.5), 1e-17)
      << "the same from both sides";
  // Brewster's angle, tan = n: rp = 0, and rs = -(n^2 - 1)/(n^2 + 1)
  const Decimal50 n("1.5"), brewster = 1 / sqrt(Decimal50(1 + n * n));
  const Decimal50 rs = (n * n - 1) / (n * n + 1);
  EXPECT_TRUE(is_close("Brewster", rs * rs / 2, dielectric_reflectance(brewster, n), 1e-45));
  // beyond the critical angle, sin = n, everything is reflected; and F is equal from both sides along one ray
  EXPECT_EQ(dielectric_reflectance(0.5, 1 / 1.5), 1);
  EXPECT_EQ(dielectric_reflectance(0.0, 1 / 1.5), 1) << "grazing from inside, where the quotients are 0/0";
  const Decimal50 c("0.8"), inside = sqrt(Decimal50(1 - (1 - c * c) / (n * n)));
  EXPECT_TRUE(is_close("both sides", dielectric_reflectance(c, n),
                       dielectric_reflectance(inside, Decimal50(1 / n)), 1e-45));
  EXPECT_EQ(weight_of_reflectance(1.0, 0.04), 1);
  EXPECT_EQ(weight_of_reflectance(0.04, 0.04), 0);
}

/// |rs|^2 and |rp|^2 in complex arithmetic: Fresnel's equations as Born and Wolf write them, with n + i k for
/// n.
Decimal50 conductor_by_complex_numbers(const Decimal50& c, const Decimal50& n, const Decimal50& k) {
  struct Complex {
    Decimal50 re, im;
  };
  const auto times = [](const Complex& a, const Complex& b) {
    return Complex{a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  };
  const auto norm = [](const Complex& a) { return Decimal50(a.re * a.re + a.im * a.im); };
  const Complex index{n, k}, square = times(index, index);
  const Complex inside{square.re - (1 - c * c), square.im};
  const Decimal50 modulus = sqrt(norm(inside));
  const Decimal50 v = sqrt(Decimal50((modulus - inside.re) / 2));  // the root by v, the formula by u
  const Complex t{v == 0 ? Decimal50(sqrt(inside.re)) : Decimal50(inside.im / (2 * v)), v};
  const Decimal50 rs = norm({c - t.re, -t.im}) / norm({c + t.re, t.im});
  const Complex n2c{square.re * c, square.im * c};
  const Decimal50 rp = norm({n2c.re - t.re, n2c.im - t.im}) / norm({n2c.re + t.re, n2c.im + t.im});
  return (rs + rp) / 2;
}

TEST(Conductor, IsFresnelsEquationsWithAComplexIndex) {
  for (const OpticalConstants& metal : metals) {
    const Decimal50 n(std::string(metal.ior)), k(std::string(metal.extinction));
    for (const char* cosine : {"1e-6", "0.05", "0.3", "0.7", "1"}) {
      const Decimal50 c(cosine);
      EXPECT_TRUE(is_close(std::string(metal.material) + " " + std::string(metal.wavelength) + " " + cosine,
                           conductor_by_complex_numbers(c, n, k), conductor_reflectance(c, n, k), 1e-40));
    }
    EXPECT_TRUE(is_close("normal", conductor_reflectance_at_normal(n, k),
                         conductor_reflectance(Decimal50(1), n, k), 1e-45));
    EXPECT_EQ(conductor_reflectance(Decimal50(0), n, k), 1) << "grazing";
  }
}

TEST(Conductor, WithoutExtinctionIsADielectric) {
  for (const char* index : {"1.33", "1.5", "2", "0.75"}) {
    for (const char* cosine :
         {"0.1", "0.5", "0.75", "1"}) {  // 0.75 inside is below the critical angle, 0.5 beyond
      const Decimal50 n(index), c(cosine);
      EXPECT_TRUE(is_close(std::string(index) + " " + cosine, dielectric_reflectance(c, n),
                           conductor_reflectance(c, n, Decimal50(0)), 1e-40));
    }
  }
}

// Johnson and Christy 1972 and the colour of gold: most of red, half of blue.
TEST(Conductor, GoldIsYellow) {
  EXPECT_NEAR(conductor_reflectance_at_normal(0.14, 3.697), 0.963, 0.0005);
  EXPECT_NEAR(conductor_reflectance_at_normal(1.38, 1.914), 0.408, 0.0005);
}

TEST(Srgb, LandmarksOfTheStandard) {
  EXPECT_EQ(srgb_encode(0.0), 0);
  EXPECT_NEAR(srgb_encode(1.0), 1, 1e-15);
  // IEC 61966-2-1: the two branches meet at 0.0031308, within the rounding of its published constants
  const double below = srgb_encode(0.0031308), above = srgb_encode(std::nextafter(0.0031308, 1));
  EXPECT_EQ(below, 12.92 * 0.0031308);
  EXPECT_NEAR(below, above, 3e-8);
  EXPECT_NE(below, above);
  EXPECT_NEAR(255 * srgb_encode(0.5), 187.5, 0.05) << "linear middle grey is code 187 or 188";
}

TEST(Srgb, DecodingIsTheInverse) {
  EXPECT_EQ(srgb_decode(0.0), 0);
  EXPECT_EQ(srgb_decode(1.0), 1);
  // the branches meet at 0.04045, within the rounding of its published constants
  const double below = srgb_decode(0.04045), above = srgb_decode(std::nextafter(0.04045, 1));
  EXPECT_EQ(below, 0.04045 / 12.92);
  EXPECT_NEAR(below, above, 3e-8);
  EXPECT_NE(below, above);
  // Away from the joint, where the two functions choose their branches a hair apart.
  for (const char* x : {"0.0001", "0.003", "0.0032", "0.18", "0.5", "0.999"}) {
    EXPECT_TRUE(is_close(x, Decimal50(x), srgb_decode(srgb_encode(Decimal50(x))), 1e-47));
  }
  // 18 % of the light is code 117.6, half of it 187.5 (mpmath, from the formula of the standard)
  EXPECT_NEAR(255 * srgb_encode(0.18), 117.64581302261261, 1e-10);
  EXPECT_NEAR(srgb_decode(187.51603067837462 / 255), 0.5, 1e-14);
}

TEST(Normalisation, ClosedFormsAtSimpleExponents) {
  const Decimal50 p = pi<Decimal50>();
  EXPECT_EQ(PhongLobe::constant(Decimal50(1)), 1 / p) << "Phong of exponent 1 is Lambert's lobe";
  EXPECT_EQ(PhongBrdfLobe::constant(Decimal50(0)), 1 / p) << "alpha = 0 leaves n.l";
  EXPECT_TRUE(is_close("a = 0", 1 / (2 * p), BlinnPhongLobe::constant(Decimal50(0)), 1e-48))
      << "a constant over the hemisphere";
  EXPECT_TRUE(is_close("a = 0", 1 / p, BlinnPhongBrdfLobe::constant(Decimal50(0)), 1e-48));
}

}  // namespace
}  // namespace shadefit
