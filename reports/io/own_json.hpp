#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"

/// Reads JSON files that shadefit wrote. A value that breaks a rule throws std::invalid_argument, or an
/// exception of nlohmann::json; `read_own` makes one line of either.
namespace shadefit {

using OwnJson = nlohmann::ordered_json;

/// What `read` returns. Throws UserError that begins with `file`, "certificate 'a.json'", if it refuses.
template <class Read>
auto read_own(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const OwnJson::exception& error) {
    const std::string_view words(error.what());  // "[json.exception.out_of_range.403] key 'a' not found"
    throw UserError(fmt::format("{}: {}", file, words.substr(words.find(']') + 2)));
  } catch (const std::invalid_argument& error) {
    throw UserError(fmt::format("{}: {}", file, error.what()));
  }
}

/// A double that is written as `hex_text` writes it.
inline double own_number(const OwnJson& json) {
  const auto text = json.get<std::string>();
  const auto value = parse_hex(text);
  if (!value)
    throw std::invalid_argument(fmt::format("'{}' is not a hexadecimal double as shadefit prints it", text));
  return *value;
}

inline std::vector<double> own_numbers(const OwnJson& list) {
  std::vector<double> values;
  for (const OwnJson& item : list) values.push_back(own_number(item));
  return values;
}

/// A pair of such numbers.
inline std::pair<double, double> own_interval(const OwnJson& list) {
  const std::vector<double> ends = own_numbers(list);
  if (ends.size() != 2) throw std::invalid_argument("an interval is not a pair");
  return {ends.front(), ends.back()};
}

/// A whole number >= 0.
inline int own_whole(const OwnJson& json) {
  constexpr auto most = std::uint64_t{std::numeric_limits<int>::max()};
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > most)
    throw std::invalid_argument(fmt::format("{} is not a whole number from 0 to {}", json.dump(), most));
  return json.get<int>();
}

/// What a text stands for.
template <class T>
T own_choice(const OwnJson& json, const std::vector<std::pair<std::string_view, T>>& known) {
  const auto text = json.get<std::string>();
  for (const auto& [name, value] : known) {
    if (name == text) return value;
  }
  throw std::invalid_argument("'" + text + "' is unknown");
}

/// The members of an object of texts.
inline std::vector<std::pair<std::string, std::string>> own_members(const OwnJson& object) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& [name, value] : object.items()) texts.emplace_back(name, value.get<std::string>());
  return texts;
}

/// Refuses a file of another kind, or of another version of it.
inline void require_kind(const OwnJson& json, std::string_view kind, int schema) {
  if (json.at("file") != kind) throw std::invalid_argument(fmt::format("'file' does not say '{}'", kind));
  if (const int found = own_whole(json.at("schema")); found != schema)
    throw std::invalid_argument(fmt::format("version {}: this shadefit reads version {}", found, schema));
}

/// What is wrong with the digest, in words; empty if nothing is.
inline std::string fault_of_digest(const OwnJson& json) {
  const auto stated = json.at(digest_field).get<std::string>(), digest = digest_of(json);
  if (stated == digest) return "";
  return fmt::format("its digest is {}, that of its fields is {}: it was changed after it was written",
                     stated, digest);
}

/// Refuses a field that differs from `written`, the output of shadefit for the data that was read. The digest
/// is checked separately.
inline void require_written_as(const OwnJson& json, const OwnJson& written) {
  for (const auto& [key, value] : json.items()) {
    const auto found = written.find(key);
    if (key != digest_field && (found == written.end() || *found != value))
      throw std::invalid_argument("'" + key + "' is unknown, or not as shadefit writes it");
  }
}

}  // namespace shadefit
