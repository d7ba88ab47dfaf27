#include <array>
#include <string>
#include <vector>

#include "approx/normalisation.hpp"
#include "bench/peers/tasks/shadefit_tasks.hpp"
#include "fit/families/families.hpp"
#include "fit/fit.hpp"
#include "fit/integrals/normalisation_check.hpp"
#include "fit/minimax/minimax_problem.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/solve/under.hpp"

namespace peer_tasks {
namespace {

using shadefit::Error;
using shadefit::FresnelQuadratic;

Answer minimax(Error error) {
  using Pair = shadefit::Under<FresnelQuadratic, 2>;
  const Pair pair{.family = {}, .error_kind = error};
  const shadefit::Metric metric{.norm = shadefit::Norm::minimax, .error = error};
  const auto optimum = shadefit::Minimax<Pair>(pair, metric, {1, 0}, {0, 1}).solve();
  Answer answer;
  if (optimum.status != shadefit::Status::converged) answer.remark("a fit did not converge");
  for (std::size_t i = 0; i < 2; ++i)
    answer.add(std::string(FresnelQuadratic::parameters[i]), optimum.parameters[i]);
  return answer;
}

Answer search() {
  constexpr std::array published{-5.55473, -6.98316};
  Answer answer;
  const auto* family = shadefit::find_family("fresnel-quadratic");
  answer.add("level", family->max_abs_error({}, {}, published).magnitude);
  return answer;
}

Answer prove(double width) {
  const shadefit::Subject pair{.family = "fresnel-quadratic",
                               .parameters = {{"a", "-5.55473"}, {"b", "-6.98316"}}};
  const auto certified = shadefit::certify(pair, width);
  Answer answer;
  answer.add("level", certified.certificate.lower);
  answer.add("level", certified.certificate.upper);
  answer.remark(certified.is_reached ? "certified" : "not certified");
  return answer;
}

Answer constants() {
  Answer answer;
  for (const auto* record : {&shadefit::PhongLobe::record, &shadefit::PhongBrdfLobe::record,
                             &shadefit::BlinnPhongLobe::record, &shadefit::BlinnPhongBrdfLobe::record}) {
    for (const auto& check : shadefit::check_normalisation(*record))
      answer.add(std::string(record->id), check.integral, *check.exponent);
  }
  return answer;
}

}  // namespace

std::vector<Variant> other_tasks() {
  const std::string pair = "fit fresnel-quadratic --norm minimax --json",
                    published = "certify fresnel-quadratic --json --width ";
  return {{"T4-absolute", "from nothing", Standing::judged, [] { return minimax(Error::absolute); }, pair},
          {"T4-relative", "from nothing", Standing::judged, [] { return minimax(Error::relative); },
           pair + " --error relative"},
          {"T5", "search, sampled", Standing::judged, search},
          {"T5", "certified to 1e-9", Standing::judged, [] { return prove(1e-9); }, published + "1e-9"},
          {"T5", "certified to 1e-12", Standing::judged, [] { return prove(1e-12); }, published + "1e-12"},
          {"T6", "two rules in two variables, each constant", Standing::judged, constants}};
}

}  // namespace peer_tasks
