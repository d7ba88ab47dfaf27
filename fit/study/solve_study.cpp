#include "fit/study/solve_study.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/linear_optimum.hpp"
#include "fit/least_squares/newton.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/quadrature/rule_choice.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/rules.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;

/// Newton's method in double from a candidate to the bottom of its basin. Returns the exact Hessian there, or
/// empty if there is no minimum.
std::optional<ParameterMatrix<double>> polish(const SampledStudy<double>& sampled,
                                              std::vector<double>& parameters) {
  double last = HUGE_VAL;
  for (int i = 0; i < 40; ++i) {
    const auto sums = sampled.derivatives(parameters);
    const ScaledHessian hessian(sums.hessian);
    const Vector step = -(hessian.inverse() * sums.gradient);
    if (!step.allFinite()) return std::nullopt;
    const auto size =
        static_cast<double>(relative_size(step, parameters, sums.hessian, sampled.target_norm()));
    std::vector<double> next = parameters;
    for (std::size_t j = 0; j < next.size(); ++j) next[j] += step[static_cast<Eigen::Index>(j)];
    if (size < 1e-15 || (size < 1e-10 && size >= last / 2)) {
      return is_minimum(hessian.scaled) ? std::optional(sums.hessian) : std::nullopt;
    }
    // Far from the optimum a step may lead up, or over a pole: then it is halved.
    double scale = 1;
    while (size > 1e-6 && scale > 1e-4 &&
           (!(sampled.square(next) <= sums.square * (1 + 1e-12)) || sampled.has_pole(next))) {
      scale /= 2;
      for (std::size_t j = 0; j < next.size(); ++j)
        next[j] = parameters[j] + scale * step[static_cast<Eigen::Index>(j)];
    }
    parameters = next;
    last = size;
  }
  return std::nullopt;
}

/// Polishes a candidate in long double, on one rule after the other, until the next rule moves no parameter.
/// `searched` is the study under the first rule, if its panels are still the same.
StudyFit settle(const Rules& rules, const StudyCandidate& candidate, std::size_t first,
                const SampledStudy<double>* searched) {
  StudyFit fit;
  fit.parameters = candidate.parameters;
  long double best = HUGE_VALL;
  for (std::size_t rule = first; rule < rules.last(); ++rule) {
    std::optional<SampledStudy<double>> sampled;
    if (rule > first || searched == nullptr) sampled.emplace(rules.sampled<double>(rule));
    const SampledStudy<double>& fine = sampled ? *sampled : *searched;
    std::vector<double> parameters = fit.parameters;
    const auto hessian = polish(fine, parameters);
    if (!hessian) {
      if (rule + 1 < rules.last()) continue;
      fit.why = "Newton's method did not find a minimum";
      return fit;
    }
    const auto wide = rules.sampled<long double>(rule + 1);
    const std::vector<long double> at(parameters.begin(), parameters.end());
    const auto sums = wide.gradient(at);
    const ParameterMatrix<double> inverse = ScaledHessian(*hessian).inverse();
    const ParameterVector<long double> step = -(inverse.cast<long double>() * sums.gradient);
    const long double size = relative_size(step, parameters, *hessian, fine.target_norm());
    const double square = fine.square(parameters);
    // Below this the square is rounding.
    const double rounding = 1e-20 * fine.target_norm() * fine.target_norm();
    if (std::abs(static_cast<double>(sums.square) - square) > 1e-6 * square + rounding) continue;
    if (!(size < best)) continue;
    best = size;
    // The step of the larger rule, in the wider arithmetic, is the better answer.
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      fit.parameters[i] = static_cast<double>(static_cast<long double>(parameters[i]) + step[k]);
      // A parameter that moves the form by less than 1e-16 of the target is rounding.
      if (std::abs(fit.parameters[i]) * std::sqrt((*hessian)(k, k)) < 1e-16 * fine.target_norm())
        fit.parameters[i] = 0;
    }
    fit.digits = correct_digits(size);
    fit.rms_error = static_cast<double>(std::sqrt(sums.square));
    fit.status = Status::converged;
    if (size <= settled) break;
  }
  if (fit.status != Status::converged) {
    fit.why = rules.is_of_rows() ? "Newton's method does not settle in long double"
                                 : "the integral of the squared error does not converge";
  } else if (fit.digits < least_study_digits) {
    fit.status = Status::not_converged;
    fit.why = rules.is_of_rows() ? "long double still moves a parameter in its sixth digit"
                                 : "the largest quadrature rule still moves a parameter in its sixth digit";
  }
  return fit;
}

