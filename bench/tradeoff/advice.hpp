#pragma once

#include <string>

#include "bench/tradeoff/trade.hpp"

/// Advice in words: when to use which form.
namespace shadefit::bench {

/// The bottleneck of a form, its loads and stores or its computation, and the remaining difference with data
/// in memory.
std::string bound_of(const Trade& trade, const TimedForm& timed);

/// One line of a list for each form on the front of a target, from the least exact on: "Up to an error of E
/// ..".
std::string advice(const Trade& trade, const std::string& target);

}  // namespace shadefit::bench
