#pragma once

#include <string>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::bench {

/// Time and host of the run, for people who compare files; nothing else depends on it.
struct Occasion {
  std::string date;  ///< ISO 8601
  std::string host;
  std::string executable;
};

Occasion this_occasion();

/// The times as Google Benchmark's --benchmark_format=json writes them, with its aggregates, so that its
/// tools/compare.py reads them. An iteration is a thousand elements; times are in nanoseconds.
std::string google_json(const Trade& trade, const Occasion& occasion);

/// "schlick/multiplications/float/avx2/L1", the name of a row there.
std::string benchmark_name(const TimedForm& timed);

}  // namespace shadefit::bench
