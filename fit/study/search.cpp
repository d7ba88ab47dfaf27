#include "fit/study/search.hpp"

#include <ceres/tiny_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "fit/quadrature/rule_choice.hpp"
#include "fit/study/projection.hpp"
#include "fit/study/require_values.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;

/// The n-th number of van der Corput's sequence in a base: Halton's points have one for each coordinate.
double radical_inverse(std::uint64_t n, std::uint64_t base) {
  double result = 0, digit = 1;
  for (; n > 0; n /= base) {
    digit /= static_cast<double>(base);
    result += digit * static_cast<double>(n % base);
  }
  return result;
}

/// A start of a parameter from a number in [0, 1): either sign, as many in each octave. A descent leaves the
/// range.
double spread(double u, int octaves) {
  const double side = 2 * u - 1;
  return std::copysign(std::exp2(octaves * (2 * std::abs(side) - 1)), side);
}

/// How many powers of two the largest of some numbers is away from 1.
int octaves_from_one(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest == 0 ? 0 : static_cast<int>(std::ceil(std::abs(std::log2(largest))));
}

/// Of more rows than this only some take part in the first steps from every start: they show the same basins.
constexpr std::size_t most_scanned = 2000;

/// Nodes at even steps through the list, at most `most_scanned`, with even weights.
StudyNodes thinned(const StudyNodes& nodes) {
  const std::size_t size = nodes.weights.size(), step = (size + most_scanned - 1) / most_scanned;
  StudyNodes result{std::vector<std::vector<long double>>(nodes.coordinates.size()), {}, 1};
  for (std::size_t n = 0; n < size; n += step) {
    for (std::size_t i = 0; i < nodes.coordinates.size(); ++i)
      result.coordinates[i].push_back(nodes.coordinates[i][n]);
  }
  const std::size_t kept = result.coordinates.front().size();
  result.weights.assign(kept, 1.0L / static_cast<long double>(kept));
  return result;
}

constexpr std::uint64_t primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};

std::vector<double> start_of(const ReadStudy& study, const std::vector<Held>& starts) {
  std::vector<double> result(study.parameters.size(), 1);
  for (const Held& start : starts) {
    const auto found = std::find(study.parameters.begin(), study.parameters.end(), start.parameter);
    result[static_cast<std::size_t>(found - study.parameters.begin())] = start.value;
  }
  return result;
}

}  // namespace

SearchStarts starts_of(const ReadStudy& study, std::size_t nonlinear) {
  constexpr int octaves_of_shading = 6;
  SearchStarts starts{
      nonlinear == 0 ? 1 : std::min(std::size_t{16} << nonlinear, std::size_t{96}), octaves_of_shading, {}};
  if (!study.rows || nonlinear == 0) return starts;
  // A rate is of the size of 1/x, a place of that of x, and a parameter of 1/(a + b x) of that of 1/value.
  int further = octaves_from_one(study.rows->value);
  for (const auto& places : study.rows->places) further = std::max(further, octaves_from_one(places));
  starts.octaves += further;
  constexpr std::size_t more = 4;
  if (further > 1) starts.count *= more;
  return starts;
}

