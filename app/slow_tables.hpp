#pragma once

#include <vector>

#include "app/progress.hpp"
#include "fit/checkpoint.hpp"
#include "reports/files.hpp"

/// The tables that take seconds: `check --all` compares them, `check` and `run` leave them out.
namespace shadefit {

/// Makes its tables as they are committed, in `slow_tables_folder` of the baseline.
using SlowTableMaker = std::vector<File> (*)(const Checkpoint& checkpoint, const Progress& progress);

inline constexpr const char* slow_tables_folder = "slow";

std::vector<File> stress_tables(const Checkpoint& checkpoint, const Progress& progress);
std::vector<File> accuracy_tables(const Checkpoint& checkpoint, const Progress& progress);

/// One line for each command that has some.
inline const std::vector<SlowTableMaker> slow_table_makers{stress_tables, accuracy_tables};

}  // namespace shadefit
