#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Formulas with a name.
namespace shadefit {

/// A named formula, `hg(c, g) = ..`; without arguments a name for an expression.
struct Definition {
  std::vector<std::string> arguments;
  Symbolic formula;
};

/// The most operations of a formula with its definitions put in. Definitions that use each other double it
/// with each line.
inline constexpr std::size_t most_operations = 100'000;

/// How many operations, names and numbers a formula has; counted only as far as `most_operations`.
std::size_t size_of(const Symbolic& formula);

/// The same of a definition with its arguments put in, before that is done.
std::size_t size_of(const Definition& definition, std::span<const Symbolic> given);

/// A definition with its arguments put in.
Symbolic put_in(const Definition& definition, std::span<const Symbolic> given);

}  // namespace shadefit
