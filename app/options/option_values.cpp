#include "app/options/option_values.hpp"

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <string_view>
#include <utility>

#include "fit/proof/proof.hpp"
#include "fit/study/study.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/lines.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// The narrowest domain. Places are printed to six digits of the domain's width, and a cosine is rounded to
/// 1.1e-16. So the width must be about a million roundings.
constexpr double narrowest_domain = 1e-10;

/// The two parts of a text "NAME=VALUE"; empty for any other text.
std::optional<std::pair<std::string, std::string>> split(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) return std::nullopt;
  return std::pair(text.substr(0, equals), text.substr(equals + 1));
}

bool is_in_degrees(std::string_view text) {
  return trimmed(text).ends_with("deg");
}

/// An end of a domain of cosines: a number, a formula of numbers, or in degrees an angle.
std::optional<double> cosine_of(const std::string& text) {
  if (const auto number = parse_number(text)) return number;
  const auto value = value_of_numbers(is_in_degrees(text) ? "cos(" + text + ")" : text);
  constexpr double rounding = 1e-40;  // of 50 digits: cos(90deg) is 0
  return value && std::abs(*value) < rounding ? 0 : value;
}

}  // namespace

void refuse_option(const std::string& option, const std::string& text) {
  if (text.starts_with("--"))
    throw UserError(
        fmt::format("{} '{}' looks like an option: name a value (a path may begin with './')", option, text));
}

std::string parse_text(const std::string&, const std::string& text) {
  return text;
}

double parse_finite(const std::string& option, const std::string& text) {
  const auto value = parse_number(text);
  if (!value) throw UserError(fmt::format("{} '{}' is not a finite number", option, text));
  return *value;
}

double parse_percentage(const std::string& option, const std::string& text) {
  const bool has_sign = text.ends_with('%');
  const double percent = has_sign ? parse_finite(option, text.substr(0, text.size() - 1)) : 0;
  if (!(percent > 0))
    throw UserError(fmt::format("{} '{}' must be a percentage above 0, such as 10%", option, text));
  return percent / 100;
}

std::vector<double> parse_exponents(const std::string& option, const std::string& text) {
  try {
    return parse_sweep(text);
  } catch (const UserError& error) {
    throw UserError(fmt::format("{} {}: give K or A:B:STEP, separated by commas", option, error.what()));
  }
}

Domain parse_domain(const std::string& option, const std::string& text) {
  const auto refuse = [&](const std::string& rule) {
    throw UserError(fmt::format("{} '{}' {}", option, text, rule));
  };
  const auto colon = text.find(':');
  const std::string first = text.substr(0, colon), second = colon == text.npos ? "" : text.substr(colon + 1);
  auto lower = cosine_of(first), upper = cosine_of(second);
  if (!lower || !upper) refuse("is not a pair A:B of finite numbers, such as 0:1 or cos(60deg):1");
  // The cosine falls as the angle rises.
  if (is_in_degrees(first) && is_in_degrees(second)) std::swap(lower, upper);
  if (!(*lower < *upper)) refuse("is empty or reversed: A must be less than B");
  if (*lower < 0 || *upper > 1) refuse("is not inside 0:1: A and B are cosines");
  if (*upper - *lower < narrowest_domain)
    refuse(fmt::format("is {:.3g} wide: at least {:g}, a million roundings of a cosine", *upper - *lower,
                       narrowest_domain));
  return {*lower, *upper};
}

Held parse_held(const std::string& option, const std::string& text) {
  const auto parts = split(text);
  auto value = parts ? parse_number(parts->second) : std::nullopt;
  if (parts && !value) value = parse_hex(parts->second);
  if (!value) throw UserError(fmt::format("{} '{}' is not NAME=VALUE with a finite number", option, text));
  return {parts->first, *value};
}

Constants parse_parameters(const std::string& option, const std::string& text) {
  Constants parameters;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const auto part = split(text.substr(start, end - start));
    if (!part)
      throw UserError(fmt::format("{} '{}' is not a list of NAME=VALUE separated by commas", option, text));
    parameters.push_back(*part);
    start = end + 1;
  }
  return parameters;
}

double parse_relative_width(const std::string& option, const std::string& text) {
  const double width = parse_finite(option, text);
  if (!(width > 0 && width < 1))
    throw UserError(fmt::format("{} '{}' is not a relative width: it must be greater than 0 and less than 1",
                                option, text));
  if (width < least_width)
    throw UserError(fmt::format("{} '{}' cannot be reached: the bounds are doubles, {} is the least", option,
                                text, least_width));
  return width;
}

std::vector<std::string> words_of(const CLI::App& command, const std::vector<std::string>& without) {
  std::vector<std::string> words{command.get_name()};
  for (const CLI::Option* option : command.get_options()) {
    const std::string option_name = option->get_name();
    if (std::ranges::find(without, option_name) != without.end()) continue;
    for (const std::string& value : option->results()) {
      if (value == option->get_default_str()) continue;
      if (!option->get_positional()) words.push_back(option_name);
      const bool is_flag = option->get_items_expected_max() == 0;
      if (!is_flag) words.push_back(value);
    }
  }
  return words;
}

std::string shell_text(const std::vector<std::string>& words) {
  std::string text = "shadefit";
  for (const std::string& word : words) {
    // POSIX's portable characters of file names, and others without a meaning for a shell. Words with any
    // other character are quoted.
    constexpr std::string_view plain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./:=,+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      text += " " + word;
      continue;
    }
    text += " '" + boost::replace_all_copy(word, "'", "'\\''") + "'";
  }
  return text;
}

}  // namespace shadefit
