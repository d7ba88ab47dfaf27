#include "fit/study/solve_study.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/linear_optimum.hpp"
#include "fit/quadrature/rule_choice.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/scaled_hessian.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;

/// Newton's method in double from a candidate to the bottom of its basin. Returns the exact Hessian there, or
/// empty if there is no minimum.
std::optional<MatrixOf<double>> polish(const SampledStudy<double>& sampled, std::vector<double>& parameters) {
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
      return hessian.is_positive() ? std::optional(sums.hessian) : std::nullopt;
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

/// The nodes of one rule after the other, each sampled when it is needed.
class Rules {
 public:
  explicit Rules(const ReadStudy& study, const StudyError& error) : study_(study), error_(error) {
    for (std::size_t i = 0; i < study.axes.size() && !is_of_rows(); ++i) edges_.push_back(edges_of(study, i));
  }

  /// Whether the nodes are measured rows, which all rules share.
  bool is_of_rows() const { return study_.rows != nullptr; }

  /// The last rule whose nodes are few enough.
  std::size_t last() const {
    if (is_of_rows()) return search_rule(study_) + 1;
    constexpr double most_nodes = 60000;
    std::size_t result = 0;
    for (std::size_t i = 0; i < fit_rules.size(); ++i) {
      double nodes = 1;
      for (const auto& edges : edges_) nodes *= 2.0 * static_cast<double>((edges.size() - 1) * fit_rules[i]);
      if (nodes <= most_nodes * std::pow(2.0, static_cast<double>(edges_.size()))) result = i;
    }
    return result;
  }

  StudyNodes nodes(std::size_t rule) const { return nodes_of(study_, edges_, fit_rules[rule]); }

  template <class T>
  SampledStudy<T> sampled(std::size_t rule) const {
    return SampledStudy<T>(error_, nodes(rule));
  }

  const std::vector<std::vector<StudyEdge>>& edges() const { return edges_; }

  /// Cuts the panels of a single axis until two small rules agree on the squares of the error and its
  /// derivatives: a lobe needs narrow panels at its peak.
  void cut_panels(const std::vector<double>& parameters) {
    if (edges_.size() != 1) return;
    const auto whole = squares(edges_.front(), parameters, 6);
    std::vector<StudyEdge> cut{edges_.front().front()};
    for (std::size_t i = 1; i < edges_.front().size(); ++i)
      cut_panel(cut.back(), edges_.front()[i], parameters, whole, 0, cut);
    edges_.front() = cut;
  }

 private:
  /// The integrals of error^2 and of the square of each derivative over the panels between edges.
  VectorOf<double> squares(const std::vector<StudyEdge>& edges, const std::vector<double>& parameters,
                           std::size_t rule) const {
    const StudyNodes nodes = nodes_of(study_, {edges}, fit_rules[rule]);
    const SampledStudy<double> sampled(error_, nodes);
    VectorOf<double> errors;
    MatrixOf<double> slopes;
    sampled.errors(parameters, errors, &slopes);
    const auto weights = sampled.roots().cwiseAbs2();
    VectorOf<double> result(slopes.cols() + 1);
    result[0] = errors.cwiseAbs2().dot(weights);
    for (Eigen::Index j = 0; j < slopes.cols(); ++j) result[j + 1] = slopes.col(j).cwiseAbs2().dot(weights);
    return result * static_cast<double>(nodes.total);
  }

  void cut_panel(StudyEdge left, StudyEdge right, const std::vector<double>& parameters,
                 const VectorOf<double>& whole, int depth, std::vector<StudyEdge>& cut) const {
    // A rule of 22 nodes that is right to 1e-6 becomes right to rounding with 38.
    constexpr double agree = 1e-6;
    constexpr int deepest = 20;
    const auto coarse = squares({left, right}, parameters, 0), fine = squares({left, right}, parameters, 2);
    const bool is_resolved = ((coarse - fine).cwiseAbs().array() <= agree * whole.array()).all();
    if (is_resolved || depth == deepest || cut.size() > 40) {
      cut.push_back(right);
      return;
    }
    const StudyEdge middle{left.at + (right.at - left.at) / 2};
    cut_panel(left, middle, parameters, whole, depth + 1, cut);
    cut_panel(middle, right, parameters, whole, depth + 1, cut);
  }

  const ReadStudy& study_;
  const StudyError& error_;
  std::vector<std::vector<StudyEdge>> edges_;
};

/// Polishes a candidate in long double, on one rule after the other, until the next rule moves no parameter.
StudyFit settle(const Rules& rules, const StudyCandidate& candidate, std::size_t first) {
  StudyFit fit;
  fit.parameters = candidate.parameters;
  long double best = HUGE_VALL;
  for (std::size_t rule = first; rule < rules.last(); ++rule) {
    const auto fine = rules.sampled<double>(rule);
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
    const MatrixOf<double> inverse = ScaledHessian(*hessian).inverse();
    const VectorOf<long double> step = -(inverse.cast<long double>() * sums.gradient);
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

std::optional<LinearOptimum> optimum_of(const SampledStudy<long double>& sampled) {
  return linear_optimum(sampled.parameter_count(), [&](const auto& parameters, auto& errors, auto& slopes) {
    sampled.errors(parameters, errors, &slopes);
    errors = errors.cwiseProduct(sampled.roots()).eval();
    slopes = (sampled.roots().asDiagonal() * slopes).eval();
  });
}

/// The optimum of a form that is linear in all parameters, by one rule after the other.
StudyFit settle_linear(const Rules& rules, std::size_t first) {
  StudyFit fit;
  fit.status = Status::not_converged;
  long double best = HUGE_VALL;
  auto fine = optimum_of(rules.sampled<long double>(first));
  for (std::size_t rule = first; rule < rules.last(); ++rule) {
    const auto coarse = fine;
    const auto wide = rules.sampled<long double>(rule + 1);
    fine = optimum_of(wide);
    if (!coarse || !fine) continue;
    const VectorOf<long double> step =
        (coarse->parameters - fine->parameters).cwiseAbs() + fine->last_step.cwiseAbs();
    const std::vector<double> parameters(fine->parameters.begin(), fine->parameters.end());
    const MatrixOf<double> hessian = fine->sizes.cwiseAbs2().cast<double>().asDiagonal();
    const auto size = relative_size(step, parameters, hessian, static_cast<double>(wide.target_norm()));
    if (!(size < best)) continue;
    best = size;
    fit.parameters = parameters;
    fit.digits = correct_digits(size);
    fit.rms_error = static_cast<double>(std::sqrt(fine->square));
    if (fit.digits >= least_study_digits) fit.status = Status::converged;
    if (size <= settled) break;
  }
  if (fit.status != Status::converged)
    fit.why = "long double does not tell six digits of its parameters, whose columns are nearly dependent";
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

/// The sum of the squares of some parameters.
double size_of(const std::vector<double>& parameters) {
  return std::inner_product(parameters.begin(), parameters.end(), parameters.begin(), 0.0);
}

/// If several sets of parameters give one curve, the one that comes first, number by number. With rows the
/// smallest comes first, because every faster wave through evenly spaced rows fits as well.
StudyCandidate canonical(const ReadStudy& study, const SampledStudy<double>& sampled,
                         const std::vector<StudyCandidate>& best) {
  StudyCandidate first = best.front();
  const auto comes_before = [&](const std::vector<double>& a, const std::vector<double>& b) {
    const double first_size = size_of(a), second_size = size_of(b);
    if (study.rows && std::abs(first_size - second_size) > 1e-3 * std::max(first_size, second_size))
      return first_size < second_size;
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

/// The parameters along which the square does not change, in words; empty if there are none.
std::string flat_direction(const ReadStudy& study, const SampledStudy<double>& sampled,
                           const std::vector<double>& parameters) {
  const MatrixOf<double> hessian = sampled.derivatives(parameters).hessian;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) == 0)
      throw UserError("--form does not depend on its parameter '" + study.parameters[i] +
                      "' where it was evaluated");
  }
  const Eigen::SelfAdjointEigenSolver<MatrixOf<double>> values(ScaledHessian(hessian).scaled);
  constexpr double flat = 1e-13;  // rounding of the sums
  if (std::abs(values.eigenvalues()[0]) > flat) return "";
  std::string names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(values.eigenvectors()(static_cast<Eigen::Index>(i), 0)) > 0.1)
      names += (names.empty() ? "" : ", ") + study.parameters[i];
  }
  return names;
}

}  // namespace

