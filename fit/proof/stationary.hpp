#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fit/fit.hpp"
#include "fit/support/checkpoint.hpp"

/// Proves that the stationary point of a least-squares integral exists near a fit and is unique.
namespace shadefit {

/// The relative half width of the box around a fit in which the stationary point is proven unique. A hundred
/// times the promised accuracy of a fit.
inline constexpr double stationary_radius = 1e-13;

/// A proof that the gradient of the integral of measure * error^2 vanishes once in a box of parameters.
struct StationaryPoint {
  using Range = std::pair<double, double>;

  bool is_proven = false;
  std::string reason = {};            ///< why it is not proven
  bool is_minimum = false;            ///< the Hessian is positive definite in the whole box
  std::vector<Range> unique_in = {};  ///< parameters: exactly one stationary point is in here
  std::vector<Range> lies_in = {};    ///< and it lies in here
  int digits = 0;  ///< floor(-log10) of the fit's distance from it, relative; the worst parameter
};

/// Proves it by one step of Krawczyk's operator, K = p - C g(p) + (1 - C H)(P - p): if K lies inside the box
/// P, g vanishes exactly once in P, namely in K. Gradient g and Hessian H are integrals, enclosed with their
/// quadrature's remainder (fit/proof/enclosed_integral.hpp), so the proof is about the integral, not about a
/// sum. Source: Krawczyk 1969, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken"; Moore
/// 1977, "A test for existence of solutions to nonlinear systems".
///
/// Only for a converged least-squares fit of the absolute error; for other fits `reason` says why not.
StationaryPoint prove_stationary(const Fit& fit, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
