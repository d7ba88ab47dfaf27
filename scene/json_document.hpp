#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

/// JSON of others, parsed within bounds.
namespace shadefit::scene {

/// Values may lie this deep in each other. What glTF itself defines needs 10.
inline constexpr int most_json_depth = 64;

/// So many values are kept: each takes 16 to 100 bytes, however short its text.
inline constexpr std::size_t most_json_values = 4'000'000;

/// The document without the members that `is_kept` refuses by their name, at any depth. Of members of one
/// name the last counts. Time and memory grow with the text alone. Throws UserError with line and column:
/// malformed, deeper than `most_json_depth`, more than `most_json_values`, a number beyond double precision.
nlohmann::json parse_json(std::string_view text, const std::string& file,
                          bool (*is_kept)(std::string_view key));

}  // namespace shadefit::scene
