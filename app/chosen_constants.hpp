#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/fit_arguments.hpp"
#include "fit/proof/certificate.hpp"

/// Which constants of a form `certify` and `emit` are about.
namespace shadefit {

struct ChosenSubject {
  Subject subject;
  std::string_view from;  ///< whose its values are: given, published or fitted
};

/// Those of `parameters`, "a=-5.55473,b=-6.98316"; without it the published ones of that setting, and where
/// not all were published those of a fit. Throws UserError where the text is no such list, or the fit did not
/// converge.
ChosenSubject chosen_constants(const std::optional<std::string>& parameters, const NamedFit& named,
                               const Setting& setting, const Metric& metric);

}  // namespace shadefit
