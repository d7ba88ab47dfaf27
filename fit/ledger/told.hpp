#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fit/ledger/finding.hpp"

/// The texts of a record with their numbers.
namespace shadefit {

/// A number or words that the computation of a claim found, by name.
struct Told {
  std::string_view name;
  std::variant<double, std::string> value;

  Told(std::string_view of, std::convertible_to<double> auto number)
      : name(of), value(static_cast<double>(number)) {}
  Told(std::string_view of, std::string_view words) : name(of), value(std::string(words)) {}
};

Finding told_of(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
                std::vector<Told> found);

/// The finding of a claim, with the texts `computed` and `evidence` of its record. There `{name}` is that
/// word, input or printed number as it stands; `{formula:.6g}` the value of a formula of the numbers found,
/// the inputs and the printed numbers, in that format; `{powers#power}` counts the numbers of an input, "4
/// powers", and in formulas `powers_first` and `powers_last` are its ends. The names of inputs have `_` for
/// blanks; `printed_0` is the first printed number. `{identity}` is "identity" if the verdict is `confirmed`,
/// else "no identity". Throws std::exception for a name that is not known and for a formula that cannot be
/// read.
template <class... Found>
Finding told(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
             const Found&... found) {
  return told_of(claim, verdict, effect, {found...});
}

}  // namespace shadefit
