#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "fit/better/better_study.hpp"
#include "fit/catalogue/study_file.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/files.hpp"

/// The commands, each with its parsed options. Bad input throws UserError. Long work calls the checkpoint
/// until its files are written, and shows its progress.
namespace shadefit {

Outcome list_command(const ListOptions& options, const Watched& work);
Outcome run_command(const RunOptions& options, const Watched& work);
Outcome fit_command(const FitOptions& options, const Watched& work);
Outcome better_command(const FitOptions& options, const Watched& work);
Outcome certify_command(const CertifyOptions& options, const Watched& work);
Outcome verify_command(const VerifyOptions& options, const Watched& work);
Outcome emit_command(const EmitOptions& options, const Watched& work);
Outcome explain_command(const ExplainOptions& options, const Watched& work);
Outcome cite_command(const CiteOptions& options, const Watched& work);
Outcome bench_command(const BenchOptions& options, const Watched& work);
/// `bench --exhaustive`.
Outcome exhaustive_command(const BenchOptions& options, const Watched& work);
/// Exit 1 if the plan exceeds the tolerance.
Outcome scene_command(const SceneOptions& options, const Watched& work);
Outcome stress_command(const StressOptions& options, const Watched& work);
Outcome check_command(const CheckOptions& options, const Watched& work);

/// The outcome with the picture of --plot, and a line that names it; on standard error, where standard output
/// is for a program.
Outcome with_picture(Outcome outcome, const FitOptions& options, const std::function<Figure()>& figure,
                     const Checkpoint& checkpoint);

/// A command as a line for a comment. Throws UserError for a word with line ends or control characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the commands named in the comments of generated files and compares their output: exit 1 if one would
/// print something else now. Throws UserError if a file names no command.
Outcome check_generated_files(const std::vector<std::string>& files, const Checkpoint& checkpoint);

// For a study.

/// The published sets of a study against the fits of its forms, one for each combination of given constants.
std::vector<StudyComparison> comparisons_of(const StudyFile& file, const Watched& work,
                                            Judged judged = Judged::yes);

Outcome explain_study_command(const StudyFile& file, const ExplainOptions& options, const Watched& work);
/// The pages of a study, or of all studies in the folders.
Outcome gallery_command(const RunOptions& options, const Watched& work);

Outcome run_study_command(const StudyFile& file, const RunOptions& options, const Checkpoint& checkpoint);

/// Recomputes drawn rows of the table of a study, if it says by which formula, and says how many. Throws
/// CheckFailed with both values of the first row that differs.
std::string recomputed_text(const StudyFile& file, const Checkpoint& checkpoint);
Outcome check_study_command(const StudyFile& file, const CheckOptions& options, const Checkpoint& checkpoint);

/// What `check` prints: what was `recomputed`, and the drifts as a table, or how many cells agree; or the
/// drifts alone in a format of findings.
Outcome check_outcome(const CheckedTables& checked, const CheckOptions& options,
                      const std::string& recomputed);

/// The tables of `stress`, which `check --all` compares.
std::vector<File> stress_tables(const Checkpoint& checkpoint);

}  // namespace shadefit
