#pragma once

#include <vector>

#include "fit/ledger/finding.hpp"

/// The functions that compute the claims: one function and one file for each topic.
namespace shadefit {

std::vector<Evaluator> lobe_evaluators();
std::vector<Evaluator> gloss_evaluators();
std::vector<Evaluator> arithmetic_evaluators();
std::vector<Evaluator> half_banding_evaluators();
std::vector<Evaluator> cost_evaluators();
std::vector<Evaluator> kernels_evaluators();
std::vector<Evaluator> density_evaluators();
std::vector<Evaluator> fresnel_evaluators();
std::vector<Evaluator> phong_blinn_evaluators();
std::vector<Evaluator> normalisation_evaluators();
std::vector<Evaluator> environment_map_evaluators();
std::vector<Evaluator> solid_angle_evaluators();
std::vector<Evaluator> gloss_chain_evaluators();
std::vector<Evaluator> harmonics_evaluators();
std::vector<Evaluator> material_evaluators();
std::vector<Evaluator> colour_chart_evaluators();
std::vector<Evaluator> dither_evaluators();
std::vector<Evaluator> microfacet_evaluators();

}  // namespace shadefit
