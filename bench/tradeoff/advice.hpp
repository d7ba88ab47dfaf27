#pragma once

#include <string>

#include "bench/tradeoff/trade.hpp"

/// What to use when, in words.
namespace shadefit::bench {

/// What holds a form up: its loads and stores, or what it computes; and what is left of that in memory.
std::string bound_of(const Trade& trade, const TimedForm& timed);

/// One line of a list for each form on the front of a target, from the least exact on: "Up to an error of E
/// ..".
std::string advice(const Trade& trade, const std::string& target);

}  // namespace shadefit::bench
