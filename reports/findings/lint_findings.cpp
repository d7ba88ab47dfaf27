#include "reports/findings/lint_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fit/support/decimal.hpp"
#include "reports/io/digest.hpp"

namespace shadefit {
namespace {

using findings::FindingLevel;
using lint::Grade;
using lint::LintedNumber;
using lint::LintedSite;

std::string rule_of(const LintedSite& site) {
  if (!site.fault.empty()) return "unknown-pin";
  if (site.is_pinned && site.grade != Grade::right) return "pinned-constant";
  if (!site.slip.empty()) return site.grade == Grade::wrong ? "wrong-expression" : "other-expression";
  return std::string(name(site.grade)) + "-constant";
}

std::vector<findings::FindingRule> lint_rules() {
  return {
      {"wrong-constant", "A constant with a wrong digit that is visible",
       "Digits differ from the published ones, and the curve moves by more than half an 8-bit sRGB code, or by "
       "more than 0.001 for values that are not colours."},
      {"wrong-expression", "A published formula with a wrong operation",
       "All constants are those of a published formula, but an operation differs."},
      {"typo-constant", "A constant with a wrong digit", "Digits differ, without a visible effect."},
      {"other-expression", "A published formula with another operation",
       "All constants are those of a published formula, an operation differs, without a visible effect."},
      {"outdated-constant", "A constant that was replaced",
       "Its own source or standard has another value now."},
      {"truncated-constant", "A constant with fewer digits",
       "Fewer digits than published, without a visible effect."},
      {"pinned-constant", "A pinned number that is not its constant",
       "The mark behind the number names a published constant, and that has other digits."},
      {"unknown-pin", "A mark that pins nothing",
       "It names no published constant, or there is no number before it in its line."},
      {"right-constant", "A published constant", "The digits are those that were published."},
  };
}

/// "by up to 0.0071, 1.7 codes of 8-bit sRGB".
std::string effect_words(const LintedSite& site) {
  const double change = site.effect.absolute.magnitude;
  if (!(change > 0)) return "the curve stays the same";
  std::string words = std::isfinite(change) ? fmt::format("the curve moves by up to {}", decimal(change, 2))
                                            : "the curve has no value at some places";
  if (site.is_shown && std::isfinite(change))
    words += fmt::format(", {} codes of {}", decimal(site.effect.srgb_codes, 2),
                         site.is_encoded ? "8 bits" : "8-bit sRGB");
  return words;
}

std::string numbers_words(const LintedSite& site) {
  std::string words;
  for (const LintedNumber& number : site.numbers) {
    if (number.grade == Grade::right) continue;
    std::string_view published = number.published;
    if (!number.text.starts_with('-') && published.starts_with('-')) published.remove_prefix(1);
    words += fmt::format("{}{} instead of {}", words.empty() ? "" : ", ", number.text, published);
  }
  return words;
}

std::string message_of(const LintedSite& site) {
  if (!site.fault.empty()) return site.fault;
  const std::string set = fmt::format("{}{}{}", site.id, site.form.empty() ? "" : " (" + site.form + ")",
                                      site.is_pinned ? ", pinned" : "");
  if (site.grade == Grade::right) return fmt::format("{}: the constants of {}", set, site.source);
  std::string what = numbers_words(site);
  if (!site.slip.empty())
    what += (what.empty() ? "" : ", ") + fmt::format("the expression has {}", site.slip);
  if (what.empty()) what = "a number differs";
  const std::string reason = site.grade == Grade::outdated ? "; " + site.replaced : "";
  return fmt::format("{}: {}{}; {}", set, what, reason, effect_words(site));
}

FindingLevel level_of(const LintedSite& site, const std::optional<Grade>& fail_on) {
  if (site.is_in_comment || site.grade == Grade::right) return FindingLevel::note;
  if (fail_on && site.grade >= *fail_on) return FindingLevel::error;
  return site.grade == Grade::truncated ? FindingLevel::note : FindingLevel::warning;
}

std::string name_within(const std::filesystem::path& project, const std::string& file) {
  if (project.empty()) return file;
  return std::filesystem::absolute(file).lexically_normal().lexically_relative(project).generic_string();
}

/// Of what does not change when lines move: file, rule, set and numbers. Equal sites of a file are counted.
std::string fingerprint_of(const LintedSite& site, const std::filesystem::path& project,
                           std::map<std::string, int>& seen) {
  std::string text = fmt::format("{}\n{}\n{} {}\n{}", name_within(project, site.file), rule_of(site), site.id,
                                 site.form, site.slip);
  for (const LintedNumber& number : site.numbers) text += "\n" + number.text;
  const int count = seen[text]++;
  return fmt::format("{:08x}{:08x}", crc_of(text), crc_of(fmt::format("{}\n{}", count, text)));
}

bool is_shown(const LintedSite& site, const LintReportOptions& options) {
  return site.grade != Grade::right || options.all;
}

}  // namespace

findings::FindingReport lint_findings(const lint::LintedTree& tree, const LintReportOptions& options) {
  findings::FindingReport report{"lint", lint_rules(), {}, tree.files, "files"};
  std::map<std::string, int> seen;
  for (const LintedSite& site : tree.sites) {
    if (!is_shown(site, options)) continue;
    findings::Finding& finding = report.findings.emplace_back();
    finding.rule = rule_of(site);
    finding.level = level_of(site, options.fail_on);
    finding.message = message_of(site);
    finding.place = {site.file, site.begin.line, site.begin.column, site.end.line, site.end.column};
    finding.fingerprint = fingerprint_of(site, options.project, seen);
    finding.suppressed = site.ignored;
    finding.is_known = options.known.contains(finding.fingerprint);
  }
  return report;
}

LintAdvice lint_advice(const lint::LintedTree& tree, const LintReportOptions& options,
                       const findings::FindingReport& report) {
  LintAdvice advice;
  Grade worst = Grade::right, to_fix = Grade::right;
  bool has_pin = false;
  auto finding = report.findings.begin();
  for (const LintedSite& site : tree.sites) {
    if (!is_shown(site, options) || finding++->is_known || site.ignored || !site.fault.empty()) continue;
    if (advice.id.empty() || site.grade > worst) advice.id = site.id;
    worst = std::max(worst, site.grade);
    const bool is_fixable = std::ranges::any_of(site.numbers, [](const LintedNumber& number) {
      return number.is_certain && number.grade != Grade::right;
    });
    if (!is_fixable || site.is_in_comment) continue;
    has_pin = has_pin || site.is_pinned;
    const bool is_milder = to_fix == Grade::right || site.grade < to_fix;
    if (site.slip.empty() && site.grade >= Grade::typo && is_milder) to_fix = site.grade;
  }
  if (to_fix != Grade::right || has_pin) advice.fix = to_fix == Grade::right ? "pins" : name(to_fix);
  return advice;
}

std::string skipped_words(const lint::SkippedFiles& skipped) {
  std::string files;
  const auto add = [&](std::size_t count, std::string_view what) {
    if (count > 0) files += fmt::format("{}{} {}", files.empty() ? "" : ", ", count, what);
  };
  add(skipped.ignored, "ignored");
  add(skipped.vendored, skipped.vendored == 1 ? "folder of others" : "folders of others");
  add(skipped.minified, "minified");
  add(skipped.binary, "binary");
  add(skipped.too_large, "too large");
  add(skipped.links, skipped.links == 1 ? "link" : "links");
  add(skipped.unreadable, "unreadable");
  add(skipped.in_tables,
      skipped.in_tables == 1 ? "place in a table of numbers" : "places in tables of numbers");
  return files.empty() ? "" : "not read: " + files;
}

}  // namespace shadefit
