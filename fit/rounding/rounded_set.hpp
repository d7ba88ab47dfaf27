#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/rounding/study_in_format.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_objectives.hpp"

/// Constants of a study in a number format, with their errors.
namespace shadefit {

/// `max_error` is the largest |weight * error|. It is the largest over every number of the format in the
/// range, with each operation rounded and the target in double; or else a proven bound: that of the form in
/// real numbers, plus in float what rounding adds, where a bound of that was found.
struct RoundedStudySet {
  std::vector<double> values;
  std::vector<std::string> texts;  ///< the shortest decimals that read back as these numbers of the format
  double max_error = 0;
  std::vector<double> at;  ///< where it is reached; of a proven bound, where a lower bound is
  std::optional<double> real_error = {}, rounding_error = {};  ///< the parts of a proven bound
  std::optional<double> srgb_codes = {};  ///< the largest error in 8-bit sRGB codes, if every input was tried
  std::optional<double> gpu_bound = {};   ///< bounds the error on a GPU, by `usual_gpu`
};

struct RoundedStudy {
  NumberFormat format;
  RoundedStudySet best = {};
  RoundedStudySet naive = {};                     ///< each parameter of the fit rounded separately
  std::optional<RoundedStudySet> published = {};  ///< the published values rounded
  bool is_proven = false;     ///< no other constants among those searched have a smaller error
  std::string searched = {};  ///< the set of constants that was searched
  long evaluated = 0;         ///< constants whose error was computed
};

/// Refuses measured rows, constraints, which rounding breaks, and a formula with an integral. `option` is
/// "--round 'half'".
void require_plain(const StudyObjective& objective, const Symbolic& formula, const std::string& option);

/// The constants of a fit, and those of the minimax fit if they are others and the study has one variable.
std::vector<std::vector<double>> fitted_values(const StudyObjective& objective, const StudyFit& fit,
                                               const Checkpoint& checkpoint);

/// The indices of the numbers nearest to some values. Throws UserError if one overflows.
template <class Lattice>
std::vector<std::int64_t> indices_of(const Lattice& lattice, const std::vector<double>& values,
                                     const std::vector<std::string>& names, const std::string& option) {
  std::vector<std::int64_t> indices;
  for (std::size_t i = 0; i < values.size(); ++i) {
    indices.push_back(lattice.nearest(values[i]));
    if (std::abs(indices.back()) > lattice.last())
      throw UserError(option + ": " + names[i] + " = " + decimal(values[i], 6) +
                      " overflows: the largest is " + largest_text(lattice));
  }
  return indices;
}

template <class Lattice, class Indices>
RoundedStudySet set_at(const Lattice& lattice, const Indices& indices) {
  RoundedStudySet set;
  for (const std::int64_t index : indices) {
    set.values.push_back(lattice.value(index));
    set.texts.push_back(shortest(lattice, index));
  }
  return set;
}

/// A form in a format. Throws UserError if no number of the format lies in the range.
template <class Format>
StudyInFormat<Format> study_in(const ReadStudy& study, const std::string& option,
                               const Checkpoint& checkpoint) {
  StudyInFormat<Format> in_format(study, checkpoint);
  if (in_format.places().empty())
    throw UserError(option + ": the range of " + study.axes.front().variable + " holds no number of " +
                    std::string(Format::name));
  return in_format;
}

/// Adds the errors of a set in a narrow format. The form is evaluated at every number in the range.
template <class Format>
void add_errors(RoundedStudySet& set, StudyInFormat<Format>& in_format, const Checkpoint& checkpoint) {
  const ErrorInFormat largest = in_format.largest_error(set.values);
  set.max_error = largest.magnitude;
  set.at = largest.at;
  set.srgb_codes = in_format.srgb_codes(set.values);
  const double on_gpu = in_format.bound_on_gpu(set.values, checkpoint);
  if (std::isfinite(on_gpu)) set.gpu_bound = on_gpu;
}

/// Whether a bound of the error in real numbers can be proven.
bool has_bound(const StudyObjective& objective, const ReadStudy& study, const std::vector<double>& values,
               const Checkpoint& checkpoint);

/// Adds the proven bounds of the errors of a set, in float also those of rounding. Throws CheckFailed if no
/// bound of the error in real numbers was proven.
void add_proven_errors(RoundedStudySet& set, const StudyObjective& objective, const ReadStudy& study,
                       bool is_float, const Checkpoint& checkpoint);

}  // namespace shadefit
