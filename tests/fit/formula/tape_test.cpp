#include "fit/formula/tape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fit/formula/batch.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/proof/interval.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/any_expression.hpp"
#include "tests/decimal100.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

const std::vector<std::string> names{"x", "a", "b"};
const std::array<std::array<double, 3>, 4> places{
    {{0.3, 1.7, 0.6}, {0.9, -0.4, 2.3}, {0.55, 0.21, -1.1}, {0.02, 3.1, 0.8}}};

/// Whether an operation has numbers alone as operands. The tape computes it in 50 digits, `evaluate` in its
/// scalar.
bool folds(const Symbolic& e) {
  bool all_numbers = !e.parts().empty();
  for (const Symbolic& part : e.parts()) {
    if (folds(part)) return true;
    const bool is_number = part.kind() == Symbolic::Kind::number || part.kind() == Symbolic::Kind::constant;
    all_numbers = all_numbers && is_number;
  }
  return all_numbers;
}

/// Random formulas of x, a and b in which nothing is folded.
std::vector<Symbolic> formulas(std::size_t count) {
  testing::AnyExpression any(7, names);
  std::vector<Symbolic> result;
  while (result.size() < count) {
    const Symbolic e = any.of_depth(4);
    if (!folds(e)) result.push_back(e);
  }
  return result;
}

Tape tape_of(Graph& graph, std::span<const int> outputs) {
  std::vector<int> inputs;
  for (const std::string& name : names) inputs.push_back(graph.add(Symbolic::variable(name)));
  return {graph, outputs, inputs};
}

/// The outputs of a tape for some inputs.
template <class T>
std::vector<T> outputs_of(const Tape& tape, const std::vector<T>& inputs) {
  TapeProgram<T> program(tape, {});
  program.run(inputs);
  std::vector<T> outputs;
  for (std::size_t i = 0; i < tape.output_count(); ++i) outputs.push_back(program.output(i));
  return outputs;
}

/// x, a and b at a place. In a Jet a and b are the variables of its derivatives.
template <class T>
std::vector<T> inputs_at(const std::array<double, 3>& place) {
  std::vector<T> result;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if constexpr (is_jet<T>) {
      T jet(inputs_at<typename T::Scalar>(place)[i]);
      if (i > 0) jet.v[static_cast<int>(i) - 1] = integer<typename T::Scalar>(1);
      result.push_back(jet);
    } else {
      result.push_back(static_cast<T>(place[i]));
    }
  }
  return result;
}

/// A formula with one of these inputs for each name.
template <class T>
T evaluate_at(const Symbolic& e, const std::vector<T>& inputs) {
  return evaluate<T>(e, [&](const std::string& name) {
    return inputs[name == "x" ? 0 : name == "a" ? 1 : 2];
  });
}

std::string words(const Symbolic& e, const std::array<double, 3>& at) {
  return to_text(e) + " at x = " + std::to_string(at[0]) + ", a = " + std::to_string(at[1]) +
         ", b = " + std::to_string(at[2]);
}

template <class T>
bool is_same(const T& a, const T& b) {
  if constexpr (std::same_as<T, Interval>) {
    const auto *p = a.backend().data(), *q = b.backend().data();
    return (mpfi_nan_p(p) != 0 && mpfi_nan_p(q) != 0) ||
           (mpfr_equal_p(&p->left, &q->left) != 0 && mpfr_equal_p(&p->right, &q->right) != 0);
  } else if constexpr (std::same_as<T, TwoLanes>) {
    return is_same(a[0], b[0]) && is_same(a[1], b[1]);
  } else {
    return a == b || (a != a && b != b);
  }
}

template <class T>
class TapeIn : public ::testing::Test {};
using Scalars =
    ::testing::Types<float, double, long double, Eigen::half, TwoLanes, Decimal50, Decimal100, Interval>;
TYPED_TEST_SUITE(TapeIn, Scalars);

