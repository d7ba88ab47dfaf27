#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/better/results.hpp"
#include "reports/findings/finding.hpp"
#include "reports/io/files.hpp"
#include "reports/rows/tables.hpp"

/// Compares the current results with the committed tables, cell by cell.
namespace shadefit {

struct Drift {
  std::string file;
  std::string row;          ///< the row's key, like "sg-offset x 5 cosine"
  std::string column = {};  ///< empty if the whole row is missing or new
  std::string before = {};
  std::string after = {};
  std::string effect = {};            ///< what it means: of the curve, a relative change, or a changed word
  std::string path = {};              ///< of the baseline's file
  long line = 1;                      ///< of the row in it; of the header, if the row is new
  std::optional<double> change = {};  ///< of a number, as a share of the baseline's; infinite from 0
};

/// What came of a comparison.
struct CheckedTables {
  std::vector<Drift> drifts;  ///< every difference, once each
  std::size_t cells = 0;      ///< that were compared
};

/// The tables that a baseline holds, read into memory.
struct Baseline {
  std::filesystem::path directory;
  std::vector<File> files;
};

/// Reads a baseline. Throws UserError naming a file that is missing or not a table.
Baseline read_baseline(const std::filesystem::path& directory);

/// The same for tables with these names, which are optional in a baseline.
Baseline read_tables(const std::filesystem::path& directory, const std::vector<std::string>& names);

/// Compares the baseline with the results. Throws UserError naming file and line if the baseline is
/// truncated, malformed or has other columns.
CheckedTables compare(const Baseline& baseline, const Results& results);

/// Compares tables of `read_tables` with CSV tables of the same names as they are now; `origins` are those of
/// the rows of fits.csv. Throws UserError as `compare` does.
CheckedTables compare_files(const Baseline& tables, const std::vector<File>& now,
                            const std::vector<FitRow>& origins = {});

/// Whether a drift fails the check: every one, or with a limit each number that changed by a larger share,
/// and each word and row.
bool is_failing(const Drift& drift, const std::optional<double>& fail_above);

/// The drifts as findings of `check`, each at its row of the baseline; a row that the baseline lacks at the
/// header. One that fails is an error, others are notes.
findings::FindingReport drift_findings(const CheckedTables& checked, const std::optional<double>& fail_above);

}  // namespace shadefit
