#include "fit/ledger/colour/transfer_function.hpp"

#include <stdexcept>

#include "approx/encoding.hpp"
#include "fit/ledger/finding.hpp"
#include "fit/support/format.hpp"

namespace shadefit {

double TransferFunction::linear(double code) const {
  const double encoded = code / codes;
  return gamma == 0 ? srgb_decode(encoded) : gamma_decode(encoded, gamma);
}

double TransferFunction::code(double linear) const {
  return codes * (gamma == 0 ? srgb_encode(linear) : gamma_encode(linear, gamma));
}

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
    if (!(result.gamma > 0))
      throw std::invalid_argument(fmt::format("not an exponent above 0: {}", result.name));
  } else if (function != "sRGB") {
    throw std::invalid_argument(fmt::format("not a transfer function: '{}'", result.name));
  }
  if (!(result.codes > 0)) throw std::invalid_argument(fmt::format("not a divisor above 0: {}", result.name));
  return result;
}

std::vector<TransferFunction> transfer_functions(std::string_view names) {
  std::vector<TransferFunction> result;
  for (const std::string_view name : items_of(names)) result.push_back(transfer_function(name));
  return result;
}

}  // namespace shadefit
