#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/squares/rules.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/study/study_problem.hpp"

/// Many least-squares fits of one study.
namespace shadefit {

/// A study whose formulas are read, recorded and sampled once. One thread uses it at a time. It keeps its
/// place: its parts point to each other.
class PreparedStudy {
 public:
  /// Throws UserError like `read_study`, where target or weight have no value, and if the range, the target
  /// or a likely parameter is beyond 2^32 or below 2^-32: those fits need units of their own. The panels see
  /// what the target does, narrow or not; where they cannot, no fit converges.
  explicit PreparedStudy(const Study& study);
  PreparedStudy(const PreparedStudy&) = delete;
  PreparedStudy& operator=(const PreparedStudy&) = delete;

  /// The free parameters, in the order of starts and answers.
  const std::vector<std::string>& parameters() const { return study_.parameters; }

  /// The bottom of the basin of a start, with the digits that the next rule in long double confirms and its
  /// rms error. No other basin is looked for, and no largest error: `solve_study` does that. A start without
  /// a finite error does not converge.
  StudyFit fit(const std::vector<double>& start) { return fit_from({start}); }

  /// The same from several starts; `ambiguous` if they do not all lead to the same curve.
  StudyFit fit_from(const std::vector<std::vector<double>>& starts);

  /// sqrt(integral of density * error^2 / integral of density), weighted.
  double rms_error(const std::vector<double>& parameters);

 private:
  void cut_panels(const std::vector<double>& parameters);

  ReadStudy study_;
  std::optional<double> unresolved_;
  StudyError error_;
  Rules rules_;
  bool has_cut_panels_;
};

}  // namespace shadefit
