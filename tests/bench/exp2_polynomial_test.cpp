#include "approx/exp2_polynomial.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "fit/bounds/rounding_bound.hpp"
#include "fit/scalars/binary_logarithm.hpp"
#include "tests/bench/exp2_choices.hpp"
#include "tests/bench/exponent_bits.hpp"

namespace shadefit {
namespace {

using testing::for_each_degree;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The polynomial of these coefficients as a study of 2^r, its error relative.
StudySubject approximation_of(const std::vector<std::string>& coefficients) {
  StudySubject subject{
      {.target = "exp2(r)", .form = "", .over = {{"r", "-1/2", "1/2"}}, .error = Error::relative}};
  std::string end;
  for (const std::string& coefficient : coefficients) {
    const std::string name = fmt::format("c{}", subject.parameters.size() + 1);
    subject.parameters.emplace_back(name, coefficient);
    subject.study.form += (subject.study.form.empty() ? "1 + r (" : " + r (") + name;
    end += ")";
  }
  subject.study.form += end;
  return subject;
}

/// The printed digits, and all digits of what they round to in a format.
template <class Format>
std::array<StudySubject, 2> approximations_of(const Exp2Coefficients& polynomial) {
  std::vector<std::string> printed, rounded;
  for (int i = 0; i < polynomial.degree; ++i) {
    printed.emplace_back(polynomial.printed[static_cast<std::size_t>(i)]);
    rounded.push_back(fmt::format("{:.80g}", static_cast<double>(constant<Format>(printed.back()))));
  }
  return {approximation_of(printed), approximation_of(rounded)};
}

/// The largest |p(r)/2^r - 1|, whichever of both is worse.
struct Bounds {
  double lower = 0, upper = 0;
};

template <class Format>
Bounds proven_error(const Exp2Coefficients& polynomial) {
  Bounds bounds;
  for (const StudySubject& subject : approximations_of<Format>(polynomial)) {
    const StudyCertificate proof = certify_study(subject, 1e-5).certificate;
    bounds = {std::max(bounds.lower, proof.lower), std::max(bounds.upper, proof.upper)};
  }
  return bounds;
}

/// Three half ulps bound the rounding of Horner's rule.
template <class Format>
constexpr double rounding = 1.5 * static_cast<double>(std::numeric_limits<Format>::epsilon());

/// The proven relative bounds of the polynomial and of its evaluation.
template <class Format>
double proven(const Exp2Coefficients& polynomial) {
  const double upper = proven_error<Format>(polynomial).upper;
  return upper + rounding<Format> * (1 + upper);  // the product of two errors is negligible
}

// The best: the error has its largest size at one place more than the polynomial has coefficients, and
// error/r has alternating signs there.
TEST(Exp2Polynomial, HasTheBestCoefficients) {
  for_each_degree<double>([]<class P>(P) {
    const auto c = exp2_coefficients<P, long double>();
    constexpr std::size_t steps = 20000;
    std::vector<double> error, size;
    for (std::size_t i = 0; i <= steps; ++i) {
      const long double r = static_cast<long double>(i) / steps - 0.5L;
      error.push_back(static_cast<double>(exp2_near_zero(r, c) / std::exp2(r) - 1));
      size.push_back(std::abs(error.back()));
    }
    std::vector<bool> signs;
    for (std::size_t i = 0; i <= steps; ++i) {
      const bool is_maximum = (i == 0 || size[i] > size[i - 1]) && (i == steps || size[i] >= size[i + 1]);
      if (is_maximum && size[i] > (1 - 1e-5) * *std::ranges::max_element(size))
        signs.push_back((error[i] < 0) != (i < steps / 2));
    }
    EXPECT_EQ(signs.size(), c.size() + 1) << "degree " << P::record.degree;
    EXPECT_EQ(std::ranges::adjacent_find(signs), signs.end()) << "degree " << P::record.degree;
    const Exp2Coefficients& rounded = exp2_of_degree(exp2_for_float, P::record.degree);
    for (std::size_t i = 0; i < c.size(); ++i)
      EXPECT_EQ(constant<float>(rounded.printed[i]), static_cast<float>(c[i])) << "c" << i + 1;
  });
}

// The stated bounds are the proven ones, rounded up.
template <class Format>
void expect_stated_bounds() {
  for_each_degree<Format>([]<class P>(P) {
    const auto stated = constant<double>(P::record.bound);
    const Bounds bounds = proven_error<Format>(P::record);
    EXPECT_LE(bounds.upper, stated) << "degree " << P::record.degree;
    EXPECT_GE(bounds.lower * 1.0002, stated) << "degree " << P::record.degree;
  });
}

TEST(Exp2Proof, StatesItsBounds) {
  expect_stated_bounds<float>();
  expect_stated_bounds<double>();
}

// In doubles each rounding is as much smaller.
TEST(Exp2Proof, BoundsItsRounding) {
  for_each_degree<float>([]<class P>(P) {
    const double bound = bound_of_rounding<FloatFormat>(approximations_of<float>(P::record)[1]);
    EXPECT_LE(bound, rounding<float>) << "degree " << P::record.degree;
    EXPECT_GE(bound, rounding<float> / 3) << "degree " << P::record.degree;
  });
}

// The compiler reads a coefficient like the library.
TEST(Exp2Polynomial, HasItsPrintedCoefficients) {
  for_each_degree<float>([]<class P>(P) {
    const auto here = exp2_coefficients<P, float>();
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i], constant<float>(P::record.printed[i]));
  });
  for_each_degree<double>([]<class P>(P) {
    const auto here = exp2_coefficients<P, double>();
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i], constant<double>(P::record.printed[i]));
  });
}

