#pragma once

#include <vector>

#include "reports/check/baseline.hpp"
#include "reports/findings/finding.hpp"

namespace shadefit {

/// The drifts as findings of `check`, each at its row of the baseline; a row that the baseline lacks at the
/// header. `cells` were compared.
findings::FindingReport drift_findings(const std::vector<Drift>& drifts, std::size_t cells);

}  // namespace shadefit
