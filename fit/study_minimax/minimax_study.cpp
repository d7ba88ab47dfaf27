#include "fit/study_minimax/minimax_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fit/minimax/minimax.hpp"
#include "fit/minimax/minimax_curve.hpp"
#include "fit/minimax/minimax_problem.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/search.hpp"
#include "fit/study_minimax/minimax_surface.hpp"
#include "fit/support/user_error.hpp"
#include "fit/tape/tape.hpp"

namespace shadefit {
namespace {

/// A part of the range between two edges, from left to right. The variable runs as a square from an end where
/// a formula has a root: there its error may have an infinite slope.
struct SearchPanel {
  double left, right;
  bool is_rooted_left, is_rooted_right;

  template <class T>
  T at(const T& s) const {
    const T low = lift<T>(left), high = lift<T>(right), length = high - low;
    const T rest = integer<T>(1) - s;
    if (is_rooted_left) return low + length * (s * s);
    if (is_rooted_right) return high - length * (rest * rest);
    return low + length * s;
  }
};

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

/// A formula of the variable and the parameters, as the exchange takes it.
class Formula {
 public:
  Formula(const ReadStudy& study, const Symbolic& formula)
      : count_(study.parameters.size()), tape_(of(study, formula)) {}

  template <class T, class P>
  P operator()(const SearchPanel& panel, const T& s, const std::array<P, most_parameters>& p) const {
    std::vector<P> inputs{lift<P>(panel.at(s))};
    inputs.insert(inputs.end(), p.begin(), p.begin() + static_cast<std::ptrdiff_t>(count_));
    return tape_(std::span<const P>(inputs)).front();
  }

 private:
  static Tape of(const ReadStudy& study, const Symbolic& formula) {
    std::vector<std::string> names{study.axes.front().variable};
    names.insert(names.end(), study.parameters.begin(), study.parameters.end());
    Graph graph(names);
    std::vector<int> inputs;
    for (const std::string& name : names) inputs.push_back(graph.add(Symbolic::variable(name)));
    const std::array outputs{graph.add(formula)};
    return {graph, outputs, inputs};
  }

  std::size_t count_;
  Tape tape_;
};

MinimaxCurve curve_of(const Formula& formula, const std::vector<SearchPanel>& panels,
                      const std::vector<SearchPlace>& places) {
  const auto at = [&formula, &panels]<class T, class P>(std::size_t panel, const T& s,
                                                        const std::array<P, most_parameters>& p) {
    return formula(panels[panel], s, p);
  };
  return curve_of_error(at, places);
}

/// A study under a norm of minimax. It must not move while its problem is in use.
class MinimaxStudy {
 public:
  MinimaxStudy(const ReadStudy& study, const StudyError& error, const std::vector<StudyEdge>& edges,
               const Constraints& constraints)
      : panels_(panels_between(edges)),
        error_(study, error_formula(study)),
        form_(study, study.form),
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
    problem_.error = curve_of(error_, panels_, places_);
    problem_.deviation = problem_.error;
    problem_.bounded = curve_of(form_, panels_, places_);
    const auto& linear = error.is_linear();
    problem_.is_linear = std::find(linear.begin(), linear.end(), false) == linear.end();
    problem_.one_sided = constraints.one_sided;
    problem_.at_most = constraints.at_most;
    problem_.at_least = constraints.at_least;
    for (const double x : constraints.exact_at)
      problem_.exact_at.push_back(x == edges.front().at ? places_.front() : places_.back());
    // A form as text may cancel. Then fewer digits are right, as in least squares.
    problem_.largest_step = std::pow(10.0L, -least_study_digits);
    problem_.is_admissible = [this](const MinimaxParameters& p) { return !has_pole(p); };
  }

  MinimaxOptimum solve(const std::vector<double>& start) const {
    MinimaxParameters p{};
    std::copy(start.begin(), start.end(), p.begin());
    return solve_minimax(problem_, p);
  }

