#pragma once

#include <string>
#include <string_view>

/// Differences of texts, for people and for `git apply`.
namespace shadefit {

/// The unified diff of two texts with the same number of lines, with three lines of context, as git prints
/// it: the names behind a/ and b/, or as they are where they are absolute. Empty where the texts are equal.
std::string unified_diff(const std::string& name, std::string_view before, std::string_view after);

}  // namespace shadefit
