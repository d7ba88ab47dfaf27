#pragma once

#include <array>

#include "approx/ledger/arithmetic.hpp"
#include "approx/ledger/cost.hpp"
#include "approx/ledger/dither.hpp"
#include "approx/ledger/environment_map.hpp"
#include "approx/ledger/fresnel.hpp"
#include "approx/ledger/gloss.hpp"
#include "approx/ledger/harmonics.hpp"
#include "approx/ledger/kernels.hpp"
#include "approx/ledger/lobe.hpp"
#include "approx/ledger/material.hpp"
#include "approx/ledger/microfacet.hpp"
#include "approx/ledger/normalisation.hpp"
#include "approx/ledger/phase.hpp"
#include "approx/ledger/phong_blinn.hpp"
#include "approx/ledger/von_mises_fisher.hpp"
#include "approx/records/claim.hpp"

/// Every claim in one list, with one section per topic. The records of a topic are in approx/ledger/.
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
