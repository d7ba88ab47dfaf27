#pragma once

#include <span>
#include <string_view>

#include "fit/formula/definition.hpp"

/// The formulas of approx/ that other formulas may call by name: `gaussian_lobe(c, k, x)`. Each is its
/// template, run once on the symbolic scalar. docs/studies.md lists them.
namespace shadefit {

struct NamedFormula {
  std::string_view name;
  Definition definition;
};

std::span<const NamedFormula> named_formulas();

/// The formula of that name, or null.
const NamedFormula* find_formula(std::string_view name);

}  // namespace shadefit
