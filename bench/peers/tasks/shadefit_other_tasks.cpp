#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "approx/normalisation.hpp"
#include "bench/peers/tasks/shadefit_tasks.hpp"
#include "fit/families/families.hpp"
#include "fit/fit.hpp"
#include "fit/integrals/normalisation_check.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/minimax/minimax_problem.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/study/search.hpp"
#include "fit/study_squares/solve_study.hpp"

namespace peer_tasks {
namespace {

using shadefit::Error;
using shadefit::FresnelQuadratic;

Answer minimax(Error error) {
  const FresnelQuadratic pair;
  const shadefit::Metric metric{.norm = shadefit::Norm::minimax, .error = error};
  const auto optimum = shadefit::Minimax<FresnelQuadratic>(pair, metric, {1, 0}, {0, 1})
                           .solve(shadefit::start_of_minimax(pair, metric));
  Answer answer;
  if (optimum.status != shadefit::Status::converged) answer.remark("a fit did not converge");
  for (std::size_t i = 0; i < 2; ++i)
    answer.add(std::string(FresnelQuadratic::parameters[i]), optimum.parameters[i]);
  return answer;
}

/// The records of the published pair.
constexpr const shadefit::Published& published_a = shadefit::fresnel_published[2];
constexpr const shadefit::Published& published_b = shadefit::fresnel_published[3];

Answer search() {
  const std::array published{shadefit::constant<double>(published_a.printed),
                             shadefit::constant<double>(published_b.printed)};
  Answer answer;
  const auto* family = shadefit::find_family("fresnel-quadratic");
  answer.add("level", family->max_abs_error({}, {}, published).magnitude);
  return answer;
}

Answer prove(double width) {
  const shadefit::Subject pair{
      .family = "fresnel-quadratic",
      .parameters = {{"a", std::string(published_a.printed)}, {"b", std::string(published_b.printed)}}};
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

Answer answer_of(const std::vector<std::string>& names, const std::vector<double>& parameters) {
  Answer answer;
  for (std::size_t i = 0; i < names.size(); ++i) answer.add(names[i], parameters[i]);
  return answer;
}

/// From formulas as text: read, compiled to tapes, searched (or descended from the starts alone), polished
/// and checked.
Answer fit_of(const shadefit::Study& study, const std::vector<shadefit::Held>& starts = {}) {
  const shadefit::StudyFit fit = shadefit::solve_study(shadefit::read_study(study), starts);
  Answer answer = answer_of(fit.names, fit.parameters);
  if (fit.status != shadefit::Status::converged) answer.remark("the fit did not converge");
  return answer;
}

shadefit::StudyNodes thirty_nodes(const shadefit::ReadStudy& study) {
  const std::vector<shadefit::StudyEdge> unit{{0}, {1}};
  constexpr unsigned nodes_on_axis = 30;
  return shadefit::nodes_of(study, {study.axes.size(), unit}, nodes_on_axis);
}

/// The parameters after a step of Newton's method in T. The inverse of the Hessian may be an older one.
template <class T>
std::vector<double> moved(std::vector<double> parameters, const shadefit::ParameterMatrix<double>& inverse,
                          const shadefit::ParameterVector<T>& gradient) {
  const shadefit::ParameterVector<T> step = inverse.cast<T>() * gradient;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parameters[i] = static_cast<double>(T(parameters[i]) - step[static_cast<Eigen::Index>(i)]);
  return parameters;
}

/// The end of a descent has 8 digits or more. A step in double doubles them, up to the rounding of the
/// gradient; one with the gradient in long double takes that away.
std::vector<double> polished(const shadefit::StudyError& error, const shadefit::StudyNodes& nodes,
                             const shadefit::SampledStudy<double>& sampled,
                             const std::vector<double>& parameters) {
  const auto sums = sampled.derivatives(parameters);
  const auto inverse = shadefit::ScaledHessian(sums.hessian).inverse();
  const std::vector<double> near = moved(parameters, inverse, sums.gradient);
  const std::vector<long double> wide(near.begin(), near.end());
  return moved(near, inverse, shadefit::SampledStudy<long double>(error, nodes).gradient(wide).gradient);
}

/// One descent from a start on 30 nodes of each variable, of a study that is read outside the timed part. If
/// it is polished by Newton's method it has all digits.
std::function<Answer()> descent(const shadefit::Study& study, const std::vector<double>& start,
                                bool is_polished) {
  const auto read = std::make_shared<const shadefit::ReadStudy>(shadefit::read_study(study));
  const auto error = std::make_shared<const shadefit::StudyError>(*read);
  return [=] {
    const shadefit::StudyNodes nodes = thirty_nodes(*read);
    const shadefit::SampledStudy<double> sampled(*error, nodes);
    const auto end = shadefit::search_basins(*error, sampled, sampled, {0, 0, {start}}).front().parameters;
    return answer_of(read->parameters, is_polished ? polished(*error, nodes, sampled, end) : end);
  };
}

/// The same without the polish, with the nodes made outside the timed part too.
std::function<Answer()> descent_on_ready_nodes(const shadefit::Study& study,
                                               const std::vector<double>& start) {
  const auto read = std::make_shared<const shadefit::ReadStudy>(shadefit::read_study(study));
  const auto error = std::make_shared<const shadefit::StudyError>(*read);
  const auto sampled = std::make_shared<const shadefit::SampledStudy<double>>(*error, thirty_nodes(*read));
  return [=] {
    return answer_of(read->parameters,
                     shadefit::search_basins(*error, *sampled, *sampled, {0, 0, {start}}).front().parameters);
  };
}

}  // namespace

std::vector<Variant> other_tasks() {
  const shadefit::Study pair_study{
      .target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};
  shadefit::Study started = pair_study;
  started.has_only_starts = true;
  const shadefit::Study plane{.target = "exp(-x - y/2) + x y/2",
                              .form = "(a + b x + d y + g x y)/(1 + h x + k y + m x y + n x^2)",
                              .over = {{"x", "0", "1"}, {"y", "0", "1"}}};
  const std::string pair = "fit fresnel-quadratic --norm minimax --json",
                    published = "certify fresnel-quadratic --json --width ";
  return {
      {"T4-absolute", "from nothing", Standing::judged, [] { return minimax(Error::absolute); }, pair},
      {"T4-relative", "from nothing", Standing::judged, [] { return minimax(Error::relative); },
       pair + " --error relative"},
      {"T5", "search, sampled", Standing::judged, search},
      {"T5", "certified to 1e-9", Standing::judged, [] { return prove(1e-9); }, published + "1e-9"},
      {"T5", "certified to 1e-12", Standing::judged, [] { return prove(1e-12); }, published + "1e-12"},
      {"T6", "two rules in two variables, each constant", Standing::judged, constants},
      {"T1", "as a study, from text, with a search", Standing::listed, [=] { return fit_of(pair_study); }},
      {"T1", "as a study, from text, from a given start", Standing::listed,
       [=] {
         return fit_of(started, {{"a", -5}, {"b", -5}});
       }},
      {"T1", "as a study, nodes and one descent from a given start", Standing::listed,
       descent(pair_study, {-5, -5}, false)},
      {"T1", "as a study, nodes, one descent and Newton's polish from a given start", Standing::listed,
       descent(pair_study, {-5, -5}, true)},
      {"T7", "from text, with a search", Standing::judged, [=] { return fit_of(plane); }},
      {"T7", "one descent, 30 x 30 nodes ready", Standing::listed,
       descent_on_ready_nodes(plane, {1, 0, 0, 0, 0, 0, 0, 0})}};
}

}  // namespace peer_tasks
