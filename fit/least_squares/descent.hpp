#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "fit/least_squares/sampled_errors.hpp"
#include "fit/least_squares/status.hpp"
#include "fit/least_squares/sums.hpp"

/// The way down to the optimum of a sampled problem: Ceres into the basin from three starts, Newton to its
/// bottom.
namespace shadefit {

/// Relative. Polishing in double leaves a few units of 1e-16; two different optima differ visibly. A looser
/// agreement saves no time that could be measured, and lets a pair on a thousandth of its domain pass with a
/// wrong optimum.
inline constexpr double same_optimum = 1e-12;
/// Ceres looks for the basin with twelve nodes, on one panel or two.
inline constexpr unsigned basin_nodes = 12;

/// A point on the way down, and a Hessian from nearby, if there is one.
struct Candidate {
  ParameterVector<double> parameters;
  std::optional<ParameterMatrix<double>> hessian = std::nullopt;
  int iterations = 0;
  Status status = Status::not_converged;
  std::string_view why = {};  ///< where it did not converge, in words
};

/// The three starts of a descent.
using Starts = std::array<ParameterVector<double>, 3>;

/// Newton in double to the bottom of the basin, until the remaining distance is below `rest` of the
/// parameters. The Hessian costs up to seven times as much as the gradient: it is kept while each step is at
/// most a third of the one before, and corrected by the gradients.
void polish(const SampledErrors& problem, Candidate& candidate, double rest);

/// The optimum on few nodes, if the first `asked` starts all lead to it; else the status says why not. The
/// Hessian of the first descent serves the other starts and the larger rules. Few steps are tried first, and
/// many only if these fail.
Candidate common_optimum(const Starts& starts, const SampledErrors& problem, std::size_t asked = 3);

}  // namespace shadefit
