#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

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

/// The text of a document with the digest of its other fields.
inline std::string signed_text(nlohmann::ordered_json json) {
  if (json.is_object()) {
    json.erase(digest_field);
    json[digest_field] = digest_of(json);
  }
  return json.dump();
}

}  // namespace shadefit::testing