/// The gradient of half the square, with the range split at the kinks that the parameters move. So it is that
/// of the integral, and smooth.
VectorOf<long double> gradient_at(Rules& rules, std::size_t rule, const std::vector<double>& parameters) {
  rules.move_kinks(parameters);
  const std::vector<long double> at(parameters.begin(), parameters.end());
  return rules.sampled<long double>(rule).gradient(at).gradient;
}

/// Its derivatives by central differences: a kink that moves adds to those of the nodes. `hessian` is theirs.
MatrixOf<double> hessian_with_kinks(Rules& rules, std::size_t rule, const std::vector<double>& parameters,
                                    const MatrixOf<double>& hessian, double target_norm) {
  // Of the third order there remains 1e-10; long double loses 1e-14 or less.
  constexpr double step = 1e-5;
  MatrixOf<double> result = hessian;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double length = step * std::max(std::abs(parameters[i]), target_norm / std::sqrt(hessian(k, k)));
    std::vector<double> above = parameters, below = parameters;
    above[i] += length;
    below[i] -= length;
    const VectorOf<long double> difference =
        gradient_at(rules, rule, above) - gradient_at(rules, rule, below);
    result.col(k) = difference.cast<double>() / (above[i] - below[i]);
  }
  return (result + result.transpose()) / 2;
}

/// Newton's method where kinks move with the parameters. The derivatives of the last place count the digits
/// with the next rule.
StudyFit settle_kinks(Rules& rules, const StudyCandidate& candidate, std::size_t rule) {
  StudyFit fit;
  fit.parameters = candidate.parameters;
  fit.why = "Newton's method did not find a minimum beside the kinks that the parameters move";
  constexpr int most_steps = 30, most_stalls = 4;
  double square = HUGE_VAL, shortening = 1;
  VectorOf<double> step;
  std::vector<double> at = candidate.parameters, from;
  long double best = HUGE_VALL;
  for (int i = 0, stalls = 0; i < most_steps && stalls < most_stalls; ++i) {
    rules.move_kinks(at);
    const auto sampled = rules.sampled<double>(rule);
    const auto sums = sampled.derivatives(at);
    // A step that leads up is halved.
    if (!(sums.square <= square * (1 + 1e-12)) && shortening > 1e-4) {
      shortening /= 2;
      for (std::size_t j = 0; j < from.size(); ++j)
        at[j] = from[j] + shortening * step[static_cast<Eigen::Index>(j)];
      continue;
    }
    if ((sums.hessian.diagonal().array() == 0).any()) break;
    const double norm = sampled.target_norm();
    MatrixOf<double> hessian = hessian_with_kinks(rules, rule, at, sums.hessian, norm);
    const bool is_at_minimum = hessian.allFinite() && is_minimum(ScaledHessian(hessian).scaled);
    if (!is_at_minimum) hessian = sums.hessian;
    const MatrixOf<double> inverse = ScaledHessian(hessian).inverse();
    step = -(inverse * gradient_at(rules, rule, at).cast<double>());
    if (!step.allFinite()) break;
    // The next rule has another error where nothing is smooth, so its step counts the digits.
    const VectorOf<double> check = -(inverse * gradient_at(rules, rule + 1, at).cast<double>());
    const long double size = relative_size(check, at, hessian, norm);
    const bool is_better = is_at_minimum && size < best;
    if (is_better) {
      best = size;
      fit.parameters = at;
      fit.digits = correct_digits(size);
      fit.rms_error = std::sqrt(sums.square);
    }
    stalls = is_better ? 0 : stalls + 1;
    if (best <= settled || (best < 1e-6L && !is_better)) break;
    from = at;
    square = sums.square;
    shortening = 1;
    for (std::size_t j = 0; j < at.size(); ++j) at[j] += step[static_cast<Eigen::Index>(j)];
  }
  rules.move_kinks(fit.parameters);
  const bool is_settled = std::isfinite(best) && fit.digits >= least_study_digits;
  fit.status = is_settled ? Status::converged : Status::not_converged;
  if (is_settled) fit.why = "";
  return fit;
}

