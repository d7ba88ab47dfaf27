#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lint/known/known_set.hpp"

/// Forms of which a program computes an inner part elsewhere.
namespace shadefit::lint {

/// A form with a variable in place of an inner part: y' for pow(y, m).
struct Absorbed {
  Symbolic inner;
  KnownSet outer;
  std::string name, variable;  ///< y', which has the range of the inner part; and y
};

/// The form with each of its parts that has one variable and, of the constants, one or more of the missing
/// ones and no others. Left out are parts whose variable stands elsewhere too, and those that have one value.
std::vector<Absorbed> absorbed_in(const KnownSet& set, const std::vector<double>& constants,
                                  const std::vector<std::size_t>& missing);

/// The formula with `other` in place of each part that is `part`.
Symbolic with_part(const Symbolic& formula, const Symbolic& part, const Symbolic& other);

}  // namespace shadefit::lint
