#pragma once

#include <span>

#include "fit/ledger/finding.hpp"

/// The functions that compute the claims: one function and one file for each topic.
namespace shadefit {

std::span<const Evaluator> lobe_evaluators();
std::span<const Evaluator> gloss_evaluators();
std::span<const Evaluator> arithmetic_evaluators();
std::span<const Evaluator> cost_evaluators();
std::span<const Evaluator> kernels_evaluators();
std::span<const Evaluator> von_mises_fisher_evaluators();
std::span<const Evaluator> fresnel_evaluators();
std::span<const Evaluator> phong_blinn_evaluators();
std::span<const Evaluator> normalisation_evaluators();
std::span<const Evaluator> environment_map_evaluators();
std::span<const Evaluator> harmonics_evaluators();
std::span<const Evaluator> material_evaluators();
std::span<const Evaluator> phase_evaluators();
std::span<const Evaluator> dither_evaluators();
std::span<const Evaluator> microfacet_evaluators();

}  // namespace shadefit
