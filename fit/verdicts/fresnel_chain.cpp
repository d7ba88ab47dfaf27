#include "fit/verdicts/fresnel_chain.hpp"

#include <cmath>

#include "approx/encoding.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {

ReflectanceError reflectance_error(const Surface& surface, const std::string& form,
                                   const std::vector<double>& parameters) {
  const auto study_under = [&](Error error) {
    Study study = fresnel_study(surface, error);
    study.form = form;
    study.over = {{"c", "0", "1"}};
    return read_formulas(study);
  };
  const ReadStudy study = study_under(Error::absolute);
  const auto edges = edges_of(study);
  const auto largest = [&](const ReadStudy& under) {
    const StudyExtremum top = largest_error(weighted_error_of(under), edges, parameters);
    return Extremum{top.magnitude, {top.at.front(), 1 - top.at.front()}};
  };
  const auto f0 = normal_reflectance(surface);
  TapeProgram<double> form_at(tape_of(study.form, formula_inputs(study)), parameters),
      target_at(tape_of(study.target, formula_inputs(study)), parameters);
  const auto code_of = [&](TapeProgram<double>& weight, double c) {
    weight.run(std::span(&c, 1));
    return srgb_code(schlick_reflectance(f0, weight.output(0)));
  };
  return {largest(study), largest(study_under(Error::relative)),
          largest_sampled([&](double c) { return std::abs(code_of(form_at, c) - code_of(target_at, c)); })};
}

namespace {

/// Of a published curve or of a refit; without a family of Schlick's formula.
FresnelLink link(const OpticalConstants& constants, const Family* family, std::string_view published,
                 const std::vector<double>& parameters, Status status) {
  const double ior = constant<double>(constants.ior), extinction = constant<double>(constants.extinction);
  const Surface exact = exact_surface(ior, extinction);
  FresnelLink result{&constants, normal_reflectance(exact), family, published, parameters, status, {}, {}};
  if (status != Status::converged) return result;
  if (family == nullptr) {
    result.from_exact = reflectance_error(exact, "schlick_weight(c)");
  } else {
    result.from_schlick = reflectance_error(schlick_surface(ior, extinction), family->study.form, parameters);
    result.from_exact = reflectance_error(exact, family->study.form, parameters);
  }
  return result;
}

void append_links(std::vector<FresnelLink>& chain, const OpticalConstants& constants,
                  const std::vector<const Family*>& families) {
  chain.push_back(link(constants, nullptr, "", {}, Status::converged));
  const Surface exact =
      exact_surface(constant<double>(constants.ior), constant<double>(constants.extinction));
  for (const Family* family : families) {
    for (const Published* number : numbers_of(*family)) {
      // a curve of several parameters is named by its first
      if (number->parameter != family->parameters.front()) continue;
      std::vector<double> values;
      for (const auto& value : *number->curve) values.push_back(constant<double>(value.second));
      chain.push_back(link(constants, family, number->id, values, Status::converged));
    }
    const Fit fit = family->fit({0, exact}, {});
    chain.push_back(link(constants, family, "", fit.parameters, fit.status));
  }
}

}  // namespace

std::vector<FresnelLink> fresnel_chain(const std::vector<const Family*>& families) {
  std::vector<FresnelLink> chain;
  if (families.empty()) return chain;
  for (const OpticalConstants& constants : dielectrics) append_links(chain, constants, families);
  for (const OpticalConstants& constants : metals) append_links(chain, constants, families);
  return chain;
}

}  // namespace shadefit