template <class Format>
void expect_exact_at_whole_numbers() {
  using Limits = std::numeric_limits<Format>;
  for_each_degree<Format>([]<class P>(P) {
    for (int n = Limits::min_exponent - 1; n < Limits::max_exponent; ++n)
      ASSERT_EQ(exp2_polynomial<P>(static_cast<Format>(n)), std::ldexp(Format(1), n)) << n;
  });
}

TEST(Exp2Polynomial, IsExactAtWholeNumbers) {
  expect_exact_at_whole_numbers<float>();
  expect_exact_at_whole_numbers<double>();
}

template <class Format>
void expect_ends() {
  using Limits = std::numeric_limits<Format>;
  for_each_degree<Format>([]<class P>(P) {
    const auto largest = static_cast<Format>(Limits::max_exponent);
    EXPECT_EQ(exp2_polynomial<P>(Limits::infinity()), Limits::infinity());
    EXPECT_EQ(exp2_polynomial<P>(Limits::max()), Limits::infinity());
    EXPECT_EQ(exp2_polynomial<P>(largest), Limits::infinity());
    EXPECT_TRUE(std::isfinite(exp2_polynomial<P>(std::nextafter(largest, Format(0)))));
    EXPECT_EQ(exp2_polynomial<P>(-Limits::infinity()), Format(0));
    EXPECT_EQ(exp2_polynomial<P>(Limits::lowest()), Format(0));
    EXPECT_FALSE(std::signbit(exp2_polynomial<P>(Limits::lowest())));
    EXPECT_TRUE(std::isnan(exp2_polynomial<P>(Limits::quiet_NaN())));
    EXPECT_TRUE(std::isnan(exp2_polynomial<P>(-Limits::quiet_NaN())));
    EXPECT_EQ(exp2_polynomial<P>(Format(-0.0)), Format(1));
    EXPECT_EQ(exp2_polynomial<P>(Limits::denorm_min()), Format(1));
  });
}

TEST(Exp2Polynomial, EndsAtZeroAndInfinity) {
  expect_ends<float>();
  expect_ends<double>();
}

