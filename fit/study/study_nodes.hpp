#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_edges.hpp"

/// The nodes at which the integrals of a study are summed.
namespace shadefit {

struct StudyNodes {
  std::vector<std::vector<long double>> coordinates;  ///< of each of `node_variables`, at each node
  std::vector<long double> weights;                   ///< the density included; they sum to 1
  long double total = 1;                              ///< the integral of the density
  /// More rows than `most_copied_rows`: both lists are empty, and the nodes are read where the rows are.
  std::shared_ptr<const MeasuredRows> rows = nullptr;

  std::size_t size() const { return rows ? rows->value.size() : weights.size(); }
  long double weight(std::size_t node) const {
    return rows ? 1.0L / static_cast<long double>(rows->value.size()) : weights[node];
  }
};

/// More rows are not copied: in long double a copy takes 48 bytes a row.
inline constexpr std::size_t most_copied_rows = 100'000;

/// Whether a formula is the number 1, as a weight or a density is that nobody gave.
bool is_one(const Symbolic& formula);

/// A formula of `node_variables` at each node.
std::vector<double> values_at_nodes(const ReadStudy& study, const Symbolic& formula, const StudyNodes& nodes);

/// The product of Gauss rules with `rule_size` nodes on each panel of each axis. An axis is also split where
/// a hinge of it and of the axes before it is zero: max(x, y) has its kink at y = x. Throws UserError for a
/// density that is negative or not finite.
///
/// With measured rows each row is a node of the same weight, whatever the edges and the rule.
StudyNodes nodes_of(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                    unsigned rule_size);

}  // namespace shadefit
