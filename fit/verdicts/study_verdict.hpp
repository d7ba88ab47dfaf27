#pragma once

#include <string>
#include <vector>

#include "fit/study/study_file.hpp"
#include "fit/study_exchange/constrained_study.hpp"
#include "fit/study_exchange/minimax_study.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/verdict.hpp"

/// Verdicts on the published constants of a study.
namespace shadefit {

/// What a fit of a study minimises.
struct StudyObjective {
  std::string words;  ///< "least squares", "minimax, relative error", "least squares with a = 1.57"
  Study study;
  Norm norm = Norm::least_squares;
  Constraints constraints = {};  ///< of minimax
};

/// The fit under an objective. Throws UserError like `read_study`, `solve_study` and `solve_minimax_study`.
StudyFit fit_study(const StudyObjective& objective, const Checkpoint& checkpoint = keep_going);

/// An objective with its words.
StudyObjective objective_of(const Study& study, Norm norm, const Constraints& constraints);

/// The objectives under which a number may have been fitted, other than `asked`: each norm, each error, each
/// density of a cosine where the range is inside [0, 1], minimax that is exact at an end of the range.
std::vector<StudyObjective> other_objectives(const StudyObjective& asked);

struct StudyJudgement {
  Verdict verdict;
  std::string objective;         ///< under which the digits are right; empty if refuted
  std::vector<double> computed;  ///< under that objective, or the asked one; empty if no fit converged
};

/// Compares all constants of a set with those of one fit at a time: under the asked objective, under the
/// others, and with each constant in turn held at its printed value. `confirmed`: all printed digits are
/// those of the asked fit; `rounding`: some last digits are off by one; `other-objective`: all are those of
/// another fit; else `refuted`. Throws UserError if the set lacks a parameter of the form, or has another.
StudyJudgement judge_set(const StudyObjective& asked, const PublishedSet& set,
                         const Checkpoint& checkpoint = keep_going);

/// The verdict on what a source says about its largest error: `confirmed` if the computed one has the same
/// digits or is smaller, `rounding` if its last digit is off by one, else `refuted`.
Verdict judge_claim(const ErrorClaim& claim, double max_abs_error);

/// The values of a set in the order of the parameters. Throws like `judge_set`.
std::vector<std::string> values_of(const PublishedSet& set, const std::vector<std::string>& parameters);

}  // namespace shadefit
