#include <cmath>

#include "fit/catalogue/catalogue_study.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// Where a change is looked for: densely at both ends of the domain, and near the peak of a lobe.
Substitution places_of(const Family& family, const Setting& setting, const Domain& domain) {
  const Shape shape = family.is_fresnel
                          ? Shape{}
                          : Shape{.concentration = 2 * setting.exponent, .end_power = setting.exponent};
  return {{.measure = Measure::cosine, .domain = domain}, shape};
}

}  // namespace

Extremum Family::largest_error(const Setting& setting, Metric metric, std::span<const double> values) const {
  metric.measure = Measure::cosine;  // a density would bring edges of its own
  const Study asked = study_of(*this, setting, metric).value();
  const ReadStudy read = read_study(near_peak(asked));
  const PeakVariable variable = peak_variable(asked);
  const std::vector<double> at(values.begin(), values.end());
  if (const auto pole = pole_of(read, at)) return {HUGE_VAL, variable.cosine_at(*pole)};
  // The weighted error has no pole of its own, so the edges are those of the formulas.
  const StudyExtremum top = shadefit::largest_error(weighted_error_of(read), edges_of(read), at);
  return {top.magnitude, variable.cosine_at(top.at.front())};
}

Effect Family::effect(const Setting& setting, const Domain& domain, std::span<const double> from,
                      std::span<const double> to) const {
  const Study asked = study_of(*this, setting, {.domain = domain}).value();
  const PeakVariable variable = peak_variable(asked);
  ReadStudy changed = read_study(near_peak(asked));
  const Tape tape = tape_of(changed.form, formula_inputs(changed));
  TapeProgram<double> before(tape, from), after(tape, to);
  const auto of_cosine = [&](TapeProgram<double>& program) {
    return [&](const Cosine<double>& cosine) {
      const double at = variable.value_at(cosine);
      program.run(std::span(&at, 1));
      return program.output(0);
    };
  };
  Effect effect = sampled_effect(of_cosine(before), of_cosine(after), places_of(*this, setting, domain));
  changed.target = at_parameters(changed, changed.form, {from.begin(), from.end()});
  changed.form = at_parameters(changed, changed.form, {to.begin(), to.end()});
  changed.weight = Symbolic::number("1");
  changed.residual.reset();
  changed.parameters.clear();
  const StudyExtremum largest = shadefit::largest_error(changed, {});
  effect.absolute = {largest.magnitude, at_cosine(variable.cosine_at(largest.at.front()))};
  return effect;
}

}  // namespace shadefit
