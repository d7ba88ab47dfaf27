#pragma once

#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/catalogue/published.hpp"

/// The ledger: one record for every statement of the source documents that contains or implies a number. The
/// records are in studies/claims, a file for each topic.
namespace shadefit {

/// A named number, list or word of a record, as text.
struct Quantity {
  std::string_view name;   ///< may be empty where the record has one number, or a plain list
  std::string_view value;  ///< as printed: the number of digits matters
};

struct Quantities : std::vector<Quantity> {
  using std::vector<Quantity>::vector;
  /// The value of that name. Throws std::out_of_range if there is none.
  std::string_view at(std::string_view name) const {
    for (const Quantity& item : *this) {
      if (item.name == name) return item.value;
    }
    throw std::out_of_range("no quantity of that name");
  }
};

/// How a claim is computed where its record says that: fit/ledger/computation.hpp.
struct Instructions {
  using Line = std::vector<std::string_view>;
  std::vector<Line> definitions = {};
  std::vector<std::string_view> verdicts = {};  ///< none: code computes it, or fits
  std::vector<Line> effects = {};
  bool in_50_digits = false;
};

/// One row of the ledger: the statement and our reading of it. `evaluate` computes whether it is right.
struct Claim {
  std::string_view id;
  /// The statement in our words, with the meaning of its letters. Its formulas stand between ` and `.
  std::string_view statement;
  Quantities printed = {};  ///< its numbers as printed; none for an identity or a comparison
  Quantities inputs =
      {};  ///< the inputs of the computation: exponents, domains, readings of words ("accurate": 0.02)
  std::string_view derivation;     ///< why the computed value is what it is, in a few lines
  std::string_view computed = {};  ///< of its finding, with holes for numbers (fit/ledger/told.hpp)
  std::string_view evidence = {};  ///< the same; empty where fits judge it
  std::string_view figure = {};    ///< the figure that shows it, as in `plots/NAME.svg`; empty: none
  Source source;
  /// The published constants that fits have to reproduce, one for each printed number, in that order; empty
  /// for other kinds of claims.
  std::span<const Published> constants = {};
  Instructions instructions = {};
};

/// A section of the ledger.
struct Topic {
  std::string_view title;
  std::span<const Claim> claims;
};

}  // namespace shadefit
