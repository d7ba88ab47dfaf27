#include "fit/study_proof/error_limits.hpp"

#include <algorithm>
#include <map>
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
    int value, slope;
  };
  /// The nodes that enclose the quotient of two nodes and its slope, if both nodes are 0 here.
  std::optional<Quotient> limit_of_quotient(int a, int b) const {
    constexpr int most_zeros = 6;
    if (!is_zero(b) || !is_zero(a)) return std::nullopt;
    for (int k = 1; k <= most_zeros; ++k) {
      a = slope(a);
      b = slope(b);
      if (has_one_sign(value(b))) {
        // A'/B - (A/B) B'/B, of A = a/k!, A' = a'/(k + 1)!, and likewise B
        const int value = graph_.quotient(a, b);
        const int rise = graph_.difference(slope(a), graph_.product(value, slope(b)));
        const int next = graph_.add(Symbolic::number(std::to_string(k + 1)));
        return Quotient{value, graph_.quotient(rise, graph_.product(next, b))};
      }
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
  Graph& graph_;
  Interval place_;
  std::span<const Interval> parameters_;
};

bool is_logarithm(const GraphNode& node) {
  return node.operation == Operation::function && (name_of_one(node) == "log" || name_of_one(node) == "log2");
}

/// Whether each derivative is that of the formula wherever it is bounded.
bool is_smooth(const GraphNode& node) {
  if (node.operation == Operation::choice || node.operation == Operation::function_of_two) return false;
  if (node.operation != Operation::function) return true;
  const std::string_view name = name_of_one(node);
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
      } else if (node.operation == Operation::multiply) {
        for (const auto& [factor, other] : {std::pair(a, b), std::pair(b, a)}) {
          const GraphNode logarithm = graph.nodes()[static_cast<std::size_t>(other)];
          if (is_logarithm(logarithm) && here.is_zero_product(factor, logarithm.operands[0]))
            at[i] = graph.add(Symbolic::number("0"));
        }
      }
    }
    if (at.empty()) continue;
    const std::vector<int> value_and_slope{graph.replaced(error, beside),
                                           graph.replaced(graph.derivative(error, 0), beside)};
    const std::vector<int> value{graph.replaced(error, at)};
    places_.push_back({place, TapeProgram<Interval>(Tape(graph, value_and_slope), parameters),
                       TapeProgram<Interval>(Tape(graph, value), parameters)});
  }
}

std::optional<ErrorLimits::ValueAndSlope> ErrorLimits::near(const Interval& x) {
  const double lower = lower_end(x), upper = upper_end(x), length = upper - lower;
  for (Place& place : places_) {
    if (place.at < lower - length || upper + length < place.at) continue;
    place.beside.run(std::vector{Scalar<Interval>::hull(x, Interval(place.at))});
    const ValueAndSlope result{place.beside.output(0), place.beside.output(1)};
    if (is_bounded(result.value) && is_bounded(result.slope)) return result;
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
