#include "fit/bounds/lowest_value.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/proof/interval_ends.hpp"

namespace shadefit {
namespace {

bool is_one_place(const Stretch& side) {
  return side.lower == side.upper;
}

/// The lower end; -infinity instead of NaN.
double lowest_in(const Interval& x) {
  return std::isnan(lower_end(x)) || std::isnan(upper_end(x)) ? -std::numeric_limits<double>::infinity()
                                                              : lower_end(x);
}

/// The function, all operations of the graph, and the deciding nodes of its jumps.
Tape value_tape(Graph& graph, int node, const Jumps& jumps) {
  std::vector<int> outputs{node};
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) outputs.push_back(static_cast<int>(i));
  for (const int deciding : jumps.deciding_nodes()) outputs.push_back(deciding);
  return {graph, outputs};
}

Tape slope_tape(Graph& graph, int node, std::size_t variables) {
  std::vector<int> outputs;
  for (std::size_t i = 0; i < variables; ++i) outputs.push_back(graph.derivative(node, i));
  return {graph, outputs};
}

}  // namespace

// In this order: the slopes add nodes to the graph.
LowestValue::LowestValue(Graph graph, int node, std::vector<Domain> ranges,
                         std::span<const Interval> parameters)
    : ranges_(std::move(ranges)),
      jumps_(graph),
      operations_(graph.nodes().size()),
      value_(value_tape(graph, node, jumps_), parameters),
      slopes_(slope_tape(graph, node, ranges_.size()), parameters) {}

const Interval& LowestValue::values_on(const StudyBox& box) {
  value_.run(numbers_on(box, ranges_));
  return value_.output(0);
}

bool LowestValue::may_have_pole() const {
  for (std::size_t i = 0; i < operations_; ++i) {
    if (!is_bounded(value_.output(1 + i))) return true;
  }
  return false;
}

LowestOnBox LowestValue::on(const StudyBox& box, double enough) {
  LowestOnBox result{.values = values_on(box),
                     .may_have_pole = may_have_pole(),
                     .may_jump = jumps_.may_happen(value_, 1 + operations_),
                     .lowest = 0,
                     .place = middle_of_all(box),
                     .axis = widest_axis(box, ranges_)};
  result.lowest = lowest_in(result.values);
  if (!(result.lowest >= enough) && !result.may_have_pole && !result.may_jump)
    improve_by_mean_value(box, result);
  return result;
}

void LowestValue::improve_by_mean_value(const StudyBox& box, LowestOnBox& result) {
  StudyBox low = least_face(box);
  Interval rest(0);
  double widest_term = -1;
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (is_one_place(low[i])) continue;
    const Interval& slope = slopes_.output(i);
    if (!is_bounded(slope)) continue;  // the variable keeps its whole interval
    const Stretch side = low[i];
    low[i] = middle_of(side);
    const Interval term = slope * (span_of(side.lower, side.upper) - Interval(low[i].lower));
    rest = rest + term;
    if (width_of(term) > widest_term) {
      widest_term = width_of(term);
      result.axis = i;
    }
  }
  result.place = middle_of_all(low);
  result.lowest = std::fmax(result.lowest, lowest_in(values_on(low) + rest));
}

StudyBox LowestValue::least_face(StudyBox box) {
  bool is_narrower = true;
  while (is_narrower && !std::ranges::all_of(box, is_one_place)) {
    is_narrower = false;
    slopes_.run(numbers_on(box, ranges_));
    for (std::size_t i = 0; i < box.size(); ++i) {
      const Interval& slope = slopes_.output(i);
      if (is_one_place(box[i]) || !is_bounded(slope)) continue;
      if (!is_never_negative(slope) && !is_never_positive(slope)) continue;
      (is_never_negative(slope) ? box[i].upper : box[i].lower) =
          is_never_negative(slope) ? box[i].lower : box[i].upper;
      is_narrower = true;
    }
  }
  return box;
}

}  // namespace shadefit