// From the least normal number 2^m at x = m down to 0 at x = m - 1: never rising, never off by more than
// 2^(m-1).
TEST(Exp2Polynomial, FallsToZeroBelowTheLeastNormalNumber) {
  constexpr float least_normal = std::numeric_limits<float>::min();
  for_each_degree<float>([]<class P>(P) {
    float before = least_normal;
    for (float x = -126; x >= -127; x = std::nextafter(x, -infinity)) {
      const float result = exp2_polynomial<P>(x);
      // at the half-way place the polynomial of odd degree jumps by its error
      ASSERT_LE(result, before * (1 + 4 * constant<float>(P::record.bound))) << x;
      ASSERT_LE(std::abs(static_cast<double>(result) - std::exp2(static_cast<double>(x))), least_normal / 2)
          << x;
      before = result;
    }
    EXPECT_EQ(before, 0.0F);
  });
}

/// The largest |result/2^x - 1| over floats of one sign whose bits lie in [from, to), by steps. Truth is the
/// double function, good to 1e-16, which `TruthIsTrue` holds against 50 digits.
template <class P>
double worst(std::uint32_t from, std::uint32_t to, std::uint32_t step) {
  double worst = 0;
  for (std::uint32_t bits = from; bits < to; bits += step) {
    const auto x = std::bit_cast<float>(bits);
    const double result = exp2_polynomial<P>(x);
    worst = std::max(worst, std::abs(result / std::exp2(static_cast<double>(x)) - 1));
  }
  return worst;
}

TEST(Exp2Polynomial, TruthIsTrue) {
  const RootsOfTwo<Decimal50> roots;
  for (const float x : {-126.0F, -99.75F, -3.1F, -0.5F, -1e-7F, 0.3F, 1.5F, 77.7F, 127.9F}) {
    const Decimal50 truth = roots.exp2(Decimal50(x));
    EXPECT_LT(abs(Decimal50(std::exp2(static_cast<double>(x))) / truth - 1), Decimal50(0x1p-52)) << x;
  }
}

/// The sanitizers take twenty times as long.
#ifdef SHADEFIT_SANITIZE
constexpr std::uint32_t every = 61;
#else
constexpr std::uint32_t every = 1;
#endif

// Every float in [-2, -1), which has both halves of the polynomial and a half-way place.
TEST(Exp2Polynomial, KeepsItsBoundAtEveryFloatOfABinade) {
  for_each_degree<float>([]<class P>(P) {
    const auto from = std::bit_cast<std::uint32_t>(-1.0F), to = std::bit_cast<std::uint32_t>(-2.0F);
    const double found = worst<P>(from, to, every);
    EXPECT_LE(found, proven<float>(P::record)) << "degree " << P::record.degree;
    // and comes near it: the bound is not too loose
    EXPECT_GE(found, 0.5 * constant<double>(P::record.bound));
  });
}

// All binades, both signs, several thousand floats in each.
TEST(Exp2Polynomial, KeepsItsBoundInAllBinades) {
  for_each_degree<float>([]<class P>(P) {
    constexpr std::uint32_t sign = 0x80000000U, step = 4099;  // a prime: all low bits occur
    const double most = proven<float>(P::record);
    EXPECT_LE(worst<P>(0, std::bit_cast<std::uint32_t>(128.0F), step), most);
    EXPECT_LE(worst<P>(sign, std::bit_cast<std::uint32_t>(-126.0F), step), most);
  });
}

TEST(Exp2Polynomial, KeepsItsBoundInDoubles) {
  const RootsOfTwo<Decimal50> roots;
  for_each_degree<double>([&]<class P>(P) {
    const double most = proven<double>(P::record);
    for (double x = -1022; x < 1024; x += 13.0390625) {  // all kinds of fractions
      const Decimal50 ratio = Decimal50(exp2_polynomial<P>(x)) / roots.exp2(Decimal50(x));
      ASSERT_LE(static_cast<double>(abs(ratio - 1)), most) << x;
    }
  });
}

