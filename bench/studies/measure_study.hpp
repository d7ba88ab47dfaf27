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

/// Times every form of a study, and its target, in scalar float: the code that `emit` writes in C, compiled
/// here, over an array that is in the first cache. A form has one time for all of its constants that need the
/// same operations. Errors are those of the contenders, in exact arithmetic. `between` receives the finished
/// share. Throws UserError for a form that has no code, and where no C compiler works.
Trade measure_study(const std::string& id, const std::vector<StudyComparison>& comparisons,
                    const TimingPlan& plan, const Clock& clock, const std::function<void(double)>& between);

/// One row for each set of constants of a target, by rising time.
Table study_times(const Trade& trade, const std::string& target);

/// bench.md and bench.csv.
std::vector<File> study_bench_files(const Trade& trade);

}  // namespace shadefit::bench
