#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/options/options.hpp"

/// The options of the commands, declared. The help, the man page and the completions are generated from these
/// declarations.
namespace shadefit {

/// Options that several commands share.
void add_force(CLI::App& command, bool& force);
void add_out(CLI::App& command, std::string& out);
void add_studies(CLI::App& command, StudyFolders& folders);
void add_finding_format(CLI::App& command, findings::FindingFormat& format);

/// The options of one command each.
void declare_list(CLI::App& list, ListOptions& options);
void declare_run(CLI::App& run, RunOptions& options);
void declare_fit(CLI::App& fit, FitOptions& options);
void declare_better(CLI::App& better, FitOptions& options);
void declare_certify(CLI::App& certify, CertifyOptions& options);
void declare_verify(CLI::App& verify, VerifyOptions& options);
void declare_emit(CLI::App& emit, EmitOptions& options);
void declare_explain(CLI::App& explain, ExplainOptions& options);
void declare_cite(CLI::App& cite, CiteOptions& options);
void declare_bench(CLI::App& bench, BenchOptions& options);
void declare_scene(CLI::App& scene, SceneOptions& options);
void declare_stress(CLI::App& stress, StressOptions& options);
void declare_check(CLI::App& check, CheckOptions& options);

}  // namespace shadefit
