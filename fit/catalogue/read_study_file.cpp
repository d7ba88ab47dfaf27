#include "fit/catalogue/read_study_file.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "fit/catalogue/study_parts.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

constexpr int study_schema = 1;

void read_over(const TomlReader& reader, const toml::table& over, Study& study) {
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

void read_definitions(const TomlReader& reader, const toml::table& let, Study& study) {
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

double number(const TomlReader& reader, const toml::node& node, const std::string& key) {
  if (const auto value = node.value<double>()) return *value;
  const std::string text = reader.text(node, key);
  if (const auto value = parse_number(text)) return *value;
  reader.fail(node, fmt::format("{} '{}' is not a finite number", key, text));
}

/// The value that has the text as its name.
template <class T, std::size_t N>
T choice(const TomlReader& reader, const toml::node& node, const std::string& key,
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

void read_metric(const TomlReader& reader, const toml::table& metric, StudyFile& file) {
  reader.require_keys(
      metric, {"norm", "error", "weight", "exact_at", "one_sided", "at_most", "at_least", "monotone"});
  const auto read_choice = [&](const char* key, auto& value, const auto& values) {
    if (const toml::node* node = metric.get(key)) value = choice(reader, *node, key, values);
  };
  const auto read_number = [&](const char* key, std::optional<double>& value) {
    if (const toml::node* node = metric.get(key)) value = number(reader, *node, key);
  };
  read_choice("norm", file.norm, std::array{Norm::least_squares, Norm::minimax});
  read_choice("error", file.study.error, std::array{Error::absolute, Error::relative});
  file.study.weight = reader.optional(metric, "weight", "1");
  file.has_weight = metric.contains("weight");
  Constraints& constraints = file.constraints;
  for (const toml::node* place : reader.list(metric, "exact_at"))
    constraints.exact_at.push_back(number(reader, *place, "exact_at"));
  read_choice("one_sided", constraints.one_sided, std::array{Side::above, Side::below});
  read_number("at_most", constraints.at_most);
  read_number("at_least", constraints.at_least);
  read_choice("monotone", constraints.monotone, std::array{Course::falls, Course::rises});
}

/// Notes the lines of formulas, by which a fault is found.
void note_lines(const toml::table& whole, StudyFile& file) {
  const auto note = [&](const std::string& key, const toml::node* node) {
    if (node != nullptr) file.lines[key] = static_cast<long>(node->source().begin.line);
  };
  for (const char* key : {"over", "given", "let", "bounds"}) {
    const toml::table* part = whole[key].as_table();
    if (part == nullptr) continue;
    for (const auto& [name, node] : *part) note(fmt::format("{} {}", key, name.str()), &node);
  }
  note("over", whole.get("over"));
  note("let", whole.get("let"));
  note("target", whole["target"]["formula"].node());
  note("recompute", whole["target"]["recompute"].node());
  note("table", whole["target"]["table"].node());
  note("weight", whole["metric"]["weight"].node());
  for (std::size_t i = 0; i < file.forms.size(); ++i)
    note("form " + file.forms[i].id, whole["form"][i]["formula"].node());
}

/// The ranges of a claim: of variables of the study, without a density.
std::vector<StudyRange> read_claimed_ranges(const TomlReader& reader, const toml::table& claim,
                                            const std::vector<StudyRange>& own) {
  std::vector<StudyRange> ranges;
  const toml::node* over = claim.get("over");
  if (over == nullptr) return ranges;
  const toml::table& in = reader.table(*over, "over");
  std::vector<std::string> variables;
  for (const StudyRange& range : own) variables.push_back(range.variable);
  reader.require_keys(in, variables);
  for (const auto& [name, node] : reader.in_order(in)) {
    const std::string text = name + "=" + reader.text(*node, name);
    StudyRange range = reader.parsed(*node, [&] { return parse_over("over", text); });
    if (range.density != "1") reader.fail(*node, fmt::format("over '{}' of a claim has no density", text));
    try {
      read_formulas({.target = range.variable, .form = "0", .over = {range}});
    } catch (const StudyFault& fault) {
      reader.fail(*node, "over" + fault.rule);
    }
    ranges.push_back(std::move(range));
  }
  return ranges;
}

/// One claim for each error that the table states.
std::vector<ErrorClaim> read_claim(const TomlReader& reader, const toml::table& table,
                                   const std::vector<StudyRange>& own) {
  std::vector<std::string> keys{"says", "over"};
  for (const StatedError error : stated_errors) keys.emplace_back(name(error));
  reader.require_keys(table, keys);
  std::vector<ErrorClaim> claims;
  for (const StatedError error : stated_errors) {
    const std::string key(name(error)), printed = reader.optional(table, key);
    if (table.get(key) == nullptr) continue;
    const auto stated = parse_number(printed);
    if (!stated) reader.fail(table, fmt::format("{} '{}' is not a number", key, printed));
    if (*stated < 0)
      reader.fail(table, fmt::format("{} '{}' is negative: an error is at least 0", key, printed));
    claims.push_back(
        {error, printed, reader.optional(table, "says"), read_claimed_ranges(reader, table, own)});
  }
  if (claims.empty())
    reader.fail(table,
                fmt::format("a claim states one of {}", fmt::join(keys.begin() + 2, keys.end(), ", ")));
  return claims;
}

/// A claim, or a list of them.
std::vector<ErrorClaim> read_claims(const TomlReader& reader, const toml::table& set,
                                    const std::vector<StudyRange>& own) {
  const toml::node* node = set.get("claim");
  if (node == nullptr) return {};
  if (!node->is_array()) return read_claim(reader, reader.table(*node, "claim"), own);
  std::vector<ErrorClaim> claims;
  for (const toml::node* one : reader.list(set, "claim")) {
    const auto more = read_claim(reader, reader.table(*one, "claim"), own);
    claims.insert(claims.end(), more.begin(), more.end());
  }
  return claims;
}

std::string number_text(const TomlReader& reader, const toml::node& node, const std::string& key) {
  const std::string printed = reader.text(node, key);
  if (!parse_number(printed)) reader.fail(node, fmt::format("{} '{}' is not a number", key, printed));
  return printed;
}

/// A table of numbers as texts, all digits kept.
PrintedValues read_numbers(const TomlReader& reader, const toml::table& in) {
  PrintedValues values;
  for (const auto& [key, node] : reader.in_order(in))
    values.emplace_back(key, number_text(reader, *node, key));
  return values;
}

/// A copy that has some of the published values otherwise.
MistypedCopy read_variant(const TomlReader& reader, const toml::table& table,
                          const PrintedValues& published) {
  std::vector<std::string> known{"seen", "replaced"};
  for (const auto& value : published) known.push_back(value.first);
  reader.require_keys(table, known);
  MistypedCopy copy{{}, reader.required(table, "seen"), reader.optional(table, "replaced", "")};
  for (const auto& [key, node] : reader.in_order(table))
    if (key != "seen" && key != "replaced") copy.values.emplace_back(key, number_text(reader, *node, key));
  if (copy.values.empty()) reader.fail(table, "a variant needs the value that differs");
  return copy;
}

/// The parts of a source. An author is a text, several are a list.
CitedWork read_cited(const TomlReader& reader, const toml::table& cite) {
  reader.require_keys(cite, {"author", "title", "year", "howpublished", "note", "url"});
  CitedWork work{.title = reader.optional(cite, "title"),
                 .year = reader.optional(cite, "year"),
                 .howpublished = reader.optional(cite, "howpublished"),
                 .note = reader.optional(cite, "note"),
                 .url = reader.optional(cite, "url")};
  const toml::node* author = cite.get("author");
  if (author != nullptr && !author->is_array()) {
    work.authors = {reader.text(*author, "author")};
  } else {
    for (const toml::node* one : reader.list(cite, "author"))
      work.authors.push_back(reader.text(*one, "author"));
  }
  if (work.authors.empty() && work.title.empty()) reader.fail(cite, "'cite' needs an author or a title");
  const auto is_of_address = [](char c) {
    return '!' < c && c <= '~' && std::string_view("{}\\<>^`\"|").find(c) == std::string_view::npos;
  };
  const bool is_address = work.url.starts_with("https://") || work.url.starts_with("http://");
  if (!work.url.empty() && !(is_address && std::ranges::all_of(work.url, is_of_address)))
    reader.fail(*cite.get("url"),
                fmt::format("url '{}' is not an address: http:// or https://, without spaces", work.url));
  return work;
}

/// The keys of a part of a study, and more.
std::vector<std::string> with_more(std::vector<std::string> own, const std::vector<std::string>& more) {
  own.insert(own.end(), more.begin(), more.end());
  return own;
}

PublishedSet read_published(const TomlReader& reader, const toml::table& table, const StudyFile& file,
                            const MoreKeys& more) {
  const std::vector<StudyForm>& forms = file.forms;
  reader.require_keys(table,
                      with_more({"form", "given", "values", "source", "cite", "where", "claim", "variants"},
                                more.of_published));
  PublishedSet set{.form = reader.optional(table, "form", forms.front().id), .values = {}, .source = {}};
  const bool is_known = std::ranges::find(forms, set.form, &StudyForm::id) != forms.end();
  if (!is_known) reader.fail(table, fmt::format("published form '{}' is not the id of a form", set.form));
  const auto values_of = [&](const toml::table& in, const char* key) {
    const toml::node* node = in.get(key);
    return node == nullptr ? PrintedValues{} : read_numbers(reader, reader.table(*node, key));
  };
  set.given = values_of(table, "given");
  set.values = values_of(table, "values");
  if (set.values.empty()) reader.fail(table, "the key 'values' is missing");
  set.source = reader.required(table, "source");
  if (set.source.empty()) reader.fail(*table.get("source"), "the source is empty: name author, year, title");
  if (const toml::node* cite = table.get("cite")) set.cite = read_cited(reader, reader.table(*cite, "cite"));
  for (const toml::node* place : reader.list(table, "where"))
    set.where.push_back(reader.text(*place, "where"));
  set.claims = read_claims(reader, table, file.study.over);
  for (const toml::node* node : reader.list(table, "variants")) {
    set.variants.push_back(read_variant(reader, reader.table(*node, "variants"), set.values));
  }
  return set;
}

void read_forms(const TomlReader& reader, const toml::table& whole, StudyFile& file, const MoreKeys& more) {
  for (const toml::node* node : reader.list(whole, "form")) {
    const toml::table& form = reader.table(*node, "form");
    reader.require_keys(form, with_more({"id", "formula", "error"}, more.of_form));
    const StudyForm read{reader.required(form, "id"), reader.required(form, "formula"),
                         reader.optional(form, "error")};
    // A plain word: `--form` takes it, and it stands in tables, pictures and code.
    const bool is_id = !read.id.empty() && read.id.front() != '-' && std::ranges::all_of(read.id, [](char c) {
      return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' ||
             c == '_';
    });
    if (!is_id)
      reader.fail(form,
                  fmt::format("form id '{}' must be letters, digits, '-' and '_', no '-' first", read.id));
    const bool is_there = std::ranges::find(file.forms, read.id, &StudyForm::id) != file.forms.end();
    if (is_there) reader.fail(form, fmt::format("the form '{}' is there already", read.id));
    if (file.forms.size() == most_forms)
      reader.fail(form, fmt::format("a study has at most {} forms", most_forms));
    file.forms.push_back(read);
  }
  if (file.forms.empty()) reader.fail(whole, "a study needs a [[form]]");
}

/// Texts in several lines become one: ends of lines and tabs separate as spaces do.
void join_lines(toml::node& node) {
  if (toml::value<std::string>* text = node.as_string())
    std::ranges::replace_if(
        text->get(), [](char c) { return '\t' <= c && c <= '\r'; }, ' ');
  if (toml::array* array = node.as_array()) std::ranges::for_each(*array, join_lines);
  if (toml::table* table = node.as_table()) {
    for (auto&& [key, value] : *table) join_lines(value);
  }
}

}  // namespace

toml::table parse_in_lines(const TomlReader& reader, const std::string& text) {
  toml::table whole = reader.parse(text);
  join_lines(whole);
  return whole;
}

StudyFile read_study_file(const std::string& text, const std::string& name) {
  const TomlReader reader("study '" + name + "'");
  return study_of_toml(reader, parse_in_lines(reader, text));
}

StudyFile study_of_toml(const TomlReader& reader, const toml::table& whole, const MoreKeys& more) {
  reader.require_keys(whole, with_more({"schema", "id", "title", "about", "over", "given", "let", "target",
                                        "form", "bounds", "metric", "published"},
                                       more.of_file));
  const auto schema = whole["schema"].value<int>();
  if (schema != study_schema) reader.fail(1, fmt::format("the key 'schema' must be {}", study_schema));
  StudyFile file{.id = reader.required(whole, "id"),
                 .title = reader.optional(whole, "title"),
                 .about = reader.optional(whole, "about"),
                 .study = {},
                 .forms = {}};
  // The id is the name of the file, and of the page of the study.
  const bool is_name = file.id != "index" && std::ranges::all_of(file.id, [](char c) {
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
  if (file.study.over.empty())
    reader.fail(*over, "[over] needs a variable and its range, for example x = \"0:1\"");
  reader.require_keys(*target, with_more({"formula", "table", "recompute", "encoded"}, more.of_target));
  file.table = reader.optional(*target, "table");
  if (file.table.empty()) file.study.target = reader.required(*target, "formula");
  if (!file.table.empty() && target->contains("formula"))
    reader.fail(*target, "a target is a formula or a table, not both");
  if (target->contains("recompute")) file.recompute = reader.required(*target, "recompute");
  if (file.table.empty() && file.recompute)
    reader.fail(*target, "'recompute' goes with a table: it is the formula of its values");
  file.is_encoded = reader.flag(*target, "encoded");
  if (const toml::table* given = part("given")) {
    for (const auto& [constant, node] : reader.in_order(*given))
      file.given.push_back(reader.parsed(*node, [&, &key = constant, &value = node] {
        return parse_given("given", key + "=" + reader.text(*value, key));
      }));
  }
  if (const toml::table* let = part("let")) read_definitions(reader, *let, file.study);
  read_forms(reader, whole, file, more);
  if (const toml::table* bounds = part("bounds")) {
    for (const auto& [parameter, node] : reader.in_order(*bounds))
      file.study.bounds.push_back(reader.parsed(*node, [&, &key = parameter, &value = node] {
        return parse_bounds("bounds", key + "=" + reader.text(*value, key));
      }));
  }
  if (const toml::table* metric = part("metric")) read_metric(reader, *metric, file);
  note_lines(whole, file);
  for (const toml::node* node : reader.list(whole, "published"))
    file.published.push_back(read_published(reader, reader.table(*node, "published"), file, more));
  return file;
}

}  // namespace shadefit
