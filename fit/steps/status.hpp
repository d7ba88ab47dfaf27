#pragma once

#include <string_view>

/// How a fit ended.
namespace shadefit {

enum class Status {
  converged,  ///< one optimum; in wider arithmetic the Newton step there is below `settled` of each parameter
  ambiguous,  ///< another curve is as good
  not_converged,  ///< no quadrature rule settled the answer, or the gradient is not zero there
  not_finite,     ///< a value was infinite or not a number
  degenerate,     ///< of minimax: fewer alternation points than parameters + 1 hold the optimum
  infeasible,     ///< of minimax: no parameters satisfy the constraints
  unresolved,     ///< more happens somewhere than samples explain
  at_border,      ///< the descent ends where the form has a pole
};

constexpr std::string_view name(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::ambiguous:
      return "ambiguous";
    case Status::not_converged:
      return "not-converged";
    case Status::not_finite:
      return "not-finite";
    case Status::degenerate:
      return "degenerate";
    case Status::infeasible:
      return "infeasible";
    case Status::unresolved:
      return "unresolved";
    case Status::at_border:
      return "at-border";
  }
  return "unknown";
}

}  // namespace shadefit
