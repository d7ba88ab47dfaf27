#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace shadefit {

/// The name that a misspelled one probably means: the nearest of `known`, by how many letters are added,
/// missing, other or exchanged. Empty if it does not share at least half of its letters.
std::optional<std::string> nearest_name(std::string_view misspelled, std::span<const std::string> known);

}  // namespace shadefit
