#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string_view>

#include "approx/records/record.hpp"

/// The ledger: one record for every statement of the source documents that contains or implies a number.
namespace shadefit {

/// A named number, list or word of a record, as text.
struct Quantity {
  std::string_view name;   ///< may be empty where the record has one number, or a plain list
  std::string_view value;  ///< as printed: the number of digits matters
};

/// A short list of quantities, held by value, so that a record can be copied and changed.
class Quantities {
 public:
  constexpr Quantities() = default;
  /// Throws std::length_error (in a record: a compile-time error) beyond twelve.
  constexpr Quantities(std::initializer_list<Quantity> items) {
    if (items.size() > items_.size()) throw std::length_error("more than twelve quantities");
    for (const Quantity& item : items) items_[size_++] = item;
  }
  constexpr const Quantity* begin() const { return items_.data(); }
  constexpr const Quantity* end() const { return items_.data() + size_; }
  constexpr Quantity* begin() { return items_.data(); }
  constexpr Quantity* end() { return items_.data() + size_; }
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr const Quantity& operator[](std::size_t i) const { return items_.at(i); }
  constexpr Quantity& operator[](std::size_t i) { return items_.at(i); }

  /// The value of that name. Throws std::out_of_range if there is none.
  constexpr std::string_view at(std::string_view name) const {
    for (const Quantity& item : *this) {
      if (item.name == name) return item.value;
    }
    throw std::out_of_range("no quantity of that name");
  }

 private:
  std::array<Quantity, 12> items_{};
  std::size_t size_ = 0;
};

/// One row of the ledger: the statement and our reading of it. fit/ledger/ledger.hpp computes whether it is
/// right.
struct Claim {
  std::string_view id;
  /// The statement in our words, with the meaning of its letters. Its formulas stand between ` and `.
  std::string_view statement;
  Quantities printed = {};  ///< its numbers as printed; none for an identity or a comparison
  Quantities inputs =
      {};  ///< the inputs of the computation: exponents, domains, readings of words ("accurate": 0.02)
  std::string_view derivation;   ///< why the computed value is what it is, in a few lines
  std::string_view figure = {};  ///< the figure that shows it, as in `plots/NAME.svg`; empty: none
  Source source;
  /// The published constants that fits have to reproduce, one for each printed number, in that order; empty
  /// for other kinds of claims.
  std::span<const Published> constants = {};
};

/// The claim of one published constant. Its record holds the printed digits and the exponents; fits over the
/// cosines from 0 to 1 judge it.
constexpr Claim claim_of(const Published& published, std::string_view statement, std::string_view derivation,
                         std::string_view figure) {
  Claim claim{.id = published.id,
              .statement = statement,
              .printed = {{published.parameter, published.printed}},
              .inputs = {{"from", "0"}, {"to", "1"}},
              .derivation = derivation,
              .figure = figure,
              .source = published.source,
              .constants = std::span(&published, 1)};
  if (!published.exponents.empty())
    claim.inputs = {{"exponents", published.exponents}, {"from", "0"}, {"to", "1"}};
  return claim;
}

/// A section of the ledger.
struct Topic {
  std::string_view title;
  std::span<const Claim> claims;
};

}  // namespace shadefit
