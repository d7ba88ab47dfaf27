#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fit/rounding/rounded_set.hpp"
#include "reports/io/writers.hpp"

/// Rounded constants, as rows and as JSON.
namespace shadefit {

/// A bound with so many digits, rounded up, so that the printed number is a bound too.
Cell at_most(double bound, int digits = 6);

/// Holds the rounded constants of a fit, or the reason why it has none, and the names of what it fits.
struct RoundedSets {
  std::optional<RoundedStudy> rounded = {};
  std::string reason = {};  ///< empty: it has them, or nobody asked
  std::string error = {};   ///< "max abs error"
  std::vector<std::string> parameters = {}, variables = {};
  std::vector<std::pair<std::string, Cell>> given = {};  ///< the given constants with their values
};

/// For a terminal: the best constants of the format, the fitted and the published ones rounded, for each fit
/// that has them; the meaning of their errors, and the constants among which the best were searched.
std::string roundings_text(const std::vector<RoundedSets>& all, const Terminal& terminal);

/// Adds one of them to the JSON of a fit, as `rounded` or `evaluated`: an object, or null and the reason.
void add_rounding(nlohmann::ordered_json& json, const std::string& key, const RoundedSets& of);

}  // namespace shadefit
