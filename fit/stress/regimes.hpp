#pragma once

#include <vector>

#include "fit/stress/trial.hpp"

/// The regimes, one file for each topic.
namespace shadefit {

std::vector<Regime> lobe_regimes();              ///< c^k near its peak; its Gaussian with A; the half angle
std::vector<Regime> dot_product_regimes();       ///< c at and beyond the ends of [0, 1]
std::vector<Regime> von_mises_fisher_regimes();  ///< its normalised density
std::vector<Regime> phase_regimes();             ///< Henyey-Greenstein
std::vector<Regime> normalisation_regimes();     ///< of Blinn-Phong
std::vector<Regime> gloss_regimes();             ///< decoding
std::vector<Regime> remainder_regimes();         ///< log1p(x) - x

}  // namespace shadefit
