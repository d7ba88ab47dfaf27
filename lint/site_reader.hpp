#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lint/expression/compare.hpp"
#include "lint/known/known_set.hpp"
#include "lint/reading_memory.hpp"
#include "lint/scan/literals.hpp"
#include "lint/scan/sites.hpp"

namespace shadefit::lint {

/// The literals that stand for a constant, by their indices.
struct FoundLiterals {
  std::vector<std::size_t> literals;
  bool are_certain = false;
};

/// Reads the text around a site as the form of its set.
class SiteReader {
 public:
  SiteReader(std::string_view text, CommentStyle style, const std::vector<Literal>& literals,
             const KnownSet& set, const Site& site, ReadingMemory& memory);

  /// The constants as found: see constants_at().
  const std::vector<double>& constants() const { return constants_; }

  /// The indices of the set's constants that are not at the site.
  const std::vector<std::size_t>& missing() const { return missing_; }

  /// The smallest expression around the numbers that is the form, perhaps with a slip. Empty if there is
  /// none, if more than one constant is missing that a program must have, or if the numbers are in other
  /// units.
  std::optional<ExpressionMatch> read() const;

  /// The literals of a constant that has this value at the site, and that only the expression shows. They are
  /// certain if the text with the published number at these literals is the form with it. Several literals
  /// are in a row, as in vec3(0.4, 0.4, 0.4). If none are certain, the nearest literal with this value.
  FoundLiterals literals_of(std::size_t constant, double value) const;

  /// How much of the form the text contains.
  Reading reading() const;

 private:
  /// One branch of a choice as a set of its own, with those of its numbers that are at the site.
  struct Branch {
    KnownSet set;
    std::vector<double> numbers;
    std::vector<Symbolic> expressions;  ///< around them
  };

  std::vector<std::size_t> candidates(std::size_t constant, double value) const;
  bool is_form_with(std::size_t constant, std::span<const std::size_t> at) const;
  bool lacks_constants() const;
  bool believes_slips() const;
  std::vector<Symbolic> expressions(const Literal& first, const Literal& last) const;
  std::optional<Branch> branch(std::size_t part) const;
  bool reads_branch(std::size_t part) const;
  std::optional<ExpressionMatch> slip_of_branch() const;

  std::string_view text_;
  CommentStyle style_;
  const std::vector<Literal>& literals_;
  const KnownSet& set_;
  const Site& site_;
  ReadingMemory& memory_;
  std::vector<double> constants_;
  std::vector<std::size_t> missing_;
};

}  // namespace shadefit::lint
