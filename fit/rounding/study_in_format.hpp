#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "fit/study/study.hpp"
#include "fit/support/checkpoint.hpp"

/// The form of a study in a format: every constant, number, operation and function rounded to nearest.
namespace shadefit {

/// The first and the last index of the numbers of a format in a range; none if the first is after the last.
template <class Format>
std::pair<std::int64_t, std::int64_t> numbers_in(const StudyAxis& axis) {
  const BinaryLattice<Format> lattice;
  std::int64_t first = lattice.nearest(axis.lower), last = lattice.nearest(axis.upper);
  if (first < -lattice.last() || lattice.value(first) < axis.lower) ++first;
  if (last > lattice.last() || lattice.value(last) > axis.upper) --last;
  return {first, last};
}

/// The largest error in a format. It is infinite if the form overflows or is not a number at a sample.
struct ErrorInFormat {
  double magnitude = 0;
  std::vector<double> at;  ///< the variables, as numbers of the format
};

/// A place at which a form is evaluated.
struct PlaceInFormat {
  std::vector<double> variables;  ///< numbers of the format
  double target, scale;
};

/// The error of a form at every place: at all numbers of the format in the range of the one variable, or at
/// all rows, with their variables rounded. If the range holds more than 2^16 numbers, as it does in float,
/// the places are a sample of them. The target and the weight are computed in double, for the variables as
/// they are.
template <class Format>
class StudyInFormat {
 public:
  /// Throws std::logic_error for a formula of two variables: its places are too many.
  explicit StudyInFormat(const ReadStudy& study, const Checkpoint& checkpoint = keep_going);

  /// By rising numbers, then those that were added, or by rows; none if no number of the format lies in the
  /// range.
  std::span<const PlaceInFormat> places() const { return places_; }

  /// How many sets of constants were tried by `largest_error`.
  long tried() const { return tried_; }

  /// The largest |weight * (form - target)|, divided by the target if the error is relative: the error by
  /// which the sets of a study are compared. Rows without a weight that is asked for are compared by
  /// |form - value|: in their unit, also if they have sigma. `constants` are numbers of the format. From
  /// `enough` on, the first error that reaches it is the answer.
  ErrorInFormat largest_error(std::span<const double> constants, double enough = HUGE_VAL);

  /// The error at the first number of the format that is not below x.
  double error_from(double x, std::span<const double> constants);

  /// The error at a place. A form that is exactly its target has none, also where a relative error is 0/0.
  double error_at(const PlaceInFormat& place, std::span<const double> constants);

  /// Adds a number to the sample.
  void add(double x);

  /// The place of the variables at a node.
  PlaceInFormat place_at(const std::vector<double>& node);

  /// The largest error in 8-bit sRGB codes over all places; empty if a target is outside of [0, 1].
  std::optional<double> srgb_codes(std::span<const double> constants);

  /// Bounds the largest error that a GPU makes at these places, by `usual_gpu`. Infinite if no bound is
  /// found.
  double bound_on_gpu(std::span<const double> constants, const Checkpoint& checkpoint = keep_going) const;

 private:
  double form_at(const PlaceInFormat& place, std::span<const double> constants);

  TapeProgram<double> target_, factor_;
  std::size_t axes_;
  std::vector<PlaceInFormat> places_;
  /// Their indices, those with the largest errors of late first: such a place refuses constants at once.
  std::vector<std::size_t> order_;
  TapeProgram<NarrowResult<Format>> form_;
  std::vector<NarrowResult<Format>> inputs_;  ///< working memory
  long tried_ = 0;
};

extern template class StudyInFormat<HalfFormat>;
extern template class StudyInFormat<Bfloat16Format>;
extern template class StudyInFormat<FloatFormat>;

/// The farthest move of a constant, in steps of its format.
inline constexpr int farthest_move = 64;

/// Constants with a smaller largest error than those given, found by moves of one constant or two, by 1, 2, 4
/// .. 64 steps of the format, until no move helps. A move that makes the error larger at a place of `kept`,
/// where the form should be exact, is not taken. The given constants must be numbers of the format.
template <class Format>
std::vector<double> moved_constants(StudyInFormat<Format>& study, std::vector<double> constants,
                                    std::span<const double> kept, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
