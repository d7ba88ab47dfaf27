#pragma once

#include "fit/better/results.hpp"

namespace shadefit::testing {

/// What a run computes without options, once.
inline const Results& all_results() {
  static const Results results = compute_results({});
  return results;
}

}  // namespace shadefit::testing
