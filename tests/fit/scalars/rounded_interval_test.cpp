#include "fit/scalars/rounded_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/scalars/functions.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit {
namespace {

template <class Arithmetic>
bool contains(const RoundedInterval<Arithmetic>& interval, double x) {
  return interval.lower() <= x && x <= interval.upper();
}

/// Some cosines of a format, its subnormals too.
template <class Format>
std::vector<double> some_cosines() {
  const BinaryLattice<Format> lattice;
  std::vector<double> cosines{
      0, lattice.value(1), lattice.value(2), lattice.value(40), 1, lattice.value(lattice.nearest(1) - 1)};
  for (std::int64_t i = 1; i < lattice.nearest(1); i += lattice.nearest(1) / 23)
    cosines.push_back(lattice.value(i));
  return cosines;
}

/// A formula of a cosine and two parameters.
struct Formulas {
  template <class T>
  static std::array<T, 3> all(const T& c, const T& a, const T& b) {
    return {fresnel_quadratic(c, a, b), gaussian_lobe(c, T(b * b), a),
            blinn_lobe_of_cosine(c, T(b * b), T(a * a))};
  }
};

/// Every rounded computation with parameters in a box of 9 by 9 numbers around (a, b) lies in the interval of
/// the box. That of one number is what is computed with it.
template <class Format>
void expect_enclosure(double a, double b) {
  using T = NarrowResult<Format>;
  using I = RoundedInterval<CorrectArithmetic<Format>>;
  const BinaryLattice<Format> lattice;
  const std::int64_t i0 = lattice.nearest(a), j0 = lattice.nearest(b);
  const auto value = [&](std::int64_t i) { return lattice.value(i); };
  for (const double c : some_cosines<Format>()) {
    const auto box = Formulas::all(I(c), I(value(i0 - 4), value(i0 + 4)), I(value(j0 - 4), value(j0 + 4)));
    for (std::int64_t i = i0 - 4; i <= i0 + 4; ++i) {
      for (std::int64_t j = j0 - 4; j <= j0 + 4; ++j) {
        const auto computed = Formulas::all(T(c), T(value(i)), T(value(j)));
        const auto point = Formulas::all(I(c), I(value(i)), I(value(j)));
        for (std::size_t f = 0; f < computed.size(); ++f) {
          const auto x = static_cast<double>(computed[f]);
          ASSERT_TRUE(std::isnan(x) || contains(box[f], x))
              << Format::name << " formula " << f << " at c = " << c;
          ASSERT_TRUE(std::isnan(x) || contains(point[f], x))
              << Format::name << " formula " << f << " at c = " << c;
          if (f < 2 && !std::isnan(x)) {
            ASSERT_EQ(point[f].lower(), point[f].upper());
          }
        }
      }
    }
  }
}

TEST(RoundedInterval, ContainsEveryRoundedComputationOfABox) {
  for (const auto& [a, b] :
       {std::pair{-5.55, -6.98}, {0.775, 3.0}, {-0.001, 0.002}, {60000.0, -60000.0}, {0.0, 1e-6}}) {
    expect_enclosure<HalfFormat>(a, b);
    expect_enclosure<Bfloat16Format>(a, b);
  }
}

TEST(RoundedInterval, IsNoWiderThanItsBoxAsks) {
  using I = RoundedInterval<CorrectArithmetic<HalfFormat>>;
  const I form = fresnel_quadratic(I(0.5), I(-5.5625, -5.5546875), I(-7));
  EXPECT_EQ(form.lower(), static_cast<double>(fresnel_quadratic(NarrowResult<HalfFormat>(0.5),
                                                                NarrowResult<HalfFormat>(-5.5625),
                                                                NarrowResult<HalfFormat>(-7))));
  EXPECT_EQ(form.upper(), static_cast<double>(fresnel_quadratic(NarrowResult<HalfFormat>(0.5),
                                                                NarrowResult<HalfFormat>(-5.5546875),
                                                                NarrowResult<HalfFormat>(-7))));
}

TEST(RoundedInterval, ThatMayBeNoNumberIsEverything) {
  using I = RoundedInterval<CorrectArithmetic<HalfFormat>>;
  const double no_end = std::numeric_limits<double>::infinity();
  for (const I& x :
       {I(0) * I(no_end), I(no_end) - I(no_end), I(1) / I(-1, 1), log(I(-1)), power(I(-1, 1), I(0.5))}) {
    EXPECT_EQ(x.lower(), -no_end);
    EXPECT_EQ(x.upper(), no_end);
  }
}

TEST(OutwardArithmetic, EnclosesRealResults) {
  using I = RoundedInterval<OutwardArithmetic>;
  for (const auto& [a, b] : {std::pair{-5.55473, -6.98316}, {0.775, 3.3}, {-1e-3, 100.0}, {0.3, 1000.0}}) {
    for (const double c : some_cosines<FloatFormat>()) {
      const auto truth = Formulas::all(Decimal50(c), Decimal50(a), Decimal50(b));
      const auto point = Formulas::all(I(c), I(a), I(b));
      for (std::size_t f = 0; f < truth.size(); ++f) {
        EXPECT_LE(Decimal50(point[f].lower()), truth[f]) << f << " at c = " << c;
        EXPECT_LE(truth[f], Decimal50(point[f].upper())) << f << " at c = " << c;
        if (truth[f] > 1e-6 && truth[f] < 1e6) {
          EXPECT_LT(point[f].upper() - point[f].lower(), 1e-9 * point[f].upper());
        }
      }
    }
  }
  for (const double x : {-0.999, -0.5, -1e-3, -1e-17, -1e-310, 0.0, 1e-9, 3.0, 1e300}) {
    const I enclosed = log1p(I(x));
    const Decimal50 truth = boost::math::log1p(Decimal50(x));
    EXPECT_LE(Decimal50(enclosed.lower()), truth) << x;
    EXPECT_LE(truth, Decimal50(enclosed.upper())) << x;
    EXPECT_LE(enclosed.upper() - enclosed.lower(), 0x1p-48 * std::abs(std::log1p(x)) + 1e-322) << x;
  }
  // what has overflowed is large, not infinite
  const I large = exp2(I(2000));
  EXPECT_EQ(large.lower(), std::numeric_limits<double>::max());
}

// Every function of a formula, at numbers inside intervals of many sizes: those of a format, and of doubles.
TEST(RoundedInterval, ContainsWhatEveryFunctionReturns) {
  using Half = NarrowResult<HalfFormat>;
  using I = RoundedInterval<CorrectArithmetic<HalfFormat>>;
  using Outward = RoundedInterval<OutwardArithmetic>;
  const BinaryLattice<HalfFormat> lattice;
  long bounded = 0;
  for (std::size_t f = 0; f < functions_of_one<Half>.size(); ++f) {
    for (const double centre : {-40.0, -3.2, -1.0, -0.7, -1e-4, 0.0, 1e-4, 0.3, 0.999, 1.57, 4.0, 100.0}) {
      for (const std::int64_t steps : {0, 1, 10, 300}) {
        const std::int64_t i = lattice.nearest(centre);
        const I box = functions_of_one<I>[f](I(lattice.value(i - steps), lattice.value(i + steps)));
        const Outward real =
            functions_of_one<Outward>[f](Outward(lattice.value(i - steps), lattice.value(i + steps)));
        bounded += std::isfinite(box.lower()) && std::isfinite(box.upper()) ? 1 : 0;
        for (std::int64_t k = -steps; k <= steps; k += std::max<std::int64_t>(1, steps / 7)) {
          const double x = lattice.value(i + k);
          const auto in_half = static_cast<double>(functions_of_one<Half>[f](Half(x)));
          const double in_double = functions_of_one<double>[f](x);
          const auto name = functions_of_one<Half>[f].name;
          EXPECT_TRUE(std::isnan(in_half) || contains(box, in_half)) << name << " of " << x;
          EXPECT_TRUE(std::isnan(in_double) || contains(real, in_double)) << name << " of " << x;
        }
      }
    }
  }
  EXPECT_GT(bounded, 800) << "of 1056";
}

TEST(OutwardArithmetic, HasExactWholeNumbers) {
  using I = RoundedInterval<OutwardArithmetic>;
  EXPECT_EQ(constant<I>("1").lower(), 1);
  EXPECT_EQ(constant<I>("999999999999999").upper(), 999999999999999);
  for (const char* text : {"0.1", "1.5", "1e3", "9007199254740993"})
    EXPECT_LT(constant<I>(text).lower(), constant<I>(text).upper()) << text;
  EXPECT_EQ(tan(I(1.5, 1.6)).upper(), std::numeric_limits<double>::infinity()) << "a pole";
}

/// exp2 of a float as a GPU may compute it: that many ulps off, a subnormal flushed or not.
double gpu_exp2(double x, int ulps, bool is_flushed) {
  auto y = static_cast<float>(std::exp2(x));
  for (int i = 0; i < std::abs(ulps); ++i) y = std::nextafter(y, ulps < 0 ? 0.0F : 3e38F);
  return is_flushed && y < std::numeric_limits<float>::min() ? 0.0 : static_cast<double>(y);
}

// A computed double stands for the true power: three floats from the nearest are at most 3 ulp and a half
// from it, which is within 4.
TEST(GpuArithmetic, ContainsWhatAGpuMayReturn) {
  using I = RoundedInterval<GpuArithmetic<HalfFormat>>;
  const auto half = [](double x) { return static_cast<double>(NarrowResult<HalfFormat>::rounded(x)); };
  const double a = half(-5.55473), b = half(-6.98316);
  bool contraction_matters = false;
  const BinaryLattice<HalfFormat> lattice;
  for (std::int64_t i = 0; i <= lattice.nearest(1); i += 3) {
    const double c = lattice.value(i);
    const I form = fresnel_quadratic(I(c), I(a), I(b));
    const double separate = half(half(half(half(a * c) + b) * c)), fused = half(half(a * c + b) * c);
    contraction_matters = contraction_matters || separate != fused;
    for (const double exponent : {separate, fused}) {
      for (const int ulps : {-3, 0, 3}) {
        const double power = gpu_exp2(exponent, ulps, false), result = half(power);
        EXPECT_TRUE(contains(form, result)) << c << " " << ulps;
        const auto cut = static_cast<double>(NarrowResult<HalfFormat>::cut_off(power));
        EXPECT_TRUE(contains(form, cut)) << c << " " << ulps << ", cut off";
        if (result < 0x1p-14) {
          EXPECT_TRUE(contains(form, 0)) << "flushed at c = " << c;
        }
      }
    }
  }
  EXPECT_TRUE(contraction_matters);
}

// (x + y) + 1 may become (x + 1) + y, which rounds otherwise. A variable is not moved.
TEST(GpuArithmetic, MovesNumbersIntoSums) {
  using I = RoundedInterval<GpuArithmetic<HalfFormat>>;
  using Half = NarrowResult<HalfFormat>;
  const double x = 0x1p-11, y = 0x1p-11;  // half an ulp of 1 each: x + 1 and then + y stay at 1
  const auto moved = static_cast<double>((Half(x) + Half(1)) + Half(y));
  EXPECT_EQ(moved, 1);
  EXPECT_TRUE(contains((I(x) + I(y)) + integer<I>(1), moved));
  EXPECT_FALSE(contains((I(x) + I(y)) + I(1), moved));
  EXPECT_EQ(asin(I(0.5)).upper(), std::numeric_limits<double>::infinity()) << "nothing is known";
}

TEST(GpuArithmetic, IsFourUlpsWideAndFlushesSubnormals) {
  using F = RoundedInterval<GpuArithmetic<FloatFormat>>;
  const F y = exp2(F(-0.5));
  const double truth = std::exp2(-0.5), ulp = 0x1p-24;
  EXPECT_LE(y.lower(), truth - 3.5 * ulp);
  EXPECT_GE(y.upper(), truth + 3.5 * ulp);
  EXPECT_GE(y.lower(), truth - 8 * ulp);  // 4 ulp of 2^-23 relative, rounded
  EXPECT_EQ(exp2(F(-130)).lower(), 0);
  EXPECT_GT(exp2(F(-130)).upper(), 0x1p-131);
  EXPECT_EQ(F(0x1p-140).lower(), 0);
  EXPECT_EQ(F(-0x1p-140).upper(), 0);
  EXPECT_GT(exp2(F(-125)).lower(), 0);
  const F e = exp(F(-3)), p = power(F(0.75), F(7)), l = log(F(0.75));
  EXPECT_TRUE(contains(e, std::exp(-3))) << e.lower();
  EXPECT_TRUE(contains(p, std::pow(0.75, 7)));
  EXPECT_TRUE(contains(l, std::log(0.75)));
  EXPECT_LT(e.upper() - e.lower(), 2e-6 * e.upper());
  EXPECT_LT(p.upper() - p.lower(), 7e-6 * p.upper());  // mostly 2 * 7 ln 2 * 2^-21
}

}  // namespace
}  // namespace shadefit
