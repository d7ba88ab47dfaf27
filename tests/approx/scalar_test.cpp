#include "approx/scalar.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "fit/scalars/symbolic.hpp"
#include "tests/accuracy.hpp"
#include "tests/approx/formulas/lobes.hpp"
#include "tests/approx/formulas/surfaces.hpp"
#include "tests/decimal100.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

using testing::contains;
using testing::end;
using testing::Formula;
using testing::is_close;

/// Calls a visitor with every formula of approx/. Not a tuple: a type of 150 parts would be in every name
/// that the compiler makes.
template <class Visit>
void every_formula(const Visit& visit) {
  testing::lobe_formulas(visit);
  testing::gloss_formulas(visit);
  testing::phong_blinn_formulas(visit);
  testing::kernels_formulas(visit);
  testing::fresnel_formulas(visit);
  testing::normalisation_formulas(visit);
  testing::reflectance_formulas(visit);
  testing::shading_formulas(visit);
  testing::microfacet_formulas(visit);
  testing::material_formulas(visit);
  testing::full_range_formulas(visit);
  testing::vocabulary_formulas(visit);
}

template <class T, class F>
auto evaluate(const Formula<F>& formula, const std::vector<const char*>& a) {
  const auto arg = [&](std::size_t i) { return constant<T>(a[i]); };
  if constexpr (std::invocable<F, T>) {
    return formula.call(arg(0));
  } else if constexpr (std::invocable<F, T, T>) {
    return formula.call(arg(0), arg(1));
  } else if constexpr (std::invocable<F, T, T, T>) {
    return formula.call(arg(0), arg(1), arg(2));
  } else if constexpr (std::invocable<F, T, T, T, T>) {
    return formula.call(arg(0), arg(1), arg(2), arg(3));
  } else {
    return formula.call(arg(0), arg(1), arg(2), arg(3), arg(4));
  }
}

/// A formula at one row of its arguments.
template <class T>
struct Computed {
  std::string of;  ///< "gaussian_lobe 0.875 5 0.75"
  T value;
  double epsilons;
};

std::string describe(const char* name, const std::vector<const char*>& arguments) {
  std::string text = name;
  for (const char* a : arguments) text += std::string(" ") + a;
  return text;
}

using Bfloat16Result = NarrowResult<Bfloat16Format>;
using Jet1 = ceres::Jet<double, 1>;
using NestedJet = ceres::Jet<ceres::Jet<double, 2>, 2>;
using WideNestedJet = ceres::Jet<ceres::Jet<long double, 1>, 1>;

template <class... T>
struct Scalars {
  using Table = std::tuple<std::vector<Computed<T>>...>;
  using Tested = ::testing::Types<T...>;
};
/// The rows whose values are numbers.
using Numbers = Scalars<float, double, long double, Eigen::half, HalfResult, Bfloat16Result, Decimal50, Jet1,
                        NestedJet, WideNestedJet>;
using AllScalars = Scalars<float, double, long double, Eigen::half, HalfResult, Bfloat16Result, Decimal50,
                           Jet1, NestedJet, WideNestedJet, Decimal100, Symbolic, Interval>;

template <class T>
void append(std::vector<Computed<T>>& all, const std::string& of, const T& value, double epsilons) {
  all.push_back({of, value, epsilons});
}

/// Every formula in every scalar at all of its arguments. The expectations stand in one place for each
/// scalar, because every line here is compiled for each formula, and lines within `each` for each scalar too.
AllScalars::Table computed_in_all() {
  AllScalars::Table all;
  every_formula([&](const auto& formula) {
    for (const auto& arguments : formula.arguments) {
      const std::string of = describe(formula.name, arguments);
      const auto each = [&]<class T>(std::vector<Computed<T>>& computed) {
        static_assert(std::same_as<decltype(evaluate<T>(formula, arguments)), T>,
                      "a formula left its scalar");
        append(computed, of, evaluate<T>(formula, arguments), formula.epsilons);
      };
      std::apply([&](auto&... of_scalar) { (each(of_scalar), ...); }, all);
    }
  });
  return all;
}

