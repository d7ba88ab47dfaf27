#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/options/options.hpp"
#include "fit/support/user_error.hpp"

/// Options with values. CLI11 passes each text to a function that parses it. These functions take the
/// option's name and the text, and throw UserError with one line that contains both and the rule.
namespace shadefit {

/// Refuses a value that looks like an option: CLI11 takes the next word, whatever it is.
void refuse_option(const std::string& option, const std::string& text);

/// An option with one value. `type` names the value in the help; words separated by '|' are the choices.
template <class V, class Parse>
CLI::Option* add_value(CLI::App& command, const std::string& option, V& value, Parse parse,
                       const std::string& type, const std::string& help) {
  const auto set = [&value, option, parse](const std::string& text) {
    refuse_option(option, text);
    value = parse(option, text);
  };
  return command.add_option_function<std::string>(option, set, help)->type_name(type);
}

/// An option that may be repeated, with one value each time.
template <class V, class Parse>
CLI::Option* add_values(CLI::App& command, const std::string& option, std::vector<V>& values, Parse parse,
                        const std::string& type, const std::string& help) {
  const auto set = [&values, option, parse](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      refuse_option(option, text);
      values.push_back(parse(option, text));
    }
  };
  return command.add_option_function<std::vector<std::string>>(option, set, help)
      ->type_name(type)
      ->allow_extra_args(false);
}

/// Words and their values.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// The values with their own names.
template <class T, std::size_t N>
Choices<T> by_name(const std::array<T, N>& values) {
  Choices<T> choices;
  for (const T& value : values) choices.emplace_back(name(value), value);
  return choices;
}

/// The value of one of a few words.
template <class T>
auto parse_choice(const Choices<T>& choices) {
  return [choices](const std::string& option, const std::string& text) {
    std::vector<std::string> words;
    for (const auto& [word, chosen] : choices) {
      if (word == text) return chosen;
      words.push_back(word);
    }
    throw UserError(
        fmt::format("{} '{}' is unknown: it must be one of {}", option, text, fmt::join(words, ", ")));
  };
}

/// An option whose value is one of a few words.
template <class V, class T>
CLI::Option* add_choice(CLI::App& command, const std::string& option, V& value, const Choices<T>& choices,
                        const std::string& help) {
  std::vector<std::string> words;
  for (const auto& choice : choices) words.push_back(choice.first);
  CLI::Option* added = add_value(command, option, value, parse_choice(choices),
                                 fmt::format("{}", fmt::join(words, "|")), help);
  for (const auto& [word, chosen] : choices) {
    if (value == chosen) added->default_str(word);
  }
  return added;
}

/// The text itself.
std::string parse_text(const std::string& option, const std::string& text);

/// A finite number.
double parse_finite(const std::string& option, const std::string& text);

/// A parser of finite numbers that `is_good` takes; for others `rule` follows the option and the text.
template <class IsGood>
auto parse_finite_with(const IsGood& is_good, const std::string& rule) {
  return [=](const std::string& option, const std::string& text) {
    const double value = parse_finite(option, text);
    if (!is_good(value)) throw UserError(fmt::format("{} '{}' {}", option, text, rule));
    return value;
  };
}

/// "10%" as 0.1: a percentage above 0.
double parse_percentage(const std::string& option, const std::string& text);

/// "5", or a sweep "3:15:1,25".
std::vector<double> parse_exponents(const std::string& option, const std::string& text);

/// "A:B" with 0 <= A < B <= 1, at least 1e-10 wide. A and B are formulas of numbers. In degrees they are
/// angles, "0deg:30deg", whose cosines count.
Domain parse_domain(const std::string& option, const std::string& text);

/// "NAME=VALUE" with a finite number, decimal or hexadecimal as shadefit prints it.
Held parse_held(const std::string& option, const std::string& text);

/// "a=-5.55473,b=-6.98316"; the values stay texts, as a proof needs every digit.
Constants parse_parameters(const std::string& option, const std::string& text);

/// A relative width of bounds that double precision can reach.
double parse_relative_width(const std::string& option, const std::string& text);

/// The words of a parsed command: its options with their values as given. Leaves out the options `without`
/// and options with default values.
std::vector<std::string> words_of(const CLI::App& command, const std::vector<std::string>& without);

/// A command as a line for a shell: "shadefit scene 'a b.mtl' --lang glsl".
std::string shell_text(const std::vector<std::string>& words);

}  // namespace shadefit
