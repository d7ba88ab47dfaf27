#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/timing/timing.hpp"
#include "bench/tradeoff/trade.hpp"
#include "fit/better/better_study.hpp"
#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

/// Run time against error of the forms of a study.
namespace shadefit::bench {

/// Times every form of a study, and its target, in scalar float. It compiles the C code that `emit` writes,
/// and runs it over an array in the first cache. All constants of a form that need the same operations share
/// one time. Errors are those of the contenders, in exact arithmetic. `between` receives the finished share.
/// Throws UserError for a form that has no code, and if no C compiler works.
Trade measure_study(const std::string& id, const std::vector<StudyComparison>& comparisons,
                    const TimingPlan& plan, const Clock& clock, const std::function<void(double)>& between);

/// The target of a comparison, with its id among all comparisons of a study. Throws UserError if the
/// comparison has nothing to time, because no fit converged and nothing was published.
TimedTarget timed_target(const std::string& id, const std::vector<StudyComparison>& comparisons,
                         const StudyComparison& comparison);

/// The row of a target itself, and that of a contender without its error; both without times.
TimedForm row_of(const StudyComparison& comparison, const TimedTarget& target);
TimedForm row_of(const StudyContender& contender, const TimedTarget& target);

/// One row for each set of constants of a target, the fastest first.
Table study_times(const Trade& trade, const std::string& target);

/// bench.md and bench.csv.
std::vector<File> study_bench_files(const Trade& trade);

}  // namespace shadefit::bench
