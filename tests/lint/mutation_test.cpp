#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "fit/support/user_error.hpp"
#include "lint/lint_tree.hpp"
#include "lint/scan/characters.hpp"
#include "reports/code/shader_code.hpp"
#include "tests/lint/all_known.hpp"

/// Each digit of each published constant, changed once in generated code.
namespace shadefit::lint {
namespace {

/// The form of a set with its constants, in GLSL; empty if shaders have no such function.
std::string code_of(const KnownSet& set) {
  std::vector<std::string> variables;
  for (const KnownAxis& axis : set.axes) variables.push_back("v_" + axis.variable);
  const Symbolic formula = evaluate<Symbolic>(set.formula, [&](const std::string& name) {
    for (const KnownConstant& constant : set.constants)
      if (constant.name == name) return Symbolic::number(constant.printed);
    return Symbolic::variable("v_" + name);
  });
  const std::vector<ShaderFunction> functions{{"f", variables, formula}};
  try {
    return shader_code(functions, Language::glsl, ShaderPrecision::float32, {});
  } catch (const UserError&) {
    return "";
  }
}

TEST(LintMutation, EachChangedDigitIsNoticed) {
  const KnownConstants known = all_known();
  std::size_t sets = 0, silent = 0, digits = 0, noticed = 0, by_numbers = 0, noticed_by_numbers = 0;
  std::string missed;
  const auto sites_in = [&](const std::string& code) {
    return lint_source("a.glsl", code, SourceLanguage::glsl, known, {});
  };
  for (const KnownSet& set : known.sets) {
    const std::string code = code_of(set);
    if (code.empty()) continue;
    ++sets;
    if (std::getenv("SHOWCODE")) std::cout << set.id << " " << set.form << ": " << set.source << "\n" << code;
    const std::vector<LintedSite> sites = sites_in(code);
    if (sites.empty()) {
      ++silent;
      missed += set.id + " " + set.form + " is not found\n";
    }
    for (const LintedSite& site : sites) {
      for (const LintedNumber& number : site.numbers) {
        for (std::size_t i = 0; i < number.text.size(); ++i) {
          if (!is_digit(number.text[i])) continue;
          std::string other = code;
          char& digit = other[number.offset + i];
          digit = static_cast<char>('0' + (digit - '0' + 5) % 10);
          const std::vector<LintedSite> found = sites_in(other);
          const bool is_noticed = std::any_of(found.begin(), found.end(),
                                              [](const LintedSite& one) { return one.grade >= Grade::typo; });
          ++digits;
          if (is_noticed) ++noticed;
          const bool has_telling_digits = digits_of(number.published).text.size() >= least_digits_to_vary;
          if (has_telling_digits) ++by_numbers;
          if (has_telling_digits && is_noticed) ++noticed_by_numbers;
          if (!is_noticed) missed += fmt::format("{} {}: {} at {}\n", set.id, set.form, number.text, i);
        }
      }
    }
  }
  std::cout << fmt::format(
      "{} sets, {} not found; {} digits changed, {} noticed; of constants of four digits {} of {}\n{}", sets,
      silent, digits, noticed, noticed_by_numbers, by_numbers, missed);
}

}  // namespace
}  // namespace shadefit::lint
