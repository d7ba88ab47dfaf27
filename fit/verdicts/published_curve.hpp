#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/fit.hpp"

/// The curve that a source draws with the numbers that it prints together.
namespace shadefit {

/// Every number published for the family.
std::vector<const Published*> numbers_of(const Family& family);

/// Names and digits of the parameters that the published curve of that number has: those that the same source
/// prints together. In the order of the family's names.
std::vector<std::pair<std::string_view, std::string_view>> printed_parameters(const FittableFamily& family,
                                                                              const Published& published);

/// The same as numbers.
std::vector<double> published_parameters(const FittableFamily& family, const Published& published);

}  // namespace shadefit
