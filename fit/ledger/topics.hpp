#pragma once

#include <vector>

#include "fit/ledger/told.hpp"
#include "fit/ledger/where.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

/// The functions that compute the claims: one function and one file for each topic, and what all of them use.
namespace shadefit {

std::vector<Evaluator> lobe_evaluators();
std::vector<Evaluator> half_banding_evaluators();
std::vector<Evaluator> cost_evaluators();
std::vector<Evaluator> kernels_evaluators();
std::vector<Evaluator> normalisation_evaluators();
std::vector<Evaluator> microfacet_evaluators();

}  // namespace shadefit
