#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/catalogue/study_file.hpp"

/// The published constants of the families, in studies/catalogue.
namespace shadefit {

/// A mistyped copy of a published number that is in circulation, and where it was seen.
struct Variant {
  std::string printed;
  std::string seen_in;
};

/// The meaning of a published number: the computation that has to reproduce it.
enum class Statement {
  best_fit,       ///< the optimum of its family (at the single number in `exponents`, if the family has an
                  ///< exponent)
  mean_of_fits,   ///< the arithmetic mean of the optima over the sweep `exponents`
  limit_of_fits,  ///< the optimum as the exponent grows without bound
  fit_somewhere,  ///< the optimum at exponents that the source does not state
};

/// A closed form that gives a published number by convention instead of a fit.
struct Convention {
  std::string name = {};     ///< empty if the number has no convention
  std::string formula = {};  ///< as text
  std::optional<double> value = std::nullopt;
};

/// One published constant of a fitted family.
struct Published {
  std::string id;         ///< its name in the ledger, e.g. "sg-offset-k5"
  std::string family;     ///< the family that refits it, e.g. "sg-offset"
  std::string parameter;  ///< which parameter of that family
  std::string printed;    ///< the digits as printed: their number matters
  Statement statement;
  std::string exponents = {};  ///< "5", or a sweep "3:15:1"; empty where the family has none
  Convention convention = {};
  Source source;
  std::vector<Variant> variants = {};
  const PrintedValues* curve = nullptr;  ///< all that its source prints together, in the order of the family
};

/// All of them, in the order of the ledger.
std::span<const Published> published_constants();

/// The constant of that id, or null.
const Published* find_published(std::string_view id);

}  // namespace shadefit
