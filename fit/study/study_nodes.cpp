#include "fit/study/study_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "fit/formula/tape_program.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/scalars/rounded_once.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A node of one axis. Near a root the distance from it is known to full precision.
struct AxisNode {
  long double at, weight;
};

/// The density of an axis. Near x = 1, 1/sqrt(1 - x^2) cancels: then it is computed in 50 digits. One thread
/// uses it at a time.
class Density {
 public:
  explicit Density(const StudyAxis& axis) : axis_(axis) {
    if (is_one(axis.density)) return;
    const std::array variables{axis.variable};
    narrow_.emplace(tape_of(axis.density, variables), std::span<const double>());
    wide_.emplace(narrow_->tape(), std::span<const long double>());
  }

  long double at(double root, long double distance) {
    if (!narrow_) return 1;
    const long double x = root + distance;
    narrow_->run(std::array{static_cast<double>(x)});
    wide_->run(std::array{x});
    const double narrow = narrow_->output(0);
    const long double wide = wide_->output(0);
    // Long double has eleven digits more: what double loses to some ulps, it does not.
    constexpr long double few_ulps = 8 * std::numeric_limits<double>::epsilon();
    if (std::abs(narrow - wide) <= few_ulps * std::abs(wide)) return wide;
    return rounded_once(axis_.density, [&](const std::string&) {
      return std::array{static_cast<long double>(root), distance};
    });
  }

 private:
  const StudyAxis& axis_;
  std::optional<TapeProgram<double>> narrow_;  ///< empty where it is 1
  std::optional<TapeProgram<long double>> wide_;
};

/// Appends the nodes between an end that may be a root and the other end.
void append_panel(const StudyAxis& axis, Density& density_of_axis, double root, double other, int root_power,
                  unsigned rule_size, std::vector<AxisNode>& nodes) {
  const long double length = static_cast<long double>(other) - static_cast<long double>(root);
  visit_gauss_rule<long double>(rule_size, [&](long double u, long double w) {
    long double lower_power = 1;
    for (int i = 1; i < root_power; ++i) lower_power *= u;
    const long double distance = length * lower_power * u;
    const long double weight = w * std::abs(length) * static_cast<long double>(root_power) * lower_power;
    const long double density = density_of_axis.at(root, distance);
    if (!(density >= 0) || !std::isfinite(density))
      throw UserError("--over '" + axis.variable + "': its density must be finite and not negative; at " +
                      axis.variable + " = " + to_text(static_cast<double>(root + distance)) + " it is " +
                      to_text(static_cast<double>(density)));
    nodes.push_back({static_cast<long double>(root) + distance, weight * density});
  });
}

/// The nodes of an axis between its edges, by a Gauss rule on each panel. Throws UserError where the density
/// is negative or not finite.
std::vector<AxisNode> axis_nodes(const StudyAxis& axis, const std::vector<StudyEdge>& edges,
                                 unsigned rule_size) {
  std::vector<AxisNode> nodes;
  nodes.reserve(std::size_t{2} * rule_size * (edges.size() - 1));
  Density density(axis);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const StudyEdge &left = edges[i - 1], &right = edges[i];
    if (left.power == 1 || right.power == 1) {
      const bool from_right = right.power > 1;
      append_panel(axis, density, from_right ? right.at : left.at, from_right ? left.at : right.at,
                   std::max(left.power, right.power), rule_size, nodes);
    } else {
      const double middle = left.at + (right.at - left.at) / 2;
      append_panel(axis, density, left.at, middle, left.power, rule_size, nodes);
      append_panel(axis, density, right.at, middle, right.power, rule_size, nodes);
    }
  }
  return nodes;
}

StudyNodes nodes_of_rows(const std::shared_ptr<const MeasuredRows>& rows) {
  StudyNodes nodes;
  if (rows->value.size() > most_copied_rows) {
    nodes.rows = rows;
    return nodes;
  }
  for (const auto* column : columns_of(*rows)) nodes.coordinates.emplace_back(column->begin(), column->end());
  nodes.weights.assign(rows->value.size(), 1.0L / static_cast<long double>(rows->value.size()));
  return nodes;
}

}  // namespace

bool is_one(const Symbolic& formula) {
  return formula.parts().empty() && formula.name() == "1";
}

std::vector<double> values_at_nodes(const ReadStudy& study, const Symbolic& formula,
                                    const StudyNodes& nodes) {
  TapeProgram<double> program(tape_of(formula, node_variables(study)), {});
  std::vector<const std::vector<double>*> columns;
  if (nodes.rows) columns = columns_of(*nodes.rows);
  std::vector<double> values, place(nodes.rows ? columns.size() : nodes.coordinates.size());
  values.reserve(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t i = 0; i < place.size(); ++i)
      place[i] = nodes.rows ? (*columns[i])[n] : static_cast<double>(nodes.coordinates[i][n]);
    program.run(place);
    values.push_back(program.output(0));
  }
  return values;
}

StudyNodes nodes_of(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                    unsigned rule_size) {
  if (study.rows) return nodes_of_rows(study.rows);
  StudyNodes nodes{{}, {1.0L}, 1};
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    MovingEdges moving(study, i, edges[i]);
    std::vector<AxisNode> of_axis = axis_nodes(study.axes[i], edges[i], rule_size);
    StudyNodes product{std::vector<std::vector<long double>>(i + 1), {}, 1};
    product.weights.reserve(nodes.weights.size() * of_axis.size());
    for (auto& coordinate : product.coordinates) coordinate.reserve(product.weights.capacity());
    for (std::size_t n = 0; n < nodes.weights.size(); ++n) {
      std::vector<long double> before;
      for (std::size_t k = 0; k < i; ++k) before.push_back(nodes.coordinates[k][n]);
      if (!moving.are_fixed()) of_axis = axis_nodes(study.axes[i], moving.at(before), rule_size);
      for (const AxisNode& node : of_axis) {
        for (std::size_t k = 0; k < i; ++k) product.coordinates[k].push_back(before[k]);
        product.coordinates[i].push_back(node.at);
        product.weights.push_back(nodes.weights[n] * node.weight);
      }
    }
    nodes = std::move(product);
  }
  nodes.total = 0;
  for (const long double weight : nodes.weights) nodes.total += weight;
  for (long double& weight : nodes.weights) weight /= nodes.total;
  return nodes;
}

}  // namespace shadefit
