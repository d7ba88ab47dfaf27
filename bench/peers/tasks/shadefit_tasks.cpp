// The tasks of bench/peers/run with the library of shadefit.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "approx/normalisation.hpp"
#include "bench/peers/tasks/task_program.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/claims/normalisation_check.hpp"
#include "fit/squares/prepared_study.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/support/sweep.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Task;
using shadefit::Error;

/// A family uniform in the cosine, at each exponent.
Task task_of(const std::string& id, const std::string& family_id, const std::vector<double>& exponents) {
  return {id, "from nothing", [family = shadefit::find_family(family_id), exponents] {
            Answer answer;
            for (const double k : exponents) {
              const shadefit::Fit fit = family->fit(k, {});
              for (std::size_t p = 0; p < fit.parameters.size(); ++p)
                answer.push_back({std::string(family->parameters[p]), fit.parameters[p], k});
            }
            return answer;
          }};
}

Answer minimax(Error error) {
  const shadefit::Fit fit =
      shadefit::find_family("fresnel-quadratic")->fit({}, {.norm = shadefit::Norm::minimax, .error = error});
  return {{"a", fit.parameters[0]}, {"b", fit.parameters[1]}};
}

const shadefit::Study pair_in_words{
    .target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};

/// The records of the published pair.
const shadefit::Published& published_a = *shadefit::find_published("fresnel-quadratic-a");
const shadefit::Published& published_b = *shadefit::find_published("fresnel-quadratic-b");

Answer search() {
  const std::array published{shadefit::constant<double>(published_a.printed),
                             shadefit::constant<double>(published_b.printed)};
  const auto* family = shadefit::find_family("fresnel-quadratic");
  return {{"level", family->largest_error({}, {}, published).magnitude}};
}

Answer prove(double width) {
  const shadefit::StudySubject pair{
      pair_in_words, {{"a", std::string(published_a.printed)}, {"b", std::string(published_b.printed)}}};
  const auto certificate = shadefit::certify_study(pair, width).certificate;
  return {{"level", certificate.lower}, {"level", certificate.upper}};
}

Answer constants() {
  Answer answer;
  for (const auto* record : {&shadefit::PhongLobe::record, &shadefit::PhongBrdfLobe::record,
                             &shadefit::BlinnPhongLobe::record, &shadefit::BlinnPhongBrdfLobe::record}) {
    for (const auto& check : shadefit::check_normalisation(*record))
      answer.push_back({std::string(record->id), check.integral, *check.exponent});
  }
  return answer;
}

/// The pair from a given start, in a study that is read once.
Task prepared() {
  return {"T1", "prepared, from a start",
          [study = std::make_shared<shadefit::PreparedStudy>(pair_in_words)]() -> Answer {
            const shadefit::StudyFit fit = study->fit({-5, -7});
            return {{"a", fit.parameters[0]}, {"b", fit.parameters[1]}};
          }};
}

/// From formulas as text: read, compiled to tapes, searched, polished and checked.
Task study(const std::string& id, const shadefit::Study& study) {
  return {id, "as a study, from text, with a search", [=] {
            const shadefit::StudyFit fit = shadefit::solve_study(shadefit::read_study(study), {});
            Answer answer;
            for (std::size_t i = 0; i < fit.names.size(); ++i)
              answer.push_back({fit.names[i], fit.parameters[i]});
            return answer;
          }};
}

}  // namespace

int main(int argc, char** argv) {
  using shadefit::parse_sweep;
  return peer_tasks::run_all(
      argc, argv,
      {task_of("T1", "fresnel-quadratic", {0}),
       task_of("T2", "sg-offset", parse_sweep("3:15:1")),
       task_of("T2-large", "sg-offset", parse_sweep("100,1000,10000,1000000")),
       task_of("T3", "phong-blinn", parse_sweep("2,4,8,16,32,64,128,256,512,1024,2048")),
       {"T4-absolute", "from nothing", [] { return minimax(Error::absolute); }},
       {"T4-relative", "from nothing", [] { return minimax(Error::relative); }},
       {"T5", "search, sampled", search},
       {"T5", "certified to 1e-9", [] { return prove(1e-9); }},
       {"T5", "certified to 1e-12", [] { return prove(1e-12); }},
       {"T6", "two rules in two variables, each constant", constants},
       prepared(),
       study("T1", pair_in_words),
       study("T7", {.target = "exp(-x - y/2) + x y/2",
                    .form = "(a + b x + d y + g x y)/(1 + h x + k y + m x y + n x^2)",
                    .over = {{"x", "0", "1"}, {"y", "0", "1"}}})});
}
