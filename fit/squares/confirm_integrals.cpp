#include "fit/squares/confirm_integrals.hpp"

#include <algorithm>
#include <utility>

#include "fit/scalars/integral.hpp"
#include "fit/squares/rules.hpp"
#include "fit/steps/digits.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {

void confirm_integrals(const ReadStudy& study, StudyFit& fit) {
  const Symbolic formula = error_formula(study);
  if (fit.status != Status::converged || integral_depth(formula) == 0) return;
  const StudyError usual_error(study);
  const StudyNodes nodes = Rules(study, usual_error).nodes(search_rule(study));
  const auto errors_by = [&](IntegralRule rule) {
    const StudyError error(study, rule);
    const SampledStudy<double> sampled(error, nodes);
    VectorOf<double> errors;
    sampled.errors(fit.parameters, errors, nullptr);
    return std::pair(errors, sampled.target_norm());
  };
  const auto [usual, norm] = errors_by(IntegralRule::usual);
  const VectorOf<double> check = errors_by(IntegralRule::check).first;
  const double difference = (usual - check).cwiseAbs().maxCoeff();
  fit.digits = std::min(fit.digits, correct_digits(difference / norm));
  if (fit.digits < least_study_digits)
    fail(fit, Status::not_converged,
         "two rules for 'integral' agree to fewer than 6 digits: split it where its body is not smooth");
}

}  // namespace shadefit
