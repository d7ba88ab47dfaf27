#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

/// JSON from files, parsed within bounds and without a doubt about what it says.
namespace shadefit {

/// Values may lie this deep in each other. What glTF itself defines needs 10, our own files 3.
inline constexpr int most_json_depth = 64;

/// So many values are kept: each takes 16 to 100 bytes, however short its text.
inline constexpr std::size_t most_json_values = 4'000'000;

/// So many members may an object of our own files have: they are searched one after the other. A state, which
/// has the most, has 19.
inline constexpr std::size_t most_own_members = 64;

/// The document without the members that `is_kept` refuses by their name, at any depth. Time and memory grow
/// with the text alone. Throws UserError, with line and column where there is one: malformed, ends early, a
/// byte 0, invalid UTF-8, text behind the document, deeper than `most_json_depth`, more than
/// `most_json_values`, a number beyond double precision, two kept members of one name.
nlohmann::json parse_json(std::string_view text, const std::string& file,
                          bool (*is_kept)(std::string_view key));

/// The same of a file that shadefit wrote: all members, in their order, at most `most_own_members` in an
/// object. `file` begins every message: "certificate 'a.json'".
nlohmann::ordered_json parse_own_json(std::string_view text, const std::string& file);

}  // namespace shadefit
