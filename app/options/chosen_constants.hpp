#pragma once

#include <optional>
#include <string_view>

#include "app/options/fit_arguments.hpp"
#include "fit/proof/certificate.hpp"

/// Which constants of a form `certify` and `emit` are about.
namespace shadefit {

struct ChosenSubject {
  Subject subject;
  std::string_view from;  ///< whose its values are: given, published or fitted
};

/// The given `parameters`; without them the ones published for that setting, or, where one of them was not
/// published, those of a fit. Throws UserError where the fit did not converge.
ChosenSubject chosen_constants(const std::optional<Parameters>& parameters, const NamedFit& named,
                               const Setting& setting, const Metric& metric);

}  // namespace shadefit
