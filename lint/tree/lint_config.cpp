#include "lint/tree/lint_config.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include "fit/input/bounded_file.hpp"

#include "fit/catalogue/toml_reader.hpp"
#include "fit/support/nearest.hpp"
#include "lint/tree/git_files.hpp"

namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;

/// Far more than a person writes. toml++ takes some hundred bytes for each value.
constexpr std::uintmax_t most_config_bytes = 1 << 18;

std::string word_of(const TomlReader& reader, const toml::node& node, const std::string& key) {
  const auto word = node.value_exact<std::string>();
  if (!word) reader.fail(node, fmt::format("'{}' must be a text in quotes", key));
  // A path with a byte 0 would be cut there.
  if (word->empty() || word->find('\0') != std::string::npos)
    reader.fail(node, fmt::format("'{}' is empty or has a byte 0", key));
  return *word;
}

std::vector<std::string> words_of(const TomlReader& reader, const toml::table& in, const std::string& key) {
  std::vector<std::string> words;
  for (const toml::node* node : reader.list(in, key)) words.push_back(word_of(reader, *node, key));
  return words;
}

/// One of the words that a key may have.
std::string choice_of(const TomlReader& reader, const toml::node& node, const std::string& key,
                      const std::vector<std::string>& known) {
  const std::string word = word_of(reader, node, key);
  if (std::ranges::find(known, word) != known.end()) return word;
  const auto nearest = nearest_name(word, known);
  reader.fail(node, fmt::format("{} '{}' is unknown: {}", key, word,
                                nearest ? fmt::format("did you mean '{}'?", *nearest)
                                        : fmt::format("it must be one of {}", fmt::join(known, ", "))));
}

double effect_of(const TomlReader& reader, const toml::node& node) {
  const auto number = node.value<double>();
  if (!node.is_number() || !number) reader.fail(node, "'max-effect' must be a number");
  if (!(*number >= 0 && std::isfinite(*number)))
    reader.fail(node, fmt::format("max-effect {} must be at least 0 and finite", *number));
  return *number;
}

std::vector<std::string> language_names() {
  std::vector<std::string> names;
  for (const SourceLanguage language : source_languages) names.emplace_back(name(language));
  return names;
}

}  // namespace

LintConfig read_lint_config(const std::string& text, const fs::path& file,
                            const std::vector<std::string>& verdicts) {
  const TomlReader reader("'" + file.string() + "'");
  const toml::table whole = reader.parse(text);
  reader.require_keys(whole, {"lint"});
  LintConfig config{.file = file};
  const toml::node* found = whole.get("lint");
  if (found == nullptr) return config;
  const toml::table& table = reader.table(*found, "lint");
  reader.require_keys(table, {"exclude", "languages", "fail-on", "max-effect", "baseline", "paths"});
  config.exclude = words_of(reader, table, "exclude");
  for (const toml::node* node : reader.list(table, "languages"))
    config.languages.push_back(*language_named(choice_of(reader, *node, "languages", language_names())));
  if (const toml::node* node = table.get("fail-on"))
    config.fail_on = choice_of(reader, *node, "fail-on", verdicts);
  if (const toml::node* node = table.get("max-effect")) config.max_effect = effect_of(reader, *node);
  const auto from_here = [&](const std::string& path) { return (file.parent_path() / path).string(); };
  if (const toml::node* node = table.get("baseline"))
    config.baseline = from_here(word_of(reader, *node, "baseline"));
  for (const std::string& path : words_of(reader, table, "paths")) config.paths.push_back(from_here(path));
  return config;
}

std::optional<LintConfig> find_lint_config(const std::vector<std::string>& verdicts) {
  std::error_code error;
  const fs::path current = fs::current_path(error);
  if (error) return std::nullopt;
  const fs::path last = repository_of(current).value_or(current);
  fs::path file = lint_config_name;
  for (fs::path at = current;; at = at.parent_path(), file = ".." / file) {
    // Not its absolute path: messages and reports name files as seen from here.
    if (fs::exists(fs::symlink_status(file, error)))
      return read_lint_config(read_bounded(file, most_config_bytes), file, verdicts);
    if (at == last) return std::nullopt;
  }
}

}  // namespace shadefit::lint
