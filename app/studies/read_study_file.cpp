#include "app/studies/read_study_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>

#include "app/options/study_options.hpp"
#include "fit/support/nearest.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

constexpr int study_schema = 1;

/// The file being read, for messages.
class Reader {
 public:
  explicit Reader(const std::string& name) : name_(printable(name)) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& rule) const {
    fail(static_cast<long>(node.source().begin.line), rule);
  }
  [[noreturn]] void fail(long line, const std::string& rule) const {
    throw UserError(fmt::format("study '{}', line {}: {}", name_, line, one_line(rule)));
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
    std::sort(result.begin(), result.end(),
              [&](const auto& a, const auto& b) { return place(a) < place(b); });
    return result;
  }

  /// A table of texts.
  PrintedValues texts(const toml::table& in) const {
    PrintedValues result;
    for (const auto& [key, node] : in_order(in)) result.emplace_back(key, text(*node, key));
    return result;
  }

 private:
  std::string name_;
};

void read_over(const Reader& reader, const toml::table& over, Study& study) {
  for (const auto& [variable, node] : reader.in_order(over)) {
    std::string range, density = "1";
    if (const toml::table* table = node->as_table()) {
      reader.require_keys(*table, {"range", "density"});
      range = reader.required(*table, "range");
      density = density_of(reader.optional(*table, "density", "1"), variable);
    } else {
      range = reader.text(*node, variable);
    }
    // The range of measured rows is empty.
    study.over.push_back(reader.parsed(*node, [&, &name = variable] {
      return parse_over("over", range.empty() ? name : name + "=" + range);
    }));
    if (density != "1") study.over.back().density = density;
  }
}

void read_definitions(const Reader& reader, const toml::table& let, Study& study) {
  for (const auto& [name, node] : reader.in_order(let)) {
    const toml::table* table = node->as_table();
    if (table == nullptr) {
      study.definitions.push_back({name, {}, reader.text(*node, name)});
      continue;
    }
    reader.require_keys(*table, {"of", "is"});
    StudyDefinition definition{name, {}, reader.required(*table, "is")};
    for (const toml::node* argument : reader.list(*table, "of"))
      definition.arguments.push_back(reader.text(*argument, "of"));
    study.definitions.push_back(definition);
  }
}

double number(const Reader& reader, const toml::node& node, const std::string& key) {
  if (const auto value = node.value<double>()) return *value;
  const std::string text = reader.text(node, key);
  if (const auto value = parse_number(text)) return *value;
  reader.fail(node, fmt::format("{} '{}' is not a finite number", key, text));
}

/// The value that has the text as its name.
template <class T, std::size_t N>
T choice(const Reader& reader, const toml::node& node, const std::string& key,
         const std::array<T, N>& values) {
  const std::string word = reader.text(node, key);
  std::vector<std::string_view> words;
  for (const T& value : values) {
    if (name(value) == word) return value;
    words.push_back(name(value));
  }
  reader.fail(node,
              fmt::format("{} '{}' is unknown: it must be one of {}", key, word, fmt::join(words, ", ")));
}

void read_metric(const Reader& reader, const toml::table& metric, StudyFile& file) {
  reader.require_keys(
      metric, {"norm", "error", "weight", "exact_at", "one_sided", "at_most", "at_least", "monotone"});
  const auto with = [&](const char* key, const auto& use) {
    if (const toml::node* node = metric.get(key)) use(*node, key);
  };
  with("norm", [&](const toml::node& node, const char* key) {
    file.norm = choice(reader, node, key, std::array{Norm::least_squares, Norm::minimax});
  });
  with("error", [&](const toml::node& node, const char* key) {
    file.study.error = choice(reader, node, key, std::array{Error::absolute, Error::relative});
  });
  file.study.weight = reader.optional(metric, "weight", "1");
  file.has_weight = metric.contains("weight");
  Constraints& constraints = file.constraints;
  for (const toml::node* place : reader.list(metric, "exact_at"))
    constraints.exact_at.push_back(number(reader, *place, "exact_at"));
  with("one_sided", [&](const toml::node& node, const char* key) {
    constraints.one_sided = choice(reader, node, key, std::array{Side::above, Side::below});
  });
  with("at_most",
       [&](const toml::node& node, const char* key) { constraints.at_most = number(reader, node, key); });
  with("at_least",
       [&](const toml::node& node, const char* key) { constraints.at_least = number(reader, node, key); });
  with("monotone", [&](const toml::node& node, const char* key) {
    constraints.monotone = choice(reader, node, key, std::array{Course::falls, Course::rises});
  });
}

/// One claim for each error that the table states.
std::vector<ErrorClaim> read_claims(const Reader& reader, const toml::table& table) {
  std::vector<std::string> keys{"says"};
  for (const StatedError error : stated_errors) keys.emplace_back(name(error));
  reader.require_keys(table, keys);
  std::vector<ErrorClaim> claims;
  for (const StatedError error : stated_errors) {
    const std::string key(name(error)), printed = reader.optional(table, key);
    if (table.get(key) == nullptr) continue;
    if (!parse_number(printed)) reader.fail(table, fmt::format("{} '{}' is not a number", key, printed));
    claims.push_back({error, printed, reader.optional(table, "says")});
  }
  if (claims.empty())
    reader.fail(table,
                fmt::format("a claim states one of {}", fmt::join(keys.begin() + 1, keys.end(), ", ")));
  return claims;
}