/// The lowest basins, settled with the kinks where they are, best first. Those that do not settle come last.
std::vector<StudyCandidate> settled_basins(Rules& rules, const SearchedStudy& searched, std::size_t rule) {
  // The search sums over nodes that miss the kinks by a part of a panel: that far its squares may be wrong.
  constexpr double near = 1.5;
  std::vector<StudyCandidate> result, others;
  for (const StudyCandidate& basin : lowest_basins(searched)) {
    if (basin.square > near * searched.candidates.front().square) break;
    const StudyFit fit = settle_kinks(rules, basin, rule);
    if (fit.status == Status::converged) {
      result.push_back({fit.parameters, fit.rms_error * fit.rms_error});
    } else {
      others.push_back(basin);
    }
  }
  const auto is_lower = [](const auto& a, const auto& b) { return a.square < b.square; };
  std::stable_sort(result.begin(), result.end(), is_lower);
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

std::optional<LinearOptimum> optimum_of(const SampledStudy<long double>& sampled) {
  return linear_optimum(sampled.parameter_count(), [&](const auto& parameters, auto& errors, auto& slopes) {
    sampled.errors(parameters, errors, &slopes);
    errors = errors.cwiseProduct(sampled.roots()).eval();
    slopes = (sampled.roots().asDiagonal() * slopes).eval();
  });
}

/// The optimum of a form that is linear in all parameters, by one rule after the other.
StudyFit settle_linear(const Rules& rules, std::size_t first) {
  const std::string dependent_columns =
      "long double does not tell six digits of its parameters, whose columns are nearly dependent";
  StudyFit fit;
  fit.status = Status::not_converged;
  fit.why = "the integral of the squared error does not converge";
  long double best = HUGE_VALL;
  StudyNodes nodes = rules.nodes(first);
  auto fine = optimum_of(rules.sampled<long double>(nodes));
  for (std::size_t rule = first; rule < rules.last(); ++rule) {
    const auto coarse = fine;
    const long double coarse_total = nodes.total;
    nodes = rules.nodes(rule + 1);
    const auto wide = rules.sampled<long double>(nodes);
    fine = optimum_of(wide);
    if (!fine) fit.why = dependent_columns;
    if (!coarse || !fine) continue;
    // Below this the square is rounding. A density may have no integral where the squared error has one.
    const long double rounding = 1e-20L * wide.target_norm() * wide.target_norm();
    const long double shrinking = coarse_total / nodes.total;
    if (std::abs(coarse->square * shrinking - fine->square) > 1e-6L * fine->square + rounding) continue;
    const VectorOf<long double> by_rule = (coarse->parameters - fine->parameters).cwiseAbs(),
                                by_rounding = fine->last_step.cwiseAbs(), step = by_rule + by_rounding;
    const std::vector<double> parameters(fine->parameters.begin(), fine->parameters.end());
    const MatrixOf<double> hessian = fine->sizes.cwiseAbs2().cast<double>().asDiagonal();
    const auto size = relative_size(step, parameters, hessian, static_cast<double>(wide.target_norm()));
    if (!(size < best)) continue;
    best = size;
    fit.parameters = parameters;
    fit.digits = correct_digits(size);
    fit.rms_error = static_cast<double>(std::sqrt(fine->square));
    if (fit.digits >= least_study_digits) fit.status = Status::converged;
    fit.why = by_rounding.maxCoeff() > by_rule.maxCoeff()
                  ? dependent_columns
                  : "the largest quadrature rule still moves a parameter in its sixth digit";
    if (size <= settled) break;
  }
  if (fit.status == Status::converged) fit.why = "";
  return fit;
}

/// The candidates whose square is the best one: other parameters may reach the optimum too.
std::vector<StudyCandidate> best_of(const std::vector<StudyCandidate>& candidates, double target_norm) {
  constexpr double equal = 1e-9;
  // Below this the square is rounding.
  const double least = 1e-24 * target_norm * target_norm;
  std::vector<StudyCandidate> best;
  for (const StudyCandidate& candidate : candidates) {
    if (candidate.square <= candidates.front().square * (1 + equal) + least) best.push_back(candidate);
  }
  return best;
}

/// Whether two candidates give the same curve.
bool is_same_curve(const SampledStudy<double>& sampled, const StudyCandidate& a, const StudyCandidate& b) {
  Vector first, second;
  sampled.errors(a.parameters, first, nullptr);
  sampled.errors(b.parameters, second, nullptr);
  const double distance = std::sqrt((first - second).cwiseAbs2().dot(sampled.roots().cwiseAbs2()));
  return distance <= 1e-5 * std::max(sampled.target_norm(), std::sqrt(a.square));
}

/// If several sets of parameters give one curve, the one that comes first, number by number. With rows the
/// smallest comes first, because every faster wave through evenly spaced rows fits as well.
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

/// Why a place is flat: the parameters along which the square does not change. Empty if there are none.
std::string flat_direction(const ReadStudy& study, const SampledStudy<double>& sampled,
                           const std::vector<double>& parameters) {
  const MatrixOf<double> hessian = sampled.derivatives(parameters).hessian;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) == 0)
      return "the curve stays the same while " + study.parameters[i] + " changes";
  }
  const Eigen::SelfAdjointEigenSolver<MatrixOf<double>> values(ScaledHessian(hessian).scaled);
  constexpr double flat = 1e-13;  // rounding of the sums
  if (std::abs(values.eigenvalues()[0]) > flat) return "";
  std::string names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(values.eigenvectors()(static_cast<Eigen::Index>(i), 0)) > 0.1)
      names += (names.empty() ? "" : ", ") + study.parameters[i];
  }
  return "the curve stays the same while " + names + " change together";
}

}  // namespace

