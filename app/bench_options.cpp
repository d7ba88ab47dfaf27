#include "app/bench_options.hpp"

#include <CLI/CLI.hpp>

namespace shadefit {
namespace {

void add_exhaustive_options(CLI::App& bench, BenchOptions& options) {
  bench
      .add_option("--exhaustive", options.exhaustive,
                  "every float in [0, 1] through this form, against its target in double")
      ->type_name("FORM");
  bench.add_option("--constants", options.constants, "of that form; default: its first")->type_name("ID");
  bench
      .add_option("--exp2-degree", options.exp2_degree,
                  "of the polynomial in its exp2; default: the library's exp2")
      ->type_name("N");
  bench.add_option("--shard", options.shard, "the i-th of n parts of the floats, for another process each")
      ->type_name("i/n");
  bench
      .add_option("--state", options.state,
                  "the file of the result, which goes on where it was stopped; default: in --out")
      ->type_name("FILE");
  bench.add_option("--merge", options.merge, "the files of all shards, instead of a sweep")
      ->type_name("FILE");
  bench
      .add_option("--range", options.range, "bit patterns of floats, without the last; default: 0:0x3f800001")
      ->type_name("A:B");
}

}  // namespace

CLI::App* add_bench_options(CLI::App& app, BenchOptions& options) {
  auto* bench = app.add_subcommand("bench", "run time against error of every form, on this machine");
  bench->add_option("--out", options.out, "directory to write")->capture_default_str()->type_name("DIR");
  bench->add_option("--only", options.only, "only these targets, one or more")->type_name("TARGET");
  bench->add_flag("--quick", options.quick, "fewer and shorter rounds: seconds");
  bench->add_flag("--json", options.json,
                  "print the times as Google Benchmark does; with --exhaustive the result");
  bench->add_flag("--no-plots", options.no_plots, "neither plots nor their data and scripts");
  bench
      ->add_option("--width", options.width,
                   "scalar, sse2, avx2 or avx512: this beside scalar alone; of --exhaustive by default sse2")
      ->type_name("NAME");
  add_exhaustive_options(*bench, options);
  return bench;
}

}  // namespace shadefit
