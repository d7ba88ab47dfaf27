#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "reports/figures/plot_script.hpp"

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

/// The outcome with the picture of --plot, and a line that names it; on standard error, where standard output
/// is for a program.
Outcome with_picture(Outcome outcome, const FitOptions& options, const std::function<Figure()>& figure,
                     const Checkpoint& checkpoint);

/// A command as a line for a comment. Throws UserError for a word with line ends or control characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the commands named in the comments of generated files and compares their output: exit 1 if one would
/// print something else now. Throws UserError if a file names no command.
Outcome check_generated_files(const std::vector<std::string>& files, const Checkpoint& checkpoint);

}  // namespace shadefit
