#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/rounding/lattice_search.hpp"
#include "fit/rounding/study_in_format.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/scalars/rounded_interval.hpp"
#include "fit/study/even_grid.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"

/// The problems that `search_lattice` solves for a study: the constants of a lattice with the smallest
/// largest error of a form.
namespace shadefit {

/// A place at which constants are compared with the target.
struct StudyTrial {
  std::vector<double> at;
  Ends target;    ///< encloses it
  double factor;  ///< at most that of |form - target| in the error
};

/// The steps of the grid of the first trials, in one, two and three variables.
inline constexpr std::array<int, most_axes> steps_of_trials{16, 4, 2};

/// The trials that rule out boxes of constants, those that did so of late first.
template <class Arithmetic>
class StudyTrials {
 public:
  explicit StudyTrials(const ReadStudy& study) : form_(tape_of(study.form, formula_inputs(study)), {}) {}

  bool has(const std::vector<double>& place) const {
    return std::ranges::find(trials_, place, &StudyTrial::at) != trials_.end();
  }
  void add(StudyTrial trial) {
    if (!has(trial.at)) trials_.insert(trials_.begin(), std::move(trial));
  }

  /// The largest of the least errors of all forms with constants in a box; stops from `best` up.
  template <class Lattice>
  double least_error(const Lattice& lattice, const LatticeBox& box, double best) {
    double least = 0;
    for (std::size_t i = 0; i < trials_.size() && least < best; ++i) {
      const StudyTrial& trial = trials_[i];
      inputs_.clear();
      for (const double x : trial.at) inputs_.emplace_back(x);
      for (std::size_t k = 0; k < box.lower.size(); ++k)
        inputs_.emplace_back(lattice.value(box.lower[k]), lattice.value(box.upper[k]));
      form_.run(inputs_);
      const auto& form = form_.output(0);
      const double off = std::max(form.lower() - trial.target.upper, trial.target.lower - form.upper());
      if (off > 0) least = std::max(least, trial.factor * off);
      if (least >= best) std::swap(trials_[i], trials_[i / 2]);
    }
    return least;
  }

 private:
  TapeProgram<RoundedInterval<Arithmetic>> form_;
  std::vector<RoundedInterval<Arithmetic>> inputs_;  ///< working memory
  std::vector<StudyTrial> trials_;
};

template <class Lattice>
std::vector<double> values_at(const Lattice& lattice, const LatticePoint& point) {
  std::vector<double> values;
  for (const std::int64_t index : point) values.push_back(lattice.value(index));
  return values;
}

/// A narrow format: the error is the largest over every number of the format in the range, each operation
/// rounded. The bound subtracts and multiplies as the error does, so it is at most the error in double.
template <class Format>
class NarrowStudyProblem {
 public:
  NarrowStudyProblem(const ReadStudy& study, StudyInFormat<Format>& in_format)
      : in_format_(in_format), trials_(study) {
    const auto places = in_format.places();
    for (const auto& at : even_grid(study.axes, steps_of_trials.front())) {
      const auto found = std::ranges::lower_bound(places, at, {}, &PlaceInFormat::variables);
      add_trial(found == places.end() ? places.back() : *found);
    }
  }

  double bound(const LatticeBox& box, double best) { return trials_.least_error(lattice_, box, best); }

  double error(const LatticePoint& point, double best) {
    const ErrorInFormat worst = in_format_.largest_error(values_at(lattice_, point), best);
    add_trial(*std::ranges::lower_bound(in_format_.places(), worst.at, {}, &PlaceInFormat::variables));
    return worst.magnitude;
  }

 private:
  void add_trial(const PlaceInFormat& place) {
    if (std::isfinite(place.target) && std::isfinite(place.scale))
      trials_.add({place.variables, {place.target, place.target}, std::abs(place.scale)});
  }

