#pragma once

#include <string>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/study_verdict.hpp"

/// The best constants of a study in a number format.
namespace shadefit {

struct RoundedStudySet {
  std::vector<double> values;
  std::vector<std::string> texts;  ///< the shortest decimals that read back as these numbers of the format
  double max_error = 0;            ///< a proven bound of |weight * error| of the form in real numbers
  std::vector<double> at;          ///< where a lower bound of it is attained
};

struct RoundedStudy {
  NumberFormat format;
  RoundedStudySet best;
  RoundedStudySet naive;   ///< each parameter of the fit rounded separately
  bool is_proven = false;  ///< no other constants among those searched have a smaller error
  std::string searched;    ///< the set of constants that was searched
  long evaluated = 0;      ///< constants whose error was computed
};

/// The most parameters of a form whose constants are searched for.
inline constexpr std::size_t most_rounded_parameters = 4;

/// Searches a format, float or decimal, for the constants with the smallest largest |weight * error| over the
/// ranges. Held parameters stay as they are. Throws UserError for half and bfloat16, for measured rows, for
/// constraints, which rounding breaks, for more than four parameters, and if one overflows the format;
/// CheckFailed if no bound of the error was proven.
RoundedStudy round_study(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                         const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