// The same operations in the same order: the same bits.
TYPED_TEST(TapeIn, IsWhatEvaluateReturns) {
  for (const Symbolic& e : formulas(200)) {
    Graph graph(names);
    const std::array outputs{graph.add(e)};
    const Tape tape = tape_of(graph, outputs);
    for (const auto& place : places) {
      const auto inputs = inputs_at<TypeParam>(place);
      const auto expected = evaluate_at(e, inputs);
      ASSERT_TRUE(is_same(outputs_of(tape, inputs).front(), expected)) << words(e, place);
    }
  }
}

/// Whether every part of a formula is a number at a place. A maximum may hide one that is not. A power of 0
/// has derivatives by limits alone.
bool is_defined(const Symbolic& e, const std::array<double, 3>& at) {
  const double value = evaluate_at(e, inputs_at<double>(at));
  if (e.kind() == Symbolic::Kind::real_power && evaluate_at(e.part(0), inputs_at<double>(at)) == 0)
    return false;
  return std::isfinite(value) && std::all_of(e.parts().begin(), e.parts().end(),
                                             [&](const Symbolic& part) { return is_defined(part, at); });
}

// Around each place, of radius 1e-9 in every input: the values at two corners and in its middle, in 50
// digits.
TEST(Tape, AnIntervalEnclosesWhatIsInside) {
  constexpr double radius = 1e-9;
  int compared = 0;
  for (const Symbolic& e : formulas(200)) {
    Graph graph(names);
    const std::array outputs{graph.add(e)};
    const Tape tape = tape_of(graph, outputs);
    for (const auto& place : places) {
      std::vector<Interval> box;
      for (const double x : place)
        box.push_back(Scalar<Interval>::hull(Interval(x - radius), Interval(x + radius)));
      const Interval enclosure = outputs_of(tape, box).front();
      // x < x is not decided for a box: both branches count, and one may leave the domain of a root. Then
      // the ends are no numbers, and no proof uses them.
      if (isnan(testing::end(enclosure, false)) || isnan(testing::end(enclosure, true))) continue;
      for (const int corner : {0, 7, 8}) {
        std::array<double, 3> inside = place;
        for (std::size_t i = 0; i < 3 && corner < 8; ++i)
          inside[i] += (corner >> i) % 2 == 0 ? radius : -radius;
        if (!is_defined(e, inside)) continue;
        ++compared;
        const Decimal100 value(evaluate_at(e, inputs_at<Decimal50>(inside)));
        // At a corner the value may be an end of the interval. It is right to 40 of its digits.
        const Decimal100 rounding = abs(value) * Decimal100("1e-40");
        EXPECT_TRUE(testing::end(enclosure, false) - rounding <= value &&
                    value <= testing::end(enclosure, true) + rounding)
            << words(e, inside) << ": " << value.str(30) << " is not in ["
            << testing::end(enclosure, false).str(30) << ", " << testing::end(enclosure, true).str(30) << "]";
      }
    }
  }
  EXPECT_GT(compared, 1000) << "most are numbers";
}

// Value, first and second derivatives by a and b against nested Jets, in 50 digits.
TEST(Graph, DerivativesAreThoseOfNestedJets) {
  using First = ceres::Jet<Decimal50, 2>;
  using Second = ceres::Jet<First, 2>;
  int compared = 0;
  for (const Symbolic& e : formulas(200)) {
    Graph graph(names);
    const int value = graph.add(e);
    const int by_a = graph.derivative(value, 1), by_b = graph.derivative(value, 2);
    const std::array outputs{value,
                             by_a,
                             by_b,
                             graph.derivative(by_a, 1),
                             graph.derivative(by_a, 2),
                             graph.derivative(by_b, 1),
                             graph.derivative(by_b, 2)};
    const Tape tape = tape_of(graph, outputs);
    for (const auto& place : places) {
      if (!is_defined(e, place)) continue;
      const Second jet = evaluate_at(e, inputs_at<Second>(place));
      const std::array expected{jet.a.a,       jet.a.v[0],    jet.a.v[1],   jet.v[0].v[0],
                                jet.v[0].v[1], jet.v[1].v[0], jet.v[1].v[1]};
      const auto computed = outputs_of(tape, inputs_at<Decimal50>(place));
      for (std::size_t i = 0; i < expected.size(); ++i) {
        if (!isfinite(expected[i])) continue;
        ++compared;
        // Terms of a derivative may cancel: by less than ten of fifty digits at these places.
        const Decimal50 size = 1 + Decimal50(abs(expected[i]));
        EXPECT_LE(Decimal50(abs(computed[i] - expected[i])), size * Decimal50("1e-40"))
            << words(e, place) << ", output " << i;
      }
    }
  }
  EXPECT_GT(compared, 1000) << "most are numbers";
}

