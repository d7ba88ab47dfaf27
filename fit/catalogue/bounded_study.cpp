#include "fit/catalogue/bounded_study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "fit/exchange/constrained_study.hpp"
#include "fit/squares/rules.hpp"
#include "fit/steps/digits.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The study with parameters held.
ReadStudy face_of(ReadStudy study, const std::vector<Held>& held) {
  for (const Held& h : held) study = with_held(std::move(study), h.parameter, h.value);
  return study;
}

/// Levels and mean squares of fits that converged are the same within this share.
constexpr double same_fit = 1e-11;

/// Whether a fit is clearly better: its level is lower, or its square if the levels are the same.
bool is_better(const StudyFit& a, const StudyFit& b, double same = same_fit) {
  const double of_a = a.level.value_or(a.rms_error), of_b = b.level.value_or(b.rms_error);
  if (std::abs(of_a - of_b) > same * of_b) return of_a < of_b;
  return a.rms_error < b.rms_error * (1 - same);
}

/// What the fit of a face without its bounds says about the face.
struct Face {
  std::vector<Held> held;
  StudyFit free;
  bool is_bound;  ///< whether no fit in the face is better than `free`
};

class BoundedFit {
 public:
  BoundedFit(const ReadStudy& study, Norm norm, const Constraints& constraints,
             const std::vector<Held>& starts, const SolveStudy& solve)
      : study_(study), error_(study), norm_(norm), constraints_(constraints), starts_(starts), solve_(solve) {
    for (Held& start : starts_) {
      const ParameterBounds* bounds = bounds_of(start.parameter);
      if (bounds != nullptr) start.value = std::clamp(start.value, bounds->lower, bounds->upper);
    }
  }

  StudyFit solve() {
    visit({});
    if (!best_ && is_without_answer(open_.front().free)) return open_.front().free;
    const bool is_linear = best_ ? best_->is_global : open_.front().free.is_global;
    const int starts = best_ ? best_->starts : open_.front().free.starts;
    while (!open_.empty()) {
      const auto lowest = std::ranges::min_element(open_, [](const Face& a, const Face& b) {
        return std::tuple(a.is_bound, a.free.level.value_or(0), a.free.rms_error) <
               std::tuple(b.is_bound, b.free.level.value_or(0), b.free.rms_error);
      });
      const Face face = std::move(*lowest);
      open_.erase(lowest);
      if (best_ && face.is_bound && !is_better(face.free, *best_)) break;
      divide(face);
    }
    constexpr double clear = 1e-6;  // a fit that did not converge may be as good up to its digits
    if (failed_ && (!best_ || is_better(*failed_, *best_, clear))) best_ = std::move(failed_);
    if (best_) {
      best_->is_global = is_linear;
      best_->starts = starts;
      return *std::move(best_);
    }
    StudyFit none;
    none.names = study_.parameters;
    none.parameters.resize(none.names.size());
    fail(none, Status::infeasible, "no fit was found within the bounds" + why_);
    return none;
  }

 private:
  const ParameterBounds* bounds_of(const std::string& parameter) const {
    const auto found = std::ranges::find(study_.bounds, parameter, &ParameterBounds::parameter);
    return found == study_.bounds.end() ? nullptr : &*found;
  }

  /// Whether a degenerate fit without bounds says all: its parameters depend on each other, or it lies in the
  /// box. Of an exact form outside the box, or one whose level many parameters have, one in the box may have
  /// an answer.
  bool is_without_answer(const StudyFit& free) const {
    if (free.status != Status::degenerate) return false;
    if (free.parameters.empty() || !in_box({}, free.parameters).empty()) return true;
    if (!free.is_global) return norm_ == Norm::least_squares;
    return are_dependent(
        SampledStudy<double>(error_, nodes_of(study_, edges_of(study_), fit_rules[search_rule(study_)])),
        free.parameters);
  }

  /// The fit of the face, if it lies in the box, is a candidate. Else the face is open.
  void visit(const std::vector<Held>& held) {
    if (!seen_.insert(std::set<Held>(held.begin(), held.end())).second) return;
    const ReadStudy face = face_of(study_, held);
    if (face.parameters.empty()) {
      offer(held, corner(face));
      return;
    }
    ReadStudy unbounded = face;
    unbounded.bounds.clear();
    std::vector<Held> starts = starts_;
    std::erase_if(starts, [&](const Held& start) {
      return std::ranges::find(face.parameters, start.parameter) == face.parameters.end();
    });
    StudyFit free;
    try {
      free = solve_(unbounded, starts);
    } catch (const UserError& error) {
      // At a bound a form may have a pole, or not depend on another parameter. Such a face has no fit.
      if (held.empty()) throw;
      why_ = ", with " + held.back().parameter + " = " + to_text(held.back().value) + ": " + error.what();
      return;
    }
    if (offer(held, free)) return;
    try {
      if (!free.is_global) {
        const StudyFit within = solve_(face, starts);
        if (!offer(held, within)) note_failed(held, within);
      }
    } catch (const UserError&) {
      // No start in the box has a finite error. There may be one on a face.
    }
    note_failed(held, free);
    const bool is_bound = free.status == Status::converged || free.status == Status::ambiguous;
    open_.push_back({held, std::move(free), is_bound});
  }

