#include "reports/sections/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reports/io/mathematics.hpp"
#include "reports/rows/citation.hpp"
#include "reports/sections/ledger_section.hpp"
#include "reports/sections/prose.hpp"

namespace shadefit {
namespace {

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

}  // namespace shadefit
