#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fit/better/fit_extras.hpp"
#include "reports/io/writers.hpp"

/// Rounded constants, as rows and as JSON.
namespace shadefit {

/// A bound with so many digits, rounded up, so that the printed number is a bound too.
Cell at_most(double bound, int digits = 6);

/// Holds the rounded constants of a fit, or the reason why it has none, and the names of what it fits.
struct RoundedSets {
  std::optional<RoundedStudy> rounded = {};
  std::string reason = {};  ///< empty: nobody asked for them
  std::string error = {};   ///< "max abs error"
  std::vector<std::string> parameters = {}, variables = {};
  std::vector<std::pair<std::string, Cell>> given = {};  ///< the given constants with their values
};

/// For a terminal: the best constants of the format, the fitted and the published ones rounded, for each fit
/// that has them; the meaning of their errors, and the constants among which the best were searched.
std::string roundings_text(const std::vector<RoundedSets>& all, const Terminal& terminal);

/// Writes one of them as an object, for the `rounded` or `evaluated` of a fit's JSON. Writes null if it has
/// none.
nlohmann::ordered_json rounding_json(const RoundedSets& of);

}  // namespace shadefit