const AllScalars::Table& all_computed() {
  static const AllScalars::Table all = computed_in_all();
  return all;
}

template <class T>
const std::vector<Computed<T>>& every_formula_in() {
  return std::get<std::vector<Computed<T>>>(all_computed());
}

template <class T>
Decimal50 value_of(const T& x) {
  return Decimal50(x);
}
Decimal50 value_of(Eigen::half x) {
  return Decimal50(static_cast<float>(x));
}
template <class Format>
Decimal50 value_of(NarrowResult<Format> x) {
  return Decimal50(static_cast<double>(x));
}
template <class T, int N>
Decimal50 value_of(const ceres::Jet<T, N>& x) {
  return value_of(x.a);
}

template <class T>
double epsilon_of() {
  if constexpr (std::same_as<T, Eigen::half> || std::same_as<T, HalfResult>) {
    return 0x1p-10;
  } else if constexpr (std::same_as<T, Bfloat16Result>) {
    return 0x1p-7;
  } else if constexpr (requires { typename T::Scalar; }) {
    return epsilon_of<typename T::Scalar>();
  } else {
    return static_cast<double>(std::numeric_limits<T>::epsilon());
  }
}

template <class T>
class EveryScalar : public ::testing::Test {};

struct ScalarNames {
  template <class T>
  static std::string GetName(int i) {
    constexpr const char* names[] = {"Float",      "Double",         "LongDouble", "Half",
                                     "HalfResult", "Bfloat16Result", "Decimal50",  "Jet",
                                     "NestedJet",  "WideNestedJet"};
    return names[i];
  }
};
TYPED_TEST_SUITE(EveryScalar, Numbers::Tested, ScalarNames);

TYPED_TEST(EveryScalar, KeepsItsTypeAndAgreesWithFiftyDigits) {
  // The truth is the same formula in 100 digits. Other tests show that the formula itself is right.
  const auto& computed = every_formula_in<TypeParam>();
  const auto& truth = every_formula_in<Decimal100>();
  ASSERT_EQ(computed.size(), truth.size());
  const double epsilon =
      std::max(epsilon_of<TypeParam>(), static_cast<double>(std::numeric_limits<Decimal50>::epsilon()));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_TRUE(is_close(truth[i].of, Decimal50(truth[i].value), value_of(computed[i].value),
                         truth[i].epsilons * epsilon));
  }
}

// A formula equals its own expression.
TEST(SymbolicScalar, EveryFormulaIsItsExpression) {
  const auto& expressions = every_formula_in<Symbolic>();
  const auto& truth = every_formula_in<Decimal100>();
  ASSERT_EQ(expressions.size(), truth.size());
  const auto no_variable = [](const std::string& name) -> Decimal100 { throw std::logic_error(name); };
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Symbolic& expression = expressions[i].value;
    EXPECT_EQ(shadefit::evaluate<Decimal100>(expression, no_variable), truth[i].value)
        << truth[i].of << ": " << to_text(expression);
    EXPECT_EQ(count_operations(expression), Operations{}) << "all of it is numbers";
    EXPECT_FALSE(to_latex(expression).empty());
  }
}

TEST(IntervalScalar, EveryFormulaContainsTheTruth) {
  const auto& computed = every_formula_in<Interval>();
  const auto& truth = every_formula_in<Decimal100>();
  ASSERT_EQ(computed.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Interval& interval = computed[i].value;
    EXPECT_TRUE(contains(interval, truth[i].value)) << truth[i].of;
    // and it is narrow: a relative width of 40 digits
    EXPECT_LE(end(interval, true) - end(interval, false), abs(truth[i].value) * 1e-40) << truth[i].of;
  }
}

