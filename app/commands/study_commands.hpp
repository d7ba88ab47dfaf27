#pragma once

#include <string>
#include <vector>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "fit/better/better_study.hpp"
#include "fit/catalogue/study_file.hpp"
#include "reports/findings/baseline.hpp"

/// The commands for a study. Bad input throws UserError.
namespace shadefit {

/// The published sets of a study against the fits of its forms, one for each combination of given constants.
std::vector<StudyComparison> comparisons_of(const StudyFile& file, const Checkpoint& checkpoint,
                                            const Progress& progress = unwatched,
                                            Judged judged = Judged::yes);

Outcome explain_study_command(const StudyFile& file, const ExplainOptions& options,
                              const Checkpoint& checkpoint, const Progress& progress);
/// The pages of a study, or of all studies in the folders.
Outcome gallery_command(const RunOptions& options, const Checkpoint& checkpoint, const Progress& progress);

Outcome run_study_command(const StudyFile& file, const RunOptions& options, const Checkpoint& checkpoint);

/// Recomputes drawn rows of the table of a study, if it says by which formula, and says how many. Throws
/// CheckFailed with both values of the first row that differs.
std::string recomputed_text(const StudyFile& file, const Checkpoint& checkpoint);
Outcome check_study_command(const StudyFile& file, const CheckOptions& options, const Checkpoint& checkpoint);

/// What `check` prints: the drifts as a table or in a format of findings, or how many cells agree.
Outcome check_outcome(const CheckedTables& checked, const CheckOptions& options);

}  // namespace shadefit
