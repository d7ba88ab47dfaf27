#include "fit/rounding/round_study.hpp"

#include <type_traits>

#include "fit/rounding/lattice_search.hpp"
#include "fit/rounding/study_lattice.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// The most boxes of a search: a second or two.
constexpr long most_boxes_of_studies = 200'000;

/// What all formats share.
struct RoundingTask {
  const StudyObjective& objective;
  const StudyFit& fit;
  const std::vector<double>& published;
  NumberFormat format;
  std::string option;  ///< "--round 'half'"
  ReadStudy study;
  const Checkpoint& checkpoint;
};

/// Searches a lattice. `assess` adds its errors to a set.
template <class Lattice, class Problem, class Assess>
RoundedStudy searched(const RoundingTask& asked, const Lattice& lattice, Problem& problem,
                      const Assess& assess) {
  const std::size_t count = asked.study.parameters.size();
  if (count > most_rounded_parameters)
    throw UserError(asked.option + " takes at most " + std::to_string(most_rounded_parameters) +
                    " parameters: the form has " + std::to_string(count));
  const auto point_of = [&](const std::vector<double>& values) {
    const auto indices = indices_of(lattice, values, asked.study.parameters, asked.option);
    return LatticePoint(indices.begin(), indices.end());
  };
  const auto set_of = [&](const LatticePoint& point) {
    RoundedStudySet set = set_at(lattice, point);
    assess(set);
    return set;
  };
  // Next to a pole there may be no bound.
  const auto start_at = [&](const LatticePoint& point) {
    try {
      return set_of(point);
    } catch (const CheckFailed&) {
      RoundedStudySet set = set_at(lattice, point);
      set.max_error = HUGE_VAL;
      return set;
    }
  };
  std::vector<LatticePoint> starts;
  for (const auto& values : fitted_values(asked.objective, asked.fit, asked.checkpoint))
    starts.push_back(point_of(values));
  if (!asked.published.empty()) starts.insert(starts.begin() + 1, point_of(asked.published));
  const LatticeProblem erased{
      [&](const LatticeBox& box, double least) { return problem.bound(box, least); },
      [&](const LatticePoint& point, double least) { return problem.error(point, least); }};
  const auto best =
      search_format(erased, lattice.last(), starts, asked.format, most_boxes_of_studies, asked.checkpoint);
  RoundedStudy result{.format = asked.format,
                      .best = set_of(best.point),
                      .naive = start_at(starts.front()),
                      .is_proven = best.is_proven,
                      .searched = best.searched,
                      .evaluated = best.evaluated};
  if (!asked.published.empty()) result.published = start_at(starts[1]);
  return result;
}

template <class Format>
RoundedStudy round_to_narrow(const RoundingTask& asked) {
  if (asked.study.axes.size() > 1)
    throw UserError(asked.option + " takes one variable: take float or decimal:N for " +
                    std::to_string(asked.study.axes.size()));
  for (const auto& [name, text] : asked.objective.study.given) {
    const double value = number_in(asked.objective.study, {"--given", name}, text);
    if (!std::isfinite(static_cast<double>(NarrowResult<Format>::rounded(value))))
      throw UserError(asked.option + ": " + name + " = " + text + " overflows: the largest is " +
                      to_text(largest_of<Format>));
  }
  auto in_format = study_in<Format>(asked.study, asked.option, asked.checkpoint);
  NarrowStudyProblem<Format> problem(asked.study, in_format);
  RoundedStudy result = searched(asked, BinaryLattice<Format>{}, problem,
                                 [&](RoundedStudySet& set) { add_errors(set, in_format, asked.checkpoint); });
  if (!std::isfinite(result.best.max_error))
    throw CheckFailed(asked.option + ": no constants were found whose error is finite at " +
                      asked.study.axes.front().variable + " = " + decimal(result.best.at.front(), 6));
  return result;
}

template <class Lattice>
RoundedStudy round_to_wide(const RoundingTask& asked, const Lattice& lattice) {
  RealStudyProblem<Lattice> problem(asked.study, lattice, [&](const std::vector<double>& values) {
    return has_bound(asked.objective, asked.study, values, asked.checkpoint);
  });
  const bool is_float = asked.format.kind == NumberFormat::Kind::single;
  return searched(asked, lattice, problem, [&](RoundedStudySet& set) {
    add_proven_errors(set, asked.objective, asked.study, is_float, asked.checkpoint);
  });
}

}  // namespace

RoundedStudy round_study(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                         const std::vector<double>& published, const Checkpoint& checkpoint) {
  const RoundingTask asked{
      objective, fit, published, format, "--round '" + to_text(format) + "'", read_study(objective.study),
      checkpoint};
  require_plain(objective, format.is_narrow() ? asked.study.form : error_formula(asked.study), asked.option);
  switch (format.kind) {
    case NumberFormat::Kind::half:
      return round_to_narrow<HalfFormat>(asked);
    case NumberFormat::Kind::bfloat16:
      return round_to_narrow<Bfloat16Format>(asked);
    case NumberFormat::Kind::single:
      return round_to_wide(asked, BinaryLattice<FloatFormat>{});
    default:
      return round_to_wide(asked, DecimalLattice{format.digits});
  }
}

}  // namespace shadefit
