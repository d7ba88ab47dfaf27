#pragma once

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/terminal/progress.hpp"

/// The commands, each with its parsed options. Bad input throws UserError. Long work calls the checkpoint
/// until its files are written, and shows its progress.
namespace shadefit {

Outcome list_command(const ListOptions& options, const Checkpoint& checkpoint);
Outcome run_command(const RunOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome fit_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome better_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome certify_command(const CertifyOptions& options, const Checkpoint& checkpoint,
                        const Progress& progress);
Outcome verify_command(const VerifyOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome emit_command(const EmitOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome explain_command(const ExplainOptions& options, const Checkpoint& checkpoint,
                        const Progress& progress);
Outcome cite_command(const CiteOptions& options);
Outcome stress_command(const StressOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome check_command(const CheckOptions& options, const Checkpoint& checkpoint, const Progress& progress);

}  // namespace shadefit
