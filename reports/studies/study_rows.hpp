#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/catalogue/study_file.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/verdicts/study_verdict.hpp"
#include "reports/io/table.hpp"

/// Fits of one's own as rows.
namespace shadefit {

/// A published set with the verdict on it.
struct JudgedSet {
  PublishedSet set;
  StudyJudgement judgement;
};

/// A study with its fit. All studies of a list differ in their given constants alone.
struct FittedStudy {
  StudyObjective objective;
  ReadStudy read;
  StudyFit fit;
  std::vector<JudgedSet> published = {};

  const Study& asked() const { return objective.study; }
};

/// "other-objective: minimax, exact at x = 0", "confirmed", "confirmed to 14 digits" where more are printed.
std::string verdict_in_words(const StudyJudgement& judgement);

/// The same with the number of fits that were tried: "refuted (92 tried)".
std::string verdict_text(const StudyJudgement& judgement);

/// A source for a table: the authors and the year; without a year up to the first comma or colon.
OthersText short_source(const OthersText& source);

/// A row for each fit: the given constants, the parameters, status, digits and errors; where something was
/// published, its digits and the verdict.
Table study_table(const std::vector<FittedStudy>& studies);

/// "f(x) = x^2".
std::string definition_text(const StudyDefinition& definition);

/// "sqrt(1 - x) (a + b x) ~ acos(x), x in 0:1".
OthersText formulas_text(const Study& study);

/// "sqrt(1 - x) (a + b x) ~ acos(x), x in 0:1, least squares".
OthersText study_headline(const FittedStudy& study);

/// "Level 0.00320696, the error is + at x = 0, - at x = 0.3" of a minimax fit, and a line for each place
/// where a constraint touches.
std::string level_text(const FittedStudy& study);

/// A place as an object of variables to values.
nlohmann::ordered_json place_json(const FittedStudy& study, const std::vector<double>& at);

/// The same of a minimax fit as an array: each place with its error, and "level" or the constraint that holds
/// there.
nlohmann::ordered_json alternation_json(const FittedStudy& study);

/// Of fits of measured rows, a row for each parameter: its standard error, and its profile interval, of which
/// an end may be "open".
Table uncertainty_table(const std::vector<FittedStudy>& studies);

/// The parameters of a fit of measured rows with the same numbers, for a page: a column for each of a few
/// parameters, else a row.
Table parameters_table(const FittedStudy& study);

/// Adds the same numbers to the rows of `study_table`, three columns for each parameter.
void add_uncertainty_columns(Table& table, const std::vector<FittedStudy>& studies);

/// Says what the standard errors and intervals mean, or why there are none.
std::string uncertainty_text(const std::vector<FittedStudy>& studies);

/// An object for each fit; places are objects of variables to values. A fit of measured rows also has
/// `table`, `rows`, `row` (of the largest residual, from 1), `degrees_of_freedom`, `reduced_chi_square` or
/// `residual_deviation`, `standard_error`, `covariance` and `profile`, whose open ends are null.
nlohmann::ordered_json study_json(const std::vector<FittedStudy>& studies);

}  // namespace shadefit
