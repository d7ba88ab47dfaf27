#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/timing/timing.hpp"
#include "bench/tradeoff/trade.hpp"
#include "reports/table/table.hpp"

/// From the catalogue of forms to times.
namespace shadefit::bench {

/// The largest absolute error of a form in a precision, where it is known.
struct FormError {
  std::string target, form, constants;
  int exp2_degree = 0;
  bool is_double = false;
  double max_abs_error = 0;
};

/// The errors in float and in double that the table of accuracies has: those of SSE2 where they differ from
/// the scalar ones.
std::vector<FormError> form_errors(const Table& accuracy);

struct Wanted {
  std::vector<std::string> targets;  ///< ids; empty: all
  std::vector<forms::Width> widths;  ///< that this machine has
  Plan plan;
  /// Long arrays take a system seconds to make: only those of cosines, in float.
  bool has_little_memory = false;
};

/// Rounds and visits of a whole bench, well below 90 s, and of a quick one, below 5 s.
inline constexpr Plan full_plan{21, 5e-4}, quick_plan{5, 2e-5};

/// The compiled forms of a width that this machine has.
std::vector<forms::CompiledForm> compiled_for(forms::Width width);

/// Times every form that is wanted, and joins what is known of its errors to it: one row for each set of
/// constants, of which a kernel's time does not depend. `between` is told the share that is done.
Trade measure(const forms::Catalogue& catalogue, const std::vector<FormError>& errors, const Wanted& wanted,
              const Clock& clock, const std::function<void(double)>& between);

}  // namespace shadefit::bench
