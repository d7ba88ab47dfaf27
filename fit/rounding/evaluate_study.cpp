#include "fit/rounding/evaluate_study.hpp"

#include <algorithm>
#include <concepts>
#include <utility>

#include "fit/rounding/every_number.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

std::string option_of(const NumberFormat& format) {
  return "--evaluate '" + to_text(format) + "'";
}

/// How often a place at which the best constants are worse than at the sample joins it.
constexpr int most_joined = 3;

/// The evaluation of a study in a format.
template <class Format>
class Evaluation {
 public:
  Evaluation(const ReadStudy& study, std::string option, const Checkpoint& checkpoint)
      : study_(study),
        option_(std::move(option)),
        checkpoint_(checkpoint),
        in_format_(study_in<Format>(study, option_, checkpoint)) {}

  /// Values in the format, with their errors over every number of it.
  RoundedStudySet set_of(const std::vector<double>& values) {
    RoundedStudySet set = rounded(values);
    if constexpr (std::same_as<Format, FloatFormat>) {
      const ErrorInFormat largest = largest_of_every_number(study_, in_format_, set.values, checkpoint_);
      set.max_error = largest.magnitude;
      set.at = largest.at;
    } else {
      add_errors(set, in_format_, checkpoint_);
    }
    return set;
  }

  /// The best that moves from the starts find, or the set that is given, that of the first start.
  RoundedStudySet best_from(const std::vector<std::vector<double>>& starts, RoundedStudySet best) {
    std::vector<std::vector<double>> found;
    for (const std::vector<double>& start : starts)
      found.push_back(moved_constants(in_format_, rounded(start).values, {}, checkpoint_));
    const auto error_of = [&](const auto& values) { return in_format_.largest_error(values).magnitude; };
    std::vector<double> values = *std::ranges::min_element(found, {}, error_of);
    for (int joined = 0; joined <= most_joined; ++joined) {
      const RoundedStudySet set = set_of(values);
      if (set.max_error < best.max_error) best = set;
      if (set.max_error <= error_of(values)) break;
      in_format_.add(set.at.front());
      values = moved_constants(in_format_, values, {}, checkpoint_);
    }
    return best;
  }

  long tried() const { return in_format_.tried(); }

 private:
  RoundedStudySet rounded(const std::vector<double>& values) const {
    return set_at(lattice_, indices_of(lattice_, values, study_.parameters, option_));
  }

  BinaryLattice<Format> lattice_;
  const ReadStudy& study_;
  std::string option_;
  const Checkpoint& checkpoint_;
  StudyInFormat<Format> in_format_;
};

template <class Format>
RoundedStudy evaluated(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                       const std::vector<double>& published, const Checkpoint& checkpoint) {
  const ReadStudy study = read_study(objective.study);
  Evaluation<Format> evaluation(study, option_of(format), checkpoint);
  RoundedStudy result{.format = format, .naive = evaluation.set_of(fit.parameters)};
  auto starts = fitted_values(objective, fit, checkpoint);
  if (!published.empty()) {
    result.published = evaluation.set_of(published);
    starts.push_back(published);
  }
  result.best = evaluation.best_from(starts, result.naive);
  result.evaluated = evaluation.tried();
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
