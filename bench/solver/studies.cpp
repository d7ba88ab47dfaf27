#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/squares/prepared_study.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/study/search.hpp"
#include "reports/studies/prepare.hpp"

/// The Fresnel pair as a study.
namespace shadefit::bench {
namespace {

const Study pair{.target = "(1-c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};

/// Many nodes: what is done once for all of them does not count.
constexpr unsigned nodes = gauss_sizes.back();

/// The error with its derivatives, summed over nodes.
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
  state.counters["nodes"] =
      benchmark::Counter(nodes, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1000);
}

template <class Fit>
void time_fits(benchmark::State& state, const Fit& next) {
  StudyFit fit;
  for (auto _ : state) {
    fit = next();
    benchmark::DoNotOptimize(fit);
  }
  require(fit.status == Status::converged, "the fit did not converge");
  state.counters["digits"] = fit.digits;
}

void fit_from_text(benchmark::State& state) {
  time_fits(state, [] { return solve_study(read_study(pair), {}); });
}

/// By the interface for programs, from the text of a file.
void prepare_from_text(benchmark::State& state) {
  const std::string text =
      "schema = 1\nid = \"pair\"\nover.c = \"0:1\"\ntarget.formula = \"(1 - c)^5\"\n"
      "form = [{ id = \"pair\", formula = \"exp2((a c + b) c)\" }]\n";
  time_fits(state, [&] { return prepare(text).fit(); });
}

void fit_prepared(benchmark::State& state) {
  PreparedStudy prepared(pair);
  time_fits(state, [&] { return prepared.fit({-5, -7}); });
}

}  // namespace

void register_studies() {
  benchmark::RegisterBenchmark("study/gradient/tape", rate_of_tape)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("study/fit/prepared", fit_prepared)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("study/fit/from-text", fit_from_text)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("study/prepare/from-text", prepare_from_text)->Unit(benchmark::kMicrosecond);
}

}  // namespace shadefit::bench
