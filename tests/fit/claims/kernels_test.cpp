#include "approx/kernels.hpp"

#include <boost/math/special_functions/legendre.hpp>
#include <vector>

#include "approx/lobe.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/claims/lobe_rule.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

using testing::is_close;

// The solver of the families, with its own nodes and Newton's method, against this one.
TEST(LobeRule, FitsTheSphericalGaussianAsItsFamilyDoes) {
  for (const double k : {1.0, 3.0, 16.0, 2048.0}) {
    const LobeRule rule(k);
    const auto values = [&](double sharpness) {
      std::vector<double> v;
      for (const auto& node : rule.nodes())
        v.push_back(gaussian_lobe_near_peak(node.direction.one_minus_cos, k * sharpness, 0.0));
      return v;
    };
    const KernelFit fit = fit_kernel(rule, values, 0.25, 8);
    const Fit expected = find_family("sg-offset")->fit(k, {});
    // half the digits of the sharpness k + x; all of the error, less those that form - target cancels
    EXPECT_NEAR(k * fit.parameter, k + expected.parameters[0], 1e-6 * k) << k;
    EXPECT_NEAR(fit.rms / expected.rms_error, 1, 1e-9) << k;
    const auto kernel = [&](const LobeRule::LobeAngle& direction) {
      return gaussian_lobe_near_peak(direction.one_minus_cos, k * fit.parameter, 0.0);
    };
    EXPECT_NEAR(rule.square_by_other_rule(kernel) / (fit.rms * fit.rms), 1, 1e-8) << k;
  }
}

// Of the measure itself: the integral of dc is 1, that of c^2k is 1/(2k + 1).
TEST(LobeRule, IntegratesTheCosine) {
  for (const double k : {1.0, 7.0, 2048.0}) {
    const LobeRule rule(k);
    double total = 0;
    for (const auto& node : rule.nodes()) total += node.weight;
    EXPECT_NEAR(total, 1, 1e-13) << k;
    EXPECT_NEAR(rule.square(std::vector<double>(rule.nodes().size(), 0.0)) * (2 * k + 1), 1, 1e-12) << k;
  }
}

TEST(Kernels, AtTheChordTheGaussianOfTheLineIsTheSphericalOne) {
  for (const char* sharpness : {"0.5", "8", "1000"}) {
    for (const char* text : {"0.0001", "0.5", "1.5", "2"}) {
      const Decimal50 s(sharpness), y(text);
      EXPECT_TRUE(is_close(std::string(sharpness) + " " + text, gaussian_lobe_near_peak(y, s, Decimal50(0)),
                           line_gaussian(Decimal50(sqrt(Decimal50(2 * y))), Decimal50(1 / s)), 1e-44));
    }
  }
}

TEST(Kernels, TheLobesOfPoissonAreTheKernelsOverTheirPeaks) {
  for (const char* text : {"0.1", "0.5", "0.99"}) {
    for (const char* cosine : {"-1", "0", "0.75", "1"}) {
      const Decimal50 t(text), c(cosine), y = 1 - c, m = 2 * t / ((1 - t) * (1 - t));
      const Decimal50 circle = (1 - t) * (1 - t) / (1 - 2 * t * c + t * t);
      EXPECT_TRUE(is_close(cosine, circle, poisson_of_circle_lobe(y, m), 1e-46)) << text;
      EXPECT_TRUE(is_close(cosine, pow(circle, Decimal50("1.5")), poisson_of_sphere_lobe(y, m), 1e-46))
          << text;
    }
  }
}

// The generating function: with weights (2l + 1) t^l the series is Abel-Poisson's kernel of the sphere, here
// of the peak 20/9 and the sharpness 8/9.
TEST(Kernels, TheSeriesHasTheClosedFormOfPoisson) {
  const Decimal50 t("0.25");
  std::vector<Decimal50> weights;
  for (int l = 0; l < 100; ++l) weights.push_back((2 * l + 1) * pow(t, l));
  for (const char* text : {"-1", "-0.5", "0", "0.75", "1"}) {
    const Decimal50 c(text);
    EXPECT_TRUE(is_close(text, 20 * poisson_of_sphere_lobe(Decimal50(1 - c), Decimal50(Decimal50(8) / 9)) / 9,
                         legendre_series(c, std::span<const Decimal50>(weights)), 1e-44));
  }
}

TEST(Kernels, ThePolynomialsAreLegendres) {
  for (const double c : {-0.9, 0.0, 0.3, 1.0}) {
    for (int l = 1; l < 20; ++l) {
      EXPECT_NEAR(next_legendre(c, boost::math::legendre_p(l, c), boost::math::legendre_p(l - 1, c), l),
                  boost::math::legendre_p(l + 1, c), 1e-14);
    }
  }
}

// All further terms, one by one, against the integral of their falling weights: |P_l| <= 1.
TEST(Kernels, TheTailOfTheHeatKernelIsBelowItsBound) {
  for (const char* text : {"0.0001", "0.01", "0.5"}) {
    const Decimal50 t(text);
    for (const int last : {3, 10, 40, 300}) {
      if ((2 * last + 1) * (2 * last + 1) * t < 2) continue;  // the weights still rise there
      Decimal50 tail = 0;
      for (int l = last + 1; l < last + 3000; ++l) tail += heat_weight(l, t);
      const Decimal50 bound = exp(Decimal50(-last * (last + 1) * t)) / t;
      EXPECT_LT(tail, bound) << text << " " << last;
      // and it is no mere guess: a step of l is short there, and the sum is nearly its integral
      EXPECT_TRUE(t > 0.001 || tail * 2 > bound) << text << " " << last;
    }
  }
}

// For short times the heat kernel is sqrt(theta/sin theta) e^(-theta^2/(4t)) (1 + O(t)): McKean, Singer 1967.
TEST(Kernels, TheHeatKernelIsNearlyAGaussianOfTheAngle) {
  const Decimal50 t("0.0005");
  std::vector<Decimal50> weights;
  Decimal50 peak = 0;
  for (int l = 0; l < 400; ++l) {
    weights.push_back(heat_weight(l, t));
    peak += weights.back();
  }
  for (const char* text : {"0.02", "0.05", "0.1"}) {
    const Decimal50 angle(text);
    const Decimal50 value =
        legendre_series(Decimal50(cos(angle)), std::span<const Decimal50>(weights)) / peak;
    const Decimal50 near = sqrt(Decimal50(angle / sin(angle))) * line_gaussian(angle, Decimal50(2 * t));
    EXPECT_TRUE(is_close(text, near, value, 1e-4 * 5e-2)) << "O(t theta^2) is 5e-6 at most";
  }
}

}  // namespace
}  // namespace shadefit