/// The largest relative fall from a float to the next above, around the half-way places and between.
template <class P>
double largest_fall() {
  double largest = 0;
  for (const float start : {-1.75F, -1.5001F, -1.25F, -0.5001F, -0.01F, 0.4999F}) {
    float x = start, before = exp2_polynomial<P>(x);
    for (int i = 0; i < 20000; ++i) {
      x = std::nextafter(x, infinity);
      const float next = exp2_polynomial<P>(x);
      largest = std::max(largest, static_cast<double>(before - next) / static_cast<double>(before));
      before = next;
    }
  }
  return largest;
}

// The polynomials rise, and where one ends and the next begins those of even degree jump upwards, by twice
// their error, while those of odd degree meet: what falls is rounding, an ulp or two.
TEST(Exp2Polynomial, RisesButForRounding) {
  for_each_degree<float>(
      []<class P>(P) { EXPECT_LE(largest_fall<P>(), 2 * 0x1p-23) << "degree " << P::record.degree; });
}

// One formula, every arithmetic.
TEST(Exp2Polynomial, IsTheSameInEveryArithmetic) {
  using P = Exp2Choice<4, double>;
  for (const double x : {-20.3125, -3.375, -0.75, -0.25, 0.0, 0.4375, 2.5625}) {
    const Decimal50 truth = exp2_polynomial<P>(Decimal50(x));
    const auto off = [&](const Decimal50& result) { return static_cast<double>(abs(result / truth - 1)); };
    EXPECT_LE(off(exp2_polynomial<P>(x)), 4 * 0x1p-53);
    EXPECT_LE(off(Decimal50(exp2_polynomial<P>(static_cast<long double>(x)))), 1e-15) << "15 digits";
    EXPECT_LE(off(exp2_polynomial<P>(static_cast<float>(x))), 4 * 0x1p-24);
    if (x >= -14) {
      const Eigen::half half = exp2_polynomial<P>(Eigen::half(static_cast<float>(x)));
      EXPECT_LE(off(static_cast<float>(half)), 4 * 0x1p-11) << x;
    }
  }
}

// A scalar of its own: the formulas as they stand.
TEST(WithExp2, RunsAnyFormula) {
  using P = Exp2Choice<5, float>;
  using W = WithExp2<float, P>;
  for (const float c : {0.0F, 0.125F, 0.4F, 0.77F, 1.0F}) {
    const W pair = fresnel_quadratic(W{c}, constant<W>("-5.55473"), constant<W>("-6.98316"));
    const float exponent = (-5.55473F * c - 6.98316F) * c;
    EXPECT_EQ(pair.value, exp2_polynomial<P>(exponent));
    EXPECT_NEAR(pair.value, fresnel_quadratic(c, -5.55473F, -6.98316F), 4e-7F);
    EXPECT_EQ(schlick_weight(W{c}).value, schlick_weight(c));
    EXPECT_NEAR(gaussian_lobe(W{c}, integer<W>(5), constant<W>("0.788")).value,
                gaussian_lobe(c, 5.0F, 0.788F), 1e-6F);
    EXPECT_EQ(positive_part(W{-c}).value, 0.0F);
    EXPECT_EQ(select(less(W{c}, W{0.5F}), W{1}, W{2}).value, c < 0.5F ? 1.0F : 2.0F);
    EXPECT_EQ(sqrt(W{c}).value, std::sqrt(c));
    EXPECT_EQ(min(W{c}, W{0.5F}).value, std::min(c, 0.5F));
    EXPECT_EQ((W{c} / W{3} - -W{c}).value, c / 3 - -c);
  }
  EXPECT_EQ(pi<W>().value, std::numbers::pi_v<float>);
}

}  // namespace
}  // namespace shadefit
