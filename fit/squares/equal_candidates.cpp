#include "fit/squares/equal_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "fit/steps/scaled_hessian.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {

std::vector<StudyCandidate> best_of(const std::vector<StudyCandidate>& candidates, double target_norm) {
  constexpr double equal = 1e-9;
  // Below this the square is rounding.
  const double least = 1e-24 * target_norm * target_norm;
  // What is left of a square without its linear part may be below 0.
  const double lowest = std::max(0.0, candidates.front().square);
  std::vector<StudyCandidate> best;
  for (const StudyCandidate& candidate : candidates) {
    if (candidate.square <= lowest * (1 + equal) + least) best.push_back(candidate);
  }
  return best;
}

bool is_same_curve(const SampledStudy<double>& sampled, const StudyCandidate& a, const StudyCandidate& b) {
  if (a.parameters == b.parameters) return true;
  VectorOf<double> first, second;
  sampled.errors(a.parameters, first, nullptr);
  sampled.errors(b.parameters, second, nullptr);
  const double distance = std::sqrt((first - second).cwiseAbs2().dot(sampled.roots().cwiseAbs2()));
  return distance <= 1e-5 * std::max(sampled.target_norm(), std::sqrt(a.square));
}

StudyCandidate canonical(const ReadStudy& study, const SampledStudy<double>& sampled,
                         const std::vector<StudyCandidate>& best) {
  StudyCandidate first = best.front();
  const auto comes_before = [&](const std::vector<double>& a, const std::vector<double>& b) {
    if (study.rows && (is_slower_wave(a, b) || is_slower_wave(b, a))) return is_slower_wave(a, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double same = 1e-3 * std::max(std::abs(a[i]), std::abs(b[i]));
      if (std::abs(a[i] - b[i]) <= same) continue;
      return std::abs(a[i] + b[i]) <= same ? a[i] > b[i] : a[i] < b[i];
    }
    return false;
  };
  for (const StudyCandidate& candidate : best) {
    if (comes_before(candidate.parameters, first.parameters) &&
        is_same_curve(sampled, candidate, best.front()))
      first = candidate;
  }
  return first;
}

std::string flat_direction(const ReadStudy& study, const SampledStudy<double>& sampled,
                           const std::vector<double>& parameters) {
  const MatrixOf<double> hessian = sampled.derivatives(parameters).hessian;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) == 0)
      return "the curve stays the same while " + study.parameters[i] + " changes";
  }
  const auto values = eigen_of(ScaledHessian(hessian).scaled);
  constexpr double flat = 1e-13;  // rounding of the sums
  if (std::abs(values.eigenvalues()[0]) > flat) return "";
  std::string names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(values.eigenvectors()(static_cast<Eigen::Index>(i), 0)) > 0.1)
      names += (names.empty() ? "" : ", ") + study.parameters[i];
  }
  return "the curve stays the same while " + names + " change together";
}

}  // namespace shadefit
