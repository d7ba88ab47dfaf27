#pragma once

#include <optional>
#include <vector>

#include "reports/check/baseline.hpp"
#include "reports/findings/finding.hpp"

namespace shadefit {

/// Whether a drift fails the check: every one, or with a limit each number that changed by a larger share,
/// and each word and row.
bool is_failing(const Drift& drift, const std::optional<double>& fail_above);

/// The drifts as findings of `check`, each at its row of the baseline; a row that the baseline lacks at the
/// header. One that fails is an error, others are notes. `cells` were compared.
findings::FindingReport drift_findings(const std::vector<Drift>& drifts, std::size_t cells,
                                       const std::optional<double>& fail_above);

}  // namespace shadefit
