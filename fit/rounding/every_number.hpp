#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/rounding/study_in_format.hpp"
#include "fit/scalars/rounded_interval.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {

/// The largest error of a form with constants of the format, over every number of the format in the range of
/// its one variable, and the first place that has it of those that were evaluated. `study` is that of
/// `in_format`, which has a sample of the places. A range of numbers is left out if an enclosure of the
/// rounded form and of the target shows that no number in it has a larger error; so it takes long only if
/// rounding makes most of the error. The checkpoint is called often. Throws std::logic_error for an albedo in
/// the target or the weight.
template <class Format>
ErrorInFormat largest_of_every_number(const ReadStudy& study, StudyInFormat<Format>& in_format,
                                      std::span<const double> constants,
                                      const Checkpoint& checkpoint = keep_going) {
  constexpr std::int64_t few_numbers = 16;  // evaluating them takes as long as some enclosures
  using Computed = RoundedInterval<CorrectArithmetic<Format>>;
  using Real = RoundedInterval<OutwardArithmetic>;
  TapeProgram<Computed> form_on(tape_of(study.form, formula_inputs(study)),
                                std::vector<Computed>(constants.begin(), constants.end()));
  TapeProgram<Real> target_on(tape_of(study.target, node_variables(study)), {}),
      factor_on(tape_of(error_factor(study), node_variables(study)), {});
  // A bound of the errors of all numbers between two. The enclosures of real numbers contain what double
  // makes of target and factor.
  const auto bound_between = [&](double from, double to) {
    form_on.run(std::array{Computed(from, to)});
    target_on.run(std::array{Real(from, to)});
    factor_on.run(std::array{Real(from, to)});
    const Computed& form = form_on.output(0);
    const Real error = (Real(form.lower(), form.upper()) - target_on.output(0)) * factor_on.output(0);
    return std::max(-error.lower(), error.upper());
  };
  const BinaryLattice<Format> lattice;
  ErrorInFormat largest = in_format.largest_error(constants);
  std::vector open{numbers_in<Format>(study.axes.front())};
  while (!open.empty()) {
    checkpoint();
    const auto [first, last] = open.back();
    open.pop_back();
    if (bound_between(lattice.value(first), lattice.value(last)) <= largest.magnitude) continue;
    if (last - first < few_numbers) {
      for (std::int64_t i = first; i <= last; ++i) {
        const PlaceInFormat place = in_format.place_at({lattice.value(i)});
        const double error = in_format.error_at(place, constants);
        if (error > largest.magnitude) largest = {error, place.variables};
      }
    } else {
      const std::int64_t middle = first + (last - first) / 2;
      open.push_back({middle + 1, last});
      open.push_back({first, middle});
    }
  }
  return largest;
}

}  // namespace shadefit
