#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "lint/known/known_set.hpp"
#include "lint/scan/literals.hpp"
#include "lint/scan/sites.hpp"

namespace shadefit::lint {

/// Constants of one formula are within this many bytes of each other, and in one function.
inline constexpr std::size_t most_gap = 700;

/// A number of fewer digits is only looked for near the other constants.
inline constexpr std::size_t least_digits_alone = 3;

/// Finds numbers that belong to a site only because of the others.
class Companions {
 public:
  Companions(std::string_view text, const std::vector<Literal>& literals, const std::vector<KnownSet>& sets)
      : text_(text), literals_(literals), sets_(sets) {}

  /// Adds constants of few digits, such as 0.03, near the others.
  void add_near(Site& site);

  /// Adds the constant that a list has rounded to too few digits to be looked for alone: 0.072 beside 0.212
  /// and 0.715.
  void add_short(Site& site) const;

  /// Adds wrong numbers that are no evidence. Only for sites whose numbers are evidence enough. True if
  /// there is one.
  bool add_wrong(Site& site);

  /// Adds the two missing constants of three digits as the nearest numbers with a usual slip: 0.229 for 0.299
  /// and 0.144 for 0.114. They are no evidence: only the expression can show that they belong to the site.
  void add_two_slips(Site& site);

  /// Whether two literals are in one function.
  bool are_in_one_function(std::size_t a, std::size_t b);

 private:
  /// Adds missing constants as numbers that were rounded and then mistyped, or mistyped in other units,
  /// between or beside the others. True if there is one.
  bool add_rounded_and_edited(Site& site);

  /// A constant that the form has at several places may have a wrong digit or exponent at one of them only.
  /// Then that number is the constant. True if there is one.
  bool take_edited_repetitions(Site& site);

  std::vector<std::size_t> missing_of(const Site& site) const;
  const Digits& digits_at(std::size_t literal) const { return literals_[literal].digits; }

  std::string_view text_;
  const std::vector<Literal>& literals_;
  const std::vector<KnownSet>& sets_;
  std::optional<std::vector<std::size_t>> functions_;  ///< where they begin, computed when first needed
};

}  // namespace shadefit::lint
