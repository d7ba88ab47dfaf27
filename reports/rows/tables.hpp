#pragma once

#include <vector>

#include "fit/run/results.hpp"
#include "reports/table/table.hpp"

/// From results to rows: the tables whose columns others rely on.
namespace shadefit {

/// Where a row of fits.csv comes from, so that a drift of a parameter can be turned into a drift of its
/// curve.
struct FitRow {
  const Refit* refit;
  const FitReport* report;  ///< null for a mean or limit of fits
  std::size_t parameter;
};

struct FitsTable {
  Table table;
  std::vector<FitRow> origins;  ///< one a row; they point into the results
};

/// One row per fit, parameter and published number: fits.csv. Parameters that are means or limits of fits are
/// named `x_mean`, `x_limit`. A fit that did not converge has empty cells and its status for a verdict.
FitsTable fits_table(const std::vector<Refit>& refits);

/// One row per fit, parameters to their last bit: the overview for the console.
Table fits_overview(const Refit& refit);

/// One row per constant and exponent: normalization.csv.
Table normalisation_table(const std::vector<NormalisationCheck>& checks);

/// Every published number and its verdict: the summary of the report and of the console.
Table summary_table(const Results& results);

/// What a fit approximates: the family's target, of which surface, or the exact reflectance of that.
std::string target_of(const Fit& fit);
std::string target_of(const FittableFamily& family, const Surface& surface);

}  // namespace shadefit
