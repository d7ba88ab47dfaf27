#include "fit/ledger/read_claims.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "approx/normalisation.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/catalogue/toml_reader.hpp"

namespace shadefit {
namespace {

class ClaimReader {
 public:
  ClaimReader(const std::string& name, ReadClaims& into) : file_("claims '" + name + "'"), into_(into) {}

  void sources(const std::string& text) const {
    for (const auto& [name, node] : file_.parse(text)) {
      const toml::table& table = file_.table(node, std::string(name));
      file_.require_keys(table, {"author", "year", "title", "place", "address", "of"});
      into_.sources[std::string(name)] =
          table.contains("of")
              ? record(*table.get("of"), file_.required(table, "of")).second
              : Source{required(table, "author"), static_cast<int>(table["year"].value_or(0)),
                       required(table, "title"), required(table, "place"), optional(table, "address")};
    }
  }

  void topic(const std::string& text) const {
    const toml::table table = file_.parse(text);
    file_.require_keys(table, {"title", "claim"});
    const std::string_view title = required(table, "title");
    std::vector<Claim>& claims = into_.claims.emplace_back();
    for (const toml::node* node : file_.list(table, "claim"))
      claims.push_back(claim(file_.table(*node, "claim"), claims));
    into_.topics.push_back({title, claims});
  }

 private:
  std::string_view kept(std::string text) const { return into_.texts.emplace_back(std::move(text)); }
  std::string_view required(const toml::table& table, const std::string& key) const {
    return kept(file_.required(table, key));
  }
  std::string_view optional(const toml::table& table, const std::string& key) const {
    return kept(file_.optional(table, key));
  }

  /// What the constant or normalisation of that id prints, and its source.
  std::pair<std::string_view, Source> record(const toml::node& node, std::string_view id) const {
    if (const Published* found = find_published(id)) return {found->printed, found->source};
    const auto found = std::ranges::find(normalisations, id, &Normalisation::id);
    if (found == normalisations.end()) file_.fail(node, fmt::format("no constant has the id '{}'", id));
    return {found->printed, found->source};
  }

  Quantities quantities(const toml::table& table, const std::string& key) const {
    Quantities result;
    for (const toml::node* node : file_.list(table, key)) {
      const toml::array* pair = node->as_array();
      if (pair == nullptr || pair->size() != 2)
        file_.fail(*node, fmt::format("'{}' must be a list of pairs: a name and a value", key));
      const std::string value = file_.text(*pair->get(1), key);
      result.push_back({kept(file_.text(*pair->get(0), key)),
                        value.starts_with('=') ? record(*node, value.substr(1)).first : kept(value)});
    }
    return result;
  }

  std::string_view derivation(const toml::table& table, const std::vector<Claim>& before) const {
    const std::string_view text = required(table, "derivation");
    if (!text.starts_with('=')) return text;
    const auto found = std::ranges::find(before, text.substr(1), &Claim::id);
    if (found == before.end())
      file_.fail(*table.get("derivation"), fmt::format("no claim before is '{}'", text.substr(1)));
    return found->derivation;
  }

  Source source(const toml::table& table) const {
    const auto found = into_.sources.find(file_.required(table, "source"));
    if (found == into_.sources.end()) file_.fail(*table.get("source"), "no source has that name");
    return found->second;
  }

  std::span<const Published> constants(const toml::table& table) const {
    std::vector<Published>& result = into_.constants.emplace_back();
    for (const toml::node* node : file_.list(table, "constants")) {
      const Published* found = find_published(file_.text(*node, "constants"));
      if (found == nullptr) file_.fail(*node, "no published constant has that id");
      result.push_back(*found);
    }
    return result;
  }

  /// A list of lists of texts.
  std::vector<Instructions::Line> lines(const toml::table& table, const std::string& key) const {
    std::vector<Instructions::Line> result;
    for (const toml::node* node : file_.list(table, key)) {
      const toml::array* line = node->as_array();
      if (line == nullptr) file_.fail(*node, fmt::format("'{}' must be a list of lists of texts", key));
      auto& texts = result.emplace_back();
      for (const toml::node& text : *line) texts.push_back(kept(file_.text(text, key)));
      if (texts.size() < 2) file_.fail(*node, fmt::format("a list in '{}' has at least two texts", key));
    }
    return result;
  }

  Instructions instructions(const toml::table& table) const {
    std::vector<std::string_view> verdicts;
    for (const toml::node* node : file_.list(table, "verdict"))
      verdicts.push_back(kept(file_.text(*node, "verdict")));
    return {lines(table, "define"), verdicts, lines(table, "effect"), file_.flag(table, "in_50_digits")};
  }

  Claim claim(const toml::table& table, const std::vector<Claim>& before) const {
    file_.require_keys(
        table, {"id", "statement", "printed", "inputs", "derivation", "computed", "evidence", "figure",
                "source", "constants", "define", "verdict", "effect", "in_50_digits"});
    Claim claim{.id = required(table, "id"),
                .statement = required(table, "statement"),
                .printed = quantities(table, "printed"),
                .inputs = quantities(table, "inputs"),
                .derivation = derivation(table, before),
                .computed = optional(table, "computed"),
                .evidence = optional(table, "evidence"),
                .figure = optional(table, "figure"),
                .source = source(table),
                .constants = constants(table),
                .instructions = instructions(table)};
    if (claim.printed.empty()) {
      for (const Published& constant : claim.constants)
        claim.printed.push_back({constant.parameter, constant.printed});
    }
    // the fits of one constant are at its exponents
    if (claim.constants.size() == 1 && !claim.constants[0].exponents.empty())
      claim.inputs.insert(claim.inputs.begin(), {"exponents", claim.constants[0].exponents});
    return claim;
  }

  TomlReader file_;
  ReadClaims& into_;
};

}  // namespace

void read_sources(const std::string& text, const std::string& name, ReadClaims& into) {
  ClaimReader(name, into).sources(text);
}

void read_topic(const std::string& text, const std::string& name, ReadClaims& into) {
  ClaimReader(name, into).topic(text);
}

}  // namespace shadefit
