#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "fit/scalars/narrow_result.hpp"
#include "fit/study/study.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/tape/tape_program.hpp"

/// The form of a study in a format: every constant, number, operation and function rounded to nearest.
namespace shadefit {

/// The largest error in a format. It is infinite if the form overflows or is not a number at a sample.
struct ErrorInFormat {
  double magnitude = 0;
  std::vector<double> at;  ///< the variables, as numbers of the format
};

/// The error of a form at every sample: at all numbers of the format in the range of the one variable, or at
/// all rows, with their variables rounded. The target and the weight are computed in double, for the
/// variables as they are.
template <class Format>
class StudyInFormat {
 public:
  /// Throws std::logic_error for a formula of two variables: its places are too many.
  explicit StudyInFormat(const ReadStudy& study, const Checkpoint& checkpoint = keep_going);

  /// How many places there are; none if no number of the format lies in the range.
  std::size_t size() const { return places_.size(); }

  /// The largest |weight * (form - target)|, divided by the target if the error is relative: the error by
  /// which the sets of a study are compared. Rows without a weight that is asked for are compared by
  /// |form - value|: in their unit, also if they have sigma. `constants` are numbers of the format. From
  /// `enough` on, the first error that reaches it is the answer.
  ErrorInFormat largest_error(std::span<const double> constants, double enough = HUGE_VAL);

  /// The error at the first number of the format that is not below x.
  double error_from(double x, std::span<const double> constants);

 private:
  struct Sample {
    std::vector<double> variables;  ///< numbers of the format
    double target, scale;
  };
  static std::vector<Sample> places_of(const ReadStudy& study, const Checkpoint& checkpoint);
  double error_at(const Sample& sample, std::span<const double> constants);

  std::vector<Sample> places_;
  /// Their indices, those with the largest errors of late first: such a sample refuses constants at once.
  std::vector<std::size_t> order_;
  TapeProgram<NarrowResult<Format>> form_;
  std::vector<NarrowResult<Format>> inputs_;  ///< working memory
};

extern template class StudyInFormat<HalfFormat>;
extern template class StudyInFormat<FloatFormat>;

/// Constants in half with a smaller largest error than those given, found by moves of one constant or
/// two, by 1, 2, 4 .. 64 steps of the format, until no move helps. A move that makes the error
/// larger at a sample of `kept`, where the form should be exact, is not taken. The given constants must be
/// halves.
std::vector<double> moved_constants(StudyInFormat<HalfFormat>& study, std::vector<double> constants,
                                    std::span<const double> kept, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
