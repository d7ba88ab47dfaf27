#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include "fit/formula/parse_formula.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/truths/truths.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

constexpr double circle_half = std::numbers::pi;

double number(const std::string& text) {
  return evaluate<double>(read_formula(text, {.variables = {}, .takes_integrals = true}).formula,
                          [](const std::string&) { return 0.0; });
}

std::string fault(const std::string& text, const FormulaNames& names) {
  return testing::refusal<std::invalid_argument>([&] { read_formula(text, names); });
}

/// The integral of brdf(c, l, cos(phi)) l over the directions of the light, by tanh-sinh rules. It is split
/// at l = c and at cos(phi) = 0, where the formulas have kinks.
template <class Brdf>
double albedo_of(double c, const Brdf& brdf) {
  boost::math::quadrature::tanh_sinh<double> rule(8), inner(8);
  const auto over_azimuth = [&](double l) {
    const auto of_phi = [&](double phi) { return brdf(c, l, std::cos(phi)) * l; };
    return 2 * (inner.integrate(of_phi, 0.0, circle_half / 2) +
                inner.integrate(of_phi, circle_half / 2, circle_half));
  };
  // By places in [0, 1]: in a range that is too narrow for its places an assertion of Boost fails.
  const auto over = [&](double from, double to) {
    const double length = to - from;
    const auto at = [&](double t) { return over_azimuth(std::min(from + length * t, to)); };
    return length * rule.integrate(at, 0.0, 1.0);
  };
  return over(0, c) + (c < 1 ? over(c, 1) : 0);
}

double sines(double c, double l) {
  return std::sqrt(std::max(0.0, (1 - c * c) * (1 - l * l)));
}

TEST(Truths, OfDiffuseReflectionAgreeWithTheirIntegrals) {
  for (const double c : {0.05, 0.4, 0.9}) {
    for (const double r : {0.2, 0.7, 1.0}) {
      const std::string arguments = "(" + std::to_string(c) + ", " + std::to_string(r) + ")";
      const auto burley = [&](double v, double l, double cosine) {
        const double half = (1 + v * l + sines(v, l) * cosine) / 2;  // the square of l.h
        const double f90 = 0.5 + 2 * r * half;
        return (1 + (f90 - 1) * std::pow(1 - v, 5)) * (1 + (f90 - 1) * std::pow(1 - l, 5)) / circle_half;
      };
      EXPECT_NEAR(number("burley_albedo" + arguments), albedo_of(c, burley), 1e-12) << arguments;
      const double square = r * r;
      const auto oren_nayar = [&](double v, double l, double cosine) {
        const double s = sines(v, l) * cosine;
        const double a = 1 - 0.5 * square / (square + 0.33), b = 0.45 * square / (square + 0.09);
        return (a + b * std::max(s, 0.0) / std::max(v, l)) / circle_half;
      };
      EXPECT_NEAR(number("oren_nayar_albedo" + arguments), albedo_of(c, oren_nayar), 1e-12) << arguments;
      const auto fon = [&](double v, double l, double cosine) {
        const double s = sines(v, l) * cosine;
        return (1 + r * (s > 0 ? s / std::max(v, l) : s)) / (1 + r * (0.5 - 2 / (3 * circle_half))) /
               circle_half;
      };
      EXPECT_NEAR(number("fon_albedo" + arguments), albedo_of(c, fon), 1e-12) << arguments;
    }
  }
}

// With light that is reflected several times: its part of the BRDF has the albedo of one reflection, here by
// integrals too.
TEST(Truths, OfEonAgreeWithAnIntegralOfTheBrdf) {
  for (const double r : {0.01, 0.6, 1.0}) {
    const double a = 1 / (1 + r * (0.5 - 2 / (3 * circle_half)));
    const auto once = [&](double v, double l, double cosine) {
      const double s = sines(v, l) * cosine;
      return a * (1 + r * (s > 0 ? s / std::max(v, l) : s)) / circle_half;
    };
    std::map<double, double> known;  // by the cosine of the light: it is the same for all azimuths
    const auto albedo_once = [&](double c) {
      const auto found = known.find(c);
      return found != known.end() ? found->second : known[c] = albedo_of(c, once);
    };
    boost::math::quadrature::tanh_sinh<double> rule(8);
    const double mean = rule.integrate([&](double c) { return 2 * c * albedo_once(c); }, 0.0, 1.0);
    EXPECT_NEAR(number("fon_average(" + std::to_string(r) + ")"), mean, 1e-12) << r;
    for (const double c : {0.01, 0.5}) {
      for (const double rho : {0.2, 0.9}) {
        const double often = rho * rho * mean / (1 - rho * (1 - mean));
        const auto eon = [&](double v, double l, double cosine) {
          return rho * once(v, l, cosine) +
                 often / circle_half * (1 - albedo_once(v)) * (1 - albedo_once(l)) / (1 - mean);
        };
        const std::string arguments =
            "(" + std::to_string(c) + ", " + std::to_string(r) + ", " + std::to_string(rho) + ")";
        EXPECT_NEAR(number("eon_albedo" + arguments), albedo_of(c, eon), 1e-12) << arguments;
      }
    }
  }
}

