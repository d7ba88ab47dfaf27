#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/tradeoff/trade.hpp"
#include "reports/table/table.hpp"

/// Measures the times of the forms of a catalogue.
namespace shadefit::bench {

/// The largest absolute error of a form in a precision, if known.
struct FormError {
  std::string target, form, constants;
  int exp2_degree = 0;
  bool is_double = false;
  double max_abs_error = 0;
};

/// The errors in float and in double of the accuracy table. If SSE2 differs from scalar, those of SSE2.
std::vector<FormError> form_errors(const Table& accuracy);

struct WantedForms {
  std::vector<std::string> targets;  ///< ids; empty: all
  std::vector<forms::Width> widths;  ///< that this machine has
  TimingPlan plan;
  /// Allocating long arrays can take seconds. If set, only the arrays of cosines in float are long.
  bool has_little_memory = false;
};

/// Rounds and visits of a whole bench, well below 90 s, and of a quick one, below 5 s.
inline constexpr TimingPlan full_plan{21, 5e-4}, quick_plan{5, 2e-5};

/// Times every requested form and adds its known errors: one row for each set of constants. The time of a
/// kernel does not depend on its constants. `between` receives the finished fraction.
Trade measure(const forms::Catalogue& catalogue, const std::vector<FormError>& errors,
              const WantedForms& wanted, const Clock& clock, const std::function<void(double)>& between);

}  // namespace shadefit::bench
