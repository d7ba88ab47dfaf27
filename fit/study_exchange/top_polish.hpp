#pragma once

#include <cstddef>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/tape/tape.hpp"

namespace shadefit {

/// Moves places to stationary points of the error along the variables that are not at an edge.
class TopPolish {
 public:
  /// `weighted` is a study whose form is the error (`weighted_error_of`).
  TopPolish(const ReadStudy& weighted, const std::vector<std::vector<StudyEdge>>& edges);

  /// Newton's method. A place that it does not improve stays as it is.
  std::vector<double> operator()(std::vector<double> place, const std::vector<double>& parameters) const;

 private:
  std::vector<double> at(const std::vector<double>& place, const std::vector<double>& parameters) const;
  bool snap(std::vector<double>& place, std::size_t axis, const std::vector<double>& parameters) const;
  bool step(std::vector<double>& place, const std::vector<bool>& is_free,
            const std::vector<double>& parameters) const;

  std::vector<StudyAxis> axes_;
  std::vector<std::vector<StudyEdge>> edges_;
  Tape tape_;  ///< the error, its slopes, and its second slopes: (0, 0), (1, 0), (1, 1), (2, 0) ..
};

/// The tops of the error at some parameters, polished: those with at least 0.3 of the largest.
std::vector<std::vector<double>> polished_tops(const ReadStudy& weighted,
                                               const std::vector<std::vector<StudyEdge>>& edges,
                                               const TopPolish& polish,
                                               const std::vector<double>& parameters);

}  // namespace shadefit
