#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "bench/solver/benchmarks.hpp"

namespace {

/// Google Benchmark prints a failed benchmark and goes on; its exit code does not tell. This reporter
/// forwards everything and remembers whether one failed.
class RememberingReporter : public benchmark::BenchmarkReporter {
 public:
  bool has_failed() const { return has_failed_; }

  bool ReportContext(const Context& context) override { return inner_->ReportContext(context); }
  void ReportRuns(const std::vector<Run>& runs) override {
    has_failed_ |= std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.error_occurred; });
    inner_->ReportRuns(runs);
  }
  void Finalize() override { inner_->Finalize(); }

 private:
  std::unique_ptr<benchmark::BenchmarkReporter> inner_{benchmark::CreateDefaultDisplayReporter()};
  bool has_failed_ = false;
};

}  // namespace

/// Exit code: 0; 1 if a benchmark failed, if the filter matches none, or for an unknown argument.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  shadefit::bench::register_fits();
  shadefit::bench::register_minimax();
  shadefit::bench::register_parts();
  shadefit::bench::register_claims();
  shadefit::bench::register_proofs();
  shadefit::bench::register_scaling();
  shadefit::bench::register_studies();
  shadefit::bench::register_scenes();
  shadefit::bench::register_process();
  RememberingReporter reporter;
  const bool has_run = benchmark::RunSpecifiedBenchmarks(&reporter) > 0;
  benchmark::Shutdown();
  return has_run && !reporter.has_failed() ? 0 : 1;
}
