#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fit/formula/parse_formula.hpp"
#include "lint/fixes.hpp"
#include "lint/lint_tree.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace {

using namespace shadefit;
using namespace shadefit::lint;

KnownSet set_of(const std::string& id, const std::string& formula, std::vector<KnownConstant> constants) {
  FormulaNames names;
  names.variables = {"x"};
  names.takes_parameters = true;
  return {id, "form", "a source", {{"x", 0, 1}}, read_formula(formula, names).formula, std::move(constants)};
}

/// A few of the committed sets; reading their files is another fuzzer's work.
const KnownConstants& known() {
  static const KnownConstants sets({
      set_of("acos-linear", "sqrt(1-x) (a + b x)",
             {{"a", "1.5707963", 1.5707963, true}, {"b", "-0.156583", -0.156583}}),
      set_of("fresnel-quadratic", "exp2((a x + b) x)",
             {{"a", "-5.55473", -5.55473}, {"b", "-6.98316", -6.98316}}),
      set_of("aces-narkowicz", "x (a x + b)/(x (c x + d) + e)",
             {{"a", "2.51", 2.51},
              {"b", "0.03", 0.03},
              {"c", "2.43", 2.43},
              {"d", "0.59", 0.59},
              {"e", "0.14", 0.14}}),
  });
  return sets;
}

void require(bool holds) {
  if (!holds) std::abort();
}

/// Whether a fix leaves a number of the site alone: a member such as `v.0`, or one before a factor 10^n.
bool stays(const LintedSite& site, const std::string& text) {
  return std::ranges::any_of(site.numbers, [&](const LintedNumber& number) {
    return (number.offset > 0 && is_of_name(text[number.offset - 1])) ||
           is_before_power_of_ten(text, number.offset + number.text.size());
  });
}

}  // namespace

// One input is the name of a language in its first line, and a source text. No text is refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string whole(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(whole.find('\n'), size);
  const SourceLanguage language = language_named(whole.substr(0, end)).value_or(SourceLanguage::glsl);
  const std::string text = whole.substr(std::min(end + 1, size));
  const auto sites = lint_source("fuzzed", text, language, known(), {});
  for (const LintedSite& site : sites) {
    require(site.begin.line >= 1 && site.begin.column >= 1);
    require(site.fault.empty() != site.numbers.empty());
    for (const LintedNumber& number : site.numbers) {
      require(text.compare(number.offset, number.text.size(), number.text) == 0);
      for (const NumberCopy& copy : number.copies)
        require(text.compare(copy.offset, copy.text.size(), copy.text) == 0);
    }
  }
  const std::string fixed = fixed_text(text, fixes_of(sites, text, FixScope::pins));
  require(std::count(fixed.begin(), fixed.end(), '\n') == std::count(text.begin(), text.end(), '\n'));
  // What was fixed is right.
  if (fixed != text)
    for (const LintedSite& site : lint_source("fuzzed", fixed, language, known(), {}))
      require(!site.is_pinned || !site.fault.empty() || site.grade == Grade::right || stays(site, fixed));
  fixed_text(text, fixes_of(sites, text, FixScope::typo));
  return 0;
}
