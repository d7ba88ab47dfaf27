#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "reports/io/digest.hpp"

/// Changed certificates.
namespace shadefit::testing {

/// Calls `visit` with each document that differs from this one in one place, and the place: a value (those
/// that `others_of` gives for it), a member or an element lost, doubled, or exchanged with its neighbour, a
/// member too much. Of long lists, which are those of the boxes, the first and the last elements and one
/// between.
template <class Others, class Visit>
void for_each_mutant(const nlohmann::ordered_json& original, const Others& others_of, const Visit& visit) {
  using Json = nlohmann::ordered_json;
  const auto changed = [&](const Json::json_pointer& at, const auto& change) {
    Json mutant = original;
    change(mutant[at]);
    if (mutant != original) visit(mutant, at.to_string());
  };
  const auto visit_place = [&](const auto& self, const Json::json_pointer& at) -> void {
    const Json& value = original.at(at);
    for (const Json& other : others_of(value)) changed(at, [&](Json& v) { v = other; });
    if (value.is_object()) {
      for (const Json& more : {Json(1), Json("1")}) changed(at, [&](Json& v) { v["x"] = more; });
      for (const auto& [key, member] : value.items()) {
        if (key == digest_field) continue;
        changed(at, [&name = key](Json& v) { v.erase(name); });
        self(self, at / key);
      }
    }
    if (!value.is_array()) return;
    for (const char* word : {"falls with the angle", "rises with the angle", "at most 1", "0x1p-1"})
      changed(at, [&](Json& v) { v.push_back(word); });
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool is_between = i > 1 && i + 2 < value.size() && i != value.size() / 2;
      if (is_between) continue;
      changed(at, [&](Json& v) { v.erase(i); });
      changed(at, [&](Json& v) { v.insert(v.begin() + static_cast<std::ptrdiff_t>(i), Json(v[i])); });
      if (i + 1 < value.size()) changed(at, [&](Json& v) { std::swap(v[i], v[i + 1]); });
      self(self, at / i);
    }
  };
  visit_place(visit_place, Json::json_pointer());
}

/// Other values in the place of one of a certificate: numbers, words of certificates and `words`, texts with
/// another sign, other kinds of values.
inline std::vector<nlohmann::ordered_json> others_of(const nlohmann::ordered_json& value,
                                                     const std::vector<std::string>& words) {
  using Json = nlohmann::ordered_json;
  if (value.is_number_unsigned()) {
    const auto n = value.get<std::int64_t>();
    return {0, -1, n - 1, n + 1, -n, n + (std::int64_t{1} << 32), 1.5, std::to_string(n), nullptr};
  }
  if (!value.is_string()) return {nullptr, Json::array(), Json::object(), 7, "0x1.4p+2"};
  const auto text = value.get<std::string>();
  std::vector<Json> others{"",    "x",        "c",        "0",        "1",      "0.25",
                           "-1",  "absolute", "relative", "0x0p+0",   "0x1p+0", "0x1p+1023",
                           "nan", "(",        text + " ", text + ".", 1,        nullptr};
  others.insert(others.end(), words.begin(), words.end());
  for (const char sign : {'.', '1', '2', '3'}) {
    for (const std::size_t i : {std::size_t{0}, text.size() / 2, std::max<std::size_t>(text.size(), 1) - 1}) {
      std::string other = text;
      if (i < text.size()) other[i] = sign;
      others.emplace_back(other);
      others.emplace_back(text.substr(0, i) + sign + text.substr(std::min(i, text.size())));
    }
  }
  const auto exact = parse_hex(text), number = exact ? exact : parse_number(text);
  if (!number) return others;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double other :
       {-*number, 2 * *number, *number / 2, 1 - *number, 0.99 * *number, 1.01 * *number, *number + 1,
        std::nextafter(*number, infinity), std::nextafter(*number, -infinity)})
    others.emplace_back(hex_text(other));
  const std::size_t end = std::min(text.find('p'), text.size());  // more digits than a double has
  others.emplace_back(text.substr(0, end) + (text.find('.') == std::string::npos ? "." : "") +
                      "7fffffffffffff" + text.substr(end));
  return others;
}

/// The text of a document with the digest of its other fields.
inline std::string signed_text(nlohmann::ordered_json json) {
  if (json.is_object()) {
    json.erase(digest_field);
    json[digest_field] = digest_of(json);
  }
  return json.dump();
}

}  // namespace shadefit::testing