  BinaryLattice<Format> lattice_;
  StudyInFormat<Format>& in_format_;
  StudyTrials<CorrectArithmetic<Format>> trials_;
};

/// The denominators of a form of one variable that are smooth and contain a parameter. Constants with which
/// one changes its sign have a pole, each at another place: a trial would not rule out many of them.
class StudyPoles {
 public:
  explicit StudyPoles(const ReadStudy& study) {
    if (study.axes.size() > 1) return;
    ends_ = {study.axes.front().lower, study.axes.front().upper};
    for (const Symbolic& pole : moving_poles(study)) {
      if (hinges_of(pole).empty())
        denominators_.push_back(TapeProgram<Bounds>(tape_of(pole, formula_inputs(study)), {}));
    }
  }

  /// Whether all constants of a box have a pole.
  template <class Lattice>
  bool are_in_all(const Lattice& lattice, const LatticeBox& box) {
    return std::ranges::any_of(denominators_, [&](auto& denominator) {
      bool is_below = false, is_above = false;
      for (const double end : ends_) {
        std::vector<Bounds> inputs{Bounds(end)};
        for (std::size_t k = 0; k < box.lower.size(); ++k)
          inputs.emplace_back(lattice.value(box.lower[k]), lattice.value(box.upper[k]));
        denominator.run(inputs);
        is_below = is_below || denominator.output(0).upper() < 0;
        is_above = is_above || denominator.output(0).lower() > 0;
      }
      return is_below && is_above;
    });
  }

 private:
  using Bounds = RoundedInterval<OutwardArithmetic>;

  std::array<double, 2> ends_{};
  std::vector<TapeProgram<Bounds>> denominators_;
};

/// A wide format: the error is that of the form in real numbers, whose maximum is sampled and refined, or
/// infinite if no bound of it can be proven, as with a pole between the samples. Ruling out constants is
/// rigorous nevertheless: it encloses form, target and factor at places where the form is too far from the
/// target.
template <class Lattice>
class RealStudyProblem {
 public:
  /// `has_bound` says whether a bound can be proven for constants.
  RealStudyProblem(const ReadStudy& study, const Lattice& lattice,
                   std::function<bool(const std::vector<double>&)> has_bound)
      : study_(study),
        lattice_(lattice),
        has_bound_(std::move(has_bound)),
        target_(tape_of(study.target, node_variables(study)), {}),
        factor_(tape_of(error_factor(study), node_variables(study)), {}),
        trials_(study),
        poles_(study) {
    for (const auto& place : even_grid(study.axes, steps_of_trials.at(study.axes.size() - 1)))
      add_trial(place);
  }

  double bound(const LatticeBox& box, double best) {
    if (poles_.are_in_all(lattice_, box)) return unbounded;
    constexpr double below = 1 - 0x1p-51;  // a difference and a product are rounded
    return below * trials_.least_error(lattice_, box, best);
  }

  double error(const LatticePoint& point, double best) {
    const std::vector<double> values = values_at(lattice_, point);
    const StudyExtremum worst = largest_weighted_error(study_, values);
    if (std::isnan(worst.magnitude)) return unbounded;
    add_trial(worst.at);
    return worst.magnitude < best && !has_bound_(values) ? unbounded : worst.magnitude;
  }

 private:
  void add_trial(const std::vector<double>& place) {
    if (trials_.has(place)) return;
    const std::vector<Interval> numbers(place.begin(), place.end());
    target_.run(numbers);
    factor_.run(numbers);
    const Interval &target = target_.output(0), &factor = factor_.output(0);
    if (is_bounded(target) && is_bounded(factor))
      trials_.add({place, {lower_end(target), upper_end(target)}, smallest_magnitude_in(factor)});
  }

  const ReadStudy& study_;
  Lattice lattice_;
  std::function<bool(const std::vector<double>&)> has_bound_;
  TapeProgram<Interval> target_, factor_;
  StudyTrials<OutwardArithmetic> trials_;
  StudyPoles poles_;
};

}  // namespace shadefit
