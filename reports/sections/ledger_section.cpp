#include "reports/sections/ledger_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/io/joined.hpp"
#include "reports/io/mathematics.hpp"
#include "reports/rows/citation.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/sections/prose.hpp"
#include "reports/sections/sections.hpp"

namespace shadefit {
namespace {

std::string quantities_text(const Quantities& quantities) {
  return joined(quantities, ", ", [](const Quantity& quantity) {
    return quantity.name.empty() ? std::string(quantity.value)
                                 : fmt::format("{} = {}", quantity.name, quantity.value);
  });
}

std::vector<JudgedClaim> of_topic(const std::vector<JudgedClaim>& claims, const Topic& topic) {
  std::vector<JudgedClaim> found;
  std::ranges::copy_if(claims, std::back_inserter(found),
                       [&](const JudgedClaim& judged) { return judged.topic == &topic; });
  return found;
}

std::string topic_section(const Topic& topic, const std::vector<JudgedClaim>& claims,
                          const std::vector<Figure>& figures) {
  std::string out = fmt::format("### {}\n\n", topic.title) + markdown_block(claims_overview(claims));
  for (const auto& [_, claim, finding] : claims) {
    out += fmt::format("- **`{}`** ({}): {}.\n  - **{}**: {}.\n  - Effect: {}.\n", claim->id,
                       linked(claim->source), with_mathematics(claim->statement), verdict_text(finding),
                       finding.evidence, finding.effect);
    const std::string_view name = claim->figure;  // clang 14 captures no structured binding
    const bool is_drawn = std::ranges::find(figures, name, &Figure::name) != figures.end();
    if (is_drawn) out += fmt::format("  - Plot: [{0}](plots/{0}.svg).\n", claim->figure);
  }
  return out + "\n";
}

std::string without_full_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

std::string news_of(const std::vector<JudgedClaim>& claims, std::string_view lead) {
  if (claims.empty()) return "";
  std::string out = fmt::format("{}\n\n", lead);
  for (const auto& [topic, claim, finding] : claims) {
    const bool is_refuted = finding.verdict == Verdict::refuted;
    out += fmt::format("- [`{}`](#{}) ({}): {}.\n  - Found: {}.\n  - Effect: {}.\n", claim->id,
                       anchor(topic->title), linked(claim->source), with_mathematics(claim->statement),
                       is_refuted ? finding.evidence : finding.computed,
                       without_full_stop(sentences_of(finding.effect).front()));
  }
  return out + "\n";
}

}  // namespace

std::string printed_text(const Claim& claim) {
  return claim.printed.empty() ? "-" : quantities_text(claim.printed);
}

std::string verdict_text(const Finding& finding) {
  return std::string(finding.verdict ? name(*finding.verdict) : name(Status::not_converged));
}

Table claims_table(const std::vector<JudgedClaim>& claims) {
  Table table{
      {"claim", "printed", "computed", "verdict", "effect", "evidence", "source", "topic", "statement"}, {}};
  for (const auto& [topic, claim, finding] : claims) {
    table.rows.push_back({word(claim->id), printed_text(*claim), finding.computed, verdict_text(finding),
                          finding.effect, finding.evidence, citation(claim->source), word(topic->title),
                          without_marks(claim->statement)});
  }
  return table;
}

Table claims_overview(const std::vector<JudgedClaim>& claims) {
  return columns_of(claims_table(claims), {0, 1, 2, 3});
}

Table claims_list(const std::vector<JudgedClaim>& claims, bool with_verdicts, bool with_statements) {
  Table list = columns_of(claims_table(claims), {0, 1, 2, 3, 8, 6});
  list.columns = {"id", "printed", "computed", "verdict", "of", "source"};
  for (std::size_t i = 0; i < claims.size() && !with_statements; ++i)
    list.rows[i].back() = author_and_year(claims[i].claim->source);
  std::vector<std::size_t> shown{0, 1};
  if (with_verdicts) shown.insert(shown.end(), {2, 3});
  if (with_statements) shown.push_back(4);
  shown.push_back(5);
  return columns_of(list, shown);
}

void add_forms_of_comparison(Table& list) {
  for (const Family& family : families()) {
    if (!family.is_comparison) continue;
    std::vector<Cell> row{word(family.id), word("-"), word("none: a form to compare with")};
    if (list.columns.size() == 4)
      row.insert(row.begin() + 2, fmt::format("{} ~ {}", to_text(family.target), to_text(family.form)));
    list.rows.push_back(row);
  }
}

std::string verdict_counts(const std::vector<JudgedClaim>& claims) {
  std::vector<std::pair<std::string, int>> counts;
  for (const Verdict verdict : all_verdicts) counts.emplace_back(name(verdict), 0);
  counts.emplace_back(name(Status::not_converged), 0);
  for (const JudgedClaim& judged : claims) {
    for (auto& [verdict, count] : counts) count += verdict == verdict_text(judged.finding);
  }
  std::vector<std::string> words;
  for (const auto& [verdict, count] : counts) {
    if (count > 0) words.push_back(fmt::format("{} {}", count, verdict));
  }
  return fmt::format("{} {}: {}", claims.size(), claims.size() == 1 ? "claim" : "claims",
                     fmt::join(words, ", "));
}

std::vector<JudgedClaim> claims_with(const std::vector<JudgedClaim>& claims, Verdict verdict) {
  std::vector<JudgedClaim> found;
  std::ranges::copy_if(claims, std::back_inserter(found),
                       [&](const JudgedClaim& judged) { return judged.finding.verdict == verdict; });
  return found;
}

std::string news_section(const std::vector<JudgedClaim>& claims) {
  return fmt::format("## News\n\nWe judged {}. [How to read it](#how-to-read-it) explains the words.\n\n",
                     verdict_counts(claims)) +
         news_of(claims_with(claims, Verdict::refuted), "**Refuted:**") +
         news_of(claims_with(claims, Verdict::conditional), conditional_lead);
}

std::string ledger_section(const std::vector<JudgedClaim>& claims, const std::vector<Figure>& figures) {
  std::string out = fmt::format(fmt::runtime(section_text("ledger")), verdict_counts(claims));
  const Topic* last = nullptr;
  for (const JudgedClaim& judged : claims) {
    if (judged.topic != last) out += topic_section(*judged.topic, of_topic(claims, *judged.topic), figures);
    last = judged.topic;
  }
  return out;
}

std::string explanation(const JudgedClaim& judged, const Terminal& terminal) {
  constexpr std::size_t label_width = 10, most = 106;
  const std::size_t room = (terminal.width == 0 ? most : std::min(terminal.width, most)) - label_width;
  const auto& [topic, claim, finding] = judged;
  std::string out = fmt::format("{}\n", claim->id);
  const auto line = [&](std::string_view label, const std::string& text) {
    if (text.empty()) return;
    out += fmt::format("{:<{}}{}\n", label, label_width,
                       fmt::join(folded(text, room), "\n" + std::string(label_width, ' ')));
  };
  const auto each_on_a_line = [&](std::string_view label, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) line(std::exchange(label, ""), sentence);
  };
  line("topic", std::string(topic->title));
  line("says", without_marks(claim->statement));
  line("printed", printed_text(*claim));
  line("source", citation(claim->source));
  line("given", quantities_text(claim->inputs));
  line("why", std::string(claim->derivation));
  line("computed", finding.computed);
  line("verdict", with_coloured_verdicts(verdict_text(finding), terminal));
  each_on_a_line("evidence", sentences_of(finding.evidence));
  each_on_a_line("effect", sentences_of(finding.effect));
  line("plot", claim->figure.empty() ? "" : fmt::format("plots/{}.svg", claim->figure));
  return out;
}

nlohmann::ordered_json explanation_json(const JudgedClaim& judged) {
  const auto& [topic, claim, finding] = judged;
  const auto pairs = [](const Quantities& quantities) {
    return json_array(quantities, [](const Quantity& quantity) -> nlohmann::ordered_json {
      return {{"name", quantity.name}, {"value", quantity.value}};
    });
  };
  return {
      {"schema", 1},
      {"claim", claim->id},
      {"topic", topic->title},
      {"statement", without_marks(claim->statement)},
      {"printed", pairs(claim->printed)},
      {"source",
       {{"author", claim->source.author},
        {"year", claim->source.year},
        {"title", claim->source.title},
        {"place", claim->source.place},
        {"address", address_of(claim->source)}}},
      {"inputs", pairs(claim->inputs)},
      {"derivation", claim->derivation},
      {"computed", finding.computed},
      {"verdict", verdict_text(finding)},
      {"evidence", finding.evidence},
      {"effect", finding.effect},
      {"figure", claim->figure.empty() ? nlohmann::ordered_json()
                                       : nlohmann::ordered_json(fmt::format("plots/{}.svg", claim->figure))}};
}

}  // namespace shadefit
