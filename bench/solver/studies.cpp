#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "fit/families/families.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/least_squares/sampled_problem.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/study/search.hpp"
#include "fit/study_squares/solve_study.hpp"
#include "fit/tape/tape_program.hpp"
#include "fit/truths/albedos.hpp"
#include "fit/truths/truths.hpp"

/// The Fresnel pair as a study, that is from text, beside its compiled family.
namespace shadefit::bench {
namespace {

const Study pair{.target = "(1-c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};

/// Many nodes: what is done once for all of them does not count.
constexpr unsigned nodes = gauss_sizes.back();

void count_nodes(benchmark::State& state) {
  state.counters["nodes"] =
      benchmark::Counter(nodes, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1000);
}

/// The error with its derivatives, summed over nodes.
void rate_of_family(benchmark::State& state) {
  const FresnelQuadratic family;
  const SampledProblem<FresnelQuadratic, double> sampled(
      family, Substitution::panels(Metric{}, family.shape()), nodes);
  std::array p{-5.55, -6.98};
  for (auto _ : state) {
    auto gradient = sampled.gradient(p);
    benchmark::DoNotOptimize(gradient);
  }
  count_nodes(state);
}

void rate_of_tape(benchmark::State& state) {
  const ReadStudy study = read_study(pair);
  const StudyError error(study);
  const SampledStudy<double> sampled(error, nodes_of(study, {edges_of(study, 0)}, nodes));
  const std::vector p{-5.55, -6.98};
  const std::vector<Eigen::Index> columns{0, 1, 2};
  ProductMatrix<double> products;
  for (auto _ : state) {
    sampled.products(p, columns, products);
    benchmark::DoNotOptimize(products);
  }
  count_nodes(state);
}

void fit_from_text(benchmark::State& state) {
  StudyFit fit;
  for (auto _ : state) {
    fit = solve_study(read_study(pair), {});
    benchmark::DoNotOptimize(fit);
  }
  if (fit.status != Status::converged) state.SkipWithError("the fit did not converge");
  state.counters["digits"] = fit.digits;
}

/// A truth by its quadrature, and as a formula has it.
void time_of_rule(benchmark::State& state, const Albedo& albedo) {
  for (auto _ : state) benchmark::DoNotOptimize(albedo_by_rule(albedo, 0.3, 0.2));
}

void time_of_value(benchmark::State& state, const Albedo& albedo) {
  double value = albedo_value(albedo, 0.3, 0.2);  // computes the rectangle
  for (auto _ : state) benchmark::DoNotOptimize(value = albedo_value(albedo, 0.3, 0.2));
}

/// A truth that is a formula, also one with an integral, at one place: cosines, roughness and albedos are
/// 0.3, the indices of refraction those of a metal.
void time_of_formula(benchmark::State& state, const Truth& truth) {
  std::string call(truth.name);
  std::vector<double> place;
  for (const std::string& name : truth.arguments) {
    call += (place.empty() ? "(" : ", ") + name;
    place.push_back(name == "n" ? 1.5 : name == "k" ? 3 : 0.3);
  }
  const FormulaNames names{.variables = truth.arguments, .takes_integrals = true};
  TapeProgram<double> program(tape_of(read_formula(call + ")", names).formula, truth.arguments), {});
  program.run(place);  // computes the rectangles of an albedo
  for (auto _ : state) {
    program.run(place);
    benchmark::DoNotOptimize(program.output(0));
  }
}

}  // namespace

void register_studies() {
  const auto register_one = [](const std::string& name, auto measure, auto... arguments) {
    benchmark::RegisterBenchmark(name.c_str(), measure, arguments...)->Unit(benchmark::kMicrosecond);
  };
  for (const Truth& truth : truths()) {
    const std::string name(truth.name);
    if (!truth.formula.empty()) {
      register_one("truth/formula/" + name, time_of_formula, truth);
      continue;
    }
    const Albedo albedo = *find_albedo(name);
    register_one("truth/rule/" + name, time_of_rule, albedo);
    register_one("truth/value/" + name, time_of_value, albedo);
  }
  register_one("study/gradient/family", rate_of_family);
  register_one("study/gradient/tape", rate_of_tape);
  register_one("study/fit/from-text", fit_from_text);
}

}  // namespace shadefit::bench
