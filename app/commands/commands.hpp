#pragma once

#include <string>
#include <vector>

#include "app/options/finding_format.hpp"
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

/// A command as a line for a shell: "shadefit scene 'a b.mtl' --lang glsl".
std::string shell_text(const std::vector<std::string>& words);

/// The same for a comment. Throws UserError for a word with line ends or control characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the command named in the comment of a generated file and compares the output: exit 1 if it would
/// print something else now. The files of a scene are relative to the folder of `file`. Throws UserError if
/// the file names no command.
Outcome check_generated_file(const std::string& file, FindingFormat format, const Checkpoint& checkpoint);

}  // namespace shadefit
