#include "fit/study_exchange/exchanged_study.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "fit/minimax/minimax_curve.hpp"
#include "fit/study/solve_study.hpp"
#include "fit/support/user_error.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

static_assert(most_study_parameters <= most_parameters, "the exchange takes every study");

std::vector<SearchPanel> panels_between(const std::vector<StudyEdge>& edges) {
  std::vector<SearchPanel> panels;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const StudyEdge &left = edges[i - 1], &right = edges[i];
    const bool from_left = left.power > 1, from_right = right.power > 1;
    if (from_left && from_right) {
      const double middle = left.at + (right.at - left.at) / 2;
      panels.push_back({left.at, middle, true, false});
      panels.push_back({middle, right.at, false, true});
    } else {
      panels.push_back({left.at, right.at, from_left, from_right});
    }
  }
  return panels;
}

/// The slope of a formula at an end of a panel, by the distance from it. A root at the end has no derivative,
/// though the formula is smooth in s: there quotients of differences are extrapolated to the distance 0
/// (Neville's scheme). From 1/16 on each is halved seven times, so what is left is rounding.
template <class T>
T slope_inward(const StudyFormula& formula, const SearchPanel& panel, double s,
               const std::array<T, most_parameters>& p) {
  if (!(s == 0 ? panel.is_rooted_left : panel.is_rooted_right)) {
    using Jet = ceres::Jet<T, 1>;
    Jet along(lift<T>(s));
    along.v[0] = integer<T>(s == 0 ? 1 : -1);
    return formula(panel, along, all_as<Jet>(p)).v[0];
  }
  constexpr int count = 8;
  const T end = formula(panel, s, p);
  std::vector<T> quotients;
  for (int i = 0; i < count; ++i) {
    const double distance = std::ldexp(1.0, -4 - i);
    quotients.push_back((formula(panel, s == 0 ? distance : 1 - distance, p) - end) / lift<T>(distance));
  }
  for (int order = 1; order < count; ++order) {
    const T ratio = integer<T>(1 << order);
    for (int i = count - 1; i >= order; --i) {
      T& quotient = quotients[static_cast<std::size_t>(i)];
      quotient = (ratio * quotient - quotients[static_cast<std::size_t>(i) - 1]) / (ratio - integer<T>(1));
    }
  }
  return quotients.back();
}

/// The first constraint as its option; null if there is none.
const char* option_of(const Constraints& constraints) {
  return !constraints.exact_at.empty() ? "--exact-at"
         : constraints.one_sided       ? "--one-sided"
         : constraints.at_most         ? "--at-most"
         : constraints.at_least        ? "--at-least"
         : constraints.monotone        ? "--monotone"
                                       : nullptr;
}

}  // namespace

StudyFormula::StudyFormula(const ReadStudy& study, const Symbolic& formula, Of of)
    : count_(study.parameters.size()),
      output_(of == Of::value ? 0 : 1),
      tape_(tape_of(formula, formula_inputs(study), output_)) {}

ExchangedStudy::ExchangedStudy(const ReadStudy& study, const StudyError& error,
                               const std::vector<StudyEdge>& edges, const Constraints& constraints)
    : panels_(panels_between(edges)),
      error_(study, error_formula(study), StudyFormula::Of::value),
      form_(study, study.form, StudyFormula::Of::value),
      slope_(study, study.form, StudyFormula::Of::slope),
      sampled_(error, nodes_of(study, {edges}, gauss_sizes[4])) {
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (const double s : chebyshev_places()) places_.push_back({panel, s});
  }
  problem_.size = study.parameters.size();
  problem_.places = places_;
  problem_.cosine_at = [this](const SearchPlace& place) {
    const double x = panels_[place.panel].at(place.s);
    return Cosine<double>{x, 1 - x};
  };
  problem_.error = curve_of(error_);
  problem_.deviation = problem_.error;
  problem_.bounded = curve_of(form_);
  problem_.sloping = curve_of(slope_);
  const auto& linear = error.is_linear();
  problem_.is_linear = std::find(linear.begin(), linear.end(), false) == linear.end();
  problem_.one_sided = constraints.one_sided;
  problem_.at_most = constraints.at_most;
  problem_.at_least = constraints.at_least;
  problem_.monotone = constraints.monotone;
  for (const double x : constraints.exact_at)
    problem_.exact_at.push_back(x == edges.front().at ? places_.front() : places_.back());
  // A form as text may cancel. Then fewer digits are right, as in least squares.
  problem_.largest_step = std::pow(10.0L, -least_study_digits);
  problem_.is_admissible = [this](const MinimaxParameters& p) {
    return !sampled_.has_pole(std::span(p).first(problem_.size));
  };
}

MinimaxCurve ExchangedStudy::curve_of(const StudyFormula& formula) const {
  const auto at = [&formula, this]<class T, class P>(std::size_t panel, const T& s,
                                                     const std::array<P, most_parameters>& p) {
    return formula(panels_[panel], s, p);
  };
  const auto slope = [&formula, this]<class T>(const SearchPlace& place,
                                               const std::array<T, most_parameters>& p) {
    return slope_inward(formula, panels_[place.panel], place.s, p);
  };
  return with_slopes(curve_of_error(at, places_), slope);
}

void require_possible(const ReadStudy& study, const Constraints& constraints) {
  const char* option = option_of(constraints);
  if (option == nullptr) return;
  const std::string text = option;
  if (study.rows) throw UserError(text + " does not go with --table: a row has no range");
  if (study.axes.size() > 1)
    throw UserError(text + " goes with one variable: --over '" + study.axes[1].variable + "' is a second");
  const StudyAxis& axis = study.axes.front();
  for (const double x : constraints.exact_at) {
    if (x != axis.lower && x != axis.upper)
      throw UserError("--exact-at '" + to_text(x) + "' is not an end of the range of " + axis.variable);
  }
}

bool has_constraints(const Constraints& constraints) {
  return option_of(constraints) != nullptr;
}

std::string with_variable(std::string text, const std::string& variable) {
  const std::string cosine = " c = ", own = " " + variable + " = ";
  for (std::size_t at = text.find(cosine); at != std::string::npos; at = text.find(cosine, at + own.size()))
    text.replace(at, cosine.size(), own);
  return text;
}

}  // namespace shadefit
