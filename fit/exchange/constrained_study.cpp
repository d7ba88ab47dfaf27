#include "fit/exchange/constrained_study.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "fit/exchange/exchanged_study.hpp"
#include "fit/exchange/linear_fit.hpp"
#include "fit/panels/contacts.hpp"
#include "fit/panels/panel_curve.hpp"
#include "fit/quadrature/fit_rules.hpp"
#include "fit/squares/confirm_integrals.hpp"
#include "fit/squares/rules.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/steps/digits.hpp"
#include "fit/steps/quadratic_programme.hpp"
#include "fit/steps/scaled_hessian.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/search.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// The fit from one start: the constrained optimum of its basin.
class ConstrainedFit {
 public:
  ConstrainedFit(const ReadStudy& study, const StudyError& error, const std::vector<StudyEdge>& edges,
                 const MinimaxProblem& problem, const std::vector<double>& start)
      : study_(study),
        error_(error),
        edges_(edges),
        problem_(problem),
        size_(static_cast<Eigen::Index>(problem.size)),
        sampled_(error, nodes_of(study, {edges}, fit_rules[search_rule(study)])),
        here_(problem, start) {}

  StudyFit solve(const Checkpoint& checkpoint) {
    const std::string why = here_.hold_exact();
    here_.find_tangents();
    if (!why.empty()) {
      fail(fit_, Status::infeasible, why);
    } else if (descend(checkpoint)) {
      settle();
    }
    fit_.parameters = here_.parameters;
    return std::move(fit_);
  }

 private:
  /// A contact whose constraint holds with equality, and its multiplier.
  struct Active {
    Contact contact;
    double multiplier;
  };

  static constexpr int most_steps = 60;
  /// Newton's method takes over when a relative step is below this.
  static constexpr double last_step = 1e-6;
  /// A multiplier below this share of the largest one is the rounding of 0.
  static constexpr double no_multiplier = 1e-12;

  /// The rounding of a contact's value in double. The size of the target counts too: a form of 0 may be a
  /// difference of large terms.
  double rounding(const Contact& c) const {
    double size =
        std::abs(c.value) + static_cast<double>(std::abs(here_.bound_of(c.touch))) + sampled_.target_norm();
    for (std::size_t i = 0; i < problem_.size; ++i) size += std::abs(c.gradient[i] * here_.parameters[i]);
    return 1e-15 * size;
  }

  /// The constraints, at the contacts of this step and of earlier ones.
  std::vector<Contact> constraints() {
    for (const Contact& c : here_.all()) {
      if (here_.share_of_level(c) > 0) continue;
      const bool is_known = std::any_of(known_.begin(), known_.end(), [&](const Contact& k) {
        return k.touch == c.touch && k.is_tangent == c.is_tangent && k.place.panel == c.place.panel &&
               std::abs(k.place.s - c.place.s) < 1e-9;
      });
      if (!is_known) known_.push_back(c);
    }
    std::vector<Contact> result;
    for (const Contact& k : known_) {
      const Contact c = here_.contact(k.touch, k.place, k.is_tangent);
      if (std::isfinite(c.value)) result.push_back(c);
    }
    return result;
  }

  Condition condition(const Contact& c) const {
    Condition result = here_.condition(c);
    if (!result.is_equation) result.bound += rounding(c);
    return result;
  }

  /// The Hessian of the square where it is positive; elsewhere that of the linearised error.
  Matrix convex_hessian(const std::vector<double>& at, const Matrix& hessian) const {
    if (is_minimum(hessian)) return hessian;
    Vector errors;
    Matrix slopes;
    sampled_.errors(at, errors, &slopes);
    slopes = sampled_.roots().asDiagonal() * slopes;
    Matrix result = slopes.transpose() * slopes;
    result.diagonal() *= 1 + 1e-8;
    return result;
  }

  double size_of(const Vector& step, const Matrix& hessian) const {
    return static_cast<double>(
        relative_size(step.cast<long double>(), here_.parameters, hessian, sampled_.target_norm()));
  }

