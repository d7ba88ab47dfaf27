#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The truths that formulas may name: quantities of shading that are integrals, with an exact definition.
/// docs/truths.md has their formulas, ranges and sources.
namespace shadefit {

struct Truth {
  std::string_view name;
  std::vector<std::string> arguments;
  std::string_view formula;  ///< of the arguments and other truths; empty for one of fit/truths/albedos.hpp
};

std::span<const Truth> truths();

/// The truth of that name, or null.
const Truth* find_truth(std::string_view name);

}  // namespace shadefit
