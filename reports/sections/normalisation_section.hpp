#pragma once

#include <string>

#include "fit/run/results.hpp"

/// The part of the report on normalisation constants.
namespace shadefit {

/// Each constant and 1 over its integral; the ratio of the cheap to the exact constant over the exponent.
std::string normalisation_section(const Results& results);

}  // namespace shadefit
