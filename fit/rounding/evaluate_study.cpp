#include "fit/rounding/round_study.hpp"

#include <algorithm>
#include <concepts>

#include "fit/rounding/every_number.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

std::string option_of(const NumberFormat& format) {
  return "--evaluate '" + to_text(format) + "'";
}

/// How often a place at which the best constants are worse than at the sample joins it.
constexpr int most_joined = 3;

/// The best constants that moves from the starts find, or the set that is given. `set_of` assesses constants
/// at every number of the format.
template <class Format, class SetOf>
RoundedStudySet best_from(StudyInFormat<Format>& in_format, const std::vector<std::vector<double>>& starts,
                          RoundedStudySet best, const SetOf& set_of, const Checkpoint& checkpoint) {
  const auto error_of = [&](const auto& values) { return in_format.largest_error(values).magnitude; };
  std::vector<std::vector<double>> found;
  for (const std::vector<double>& start : starts)
    found.push_back(moved_constants(in_format, start, {}, checkpoint));
  std::vector<double> values = *std::ranges::min_element(found, {}, error_of);
  for (int joined = 0; joined <= most_joined; ++joined) {
    const RoundedStudySet set = set_of(values);
    if (set.max_error < best.max_error) best = set;
    if (set.max_error <= error_of(values)) break;
    in_format.add(set.at.front());
    values = moved_constants(in_format, values, {}, checkpoint);
  }
  return best;
}

template <class Format>
RoundedStudy evaluated(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                       const std::vector<double>& published, const Checkpoint& checkpoint) {
  const ReadStudy study = read_study(objective.study);
  const BinaryLattice<Format> lattice;
  auto in_format = study_in<Format>(study, option_of(format), checkpoint);
  const auto rounded = [&](const std::vector<double>& values) {
    return set_at(lattice, indices_of(lattice, values, study.parameters, option_of(format)));
  };
  const auto set_of = [&](const std::vector<double>& values) {
    RoundedStudySet set = rounded(values);
    if constexpr (std::same_as<Format, FloatFormat>) {
      const ErrorInFormat largest = largest_of_every_number(study, in_format, set.values, checkpoint);
      set.max_error = largest.magnitude;
      set.at = largest.at;
    } else {
      add_errors(set, in_format, checkpoint);
    }
    return set;
  };
  RoundedStudy result{.format = format, .naive = set_of(fit.parameters)};
  auto starts = fitted_values(objective, fit, checkpoint);
  if (!published.empty()) {
    result.published = set_of(published);
    starts.push_back(published);
  }
  for (std::vector<double>& start : starts) start = rounded(start).values;
  result.best = best_from(in_format, starts, result.naive, set_of, checkpoint);
  result.evaluated = in_format.tried();
  result.searched = "those that moves of one constant or two, by up to " + std::to_string(farthest_move) +
                    " steps of the format, reach from the fits";
  return result;
}

}  // namespace

RoundedStudy evaluate_study(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                            const std::vector<double>& published, const Checkpoint& checkpoint) {
  const ReadStudy study = read_formulas(objective.study);
  const bool is_half = format.kind == NumberFormat::Kind::half;
  require_plain(objective, is_half ? study.form : error_formula(study), option_of(format));
  if (study.axes.size() > 1)
    throw UserError(option_of(format) + " takes one variable, not " + std::to_string(study.axes.size()));
  return is_half ? evaluated<HalfFormat>(objective, fit, format, published, checkpoint)
                 : evaluated<FloatFormat>(objective, fit, format, published, checkpoint);
}

}  // namespace shadefit