  /// The errors where all parameters are held.
  StudyFit corner(const ReadStudy& face) const {
    StudyFit fit;
    if (!face.rows && !keeps_constraints(face, constraints_)) return fit;
    fit.status = Status::converged;
    fit.digits = most_digits;
    fit.rms_error = rms_error(face, StudyError(face), {});
    fit.max_abs_error = largest_error(face, {});
    if (norm_ == Norm::minimax) fit.level = largest_weighted_error(face, {}).magnitude;
    return fit;
  }

  /// The parameters of the study at those of a face. Empty if they lie outside the box.
  std::vector<double> in_box(const std::vector<Held>& held, const std::vector<double>& of_face) const {
    std::vector<double> parameters;
    for (auto next = of_face.begin(); const std::string& name : study_.parameters) {
      const auto found = std::ranges::find(held, name, &Held::parameter);
      const double value = parameters.emplace_back(found == held.end() ? *next++ : found->value);
      const ParameterBounds* bounds = bounds_of(name);
      if (bounds != nullptr && !(bounds->lower <= value && value <= bounds->upper)) return {};
    }
    return parameters;
  }

  /// Takes the fit of a face if it is an answer in the box. Returns whether it is.
  bool offer(const std::vector<Held>& held, StudyFit fit) {
    const bool has_other = fit.status == Status::ambiguous;
    if (fit.status != Status::converged && !has_other) return false;
    fit.parameters = in_box(held, fit.parameters);
    if (has_other) fit.other = in_box(held, fit.other);
    if (fit.parameters.empty() || (has_other && fit.other.empty())) return false;
    fit.names = study_.parameters;
    for (std::size_t i = 0; i < fit.names.size(); ++i) {
      const ParameterBounds* bounds = bounds_of(fit.names[i]);
      const double value = fit.parameters[i];
      if (bounds != nullptr && (value == bounds->lower || value == bounds->upper))
        fit.at_bounds.push_back({fit.names[i], value});
    }
    if (!held.empty()) fit.statistics = std::nullopt;  // a parameter at a bound has no standard error
    if (!best_ || is_better(fit, *best_)) best_ = std::move(fit);
    return true;
  }

  /// Keeps the best of the fits in the box that are no answer: no worse one is the answer.
  void note_failed(const std::vector<Held>& held, StudyFit fit) {
    if (fit.status == Status::converged || fit.parameters.size() + held.size() != study_.parameters.size())
      return;
    fit.parameters = in_box(held, fit.parameters);
    if (fit.parameters.empty()) return;
    fit.rms_error = rms_error(study_, error_, fit.parameters);
    if (norm_ == Norm::minimax) fit.level = largest_weighted_error(study_, fit.parameters).magnitude;
    if (!std::isfinite(fit.level.value_or(fit.rms_error))) return;
    std::vector<Held> all;
    fit.names = study_.parameters;
    for (std::size_t i = 0; i < fit.names.size(); ++i) all.push_back({fit.names[i], fit.parameters[i]});
    if (!study_.rows && !keeps_constraints(face_of(study_, all), constraints_)) return;
    if (!failed_ || is_better(fit, *failed_)) failed_ = std::move(fit);
  }

  /// Visits the faces of a face.
  void divide(const Face& face) {
    constexpr std::size_t most = 6;  // 3^6 faces
    const bool has_all = !face.is_bound || (!face.free.is_global && study_.bounds.size() <= most);
    const ReadStudy study = face_of(study_, face.held);
    for (const ParameterBounds& bounds : study.bounds) {
      const auto at = std::ranges::find(study.parameters, bounds.parameter) - study.parameters.begin();
      const double value = face.is_bound ? face.free.parameters[static_cast<std::size_t>(at)] : 0;
      for (const double bound : {bounds.lower, bounds.upper}) {
        const bool is_violated = bound == bounds.lower ? value < bound : value > bound;
        if (!std::isfinite(bound) || (!has_all && !is_violated)) continue;
        std::vector<Held> held = face.held;
        held.push_back({bounds.parameter, bound});
        visit(held);
      }
    }
  }

  const ReadStudy& study_;
  StudyError error_;
  Norm norm_;
  const Constraints& constraints_;
  std::vector<Held> starts_;
  const SolveStudy& solve_;
  std::set<std::set<Held>> seen_ = {};
  std::vector<Face> open_ = {};
  std::optional<StudyFit> best_ = std::nullopt, failed_ = std::nullopt;
  std::string why_ = {};  ///< why a face has no fit
};

}  // namespace

StudyFit solve_bounded_study(const ReadStudy& study, Norm norm, const Constraints& constraints,
                             const std::vector<Held>& starts, const SolveStudy& solve) {
  return BoundedFit(study, norm, constraints, starts, solve).solve();
}

}  // namespace shadefit
