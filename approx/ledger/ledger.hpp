#pragma once

#include <array>

#include "approx/arithmetic.hpp"
#include "approx/cost.hpp"
#include "approx/dither.hpp"
#include "approx/environment_map.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/harmonics.hpp"
#include "approx/kernels.hpp"
#include "approx/lobe.hpp"
#include "approx/material.hpp"
#include "approx/microfacet.hpp"
#include "approx/normalisation.hpp"
#include "approx/phase.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/records/claim.hpp"
#include "approx/von_mises_fisher.hpp"

/// Every claim in one list, a section a topic; the records stand beside their formulas, one file a topic.
namespace shadefit {

inline constexpr std::array ledger{
    Topic{"Lobes: Blinn-Phong and Phong by a spherical Gaussian", lobe_claims},
    Topic{"Gloss and logarithms", gloss_claims},
    Topic{"What half, float and double make of a lobe", arithmetic_claims},
    Topic{"Instruction counts", cost_claims},
    Topic{"Other kernels", kernels_claims},
    Topic{"von Mises-Fisher", von_mises_fisher_claims},
    Topic{"Fresnel", fresnel_claims},
    Topic{"Phong and Blinn", phong_blinn_claims},
    Topic{"Normalisation", normalisation_claims},
    Topic{"Environment maps", environment_map_claims},
    Topic{"Spherical harmonics", harmonics_claims},
    Topic{"Materials", material_claims},
    Topic{"Volumes: phase functions", phase_claims},
    Topic{"Volumes: dithering and marching", dither_claims},
    Topic{"Microfacet distributions", microfacet_claims},
};

}  // namespace shadefit