  bool descend(const Checkpoint& checkpoint) {
    MinimaxParameters base = here_.parameters;
    Vector step = Vector::Zero(size_);
    double best = HUGE_VAL, scale = 1, penalty = 1, size = 1;
    for (int i = 0; i < most_steps; ++i) {
      checkpoint();
      here_.look();
      if (here_.is_impossible())
        return fail(fit_, Status::infeasible, "no parameters " + here_.most_violated());
      const std::vector<double> at = here_.parameters;
      const double merit =
          std::isfinite(here_.level()) ? sampled_.square(at) / 2 + penalty * here_.violation() : HUGE_VAL;
      // Short steps along a curved constraint are right even if they raise the sum a little.
      if (!(merit < best) && size > 1e-3) {
        scale /= 2;
        if (scale < 1e-6) return fail(fit_, Status::not_converged, "no part of a step improves the fit");
        here_.parameters = moved_by<double>(scale * step, base);
        continue;
      }
      const auto sums = sampled_.derivatives(at);
      const Matrix hessian = convex_hessian(at, sums.hessian);
      const std::vector<Contact> contacts = constraints();
      std::vector<Condition> conditions;
      for (const Contact& c : contacts) conditions.push_back(condition(c));
      const auto answer = least_step(hessian, sums.gradient, conditions);
      if (!answer || !answer->step.allFinite())
        return fail(fit_, problem_.is_linear ? Status::infeasible : Status::not_converged,
                    (problem_.is_linear ? "no parameters " : "no step leads to parameters that ") +
                        here_.most_violated());
      active_.clear();
      for (const auto& [index, multiplier] : answer->active) {
        active_.push_back({contacts[index], multiplier});
        penalty = std::max(penalty, 2 * std::abs(multiplier));
      }
      base = here_.parameters;
      best = sampled_.square(at) / 2 + penalty * here_.violation();
      step = answer->step;
      scale = 1;
      size = size_of(step, hessian);
      here_.parameters = moved_by(step, base);
      if (size < last_step) return true;
    }
    return fail(fit_, Status::not_converged,
                here_.violation() > 0 ? "no step leads to parameters that " + here_.most_violated()
                                      : "the steps did not end in " + std::to_string(most_steps));
  }

  /// The gradient of a constraint; of an equation, in the direction of rising values.
  Vector gradient_of(const Contact& c) const {
    Vector result(size_);
    for (Eigen::Index i = 0; i < size_; ++i)
      result[i] = sign_of(c.touch) * c.gradient[static_cast<std::size_t>(i)];
    return result;
  }

  /// The derivative of a constraint's gradient by the parameters, with the place moving along. By
  /// differences: Newton's method needs only a few digits of it.
  Matrix bend_of(const Contact& c) {
    const MinimaxParameters base = here_.parameters;
    Matrix result(size_, size_);
    for (Eigen::Index j = 0; j < size_; ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double step = 1e-6 * std::max(std::abs(base[k]), 1e-3);
      here_.parameters[k] = base[k] + step;
      const Vector above = gradient_of(here_.moved(c));
      here_.parameters[k] = base[k] - step;
      result.col(j) = (above - gradient_of(here_.moved(c))) / (2 * step);
      here_.parameters = base;
    }
    return (result + result.transpose()) / 2;
  }

  /// The distance of a constraint's value from its bound, in long double; negative if it is violated.
  long double lack_of(const Contact& c) const {
    const WideParameters wide(here_.parameters.begin(), here_.parameters.end());
    const long double value = here_.curve_of(c.touch).wide(c.place, wide, c.is_tangent);
    const long double bound = c.is_tangent ? 0 : here_.bound_of(c.touch);
    return static_cast<long double>(sign_of(c.touch)) * (bound - value);
  }

  /// Newton's step on the Karush-Kuhn-Tucker equations, and its size.
  struct Step {
    VectorOf<long double> values;  ///< of the parameters, then of the multipliers
    long double size;
    long double square;
  };

  Step newton(const SampledStudy<long double>& wide) {
    const auto count = static_cast<Eigen::Index>(active_.size());
    const std::vector<double> at = here_.parameters;
    const Matrix hessian = sampled_.derivatives(at).hessian;
    const auto sums = wide.gradient(std::vector<long double>(at.begin(), at.end()));
    Matrix matrix = Matrix::Zero(size_ + count, size_ + count);
    matrix.topLeftCorner(size_, size_) = hessian;
    VectorOf<long double> lack(size_ + count);
    lack.head(size_) = -sums.gradient;
    for (Eigen::Index i = 0; i < count; ++i) {
      auto& [contact, multiplier] = active_[static_cast<std::size_t>(i)];
      contact = here_.moved(contact);
      const Vector gradient = gradient_of(contact);
      if (multiplier != 0) matrix.topLeftCorner(size_, size_) += multiplier * bend_of(contact);
      matrix.col(size_ + i).head(size_) = gradient;
      matrix.row(size_ + i).head(size_) = gradient.transpose();
      lack.head(size_) -= (multiplier * gradient).cast<long double>();
      lack[size_ + i] = lack_of(contact);
    }
    const Matrix inverse = matrix.fullPivLu().inverse();
    Step step{inverse.cast<long double>() * lack, 0, sums.square};
    step.size =
        relative_size(VectorOf<long double>(step.values.head(size_)), at, hessian, sampled_.target_norm());
    return step;
  }

  void take(const Step& step) {
    here_.parameters = moved_by<long double>(step.values.head(size_), here_.parameters);
    for (std::size_t i = 0; i < active_.size(); ++i)
      active_[i].multiplier += static_cast<double>(step.values[size_ + static_cast<Eigen::Index>(i)]);
  }

