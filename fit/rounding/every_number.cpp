#include "fit/rounding/every_number.hpp"

#include <algorithm>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/scalars/rounded_interval.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// So many neighbours are evaluated at once: that takes as long as some enclosures.
constexpr std::int64_t few_numbers = 16;

template <class Format>
class EveryNumber {
 public:
  EveryNumber(const ReadStudy& study, StudyInFormat<Format>& in_format, std::span<const double> constants,
              const Checkpoint& checkpoint)
      : in_format_(in_format),
        constants_(constants),
        checkpoint_(checkpoint),
        form_(tape_of(study.form, formula_inputs(study)),
              std::vector<Computed>(constants.begin(), constants.end())),
        target_(tape_of(study.target, node_variables(study)), {}),
        factor_(tape_of(error_factor(study), node_variables(study)), {}),
        largest_(in_format.largest_error(constants)) {
    const auto [first, last] = numbers_in<Format>(study.axes.front());
    search(first, last);
  }

  const ErrorInFormat& largest() const { return largest_; }

 private:
  using Computed = RoundedInterval<CorrectArithmetic<Format>>;
  using Real = RoundedInterval<OutwardArithmetic>;

  void search(std::int64_t first, std::int64_t last) {
    checkpoint_();
    if (bound_on(first, last) <= largest_.magnitude) return;
    if (last - first < few_numbers) {
      for (std::int64_t i = first; i <= last; ++i) evaluate(lattice_.value(i));
      return;
    }
    const std::int64_t middle = first + (last - first) / 2;
    search(first, middle);
    search(middle + 1, last);
  }

  void evaluate(double x) {
    const PlaceInFormat place = in_format_.place_at({x});
    const double error = in_format_.error_at(place, constants_);
    if (error > largest_.magnitude) largest_ = {error, place.variables};
  }

  /// A bound of the errors of all numbers between two. The enclosures of real numbers contain what double
  /// makes of target and factor.
  double bound_on(std::int64_t first, std::int64_t last) {
    const double from = lattice_.value(first), to = lattice_.value(last);
    form_.run(std::array{Computed(from, to)});
    target_.run(std::array{Real(from, to)});
    factor_.run(std::array{Real(from, to)});
    const Computed& form = form_.output(0);
    const Real error = (Real(form.lower(), form.upper()) - target_.output(0)) * factor_.output(0);
    return std::max(-error.lower(), error.upper());
  }

  BinaryLattice<Format> lattice_;
  StudyInFormat<Format>& in_format_;
  std::span<const double> constants_;
  const Checkpoint& checkpoint_;
  TapeProgram<Computed> form_;
  TapeProgram<Real> target_, factor_;
  ErrorInFormat largest_;
};

}  // namespace

template <class Format>
ErrorInFormat largest_of_every_number(const ReadStudy& study, StudyInFormat<Format>& in_format,
                                      std::span<const double> constants, const Checkpoint& checkpoint) {
  return EveryNumber<Format>(study, in_format, constants, checkpoint).largest();
}

template ErrorInFormat largest_of_every_number(const ReadStudy&, StudyInFormat<HalfFormat>&,
                                               std::span<const double>, const Checkpoint&);
template ErrorInFormat largest_of_every_number(const ReadStudy&, StudyInFormat<FloatFormat>&,
                                               std::span<const double>, const Checkpoint&);

}  // namespace shadefit
