#include "fit/ledger/transfer_function.hpp"

#include <stdexcept>

#include "fit/ledger/finding.hpp"
#include "fit/support/format.hpp"

namespace shadefit {

TransferFunction transfer_function(std::string_view name) {
  constexpr std::string_view exponent = "gamma ", divisor = " of code/";
  TransferFunction result;
  result.name = name;
  std::string_view function = name;
  if (const auto at = name.find(divisor); at != std::string_view::npos) {
    result.codes = number_of(name.substr(at + divisor.size()));
    function = name.substr(0, at);
  }
  if (function.starts_with(exponent)) {
    result.gamma = number_of(function.substr(exponent.size()));
  } else if (function != "sRGB") {
    throw std::invalid_argument(fmt::format("not a transfer function: '{}'", result.name));
  }
  return result;
}

std::vector<TransferFunction> conventions_of(const Claim& claim) {
  std::vector<TransferFunction> conventions{transfer_function(claim.inputs.at("convention"))};
  for (const std::string& other : items_of(claim.inputs.at("other conventions")))
    conventions.push_back(transfer_function(other));
  return conventions;
}

}  // namespace shadefit
