#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fit/run/results.hpp"
#include "reports/io/files.hpp"

/// Comparing what is computed now with the committed tables, cell by cell.
namespace shadefit {

struct Drift {
  std::string file;
  std::string row;     ///< the row's key, like "sg-offset x 5 cosine"
  std::string column;  ///< empty where the whole row is missing or new
  std::string before;
  std::string after;
  std::string effect;  ///< what it means: of the curve, a relative change, or a changed word
};

/// The tables that a baseline holds, read into memory.
struct Baseline {
  std::filesystem::path directory;
  std::vector<File> files;
};

/// Reads a baseline. Throws UserError naming the file where one is missing or no table.
Baseline read_baseline(const std::filesystem::path& directory);

/// The same of the tables of these names, which no baseline has to hold.
Baseline read_tables(const std::filesystem::path& directory, const std::vector<std::string>& names);

/// Every difference between the baseline and the results, none twice. Throws UserError naming file and line
/// where the baseline is truncated, malformed or has other columns.
std::vector<Drift> compare(const Baseline& baseline, const Results& results);

/// Every difference between tables of `read_tables` and CSV tables of the same names as they are now. Throws
/// UserError as `compare` does.
std::vector<Drift> compare_files(const Baseline& tables, const std::vector<File>& now);

/// How many cells such tables have.
std::size_t count_cells(const std::vector<File>& files);

/// How many cells the tables of the results have.
std::size_t count_cells(const Results& results);

}  // namespace shadefit