TEST(Truths, OfEonKeepAllEnergyOfAWhiteSurface) {
  for (const std::string c : {"0", "0.3", "1"}) {
    EXPECT_NEAR(number("eon_albedo(" + c + ", 0.8, 1)"), 1, 1e-15);
    EXPECT_EQ(number("eon_albedo(" + c + ", 0.8, 0)"), 0);
    EXPECT_NEAR(number("eon_albedo(" + c + ", 0, 0.3)"), 0.3, 1e-15);
  }
  EXPECT_NEAR(number("integral(2 t fon_albedo(t, 0.7), t, 0, 1)"), number("fon_average(0.7)"), 1e-13);
}

TEST(Truths, OfFresnelAgreeWithTheirIntegrals) {
  EXPECT_NEAR(number("fresnel_average(1.5)"), 0.0918, 5e-5);
  for (const std::string n : {"1.05", "1.5", "2.5", "10"})
    EXPECT_NEAR(number("fresnel_average(" + n + ")"), number("conductor_average(" + n + ", 0)"), 1e-12) << n;
  // At normal incidence ((n - 1)^2 + k^2)/((n + 1)^2 + k^2); at grazing incidence 1.
  EXPECT_NEAR(number("conductor_reflectance(1, 0.2, 3)"), 9.64 / 10.44, 1e-15);
  EXPECT_NEAR(number("conductor_reflectance(0, 0.2, 3)"), 1, 1e-15);
  // Another rule.
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const auto& [n, k] : {std::pair(0.2, 3.0), {1.5, 7.0}, {3.0, 3.0}}) {
    const std::string arguments = std::to_string(n) + ", " + std::to_string(k);
    const double square = n * n - k * k;
    const auto reflectance = [&, n = n, k = k](double c) {
      const double s = 1 - c * c, length = std::sqrt((square - s) * (square - s) + 4 * n * n * k * k);
      const double a = std::sqrt((length + square - s) / 2);
      const double rs = (length + c * c - 2 * a * c) / (length + c * c + 2 * a * c);
      const double rp =
          rs * (c * c * length + s * s - 2 * a * c * s) / (c * c * length + s * s + 2 * a * c * s);
      return c * (rs + rp);
    };
    EXPECT_NEAR(number("conductor_average(" + arguments + ")"), rule.integrate(reflectance, 0.0, 1.0), 1e-12);
  }
}

TEST(Truths, OfHenyeyGreensteinIntegrateToOne) {
  for (const std::string g : {"-0.5", "0", "0.8"})
    EXPECT_NEAR(number("2 pi integral(hg(t, " + g + "), t, -1, 1)"), 1, 1e-12) << g;
  EXPECT_NEAR(number("2 pi integral(t hg(t, 0.6), t, -1, 1)"), 0.6, 1e-12) << "g is the mean cosine";
}

TEST(Truths, AllRead) {
  for (const Truth& truth : truths()) {
    std::string call(truth.name), arguments;
    for (const std::string& argument : truth.arguments)
      arguments += (arguments.empty() ? "" : ", ") + argument;
    call += "(" + arguments + ")";
    EXPECT_EQ(fault(call, {.variables = truth.arguments, .takes_integrals = true}), "") << call;
  }
}

TEST(Truths, RefuseInOneLine) {
  const FormulaNames names{.variables = {"x"}, .takes_integrals = true};
  EXPECT_EQ(
      fault("ggx_albdo(x, 1)", names),
      "formula 'ggx_albdo(x, 1)': expected one of x, pi, ln2 and the functions, not 'ggx_albdo' (did you "
      "mean 'ggx_albedo'?) at place 1");
  EXPECT_EQ(fault("ggx_albedo(x)", names),
            "formula 'ggx_albedo(x)': expected 2 arguments of 'ggx_albedo' at place 11");
  EXPECT_NE(fault("ggx_albedo(x, 1)", {.variables = {"x"}}), "") << "where no integral is read";
  // A definition of the user and a variable go before a truth of that name.
  FormulaNames own = names;
  own.definitions.emplace("hg", Definition{{"x"}, Symbolic::variable("x")});
  EXPECT_EQ(to_text(read_formula("hg(x)", own).formula), "x");
  EXPECT_EQ(to_text(read_formula("hg (2 + x)", {.variables = {"x", "hg"}, .takes_integrals = true}).formula),
            "hg (2 + x)");
}

}  // namespace
}  // namespace shadefit
