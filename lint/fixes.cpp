#include "lint/fixes.hpp"

#include <algorithm>
#include <map>

#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

bool is_fixed(const LintedSite& site, FixScope scope) {
  if (site.grade == Grade::right || !site.fault.empty()) return false;
  if (site.is_pinned) return true;
  if (site.ignored || site.is_in_comment || !site.slip.empty() || scope == FixScope::pins) return false;
  return site.grade == Grade::wrong || (scope == FixScope::typo && site.grade == Grade::typo);
}

/// Whether a number stays: one that has only fewer digits than published, beside one that is worse. If the
/// site is wrong, the other one is why.
bool stays_short(const LintedSite& site, const LintedNumber& number) {
  return !site.is_pinned && number.grade == Grade::truncated &&
         std::ranges::any_of(site.numbers,
                             [](const LintedNumber& other) { return other.grade > Grade::truncated; });
}

}  // namespace

std::string_view name(FixScope scope) {
  constexpr std::array<std::string_view, fix_scopes.size()> names{"pins", "typo", "wrong"};
  return names[static_cast<std::size_t>(scope)];
}

std::vector<Fix> fixes_of(const std::vector<LintedSite>& sites, std::string_view text, FixScope scope) {
  std::map<std::size_t, Fix> by_place;
  const auto rewrite = [&](const NumberCopy& number, std::string_view published) {
    // `v.0` is a member, whatever its digits.
    if (number.offset > 0 && is_of_name(text[number.offset - 1])) return;
    if (is_before_power_of_ten(text, number.offset + number.text.size())) return;
    const Fix fix{number.offset, number.text, rewritten(number.text, published)};
    const auto [place, is_new] = by_place.emplace(number.offset, fix);
    if (!is_new && place->second.after != fix.after) place->second.after = number.text;
  };
  for (const LintedSite& site : sites) {
    if (!is_fixed(site, scope)) continue;
    for (const LintedNumber& number : site.numbers) {
      if (number.grade == Grade::right || !number.is_certain || stays_short(site, number)) continue;
      rewrite({number.offset, number.text}, number.published);
      for (const NumberCopy& copy : number.copies) rewrite(copy, number.published);
    }
  }
  std::vector<Fix> fixes;
  for (const auto& [offset, fix] : by_place)
    if (fix.after != fix.before) fixes.push_back(fix);
  return fixes;
}

std::string fixed_text(std::string_view text, const std::vector<Fix>& fixes) {
  std::string fixed;
  std::size_t done = 0;
  for (const Fix& fix : fixes) {
    fixed += text.substr(done, fix.offset - done);
    fixed += fix.after;
    done = fix.offset + fix.before.size();
  }
  return fixed += text.substr(done);
}

}  // namespace shadefit::lint
