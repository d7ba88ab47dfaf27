#pragma once

#include <concepts>
#include <optional>
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

/// An input or a printed number of the record as it stands: by its name, with `_` for blanks, or by its
/// place: `input_0`, `printed_0`. Throws std::logic_error if there is none.
std::string_view given_text(const Claim& claim, std::string_view name);

/// The same as a number. `powers_first` and `powers_last` are the ends of the sweep `powers`.
double given_number(const Claim& claim, std::string_view name);

Finding told_of(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
                const std::vector<Told>& found);

/// The finding of a claim, with the texts `computed` and `evidence` of its record and their holes filled:
/// `{name}` is that word, input or printed number as it stands; `{formula:.6g}` the value of a formula of the
/// numbers found, the inputs and the printed numbers, in that format; `{powers#power}` counts the numbers of
/// an input, "4 powers". `{identity}` is "identity" if the verdict is `confirmed`, else "no identity". Throws
/// std::exception for a name that is not known and for a formula that cannot be read or has no finite value.
template <class... Found>
Finding told(const Claim& claim, std::optional<Verdict> verdict, const std::string& effect,
             const Found&... found) {
  return told_of(claim, verdict, effect, {found...});
}

}  // namespace shadefit