std::vector<StudyEdge> resolved_edges(const ReadStudy& study, const StudyError& error,
                                      const std::vector<double>& parameters) {
  Rules rules(study, error);
  rules.move_kinks(parameters);
  rules.cut_panels(parameters);
  return rules.edges().front();
}

void confirm_integrals(const ReadStudy& study, StudyFit& fit) {
  const Symbolic formula = error_formula(study);
  if (fit.status != Status::converged || integral_depth(formula) == 0) return;
  const StudyError usual_error(study);
  const StudyNodes nodes = Rules(study, usual_error).nodes(search_rule(study));
  const auto errors_by = [&](IntegralRule rule) {
    const StudyError error(study, rule);
    const SampledStudy<double> sampled(error, nodes);
    Vector errors;
    sampled.errors(fit.parameters, errors, nullptr);
    return std::pair(errors, sampled.target_norm());
  };
  const auto [usual, norm] = errors_by(IntegralRule::usual);
  const Vector check = errors_by(IntegralRule::check).first;
  const double difference = (usual - check).cwiseAbs().maxCoeff();
  fit.digits = std::min(fit.digits, correct_digits(difference / norm));
  if (fit.digits >= least_study_digits) return;
  fit.status = Status::not_converged;
  fit.why = "two rules for 'integral' agree to fewer than 6 digits: split it where its body is not smooth";
}

double rms_error(const ReadStudy& study, const StudyError& error, const std::vector<double>& parameters) {
  Rules rules(study, error);
  rules.move_kinks(parameters);
  rules.cut_panels(parameters);
  double square = 0, last = -1;
  for (std::size_t rule = 0; rule < rules.last() && std::abs(square - last) > 1e-12 * square; ++rule) {
    last = square;
    square = rules.sampled<double>(rule).square(parameters);
  }
  return std::sqrt(square);
}

StudyFit solve_study(const ReadStudy& study, const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  require_finite(study, study.target, "--target", Norm::least_squares);
  const StudyError error(study);
  Rules rules(study, error);
  SearchedStudy searched = search_study(study, error, rules.edges(), starts, checkpoint);
  const SampledStudy<double>& sampled = searched.sampled;
  checkpoint();
  const std::size_t first = search_rule(study);
  if (rules.has_moving_kinks()) searched.candidates = settled_basins(rules, searched, first);

  const auto best = best_of(searched.candidates, sampled.target_norm());
  const StudyCandidate chosen = canonical(study, sampled, best);
  const std::string flat = flat_direction(study, sampled, chosen.parameters);
  StudyFit fit;
  if (flat.empty() && rules.has_moving_kinks()) {
    fit = settle_kinks(rules, chosen, first);
  }
  // Near a root the first rule is not enough for the kinks; panels that are cut are, and rules tell the
  // digits.
  if (flat.empty() && fit.status != Status::converged) {
    const bool has_same_panels = !rules.cut_panels(chosen.parameters) && !rules.has_moving_kinks();
    fit = settle(rules, chosen, first, has_same_panels ? &sampled : nullptr);
  } else if (!flat.empty()) {
    fit.parameters = chosen.parameters;
    fit.status = Status::degenerate;
    fit.why = flat;
  }
  if (fit.status != Status::converged && searched.is_linear) {
    const StudyFit linear = settle_linear(rules, first);
    if (!linear.parameters.empty()) {
      fit = linear;
    } else if (fit.status == Status::not_converged) {
      fit.why = linear.why;
    }
  }
  fit.names = study.parameters;
  fit.starts = searched.starts;
  fit.is_global = searched.is_linear;
  if (fit.status == Status::not_converged) require_finite_form(study, Norm::least_squares);
  if (fit.status != Status::converged) return fit;
  for (const StudyCandidate& candidate : best) {
    if (is_same_curve(sampled, candidate, chosen)) continue;
    fit.status = Status::ambiguous;
    fit.why = "another curve is as good";
    fit.other = candidate.parameters;
    return fit;
  }
  if (study.rows) {
    checkpoint();
    fit.max_abs_error = largest_residual(study, fit.parameters);
    if (!study.has_only_starts) fit.statistics = row_statistics(study, error, sampled, fit.parameters);
  } else {
    fit.max_abs_error = largest_error(study, rules.edges(), fit.parameters);
    // The square of log(x) has an integral, that of 1/x has none. Rules fit a factor of 1/x that is rounding.
    if (std::isinf(fit.max_abs_error.magnitude)) require_finite_form(study, Norm::least_squares);
  }
  confirm_integrals(study, fit);
  return fit;
}

}  // namespace shadefit
