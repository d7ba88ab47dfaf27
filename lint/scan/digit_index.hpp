#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lint/scan/digit_match.hpp"
#include "lint/scan/known_set.hpp"
#include "lint/scan/literals.hpp"

/// Finds the published constants that a number may stand for.
namespace shadefit::lint {

/// A constant of a set, or a variant of one.
struct ConstantPlace {
  std::size_t set = 0, constant = 0;
  auto operator<=>(const ConstantPlace&) const = default;
};

struct NumberMatch {
  ConstantPlace place;
  DigitMatch match = DigitMatch::same;
  std::optional<std::size_t> variant = {};  ///< the variant of the set with these digits
};

/// The digits of all constants, sorted by value, and their texts with one digit left out: two texts that
/// differ by one edit have one of these in common (as in W. Garbe's SymSpell, 2012).
class DigitIndex {
 public:
  explicit DigitIndex(const std::vector<KnownSet>& sets);

  /// The constants with at least three digits that match.
  std::vector<NumberMatch> find(const Digits& found) const;

 private:
  struct Entry {
    Digits digits;
    double mantissa = 0;
    ConstantPlace place;
    bool is_common = false;  ///< then a near number is a different one
    std::optional<std::size_t> variant = {};
  };

  using Key = std::pair<std::uint64_t, std::uint32_t>;

  void look_near(const Digits& found, std::vector<NumberMatch>& matches) const;
  void look_edited(const Digits& found, std::vector<NumberMatch>& matches) const;

  std::vector<Entry> entries_;  ///< by rising mantissa
  std::vector<Key> keys_;       ///< of shortened texts, sorted; the entry
};

}  // namespace shadefit::lint
