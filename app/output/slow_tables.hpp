#pragma once

#include <string>
#include <vector>

#include "app/output/progress.hpp"
#include "fit/support/checkpoint.hpp"
#include "reports/io/files.hpp"
#include "reports/rows/stress_tables.hpp"

/// The tables that take seconds: `check --all` compares them, `check` and `run` leave them out.
namespace shadefit {

/// The slow tables of one command: their names in `slow_tables_folder` of the baseline, and the function that
/// computes them as committed.
struct SlowTables {
  std::vector<std::string> names;
  std::vector<File> (*make)(const Checkpoint& checkpoint, const Progress& progress);
};

inline constexpr const char* slow_tables_folder = "slow";
inline constexpr const char* accuracy_file = "accuracy.csv";

std::vector<File> stress_tables(const Checkpoint& checkpoint, const Progress& progress);
std::vector<File> accuracy_tables(const Checkpoint& checkpoint, const Progress& progress);

/// One entry for each command with slow tables.
inline const std::vector<SlowTables> slow_tables{{{forms_stress_file, fits_stress_file}, stress_tables},
                                                 {{accuracy_file}, accuracy_tables}};

}  // namespace shadefit