std::vector<StudyEdge> resolved_edges(const ReadStudy& study, const StudyError& error,
                                      const std::vector<double>& parameters) {
  Rules rules(study, error);
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
  rules.cut_panels(parameters);
  double square = 0, last = -1;
  for (std::size_t rule = 0; rule < rules.last() && std::abs(square - last) > 1e-12 * square; ++rule) {
    last = square;
    square = rules.sampled<double>(rule).square(parameters);
  }
  return std::sqrt(square);
}

StudyFit solve_study(const ReadStudy& study, const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  const StudyError error(study);
  Rules rules(study, error);
  const SearchedStudy searched = search_study(study, error, rules.edges(), starts, checkpoint);
  const SampledStudy<double>& sampled = searched.sampled;
  checkpoint();

  const auto best = best_of(searched.candidates, sampled.target_norm());
  const StudyCandidate chosen = canonical(study, sampled, best);
  const std::string flat = flat_direction(study, sampled, chosen.parameters);
  StudyFit fit;
  if (flat.empty()) {
    rules.cut_panels(chosen.parameters);
    fit = settle(rules, chosen, search_rule(study));
  } else {
    fit.parameters = chosen.parameters;
    fit.status = Status::degenerate;
    fit.why = "the curve stays the same while " + flat + " change together";
  }
  if (fit.status != Status::converged && searched.is_linear) {
    const StudyFit linear = settle_linear(rules, search_rule(study));
    if (!linear.parameters.empty()) fit = linear;
  }
  fit.names = study.parameters;
  fit.starts = searched.starts;
  fit.is_global = searched.is_linear;
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
  }
  confirm_integrals(study, fit);
  return fit;
}

}  // namespace shadefit
