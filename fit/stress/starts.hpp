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

/// The results of one fit (least squares, uniform in the cosine) that is repeated many times. Each time its
/// three starts are drawn from a wide box. All have to lead to one optimum.
struct StartsTrial {
  std::string_view family;
  std::optional<double> exponent = {};
  Domain domain;
  Status status = Status::not_converged;  ///< of the fit from the family's own starts
  long starts = 0;
  long fits = 0;
  long reached = 0;    ///< fits that converged at the optimum: the result of the family's own starts or, if
                       ///< these do not meet, of the first fit that converges
  long failed = 0;     ///< fits that reported that they did not converge
  long elsewhere = 0;  ///< fits that converged at another place
  long returned = 0;   ///< fits that converged at one of their starts
  int claimed = 0;     ///< the digits that the fit claims
  int digits = 0;      ///< its true digits by a Newton step in 50 digits, with the same cap

  /// Whether no wrong answer was returned: all converged fits agree on one optimum, with the claimed digits.
  bool is_right() const { return elsewhere == 0 && returned == 0 && digits >= claimed; }
};

/// Every family at every setting; about `starts` fits for each family. `progress` gets the finished share.
std::vector<StartsTrial> try_starts(
    std::size_t starts, const Checkpoint& checkpoint = keep_going,
    const std::function<void(double share)>& progress = [](double) {});

}  // namespace shadefit
