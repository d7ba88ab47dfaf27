#pragma once

#include <span>
#include <string>

#include "app/commands.hpp"
#include "fit/fit.hpp"
#include "fit/quadrature/metric.hpp"

/// What the options of `fit` say of a metric: read, and held against the family they are for.
namespace shadefit {

/// The metric of `options` for the fits of a family at `settings`. Throws UserError with one line that names
/// the option, its value and the rule: what it does not know, a domain or a weight that is none, constraints
/// that contradict each other or leave nothing to fit, a relative error where the target is zero.
Metric parse_metric(const FitOptions& options, const FittableFamily& family,
                    std::span<const Setting> settings);

/// "cosine measure, least squares", or what else the metric says.
std::string headline(const Metric& metric);

/// A finite number; `option` is for the complaint.
double parse_finite(const std::string& option, const std::string& text);

}  // namespace shadefit