std::vector<StudyCandidate> search_basins(const StudyError& error, const SampledStudy<double>& coarse,
                                          const SampledStudy<double>& sampled, const SearchStarts& wanted,
                                          const Checkpoint& checkpoint) {
  const Projection scan(error, coarse), problem(error, sampled);
  const std::size_t size = problem.nonlinear().size();
  std::vector<StudyCandidate> found;
  Vector residuals(problem.NumResiduals());
  const auto add = [&](const Vector& q) {
    problem(q.data(), residuals.data(), nullptr);
    const double square = residuals.squaredNorm();
    if (!std::isfinite(square) || sampled.has_pole(problem.parameters())) return;
    found.push_back({problem.parameters(), square});
  };
  if (size == 0) {
    add(Vector(0));
    return found;
  }
  // A few steps from every start, then many from the lowest ends: most starts lead to the same few basins.
  constexpr int few = 6, many = 100;
  constexpr std::size_t finalists = 8;
  ceres::TinySolver<Projection> solver;
  solver.options.parameter_tolerance = 1e-10;
  // A smaller change of the sum of squares is rounding, or is left to Newton's method.
  solver.options.function_tolerance = 1e-20 * sampled.target_norm() * sampled.target_norm();
  solver.options.gradient_tolerance = 0;
  solver.options.cost_threshold = 0;
  struct End {
    Vector q;
    double cost;
  };
  const auto sort_by_cost = [](std::vector<End>& some) {
    std::stable_sort(some.begin(), some.end(), [](const End& a, const End& b) { return a.cost < b.cost; });
  };
  std::vector<End> ends;
  const auto descend = [&](const Projection& on, Vector q, int steps) {
    checkpoint();
    on(q.data(), residuals.data(), nullptr);
    if (!residuals.allFinite()) return;
    solver.options.max_num_iterations = steps;
    const double cost = solver.Solve(on, &q).final_cost;
    if (std::isfinite(cost)) ends.push_back({q, cost});
  };
  // Half of the starts, those with the lower squares.
  std::vector<End> low;
  for (std::size_t n = 1; n <= wanted.count; ++n) {
    Vector q(static_cast<Eigen::Index>(size));
    for (std::size_t i = 0; i < size; ++i)
      q[static_cast<Eigen::Index>(i)] = spread(radical_inverse(n, primes[i]), wanted.octaves);
    scan(q.data(), residuals.data(), nullptr);
    if (residuals.allFinite()) low.push_back({q, residuals.squaredNorm()});
  }
  sort_by_cost(low);
  low.resize((low.size() + 1) / 2);
  for (const End& start : low) descend(scan, start.q, few);
  sort_by_cost(ends);
  std::vector<Vector> starts;
  for (const std::vector<double>& start : wanted.given) {
    Vector q(static_cast<Eigen::Index>(size));
    for (std::size_t i = 0; i < size; ++i) q[static_cast<Eigen::Index>(i)] = start[problem.nonlinear()[i]];
    starts.push_back(q);
  }
  // Ends that are this near to a lower one are in its basin.
  constexpr double near = 0.05;
  const auto is_near = [&](const Vector& a, const Vector& b) {
    return (a - b).cwiseAbs().cwiseQuotient(b.cwiseAbs()).maxCoeff() < near;
  };
  for (std::size_t i = 0; i < ends.size() && starts.size() < finalists; ++i) {
    const auto same = [&](const Vector& start) { return is_near(start, ends[i].q); };
    if (std::none_of(starts.begin(), starts.end(), same)) starts.push_back(ends[i].q);
  }
  ends.clear();
  for (const Vector& start : starts) descend(problem, start, many);
  for (const End& end : ends) add(end.q);
  std::stable_sort(found.begin(), found.end(),
                   [](const StudyCandidate& a, const StudyCandidate& b) { return a.square < b.square; });
  return found;
}

std::size_t search_rule(const ReadStudy& study) {
  constexpr std::array<std::size_t, most_axes> rules{4, 1, 0};
  return rules[study.axes.size() - 1];
}

SearchedStudy search_study(const ReadStudy& study, const StudyError& error,
                           const std::vector<std::vector<StudyEdge>>& edges, const std::vector<Held>& starts,
                           const Checkpoint& checkpoint) {
  const StudyNodes nodes = nodes_of(study, edges, fit_rules[search_rule(study)]);
  require_values(study, nodes);
  const auto& linear = error.is_linear();
  const auto nonlinear = static_cast<std::size_t>(std::count(linear.begin(), linear.end(), false));
  SearchStarts wanted = starts_of(study, nonlinear);
  if (!starts.empty()) wanted.given.push_back(start_of(study, starts));
  SearchedStudy result{SampledStudy<double>(error, nodes), {}, 0, nonlinear == 0};
  if (nonlinear > 0 && study.axes.size() == 1 && !study.rows) {
    // Fewer nodes, but still more than parameters, show the same basins.
    const SampledStudy<double> coarse(error, nodes_of(study, edges, fit_rules.front()));
    result.candidates = search_basins(error, coarse, result.sampled, wanted, checkpoint);
  } else if (study.rows && nodes.weights.size() > most_scanned) {
    result.candidates =
        search_basins(error, SampledStudy<double>(error, thinned(nodes)), result.sampled, wanted, checkpoint);
  } else {
    result.candidates = search_basins(error, result.sampled, result.sampled, wanted, checkpoint);
  }
  if (result.candidates.empty())
    throw UserError(
        "--form has a pole, or no finite value, from every start: give another by --start, for example --start " +
        study.parameters.front() + "=2");
  result.starts = static_cast<int>(wanted.count + (nonlinear == 0 ? 0 : wanted.given.size()));
  return result;
}

std::vector<StudyCandidate> lowest_basins(const SearchedStudy& searched) {
  constexpr std::size_t most = 4;
  // Descents end this near to each other in one basin.
  constexpr double same = 1e-6;
  std::vector<StudyCandidate> basins;
  for (const StudyCandidate& candidate : searched.candidates) {
    if (basins.size() < most && (basins.empty() || candidate.square > basins.back().square * (1 + same)))
      basins.push_back(candidate);
  }
  return basins;
}

}  // namespace shadefit
