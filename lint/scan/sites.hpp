#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "lint/scan/digit_index.hpp"

/// Places in a source text that hold the constants of a set.
namespace shadefit::lint {

/// A number of a text that stands for a constant of a set.
struct SiteNumber {
  std::size_t literal = 0;   ///< its index among the literals of the text
  std::size_t constant = 0;  ///< of the set
  DigitMatch match = DigitMatch::same;
  std::optional<std::size_t> variant = {};
  std::size_t repeats = 0;  ///< literals directly before it with the same digits: the components of a vector
};

/// Numbers near each other for constants of one set, each constant once, by their places in the text.
struct Site {
  std::size_t set = 0;
  std::vector<SiteNumber> numbers;
  /// How much evidence the numbers are: -log2 of the chance that as many numbers at random places agree as
  /// well.
  double bits = 0;
};

/// Whether the decimal points of several numbers are shifted: then they are in other units, such as 1000
/// kelvin, and right.
bool is_in_other_units(const Site& site);

/// The indices of the set's constants that are not at the site.
std::vector<std::size_t> missing_constants(const KnownSet& set, const Site& site);

/// Sites with at least this many bits need no other evidence. A tree of 10 000 files has some 2^22 numbers,
/// and there are some 2^8 sets of constants.
inline constexpr double telling_bits = 24;

/// With fewer bits the expression around a site is not read.
inline constexpr double least_bits = 6;

/// How much of a set's form the text around a site contains.
struct Reading {
  enum class Part {
    nothing,
    branch,  ///< one branch of its choice
    form,    ///< the whole form
  };
  Part part = Part::nothing;
  std::size_t constants = 0;  ///< how many constants of the set are there, right or wrong
};

/// Reads the text around a site.
using ReadSite = std::function<Reading(const Site&)>;

/// All sites of at least `least_bits`, by their places. If two sites have most of their numbers in common,
/// the one whose form is read better is kept, if it has as many constants; otherwise the more telling one.
std::vector<Site> sites_of(const ScannedText& text, const std::vector<KnownSet>& sets,
                           const DigitIndex& index, const ReadSite& read);

/// Where functions begin, in rising order: after `def`, `fn`, `func` and `function`, and at the name of
/// "float f(float x) {" unless it is a keyword such as if or for.
std::vector<std::size_t> function_begins(std::string_view text);

/// The sites to keep, by their places, of those that have numbers in common: see `sites_of`.
std::vector<Site> chosen_sites(std::vector<Site> sites, const ReadSite& read);

/// How much evidence the numbers of a site are: see `Site::bits`. What counts: the digits of each number, its
/// place among the other numbers, and the published order.
double bits_of(const ScannedText& text, const KnownSet& set, const Site& site);

}  // namespace shadefit::lint