  void settle() {
    double largest = 0;
    for (const Active& a : active_) largest = std::max(largest, std::abs(a.multiplier));
    std::erase_if(active_, [&](const Active& a) {
      return a.contact.touch != Touch::exact && std::abs(a.multiplier) <= no_multiplier * largest;
    });
    if (active_.size() > problem_.size) {
      fail(fit_, Status::degenerate, "more constraints touch than there are parameters");
      return;
    }
    const auto wide = [&](std::size_t rule) {
      return SampledStudy<long double>(error_, nodes_of(study_, {edges_}, fit_rules[rule]));
    };
    constexpr int most_passes = 20;
    long double size = HUGE_VALL, square = 0;
    for (std::size_t rule = search_rule(study_); rule + 1 < fit_rules.size() && size > settled; ++rule) {
      const auto sums = wide(rule);
      long double last = HUGE_VALL;
      for (int pass = 0; pass < most_passes; ++pass) {
        const Step step = newton(sums);
        if (!(step.size < last / 2) && pass > 2) break;
        last = step.size;
        take(step);
        if (last <= 1e-16L) break;
      }
      const Step check = newton(wide(rule + 1));
      size = check.size;
      square = check.square;
      take(check);
    }
    clear_rounding(here_.parameters, sampled_.derivatives(here_.parameters).hessian, sampled_.target_norm());
    fit_.digits = correct_digits(size);
    if (fit_.digits < least_study_digits) {
      fail(fit_, Status::not_converged, "Newton's method does not settle in long double");
      return;
    }
    fit_.rms_error = static_cast<double>(std::sqrt(square));
    fit_.status = Status::converged;
    check_constraints();
  }

  /// Checks that the constraints which do not touch hold, and that those which touch have multipliers >= 0.
  void check_constraints() {
    constexpr double tolerance = 1e3;  // of the rounding of a value
    here_.look();
    for (const Contact& c : here_.all()) {
      if (here_.share_of_level(c) > 0) continue;
      const double excess = -here_.condition(c).bound;
      if ((c.touch == Touch::exact ? std::abs(excess) : excess) > tolerance * rounding(c)) {
        fail(fit_, Status::not_converged, "no steps lead to parameters that " + here_.most_violated());
        return;
      }
    }
    for (const Active& a : active_) {
      if (a.contact.touch != Touch::exact && a.multiplier < 0) {
        fail(fit_, Status::not_converged, "a constraint that touches has a negative multiplier");
        return;
      }
      fit_.alternation.push_back({a.contact.touch, a.contact.is_tangent, problem_.cosine_at(a.contact.place),
                                  problem_.error->along(a.contact.place, here_.parameters).value,
                                  a.multiplier});
    }
    std::ranges::sort(fit_.alternation, {}, [](const AlternationPoint& point) { return point.at.cos_theta; });
  }

  const ReadStudy& study_;
  const StudyError& error_;
  const std::vector<StudyEdge>& edges_;
  const MinimaxProblem& problem_;
  Eigen::Index size_;
  SampledStudy<double> sampled_;
  Contacts here_;
  StudyFit fit_ = {};
  std::vector<Contact> known_ = {};
  std::vector<Active> active_ = {};
};

}  // namespace

StudyFit solve_constrained_study(const ReadStudy& study, const Constraints& constraints,
                                 const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  if (!has_constraints(constraints)) return solve_study(study, starts, checkpoint);
  require_possible(study, constraints);
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, {edges_of(study, 0)}, starts, checkpoint);
  const std::vector<double>& lowest = searched.candidates.front().parameters;
  const auto edges = resolved_edges(study, error, lowest);
  const ExchangedStudy exchanged(study, error, edges, lowest, constraints);

  std::optional<StudyFit> best;
  const bool is_dependent = searched.is_linear && are_dependent(searched.sampled, lowest);
  for (const StudyCandidate& candidate : lowest_basins(searched)) {
    if (is_dependent) break;
    StudyFit fit =
        ConstrainedFit(study, error, edges, exchanged.problem(), candidate.parameters).solve(checkpoint);
    const bool is_better = !best || (fit.status == Status::converged &&
                                     (best->status != Status::converged || fit.rms_error < best->rms_error));
    if (is_better) best = std::move(fit);
  }
  if (searched.is_linear && (is_dependent || best->status != Status::converged))
    best = solve_linear_fit(
        {study, error, Norm::least_squares, constraints, {edges}, searched.sampled, lowest, checkpoint});
  best->names = study.parameters;
  best->starts = searched.starts;
  // Some of these conditions are not convex, but for a linear form all are linear at each place.
  best->is_global = searched.is_linear;
  if (best->status == Status::infeasible) throw Infeasible(best->why);
  if (best->status == Status::converged)
    best->max_abs_error = largest_error(study, {edges}, best->parameters);
  confirm_integrals(study, *best);
  return std::move(*best);
}

}  // namespace shadefit