PublishedSet read_published(const Reader& reader, const toml::table& table,
                            const std::vector<StudyForm>& forms) {
  reader.require_keys(table, {"form", "given", "values", "source", "where", "claim", "variants"});
  PublishedSet set{.form = reader.optional(table, "form", forms.front().id), .values = {}, .source = {}};
  const bool is_known =
      std::any_of(forms.begin(), forms.end(), [&](const StudyForm& form) { return form.id == set.form; });
  if (!is_known) reader.fail(table, fmt::format("published form '{}' is not the id of a form", set.form));
  const auto values_of = [&](const toml::table& in, const char* key) {
    const toml::node* node = in.get(key);
    return node == nullptr ? PrintedValues{} : reader.texts(reader.table(*node, key));
  };
  set.given = values_of(table, "given");
  set.values = values_of(table, "values");
  if (set.values.empty()) reader.fail(table, "the key 'values' is missing");
  set.source = reader.required(table, "source");
  for (const toml::node* place : reader.list(table, "where"))
    set.where.push_back(reader.text(*place, "where"));
  if (const toml::node* node = table.get("claim"))
    set.claims = read_claims(reader, reader.table(*node, "claim"));
  for (const toml::node* node : reader.list(table, "variants")) {
    toml::table values = reader.table(*node, "variants");
    MistypedCopy copy{{}, reader.required(values, "seen")};
    values.erase("seen");
    copy.values = reader.texts(values);
    set.variants.push_back(copy);
  }
  return set;
}

void read_forms(const Reader& reader, const toml::table& whole, StudyFile& file) {
  for (const toml::node* node : reader.list(whole, "form")) {
    const toml::table& form = reader.table(*node, "form");
    reader.require_keys(form, {"id", "formula"});
    const StudyForm read{reader.required(form, "id"), reader.required(form, "formula")};
    const bool is_there = std::any_of(file.forms.begin(), file.forms.end(),
                                      [&](const StudyForm& other) { return other.id == read.id; });
    if (is_there) reader.fail(form, fmt::format("the form '{}' is there already", read.id));
    file.forms.push_back(read);
  }
  if (file.forms.empty()) reader.fail(whole, "a study needs a [[form]]");
}

toml::table parse_toml(const Reader& reader, const std::string& text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    reader.fail(static_cast<long>(error.source().begin.line), std::string(error.description()));
  }
}

}  // namespace

StudyFile read_study_file(const std::string& text, const std::string& name) {
  const Reader reader(name);
  const toml::table whole = parse_toml(reader, text);
  reader.require_keys(whole, {"schema", "id", "title", "about", "over", "given", "let", "target", "form",
                              "metric", "published"});
  const auto schema = whole["schema"].value<int>();
  if (schema != study_schema) reader.fail(1, fmt::format("the key 'schema' must be {}", study_schema));
  StudyFile file{.id = reader.required(whole, "id"),
                 .title = reader.optional(whole, "title"),
                 .about = reader.optional(whole, "about"),
                 .study = {},
                 .forms = {}};
  // The id is the name of the file, and of the page of the study.
  const bool is_name = file.id != "index" && std::all_of(file.id.begin(), file.id.end(), [](char c) {
                         return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-';
                       });
  if (!is_name)
    reader.fail(1, fmt::format("id '{}' must be small letters, digits and '-', and not 'index'", file.id));
  const auto part = [&](const char* key) -> const toml::table* {
    const toml::node* node = whole.get(key);
    return node == nullptr ? nullptr : &reader.table(*node, key);
  };
  const toml::table *over = part("over"), *target = part("target");
  if (over == nullptr) reader.fail(whole, "a study needs [over]");
  if (target == nullptr) reader.fail(whole, "a study needs [target]");
  read_over(reader, *over, file.study);
  reader.require_keys(*target, {"formula", "table"});
  file.table = reader.optional(*target, "table");
  if (file.table.empty()) file.study.target = reader.required(*target, "formula");
  if (!file.table.empty() && target->contains("formula"))
    reader.fail(*target, "a target is a formula or a table, not both");
  if (const toml::table* given = part("given")) {
    for (const auto& [constant, node] : reader.in_order(*given))
      file.given.push_back(reader.parsed(*node, [&, &key = constant, &value = node] {
        return parse_given("given", key + "=" + reader.text(*value, key));
      }));
  }
  if (const toml::table* let = part("let")) read_definitions(reader, *let, file.study);
  read_forms(reader, whole, file);
  if (const toml::table* metric = part("metric")) read_metric(reader, *metric, file);
  for (const toml::node* node : reader.list(whole, "published"))
    file.published.push_back(read_published(reader, reader.table(*node, "published"), file.forms));
  return file;
}

}  // namespace shadefit