// What is read back from its text is the same graph.
TEST(Graph, AFormulaReadBackIsTheSameNode) {
  const std::array<std::string_view, 3> known{"x", "a", "b"};
  for (const Symbolic& e : formulas(200)) {
    Graph graph(names);
    const int node = graph.add(e);
    EXPECT_EQ(graph.add(parse_formula(to_text(e), known)), node) << to_text(e);
  }
}

TEST(Graph, KnowsWhatDoesNotDepend) {
  Graph graph(names);
  const int line =
      graph.add(parse_formula("sqrt(1 - x) (a + b x)", std::array<std::string_view, 3>{"x", "a", "b"}));
  const int by_a = graph.derivative(line, 1);
  EXPECT_FALSE(graph.is_zero(by_a));
  EXPECT_TRUE(graph.is_zero(graph.derivative(by_a, 1))) << "linear";
  EXPECT_TRUE(graph.is_zero(graph.derivative(by_a, 2))) << "in both together";
}

TEST(Graph, EqualPartsStandOnce) {
  Graph graph(names);
  constexpr std::array<std::string_view, 3> known{"x", "a", "b"};
  const int left = graph.add(parse_formula("exp2(a x) + exp2(a x)", known));
  EXPECT_EQ(graph.nodes().size(), 5u) << "a, x, a x, exp2, the sum";
  EXPECT_EQ(graph.add(parse_formula("exp2(a x) + exp2(a x)", known)), left);
  EXPECT_THROW(graph.add(Symbolic::variable("y")), std::logic_error);
}

TEST(Tape, NeedsItsInputs) {
  Graph graph(names);
  const std::array outputs{graph.add(Symbolic::variable("x") + Symbolic::variable("a"))};
  EXPECT_THROW(Tape(graph, outputs, {}), std::logic_error);
}

// Many places at a time, an odd number of them and more than a block: the same bits as one by one.
TEST(Batch, IsTheTapeAtEachNode) {
  std::vector<double> nodes;
  for (int i = 0; i < 131; ++i) nodes.push_back((i + 0.5) / 131);
  const std::vector<std::vector<double>> coordinates{nodes};
  const std::vector<double> parameters{0.7, -0.3};
  for (const Symbolic& e : formulas(60)) {
    Graph graph(names);
    const int value = graph.add(e);
    const std::array outputs{value, graph.derivative(value, 1)};
    const Tape tape = tape_of(graph, outputs);
    const StagedTape staged(graph, outputs, 1);
    const Batch<double> batch(staged, coordinates);
    ASSERT_EQ(batch.nodes(), nodes.size());
    batch.visit(parameters, [&](std::size_t first, std::size_t count, const auto& results) {
      for (std::size_t i = 2 * first; i < std::min(2 * (first + count), nodes.size()); ++i) {
        const auto expected = outputs_of<TwoLanes>(tape, {nodes[i], parameters[0], parameters[1]});
        for (std::size_t o = 0; o < outputs.size(); ++o)
          ASSERT_TRUE(is_same(results[o][i / 2 - first][i % 2], expected[o][0]))
              << to_text(e) << ", output " << o << " at x = " << nodes[i];
      }
    });
  }
}

}  // namespace
}  // namespace shadefit
