#pragma once

#include <memory>
#include <vector>

#include "fit/panels/search_panels.hpp"
#include "fit/steps/minimax.hpp"
#include "fit/study/study.hpp"

/// Formulas of a study along its variable, as curves of the exchange.
namespace shadefit {

enum class CurveOf { formula, slope };

/// A formula of the variable and the parameters, or its slope along the variable, over panels. The search
/// visits `places`. Panels that end at a kink move with it, and the derivatives by the parameters are those
/// at a place that moves with its panel. One thread uses the curve and its panels at a time.
MinimaxCurve panel_curve(const ReadStudy& study, const Symbolic& formula, CurveOf of,
                         std::shared_ptr<SearchPanels> panels, const std::vector<SearchPlace>& places);

}  // namespace shadefit
