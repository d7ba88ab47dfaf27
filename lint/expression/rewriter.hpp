#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Rewrites expressions of programs in the notation of formulas.
namespace shadefit::lint {

/// An expression as a formula of v0, v1 and so on, and what these names stand for in the program.
struct Rewritten {
  std::string formula;
  std::vector<std::string> names;
};

/// Rewrites an expression without comments. Empty if it has operations other than those of scalars.
std::optional<Rewritten> in_formula_notation(std::string_view text);

}  // namespace shadefit::lint
