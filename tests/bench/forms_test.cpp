#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>

#include "approx/exp2_polynomial.hpp"
#include "approx/light_sum.hpp"
#include "approx/phase.hpp"
#include "bench/forms/catalogue.hpp"
#include "bench/forms/kernels.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"

namespace shadefit::forms {
namespace {

using shadefit::testing::is_close;

const std::vector<Target>& all() {
  static const std::vector<Target> made = catalogue();
  return made;
}

TEST(Kernels, ServeTheWholeCatalogue) {
  const std::set<std::string_view> with_exp2{"sg",
                                             "sg-difference",
                                             "sg-scaled",
                                             "gloss-sg",
                                             "fresnel-one-term",
                                             "fresnel-quadratic",
                                             "fresnel-cubic",
                                             "fresnel-quartic",
                                             "phong-sg"};
  for (const Target& target : all()) {
    for (const FormEntry& form : target.forms) {
      const std::span<const FormKernels> kernels = kernels_of(form.id);
      ASSERT_EQ(kernels.size(), with_exp2.contains(form.id) ? 6U : 1U) << form.id;
      EXPECT_FALSE(form.constants.empty()) << form.id;
      EXPECT_NE(kernels.front().in_long_double, nullptr) << form.id;
    }
  }
  EXPECT_TRUE(kernels_of("none").empty());
}

template <class R>
std::vector<R> run(Kernel<R> kernel, const std::array<std::vector<double>, 3>& in,
                   const std::vector<double>& given) {
  Inputs<R> places;
  for (const std::vector<double>& axis : in) places.emplace_back(axis.begin(), axis.end());
  return kernel(places, std::vector<R>(given.begin(), given.end()));
}

// Every kernel of a form is near the one in long double: to the polynomial's error, and the rounding of the
// result and of an exponent, whose A is 2955 for the largest gloss and 24 for the fixed lobe.
TEST(Kernels, OfEveryArithmeticAgree) {
  for (const Target& target : all()) {
    std::array<std::vector<double>, 3> in;
    for (std::size_t i = 0; i < 256; ++i) {
      std::array<double, 3> place{target.from + (target.to - target.from) * static_cast<double>(i) / 255, 0,
                                  0};
      if (target.arguments == Arguments::cosine_and_code) place[1] = static_cast<double>(i * 37 % 256);
      if (target.arguments == Arguments::normal_to_lights) place = spread_direction(i);
      for (std::size_t axis = 0; axis < 3; ++axis) in[axis].push_back(static_cast<float>(place[axis]));
    }
    for (const FormEntry& form : target.forms) {
      const auto given = parameters_of(target, form.constants.back());
      const auto truth = run(kernels_of(form.id).front().in_long_double, in, given);
      const auto largest = static_cast<double>(*std::ranges::max_element(truth));
      const auto expect_near = [&](const auto& kernel, double epsilon, double of_exp2,
                                   const std::string& what) {
        if (kernel == nullptr) return;
        const auto found = run(kernel, in, given);
        const double tolerance = largest * (2 * of_exp2 + (target.id == "lobe-gloss" ? 4096 : 128) * epsilon);
        for (std::size_t i = 0; i < found.size(); ++i)
          ASSERT_NEAR(static_cast<double>(found[i]), static_cast<double>(truth[i]), tolerance)
              << target.id << " " << form.id << " in " << what << " at " << i;
      };
      for (const FormKernels& kernels : kernels_of(form.id)) {
        const auto bound = [&](const auto& records) {
          return kernels.exp2_degree == 0
                     ? 0.0
                     : constant<double>(exp2_of_degree(records, kernels.exp2_degree).bound);
        };
        const std::string degree = ", degree " + std::to_string(kernels.exp2_degree);
        expect_near(kernels.in_float, 0x1p-23, bound(exp2_for_float), "float" + degree);
        expect_near(kernels.in_double, 0x1p-52, bound(exp2_for_double), "double" + degree);
        expect_near(kernels.exact_float, 0x1p-23, 0, "float of the library");
        expect_near(kernels.exact_double, 0x1p-52, 0, "double of the library");
      }
    }
  }
}

TEST(Catalogue, HasTheConstantsOfTheRecords) {
  const std::vector<FormEntry>& forms = std::ranges::find(all(), "schlick", &Target::id)->forms;
  const std::vector<Constants>& quadratic =
      std::ranges::find(forms, "fresnel-quadratic", &FormEntry::id)->constants;
  EXPECT_EQ(quadratic.front().id, "published-fresnel-quadratic-a");
  EXPECT_EQ(quadratic.front().numbers.at(1).printed, "-6.98316");
  // the published pair is least squares, uniform in the cosine
  EXPECT_EQ(quadratic.at(1).id, "least-squares-cosine");
  EXPECT_EQ(quadratic.at(1).numbers.at(0).printed, "-5.554727813");
  EXPECT_EQ(quadratic.at(1).numbers.at(0).value, -5.554727813);
  EXPECT_EQ(quadratic.back().id, "minimax-exp2-2");
  EXPECT_EQ(quadratic.back().numbers.at(0).printed, "-5.404911418");
  EXPECT_EQ(quadratic.back().numbers.at(1).printed, "-7.032870633");
  EXPECT_EQ(parameters_of(*std::ranges::find(all(), "phong-16", &Target::id), {}).size(), 1 + 3 * 16U);
}

TEST(Catalogue, SpreadsDirections) {
  double least = 2;
  for (std::size_t i = 0; i < 64; ++i) {
    const auto a = spread_direction(i);
    EXPECT_NEAR(a[0] * a[0] + a[1] * a[1] + a[2] * a[2], 1, 1e-15);
    EXPECT_GT(a[2], 0);
    for (std::size_t j = 0; j < i; ++j) {
      const auto b = spread_direction(j);
      least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  // 64 discs of that radius would cover a quarter of the hemisphere's 2 pi
  EXPECT_GT(least, 0.05);
}

// Schlick's phase function is a density, and the form with a square root is Henyey and Greenstein's.
TEST(PhaseFunctions, AreDensities) {
  for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.76}) {
    const double k = schlick_phase_parameter(g, 1.55, 0.55);
    const auto density = [&](double c) { return 2 * std::numbers::pi * schlick_phase(c, k); };
    EXPECT_NEAR(tanh_sinh(density, -1, 1, 1e-12).value, 1, 1e-10) << g;
  }
  EXPECT_EQ(schlick_phase_parameter(1.0, 1.55, 0.55), 1);
  for (const char* g : {"-0.9", "0.1", "0.76"}) {
    for (const char* c : {"-1", "-0.2", "0.5", "1"}) {
      const Decimal50 C(c), G(g);
      EXPECT_TRUE(is_close("", henyey_greenstein_by_sqrt(C, G), henyey_greenstein(C, G), 1e-45));
    }
  }
}

// (A l, -A).(n, 1) is A (n.l - 1).
TEST(LightSum, IsTheGaussianOfTheCosine) {
  const std::array<Decimal50, 3> n{Decimal50("0.48"), Decimal50("0.6"), Decimal50("0.64")};
  const std::array<Decimal50, 3> l{Decimal50("0.36"), Decimal50("0.48"), Decimal50("0.8")};
  const Decimal50 base_two("14.5"), cosine = lit_cosine(n, l);
  EXPECT_TRUE(is_close("", highlight_by_exp2(n, scaled_light(l, base_two)),
                       gaussian_lobe_base_two(cosine, base_two), 1e-45));
  EXPECT_EQ(lit_cosine(n, {Decimal50(0), Decimal50(-1), Decimal50(0)}), 0);
}

}  // namespace
}  // namespace shadefit::forms
