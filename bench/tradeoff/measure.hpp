#pragma once

#include <functional>
#include <memory>
#include <string>

#include "bench/tradeoff/timing.hpp"
#include "bench/tradeoff/trade.hpp"

/// Times forms on this processor.
namespace shadefit::bench {

/// Rounds and visits of a whole bench, and of a quick one, below 5 s.
inline constexpr TimingPlan full_plan{21, 5e-4}, quick_plan{5, 2e-5};

/// C code for the function exp2_degree_N of a float: `exp2_polynomial` of that degree, for float.
std::string exp2_in_c(int degree);

/// Functions in C, compiled and loaded as long as someone holds them: `dlsym` finds them. The compiler is the
/// one that the variable CC names, otherwise `cc`. It optimises one number at a time, without fused
/// multiply-adds. Throws UserError if it cannot compile.
std::shared_ptr<void> compiled_code(const std::string& source);

/// Times every form in float, one number at a time: compiles the C code that `emit` writes for it, and runs
/// it over an array in the first cache. All forms of one shape share one time. `between` receives the
/// finished share. Throws UserError if no C compiler works.
Trade measure(Trade trade, const TimingPlan& plan, const std::function<void(double)>& between);

}  // namespace shadefit::bench
