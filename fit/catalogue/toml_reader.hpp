#pragma once

#include <toml++/toml.h>
#include <string>
#include <utility>
#include <vector>

#include "fit/support/user_error.hpp"

namespace shadefit {

/// Takes the values of a TOML file; what it refuses is refused with the name of the file and the line.
class TomlReader {
 public:
  /// The name is that of messages: "study 'line.toml'".
  explicit TomlReader(std::string name) : name_(std::move(name)) {}

  /// The whole file.
  toml::table parse(const std::string& text) const;

  [[noreturn]] void fail(const toml::node& node, const std::string& rule) const;
  [[noreturn]] void fail(long line, const std::string& rule) const;

  /// What `parse` makes of a text, its refusals with the line of the node.
  template <class Parse>
  auto parsed(const toml::node& node, const Parse& parse) const {
    try {
      return parse();
    } catch (const UserError& error) {
      fail(node, error.what());
    }
  }

  std::string text(const toml::node& node, const std::string& key) const;
  const toml::table& table(const toml::node& node, const std::string& key) const;

  /// The elements of a key that holds a list; none if the key is missing.
  std::vector<const toml::node*> list(const toml::table& in, const std::string& key) const;

  std::string optional(const toml::table& in, const std::string& key,
                       const std::string& otherwise = "") const;
  std::string required(const toml::table& in, const std::string& key) const;
  bool flag(const toml::table& in, const std::string& key) const;  ///< false if the key is missing

  void require_keys(const toml::table& in, const std::vector<std::string>& known) const;

  /// The keys of a table with their values, in the order of the file.
  std::vector<std::pair<std::string, const toml::node*>> in_order(const toml::table& in) const;

 private:
  std::string name_;
};

}  // namespace shadefit
