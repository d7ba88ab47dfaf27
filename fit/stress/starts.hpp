#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "fit/least_squares/status.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// Fits under stress: from many starts, for exponents from 1e-3 to 1e9, on domains shrunk to a thousandth.
namespace shadefit {

/// What came of one fit (least squares, uniform in the cosine) that was made many times over, each time from
/// three starts drawn from a wide box, where it has three of its own; these have to lead to one optimum.
struct StartsTrial {
  std::string_view family;
  std::optional<double> exponent;
  Domain domain;
  Status status = Status::not_converged;  ///< of the fit from the family's own starts
  long starts = 0;
  long fits = 0;
  long reached = 0;  ///< fits that converged at the optimum: that of the family's own starts or, where these
                     ///< do not meet, that of the first that converges
  long failed = 0;   ///< that said that they did not converge
  long elsewhere = 0;  ///< that converged at another place
  long returned = 0;   ///< that converged at one of their very starts
  int claimed = 0;     ///< the digits that the fit says it has
  int digits = 0;      ///< those that it has: against a Newton step in 50 digits, capped like those claimed

  /// Whether nothing wrong was returned as an answer: what converged is one optimum, and known as well as it
  /// is said.
  bool is_right() const { return elsewhere == 0 && returned == 0 && digits >= claimed; }
};

/// Every family at every setting; about `starts` of them for each family. `progress` is told the
/// share that is done.
std::vector<StartsTrial> try_starts(
    std::size_t starts, const Checkpoint& checkpoint = keep_going,
    const std::function<void(double share)>& progress = [](double) {});

}  // namespace shadefit
