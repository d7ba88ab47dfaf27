#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fit/ledger/claim.hpp"

/// The sentences of a record with their numbers.
namespace shadefit {

/// A number or words that the computation of a claim found, by name.
struct Told {
  std::string_view name;
  std::variant<double, std::string> value;

  Told(std::string_view of, std::convertible_to<double> auto number)
      : name(of), value(static_cast<double>(number)) {}
  Told(std::string_view of, std::string_view words) : name(of), value(std::string(words)) {}
};

std::string told_of(const Claim& claim, const std::vector<Told>& found);

/// The evidence of the claim. Its `{name}` is that word, input or printed number as it stands;
/// `{formula:.6g}` the value of a formula of the numbers found, the inputs and the printed numbers, in that
/// format; `{powers#power}` counts the numbers of an input, "4 powers", and in formulas `powers_first` and
/// `powers_last` are its ends. The names of inputs have `_` for blanks; `printed_0` is the first printed
/// number. Throws std::exception for a name that is not known and for a formula that cannot be read.
template <class... Found>
std::string told(const Claim& claim, const Found&... found) {
  return told_of(claim, std::vector<Told>{found...});
}

}  // namespace shadefit
