#include "fit/bounds/error_limits.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "fit/proof/interval_ends.hpp"

namespace shadefit {
namespace {

/// Nodes of a graph at one place.
class AtPlace {
 public:
  AtPlace(Graph& graph, double place, std::span<const Interval> parameters)
      : graph_(graph), place_(place), parameters_(parameters) {}

  Interval value(int node) const {
    TapeProgram<Interval> program(Tape(graph_, std::vector{node}), parameters_);
    program.run(std::vector{place_});
    return program.output(0);
  }
  bool is_zero(int node) const { return Scalar<Interval>::is_zero(value(node)); }
  int slope(int node) const { return graph_.derivative(node, 0); }

  struct Quotient {
    int value, slope, curvature;
  };
  /// The nodes that enclose the quotient of two nodes and its derivatives, if both nodes are 0 here.
  std::optional<Quotient> limit_of_quotient(int a, int b) const {
    constexpr int most_zeros = 6;
    if (!is_zero(b) || !is_zero(a)) return std::nullopt;
    for (int k = 1; k <= most_zeros; ++k) {
      a = slope(a);
      b = slope(b);
      if (has_one_sign(value(b))) return quotient_of(a, b, k);
      if (!is_zero(b) || !is_zero(a)) return std::nullopt;
    }
    return std::nullopt;
  }

  /// Whether a product with a logarithm of `inner` is 0.
  bool is_zero_product(int factor, int inner) const {
    return is_zero(factor) && is_zero(inner) && is_bounded(value(slope(factor))) &&
           has_one_sign(value(slope(inner)));
  }

 private:
  int whole(int n) const { return graph_.add(Symbolic::number(std::to_string(n))); }

  /// Of the k-th derivatives of two nodes. With the coefficients A_j of A, each times k!, those of A/B are
  /// q_0 = A_0/B_0, q_1 = (A_1 - q_0 B_1)/B_0 and q_2 = (A_2 - q_1 B_1 - q_0 B_2)/B_0.
  Quotient quotient_of(int a, int b, int k) const {
    const auto coefficients = [&](int node) {
      const int first = slope(node), second = slope(first);
      return std::array{node, graph_.quotient(first, whole(k + 1)),
                        graph_.quotient(second, whole((k + 1) * (k + 2)))};
    };
    const auto as = coefficients(a), bs = coefficients(b);
    const auto without = [&](int sum, int factor, int other) {
      return graph_.difference(sum, graph_.product(factor, other));
    };
    const int value = graph_.quotient(as[0], bs[0]);
    const int rise = graph_.quotient(without(as[1], value, bs[1]), bs[0]);
    const int half = graph_.quotient(without(without(as[2], rise, bs[1]), value, bs[2]), bs[0]);
    return {value, rise, graph_.product(whole(2), half)};
  }

  Graph& graph_;
  Interval place_;
  std::span<const Interval> parameters_;
};

bool is_logarithm(const GraphNode& node) {
  return function_name(node) == "log" || function_name(node) == "log2";
}

/// Whether each derivative is that of the formula wherever it is bounded.
bool is_smooth(const GraphNode& node) {
  if (node.operation == Operation::choice || node.operation == Operation::function_of_two) return false;
  const std::string_view name = function_name(node);
  return name != "abs" && name != "sign" && name != "floor";
}

}  // namespace

ErrorLimits::ErrorLimits(Graph& graph, int error, std::span<const double> places,
                         std::span<const Interval> parameters) {
  if (!std::ranges::all_of(graph.nodes(), is_smooth)) return;
  const int count = static_cast<int>(graph.nodes().size());
  for (const double place : places) {
    const AtPlace here(graph, place, parameters);
    std::map<int, int> beside, at;
    for (int i = 0; i < count; ++i) {
      const GraphNode node = graph.nodes()[static_cast<std::size_t>(i)];
      const auto [a, b, c, d] = node.operands;
      if (node.operation == Operation::divide) {
        const auto limit = here.limit_of_quotient(a, b);
        if (!limit) continue;
        beside[i] = at[i] = limit->value;
        beside[here.slope(i)] = limit->slope;
        beside[here.slope(here.slope(i))] = limit->curvature;
      } else if (node.operation == Operation::multiply) {
        for (const auto& [factor, other] : {std::pair(a, b), std::pair(b, a)}) {
          const GraphNode logarithm = graph.nodes()[static_cast<std::size_t>(other)];
          if (is_logarithm(logarithm) && here.is_zero_product(factor, logarithm.operands[0]))
            at[i] = graph.add(Symbolic::number("0"));
        }
      }
    }
    if (at.empty()) continue;
    const int slope = here.slope(error), curvature = here.slope(slope);
    std::vector<int> derivatives;
    for (const int node : {error, slope, curvature}) derivatives.push_back(graph.replaced(node, beside));
    const std::vector<int> value{graph.replaced(error, at)};
    places_.push_back({place, TapeProgram<Interval>(Tape(graph, derivatives), parameters),
                       TapeProgram<Interval>(Tape(graph, value), parameters)});
  }
}

std::optional<ErrorLimits::Derivatives> ErrorLimits::on(const Interval& x) {
  for (Place& place : places_) {
    place.beside.run(std::vector{Scalar<Interval>::hull(x, Interval(place.at))});
    const Derivatives found{place.beside.output(0), place.beside.output(1), place.beside.output(2)};
    if (is_bounded(found.value) && is_bounded(found.slope) && is_bounded(found.curvature)) return found;
  }
  return std::nullopt;
}

std::optional<Interval> ErrorLimits::at(const Interval& x) {
  for (Place& place : places_) {
    if (!Scalar<Interval>::is_zero(x - Interval(place.at))) continue;
    place.here.run(std::vector{x});
    if (is_bounded(place.here.output(0))) return place.here.output(0);
  }
  return std::nullopt;
}

}  // namespace shadefit
