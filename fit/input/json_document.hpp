#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

/// JSON from files, parsed strictly and within limits.
namespace shadefit {

/// The largest depth. glTF needs 10, our own files need 3.
inline constexpr int most_json_depth = 64;

/// The largest number of values: each takes 16 to 100 bytes, even if its text is short.
inline constexpr std::size_t most_json_values = 4'000'000;

/// The largest number of members in an object of our own files, because they are searched one after the
/// other. A certificate has the most.
inline constexpr std::size_t most_own_members = 64;

/// The document without the members whose names `is_kept` refuses, at any depth. Time and memory are
/// proportional to the text. Throws UserError, with line and column where possible: malformed, ends early, a
/// byte 0, invalid UTF-8, text after the document, deeper than `most_json_depth`, more than
/// `most_json_values`, a number beyond double precision, two kept members of one name.
nlohmann::json parse_json(std::string_view text, const std::string& file,
                          bool (*is_kept)(std::string_view key));

/// The same for a file of shadefit's own: all members, in their order, at most `most_own_members` in an
/// object. Every message begins with `file`: "certificate 'a.json'".
nlohmann::ordered_json parse_own_json(std::string_view text, const std::string& file);

}  // namespace shadefit
