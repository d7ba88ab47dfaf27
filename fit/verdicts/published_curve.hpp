#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/fit.hpp"

/// The numbers that a source prints together as one curve.
namespace shadefit {

/// Every number published for the family.
std::vector<const Published*> numbers_of(const Family& family);

/// The names and digits of the parameters of the published curve that has this number: all that the same
/// source prints together, in the order of the family's names.
std::vector<std::pair<std::string_view, std::string_view>> printed_parameters(const FittableFamily& family,
                                                                              const Published& published);

/// The same as numbers.
std::vector<double> published_parameters(const FittableFamily& family, const Published& published);

}  // namespace shadefit
