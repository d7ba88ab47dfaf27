#include "fit/catalogue/toml_reader.hpp"

#include <algorithm>

#include "fit/support/format.hpp"
#include "fit/support/nearest.hpp"

namespace shadefit {

toml::table TomlReader::parse(const std::string& text) const {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    fail(static_cast<long>(error.source().begin.line), std::string(error.description()));
  }
}

void TomlReader::fail(const toml::node& node, const std::string& rule) const {
  fail(static_cast<long>(node.source().begin.line), rule);
}

void TomlReader::fail(long line, const std::string& rule) const {
  throw UserError(fmt::format("{}, line {}: {}", name_, line, rule));
}

std::string TomlReader::text(const toml::node& node, const std::string& key) const {
  if (const auto value = node.value_exact<std::string>()) return *value;
  fail(node, fmt::format("'{}' must be a text in quotes, so that every digit is kept", key));
}

const toml::table& TomlReader::table(const toml::node& node, const std::string& key) const {
  if (const toml::table* value = node.as_table()) return *value;
  fail(node, fmt::format("'{}' must be a table", key));
}

std::vector<const toml::node*> TomlReader::list(const toml::table& in, const std::string& key) const {
  const toml::node* node = in.get(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr) fail(*node, fmt::format("'{}' must be a list", key));
  std::vector<const toml::node*> result;
  for (const toml::node& element : *array) result.push_back(&element);
  return result;
}

std::string TomlReader::optional(const toml::table& in, const std::string& key,
                                 const std::string& otherwise) const {
  const toml::node* node = in.get(key);
  return node == nullptr ? otherwise : text(*node, key);
}

std::string TomlReader::required(const toml::table& in, const std::string& key) const {
  const toml::node* node = in.get(key);
  if (node == nullptr) fail(in, fmt::format("the key '{}' is missing", key));
  return text(*node, key);
}

bool TomlReader::flag(const toml::table& in, const std::string& key) const {
  const toml::node* node = in.get(key);
  if (node == nullptr) return false;
  if (const auto value = node->value_exact<bool>()) return *value;
  fail(*node, fmt::format("the key '{}' must be true or false", key));
}

void TomlReader::require_keys(const toml::table& in, const std::vector<std::string>& known) const {
  for (const auto& [key, node] : in) {
    const std::string word(key.str());
    if (std::ranges::find(known, word) != known.end()) continue;
    const auto nearest = nearest_name(word, known);
    fail(node, fmt::format("unknown key '{}': {}", word,
                           nearest ? fmt::format("did you mean '{}'?", *nearest)
                                   : fmt::format("it must be one of {}", fmt::join(known, ", "))));
  }
}

std::vector<std::pair<std::string, const toml::node*>> TomlReader::in_order(const toml::table& in) const {
  std::vector<std::pair<std::string, const toml::node*>> result;
  for (const auto& [key, node] : in) result.emplace_back(key.str(), &node);
  const auto place = [](const auto& entry) {
    const auto begin = entry.second->source().begin;
    return std::pair(begin.line, begin.column);
  };
  std::ranges::sort(result, {}, place);
  return result;
}

}  // namespace shadefit
