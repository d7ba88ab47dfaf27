#include "fit/exchange/exchanged_study.hpp"

#include <algorithm>
#include <string>

#include "fit/exchange/constrained_study.hpp"
#include "fit/panels/logarithms.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The command-line option of the first constraint; null if there is none.
const char* option_of(const Constraints& constraints) {
  return !constraints.exact_at.empty() ? "--exact-at"
         : constraints.one_sided       ? "--one-sided"
         : constraints.at_most         ? "--at-most"
         : constraints.at_least        ? "--at-least"
         : constraints.monotone        ? "--monotone"
                                       : nullptr;
}

}  // namespace

ExchangedStudy::ExchangedStudy(const ReadStudy& study, const StudyError& error,
                               const std::vector<StudyEdge>& edges, const std::vector<double>& parameters,
                               const Constraints& constraints)
    : panels_(std::make_shared<SearchPanels>(study, edges, parameters)),
      sampled_(error, nodes_of(study, {edges}, gauss_sizes[4])) {
  std::vector<SearchPlace>& places = problem_.places;
  for (std::size_t panel = 0; panel < panels_->size(); ++panel) {
    for (const double s : chebyshev_places()) places.push_back({panel, s});
  }
  problem_.size = study.parameters.size();
  problem_.variable = study.axes.front().variable;
  problem_.cosine_at = [this](const SearchPlace& place) {
    const double x = panels_->first(place.panel).at(place.s);
    return Cosine<double>{x, 1 - x};
  };
  Symbolic signed_error = error_formula(study);
  // A relative error of a negative target is negative where the form lies above it.
  if (constraints.one_sided && study.error == Error::relative &&
      values_at_nodes(study, study.target, nodes_of(study, {edges}, gauss_sizes[0])).front() < 0)
    signed_error = -signed_error;
  const auto curve = [&](const ReadStudy& of, const Symbolic& formula, CurveOf what = CurveOf::formula) {
    return std::make_shared<PanelCurve>(of, formula, what, panels_);
  };
  problem_.error = curve(study, signed_error);
  problem_.deviation = problem_.error;
  const bool is_bounded = constraints.at_most || constraints.at_least;
  const auto is_linear = [](const StudyError& of) { return std::ranges::count(of.is_linear(), false) == 0; };
  const std::optional<ReadStudy> logarithms = (constraints.one_sided || is_bounded) && !is_linear(error)
                                                  ? logarithms_of(study, parameters)
                                                  : std::nullopt;
  if (logarithms && constraints.one_sided)
    problem_.deviation = curve(*logarithms, error_formula(*logarithms));
  if (is_bounded) problem_.bounded = curve(study, logarithms ? logarithms->form : study.form);
  if (constraints.monotone) problem_.sloping = curve(study, study.form, CurveOf::slope);
  problem_.is_exponential = logarithms.has_value();
  problem_.is_linear =
      is_linear(error) || (logarithms && !constraints.monotone && is_linear(StudyError(*logarithms)));
  problem_.one_sided = constraints.one_sided;
  problem_.at_most = constraints.at_most;
  // An exponential is never below 0.
  if (!logarithms || constraints.at_least > 0) problem_.at_least = constraints.at_least;
  problem_.monotone = constraints.monotone;
  for (const double x : constraints.exact_at)
    problem_.exact_at.push_back(x == edges.front().at ? places.front() : places.back());
  problem_.is_admissible = [this](const MinimaxParameters& p) { return !sampled_.has_pole(p); };
}

void require_possible(const ReadStudy& study, const Constraints& constraints) {
  const char* option = option_of(constraints);
  if (option == nullptr) return;
  const std::string text = option;
  if (study.rows) throw UserError(text + " does not go with --table: a row has no range");
  if (study.axes.size() > 1)
    throw UserError(text + " needs a study of one variable: this one also has '" + study.axes[1].variable +
                    "'");
  const StudyAxis& axis = study.axes.front();
  for (const double x : constraints.exact_at) {
    if (x != axis.lower && x != axis.upper)
      throw UserError("--exact-at '" + to_text(x) + "' is not an end of the range of " + axis.variable);
  }
}

bool has_constraints(const Constraints& constraints) {
  return option_of(constraints) != nullptr;
}

}  // namespace shadefit
