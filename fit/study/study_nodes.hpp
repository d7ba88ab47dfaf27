#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "fit/study/study.hpp"

/// The nodes at which the integrals of a study are summed.
namespace shadefit {

/// A place where some formula of a study is not smooth in a variable.
struct StudyEdge {
  double at;
  int power = 1;         ///< the formula is smooth in this root of the distance
  bool is_jump = false;  ///< whether it has another value on each side, and perhaps a third one here
};

class KnownZeros {
 public:
  /// A hinge and the range of its variable.
  using Of = std::tuple<std::string, bool, bool, double, double>;

  /// The edges that `find` gives for it, which is called where they are not known. Safe under threads.
  std::vector<StudyEdge> of(const Of& hinge, const std::function<std::vector<StudyEdge>()>& find);

 private:
  std::mutex lock_;
  std::map<Of, std::vector<StudyEdge>> found_;
};

/// The edges of an axis, rising: both ends of its range, and inside it the zeros of the hinges that depend on
/// this variable alone.
std::vector<StudyEdge> edges_of(const ReadStudy& study, std::size_t axis);
/// Those of each axis; none of measured rows.
std::vector<std::vector<StudyEdge>> edges_of(const ReadStudy& study);

/// Edges with both sides of each jump in place of it: first the left one, which has `is_jump`. Of a jump at
/// an end they are the end and its side.
std::vector<StudyEdge> with_sides(const std::vector<StudyEdge>& edges);

/// The parts of the form at whose zeros it has a kink that parameters move: a x - b of max(a x, b).
std::vector<Symbolic> moving_kinks(const ReadStudy& study);
/// The denominators of the form, and the operands of its logarithms, that contain a parameter.
std::vector<Symbolic> moving_poles(const ReadStudy& study);

/// The edges of an axis and the zeros of formulas of its variable alone.
std::vector<StudyEdge> with_zeros(const StudyAxis& axis, std::vector<StudyEdge> edges,
                                  const std::vector<Symbolic>& formulas);

/// A formula of the study at given parameters.
Symbolic at_parameters(const ReadStudy& study, const Symbolic& formula,
                       const std::vector<double>& parameters);

/// The zeros of a formula of one variable, its ends included. The search looks at 592 places, so it can miss
/// two zeros that are closer.
std::vector<double> zeros_of(const Symbolic& formula, const StudyAxis& axis);

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
