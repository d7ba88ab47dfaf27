#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fit/catalogue/study_file.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "fit/verdicts/verdict.hpp"

/// Verdicts on the published constants of a study.
namespace shadefit {

/// The printed constants that are not held, as starts of a fit.
std::vector<Held> starts_at(const PublishedSet& set, const std::vector<Held>& held);

/// Those of the first set that was published for a form; empty if there is none.
std::vector<Held> published_starts(const StudyFile& file, const std::string& form, const Study& study);

struct StudyJudgement {
  Verdict verdict;
  /// The objective with the right digits; if refuted, with the nearest; empty if no fit converged.
  std::string objective;
  std::vector<double> computed;  ///< under that objective
  std::size_t tried = 0;         ///< how many fits were tried
  /// The expected number of fits that hold the same constant, or none, and have all printed digits by chance.
  /// Of the asked fit alone if that has them. 0 if a fit meets its target: its digits are no choice.
  double chance = 0;
  std::vector<std::string> also = {};  ///< the other objectives that have the same digits
  long units_off = 0;  ///< of the worst constant under `objective`, in units of its last printed digit
  std::optional<int> compared_digits = {};  ///< of each constant, where more are printed than a fit has
};

/// If more chance hits are expected, a hit decides nothing.
inline constexpr double most_chance_hits = 0.01;

/// A fit that was tried for a published set.
struct TriedFit {
  std::string words;                ///< of its objective
  std::vector<double> values;       ///< of all parameters, a held one at its printed value
  std::optional<std::size_t> held;  ///< the parameter that is held in addition to those of the study
  bool has_no_error = false;        ///< its form is its target
};

struct TriedFits {
  std::vector<TriedFit> fits = {};  ///< those that converged
  bool has_asked = false;           ///< whether the first of them is the fit that was asked for
  std::size_t attempts = 0;
  bool is_stated = false;  ///< the source names the fit that was asked for: its digits are no chance
};

/// The fits that may have a set's digits. First under the asked objective. If that has the digits, under the
/// plain ones, which tell how much the constants depend on an objective; otherwise under all others; and if
/// none of these has the digits, with each constant in turn held at its printed value, if that is near the
/// best one. Throws UserError if the set lacks a parameter of the form, or has another.
TriedFits tried_fits(StudyObjective asked, const PublishedSet& set,
                     const Checkpoint& checkpoint = keep_going);

/// Compares printed constants, in the order of the parameters, with each fit. `confirmed`: the asked fit has
/// all printed digits; `rounding`: some last digits are off by one; `other-objective`: another fit has them
/// all; `undecidable`: a fit has them or is off by one, but that could be chance; otherwise `refuted`.
///
/// The chance of other objectives is counted among all fits that were tried, because each had its try. The
/// asked objective stands in the file of the study: it has one try. Its chance is that of one fit.
StudyJudgement judge_digits(const TriedFits& tried, const std::vector<std::string>& printed);

/// The verdict on a set, by the fits that are tried for it. Throws as `tried_fits` does.
StudyJudgement judge_set(const StudyObjective& asked, const PublishedSet& set,
                         const Checkpoint& checkpoint = keep_going);

/// The values of a set in the order of the parameters. Throws as `judge_set` does.
std::vector<std::string> values_of(const PublishedSet& set, const std::vector<std::string>& parameters);

}  // namespace shadefit
