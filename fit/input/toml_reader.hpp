#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fit/support/nearest.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {

/// Takes the values of a TOML file; what it refuses is refused with the name of the file and the line.
class TomlReader {
 public:
  /// The name is that of messages: "study 'line.toml'".
  explicit TomlReader(std::string name) : name_(std::move(name)) {}

  /// The whole file.
  toml::table parse(const std::string& text) const {
    try {
      return toml::parse(text);
    } catch (const toml::parse_error& error) {
      fail(static_cast<long>(error.source().begin.line), std::string(error.description()));
    }
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& rule) const {
    fail(static_cast<long>(node.source().begin.line), rule);
  }
  [[noreturn]] void fail(long line, const std::string& rule) const {
    throw UserError(fmt::format("{}, line {}: {}", name_, line, rule));
  }

  /// What `parse` makes of a text, its refusals with the line of the node.
  template <class Parse>
  auto parsed(const toml::node& node, const Parse& parse) const {
    try {
      return parse();
    } catch (const UserError& error) {
      fail(node, error.what());
    }
  }

  std::string text(const toml::node& node, const std::string& key) const {
    if (const auto value = node.value_exact<std::string>()) return *value;
    fail(node, fmt::format("'{}' must be a text in quotes, so that every digit is kept", key));
  }

  const toml::table& table(const toml::node& node, const std::string& key) const {
    if (const toml::table* value = node.as_table()) return *value;
    fail(node, fmt::format("'{}' must be a table", key));
  }

  /// The elements of a key that holds a list; none if the key is missing.
  std::vector<const toml::node*> list(const toml::table& in, const std::string& key) const {
    const toml::node* node = in.get(key);
    if (node == nullptr) return {};
    const toml::array* array = node->as_array();
    if (array == nullptr) fail(*node, fmt::format("'{}' must be a list", key));
    std::vector<const toml::node*> result;
    for (const toml::node& element : *array) result.push_back(&element);
    return result;
  }

  std::string optional(const toml::table& in, const std::string& key,
                       const std::string& otherwise = "") const {
    const toml::node* node = in.get(key);
    return node == nullptr ? otherwise : text(*node, key);
  }
  std::string required(const toml::table& in, const std::string& key) const {
    const toml::node* node = in.get(key);
    if (node == nullptr) fail(in, fmt::format("the key '{}' is missing", key));
    return text(*node, key);
  }

  void require_keys(const toml::table& in, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : in) {
      const std::string word(key.str());
      if (std::find(known.begin(), known.end(), word) != known.end()) continue;
      const auto nearest = nearest_name(word, known);
      fail(node, fmt::format("unknown key '{}': {}", word,
                             nearest ? fmt::format("did you mean '{}'?", *nearest)
                                     : fmt::format("it must be one of {}", fmt::join(known, ", "))));
    }
  }

  /// The keys of a table with their values, in the order of the file.
  std::vector<std::pair<std::string, const toml::node*>> in_order(const toml::table& in) const {
    std::vector<std::pair<std::string, const toml::node*>> result;
    for (const auto& [key, node] : in) result.emplace_back(key.str(), &node);
    const auto place = [](const auto& entry) {
      const auto begin = entry.second->source().begin;
      return std::pair(begin.line, begin.column);
    };
    std::ranges::sort(result, {}, place);
    return result;
  }

 private:
  std::string name_;
};

}  // namespace shadefit
