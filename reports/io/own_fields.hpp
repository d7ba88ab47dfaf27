#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"

namespace shadefit {

/// The fields of a JSON file that shadefit wrote, or of an object in one. Every function throws UserError if
/// a field breaks its rule, with one line that names the file, the field and the rule. Refers to the JSON.
class OwnFields {
 public:
  using Json = nlohmann::ordered_json;

  /// Every message begins with `file`: "certificate 'a.json'".
  OwnFields(const Json& json, std::string file) : json_(json), file_(std::move(file)) {}

  [[noreturn]] void fail(std::string_view key, std::string_view rule) const {
    throw UserError(fmt::format("{}: the field '{}' {}", file_, key, rule));
  }

  const Json& field(const char* key) const {
    if (!has(key)) fail(key, "is missing");
    return json_.at(key);
  }
  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  /// The fields of an object that is a field itself, or an element of one.
  OwnFields inner(const char* key) const { return item(field(key)); }
  OwnFields item(const Json& json) const { return {json, file_}; }

  const Json& list(const char* key) const {
    if (!field(key).is_array()) fail(key, "is not a list");
    return field(key);
  }
  std::string text(const char* key) const { return text_of(field(key), key); }
  std::string text_of(const Json& json, const char* key) const {
    if (!json.is_string()) fail(key, "is not a text");
    return json.get<std::string>();
  }

  std::vector<std::string> texts(const char* key) const {
    std::vector<std::string> values;
    for (const Json& item : list(key)) values.push_back(text_of(item, key));
    return values;
  }
  /// The members of an object of texts.
  std::vector<std::pair<std::string, std::string>> members(const char* key) const {
    if (!field(key).is_object()) fail(key, "is not an object");
    std::vector<std::pair<std::string, std::string>> texts;
    for (const auto& [name, value] : field(key).items()) texts.emplace_back(name, text_of(value, key));
    return texts;
  }
  /// What a text stands for.
  template <class T>
  T choice(const char* key, const std::vector<std::pair<std::string_view, T>>& known) const {
    for (const auto& [name, value] : known) {
      if (name == text(key)) return value;
    }
    fail(key, "is unknown: '" + text(key) + "'");
  }

  /// A whole number >= 0.
  int whole(const char* key) const {
    constexpr auto most = std::uint64_t{std::numeric_limits<int>::max()};
    if (!field(key).is_number_unsigned() || field(key).get<std::uint64_t>() > most)
      fail(key, fmt::format("is not a whole number from 0 to {}", most));
    return field(key).get<int>();
  }

  /// A double that is written as `hex_text` writes it.
  double number(const char* key) const { return number_of(field(key), key); }
  double number_of(const Json& json, const char* key) const {
    const std::string text = text_of(json, key);
    const auto value = parse_hex(text);
    if (!value)
      fail(key, fmt::format("holds '{}', which is not a hexadecimal double as shadefit prints it", text));
    return *value;
  }
  std::vector<double> numbers(const char* key) const {
    std::vector<double> values;
    for (const Json& item : list(key)) values.push_back(number_of(item, key));
    return values;
  }

  /// A pair of such numbers.
  std::pair<double, double> interval(const char* key) const {
    if (list(key).size() != 2) fail(key, "is not a pair");
    const std::vector<double> ends = numbers(key);
    return {ends.front(), ends.back()};
  }

  /// Refuses a file of another kind, or of another version of it.
  void require_kind(std::string_view kind, int schema) const {
    if (text("file") != kind) fail("file", fmt::format("does not say '{}'", kind));
    if (const int found = whole("schema"); found != schema) {
      throw UserError(
          fmt::format("{} is of version {}: this shadefit reads version {}", file_, found, schema));
    }
  }

  /// What is wrong with the digest, in words; empty if nothing is.
  std::string fault_of_digest() const {
    const std::string stated = text(digest_field), digest = digest_of(json_);
    return stated == digest ? ""
                            : fmt::format(
                                  "its digest is {}, that of its fields is {}: it was changed after it "
                                  "was written",
                                  stated, digest);
  }

  /// Refuses a field that differs from `written`, the output of shadefit for the data that was read. The
  /// digest is checked separately.
  void require_written_as(const Json& written) const {
    for (const auto& [key, value] : json_.items()) {
      const auto found = written.find(key);
      if (key != digest_field && (found == written.end() || *found != value))
        fail(key, "is unknown, or not as shadefit writes it");
    }
  }

 private:
  const Json& json_;
  std::string file_;
};

}  // namespace shadefit
