#pragma once

#include <optional>
#include <string>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"

/// `shadefit explain 5.55473`: which published constants have a number.
namespace shadefit {

/// The constants with these digits that `lint` knows, and the claims that print them. Without any: the
/// constants that differ by a digit. Empty if the text of the options is not a number. Throws UserError if no
/// constant has it.
std::optional<Outcome> explain_number(const ExplainOptions& options);

}  // namespace shadefit
