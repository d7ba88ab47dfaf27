#pragma once

#include <optional>
#include <string_view>

#include "app/options/fit_arguments.hpp"
#include "fit/proof/certificate.hpp"

/// The constants of a form that `certify` and `emit` use.
namespace shadefit {

struct ChosenSubject {
  Subject subject;
  std::string_view from;  ///< the origin of its values: given, published or fitted
};

/// The given `parameters`; without them the parameters published for that setting; if one of these is
/// missing, those of a fit. Throws UserError if the fit did not converge.
ChosenSubject chosen_constants(const std::optional<Parameters>& parameters, const NamedFit& named,
                               const Setting& setting, const Metric& metric);

}  // namespace shadefit
