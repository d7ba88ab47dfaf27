#pragma once

#include <vector>

#include "fit/better/results.hpp"
#include "reports/io/table.hpp"

/// Results as rows: the tables with stable columns.
namespace shadefit {

/// The origin of a row of fits.csv: it turns a change of a parameter into a change of its curve.
struct FitRow {
  const Refit* refit;
  const FitReport* report;  ///< null for a mean or limit of fits
  std::size_t parameter;
};

struct FitsTable {
  Table table;
  std::vector<FitRow> origins;  ///< one for each row; they point into the results
};

/// One row per fit, parameter and published number: fits.csv. Parameters that are means or limits of fits are
/// named `x_mean`, `x_limit`. A fit that did not converge has empty cells, and its status in place of a
/// verdict.
FitsTable fits_table(const std::vector<Refit>& refits);

/// One row per constant and exponent: normalization.csv.
Table normalisation_table(const std::vector<NormalisationCheck>& checks);

/// Every published number and its verdict: the summary of the report and of the console.
Table summary_table(const Results& results);

}  // namespace shadefit