 private:
  bool has_pole(const MinimaxParameters& p) const {
    return sampled_.has_pole(std::span(p).first(problem_.size));
  }

  std::vector<SearchPanel> panels_;
  Formula error_, form_;
  SampledStudy<double> sampled_;
  std::vector<SearchPlace> places_;
  MinimaxProblem problem_;
};

/// The text of the exchange speaks of c.
std::string with_variable(std::string text, const std::string& variable) {
  const std::string cosine = " c = ", own = " " + variable + " = ";
  for (std::size_t at = text.find(cosine); at != std::string::npos; at = text.find(cosine, at + own.size()))
    text.replace(at, cosine.size(), own);
  return text;
}

/// Constraints of several variables have no exchange.
void require_no_constraint(const ReadStudy& study, const Constraints& constraints) {
  const char* option = !constraints.exact_at.empty() ? "--exact-at"
                       : constraints.one_sided       ? "--one-sided"
                       : constraints.at_most         ? "--at-most"
                       : constraints.at_least        ? "--at-least"
                                                     : nullptr;
  if (option != nullptr)
    throw UserError(std::string(option) + " goes with one variable: --over '" + study.axes[1].variable +
                    "' is a second");
}

void require_minimax(const ReadStudy& study, const Constraints& constraints) {
  if (study.rows)
    throw UserError("--norm 'minimax' does not go with --table: rows are fitted by least squares");
  if (study.parameters.size() > most_parameters)
    throw UserError("--norm 'minimax' takes at most " + std::to_string(most_parameters) +
                    " parameters: the form has " + std::to_string(study.parameters.size()));
  if (study.axes.size() > 1) return require_no_constraint(study, constraints);
  const StudyAxis& axis = study.axes.front();
  for (const double x : constraints.exact_at) {
    if (x != axis.lower && x != axis.upper)
      throw UserError("--exact-at '" + to_text(x) + "' is not an end of the range of " + axis.variable);
  }
}

}  // namespace

bool can_be_minimax(const ReadStudy& study) {
  return study.rows == nullptr && study.parameters.size() <= most_parameters;
}

StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  require_minimax(study, constraints);
  if (study.axes.size() > 1) return solve_minimax_surface(study, starts, checkpoint);
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, {edges_of(study, 0)}, starts);
  checkpoint();
  const auto edges = resolved_edges(study, error, searched.candidates.front().parameters);
  const MinimaxStudy problem(study, error, edges, constraints);

  // The lowest basins of least squares, one start for each different square.
  constexpr std::size_t most_basins = 4;
  std::optional<MinimaxOptimum> best;
  double last = -1;
  std::size_t tried = 0;
  for (const StudyCandidate& candidate : searched.candidates) {
    if (tried == most_basins || candidate.square <= last * (1 + 1e-6)) continue;
    last = candidate.square;
    ++tried;
    MinimaxOptimum optimum = problem.solve(candidate.parameters);
    checkpoint();
    const bool is_better = !best || (optimum.status == Status::converged &&
                                     (best->status != Status::converged || optimum.level < best->level));
    if (is_better) best = std::move(optimum);
  }
  StudyFit fit;
  fit.names = study.parameters;
  fit.parameters.assign(best->parameters.begin(),
                        best->parameters.begin() + static_cast<std::ptrdiff_t>(study.parameters.size()));
  fit.status = best->status;
  fit.why = with_variable(best->why, study.axes.front().variable);
  fit.digits = best->digits;
  fit.starts = searched.starts;
  fit.is_global = searched.is_linear;
  fit.level = best->level;
  fit.alternation = best->alternation;
  std::reverse(fit.alternation.begin(), fit.alternation.end());
  if (fit.status == Status::infeasible)
    throw UserError("the form cannot satisfy the constraints: " + fit.why);
  if (fit.status != Status::converged) return fit;
  fit.rms_error = rms_error(study, error, fit.parameters);
  fit.max_abs_error = largest_error(study, {edges}, fit.parameters);
  return fit;
}

}  // namespace shadefit
