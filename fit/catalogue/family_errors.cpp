#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "fit/catalogue/catalogue_study.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// The largest errors of one curve. Neither has a pole of its own, so the edges are those of the formulas.
class LargestErrors {
 public:
  LargestErrors(const Family& family, const Setting& setting, const Domain& domain,
                std::span<const double> parameters)
      : family_(family),
        setting_(setting),
        domain_(domain),
        parameters_(parameters.begin(), parameters.end()) {}

  Extremum absolute() {
    return largest_between(ends_of(family_, setting_, domain_, Error::absolute).value(), Error::absolute);
  }

  std::optional<Extremum> relative() {
    const auto ends = ends_of(family_, setting_, domain_, Error::relative);
    return ends ? std::optional(largest_between(*ends, Error::relative)) : std::nullopt;
  }

 private:
  Extremum largest_between(const CosineRange& ends, Error error) {
    const Study asked = study_of(family_, setting_, {.error = error, .domain = domain_}, ends);
    const ReadStudy study = read_study(near_peak(asked));
    const PeakVariable variable = peak_variable(asked);
    if (const auto pole = pole_of(study, parameters_)) return {HUGE_VAL, variable.cosine_at(*pole)};
    // Of a Fresnel form they are the same for both errors.
    if (edges_.empty() || !family_.is_fresnel) edges_ = edges_of(study);
    const StudyExtremum top = largest_error(weighted_error_of(study), edges_, parameters_);
    return {top.magnitude, variable.cosine_at(top.at.front())};
  }

  const Family& family_;
  Setting setting_;
  Domain domain_;
  std::vector<double> parameters_;
  std::vector<std::vector<StudyEdge>> edges_ = {};
};

/// A formula of the variable of a study at given parameters.
class AtCosine {
 public:
  AtCosine(const ReadStudy& study, const Symbolic& formula, std::span<const double> parameters)
      : program_(tape_of(formula, formula_inputs(study)), parameters) {}

  double operator()(double variable) {
    program_.run(std::span(&variable, 1));
    return program_.output(0);
  }

 private:
  TapeProgram<double> program_;
};

/// Where a change is looked for: densely at both ends of the domain, and near the peak of a lobe.
Substitution places_of(const Family& family, const Setting& setting, const Domain& domain) {
  const Shape shape = family.is_fresnel
                          ? Shape{}
                          : Shape{.concentration = 2 * setting.exponent, .end_power = setting.exponent};
  return {{.measure = Measure::cosine, .domain = domain}, shape};
}

}  // namespace

Extremum Family::max_abs_error(const Setting& setting, const Domain& domain,
                               std::span<const double> values) const {
  return LargestErrors(*this, setting, domain, values).absolute();
}

std::optional<Extremum> Family::max_rel_error(const Setting& setting, const Domain& domain,
                                              std::span<const double> values) const {
  return LargestErrors(*this, setting, domain, values).relative();
}

void Family::add_errors(Fit& of) const {
  LargestErrors errors(*this, setting_of(of), of.metric.domain, of.parameters);
  of.max_abs_error = errors.absolute();
  of.max_rel_error = errors.relative();
}

std::optional<Domain> Family::relative_domain(const Setting& setting, const Domain& domain) const {
  const auto ends = ends_of(*this, setting, domain, Error::relative);
  return ends ? std::optional(Domain{ends->second.cos_theta, domain.upper}) : std::nullopt;
}

std::function<CurvePoint(const Cosine<double>&)> Family::curve_at(const Setting& setting,
                                                                  std::span<const double> values) const {
  const CosineRange everywhere{{1, 0}, {0, 1}};
  const Study asked = study_of(*this, setting, {}, everywhere);
  const ReadStudy absolute = read_study(near_peak(asked)),
                  relative =
                      read_study(near_peak(study_of(*this, setting, {.error = Error::relative}, everywhere)));
  const auto curves = std::make_shared<std::array<AtCosine, 3>>(std::array<AtCosine, 3>{
      AtCosine(absolute, absolute.form, values), AtCosine(absolute, error_formula(absolute), values),
      AtCosine(relative, error_formula(relative), values)});
  return [variable = peak_variable(asked), curves](const Cosine<double>& cosine) {
    const double at = variable.value_at(cosine);
    auto& [of_form, of_error, of_relative_error] = *curves;
    const double share = of_relative_error(at);
    return CurvePoint{of_form(at), of_error(at), std::isfinite(share) ? std::optional(share) : std::nullopt};
  };
}

Effect Family::effect(const Setting& setting, const Domain& domain, std::span<const double> from,
                      std::span<const double> to) const {
  const Study asked =
      study_of(*this, setting, {.domain = domain}, ends_of(*this, setting, domain, Error::absolute).value());
  const PeakVariable variable = peak_variable(asked);
  ReadStudy changed = read_study(near_peak(asked));
  AtCosine before(changed, changed.form, from), after(changed, changed.form, to);
  const auto of_cosine = [&](AtCosine& formula) {
    return [&](const Cosine<double>& cosine) { return formula(variable.value_at(cosine)); };
  };
  Effect effect = sampled_effect(of_cosine(before), of_cosine(after), places_of(*this, setting, domain));
  changed.target = at_parameters(changed, changed.form, {from.begin(), from.end()});
  changed.form = at_parameters(changed, changed.form, {to.begin(), to.end()});
  changed.weight = Symbolic::number("1");
  changed.residual.reset();
  changed.parameters.clear();
  const StudyExtremum largest = largest_error(changed, {});
  effect.absolute = {largest.magnitude, at_cosine(variable.cosine_at(largest.at.front()))};
  return effect;
}

}  // namespace shadefit