TEST(DecimalText, IsConvertedPerScalarNotThroughDouble) {
  EXPECT_EQ(constant<float>("0.1"), 0.1F);
  EXPECT_EQ(constant<long double>("0.1"), 0.1L);
  EXPECT_NE(constant<long double>("0.1"), static_cast<long double>(constant<double>("0.1")));
  EXPECT_EQ(constant<Decimal50>("0.1"), Decimal50(1) / 10);
  EXPECT_EQ(static_cast<float>(constant<Eigen::half>("0.1")), 0.0999755859375F);
  EXPECT_THROW(constant<double>("0.1x"), std::invalid_argument);
  EXPECT_THROW(constant<double>(""), std::invalid_argument);
}

TEST(Half, IsRoundedOnce) {
  // Just above the tie between 1 and the next half: rounding through float loses the excess, and the tie goes
  // to even.
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 0x1p-11 + 0x1p-40)), 1 + 0x1p-10F);
  EXPECT_EQ(static_cast<float>(Eigen::half(static_cast<float>(1 + 0x1p-11 + 0x1p-40))), 1.0F);
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 0x1p-11)), 1.0F) << "a tie goes to even";
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 3 * 0x1p-11)), 1 + 0x1p-9F);
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 0x1p-11 - 0x1p-40)), 1.0F);
  EXPECT_EQ(static_cast<float>(round_to_half(-1 - 0x1p-11 - 0x1p-40)), -1 - 0x1p-10F);
  EXPECT_TRUE(std::isinf(static_cast<float>(round_to_half(65520))));
  EXPECT_EQ(static_cast<float>(round_to_half(65519.999)), 65504.0F);
}

TEST(Vocabulary, SelectsClampsAndPowers) {
  EXPECT_EQ(min(1.0, 2.0), 1);
  EXPECT_EQ(min(2.0, 1.0), 1);
  EXPECT_EQ(max(1.0, 2.0), 2);
  EXPECT_EQ(max(2.0, 1.0), 2);
  EXPECT_EQ(positive_part(-1.0), 0);
  EXPECT_EQ(positive_part(0.5), 0.5);
  EXPECT_EQ(select(less(1.0, 2.0), 3.0, 4.0), 3);
  EXPECT_EQ(select(less(2.0, 2.0), 3.0, 4.0), 4);
  EXPECT_EQ(power(0.0, 2.5), 0);
  EXPECT_EQ(power(Decimal50(0), Decimal50("2.5")), 0);
  for (int n = -9; n <= 9; ++n) EXPECT_EQ(power(2.0, n), std::ldexp(1.0, n)) << n;
  EXPECT_EQ(power(0.0, 0), 1);
}

TEST(Log1pRemainder, KeepsItsDigitsOnBothSidesOfItsBranch) {
  std::vector<double> places{-1 + 0x1p-40, -0.999, -0.75, 0.75, 1, 3, 1e-300, -1e-300, 1e-8, -1e-8};
  for (double x = -0.6; x <= 0.6; x += 0.0123) places.push_back(x);
  for (const double edge : {-0.5, 0.5}) {
    for (const double towards : {-1.0, 1.0}) places.push_back(std::nextafter(edge, towards));
    places.push_back(edge);
  }
  for (const double x : places) {
    const Decimal50 truth = Decimal50(log1p(Decimal100(x)) - Decimal100(x));
    if (x * x < std::numeric_limits<double>::min()) {
      EXPECT_EQ(log1p_remainder(x), -0.0) << "below x^2/2's range";
      continue;
    }
    // Near x = -1 the rounding of log1p itself shows; elsewhere two to three roundings, and in long double
    // the one of a tail that is summed in double.
    EXPECT_TRUE(is_close(std::to_string(x), truth, Decimal50(log1p_remainder(x)),
                         6 * std::numeric_limits<double>::epsilon()));
    EXPECT_TRUE(is_close(std::to_string(x), truth, Decimal50(log1p_remainder(static_cast<long double>(x))),
                         6 * static_cast<double>(std::numeric_limits<long double>::epsilon())));
    EXPECT_TRUE(is_close(std::to_string(x), truth, log1p_remainder(Decimal50(x)), 1e-48));
  }
  EXPECT_TRUE(std::isinf(log1p_remainder(-1.0)));
}

}  // namespace
}  // namespace shadefit
