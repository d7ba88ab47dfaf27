#include "fit/catalogue/study_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/support/format.hpp"
#include "fit/support/lines.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The text before and after the first '='.
std::pair<std::string, std::string> halves(const std::string& option, const std::string& text,
                                           const char* rule) {
  const auto sign = text.find('=');
  const std::string name(trimmed(text.substr(0, sign)));
  const std::string value(sign == std::string::npos ? "" : trimmed(text.substr(sign + 1)));
  if (name.empty() || value.empty()) throw UserError(fmt::format("{} '{}' is not {}", option, text, rule));
  return {name, value};
}

/// The parts of a text between separators that stand outside parentheses, at most `most`: the last keeps the
/// rest.
std::vector<std::string> parts_of(const std::string& text, char separator, std::size_t most) {
  std::vector<std::string> parts{""};
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == separator && depth == 0 && parts.size() < most) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = std::string(trimmed(part));
  return parts;
}

}  // namespace

StudyRange parse_over(const std::string& option, const std::string& text) {
  if (const auto several = parts_of(text, ',', text.size() + 1); several.size() > 1)
    throw UserError(fmt::format("{0} '{1}' names several variables: say {0} {2}", option, text,
                                fmt::join(several, " " + option + " ")));
  if (text.find('=') == std::string::npos && text.find(':') != std::string::npos)
    throw UserError(fmt::format("{0} '{1}' names no variable: say {0} x={1}", option, text));
  if (text.find('=') == std::string::npos) return {std::string(trimmed(text)), "", ""};
  constexpr const char* rule = "NAME=A:B or NAME=A:B:DENSITY";
  const auto [name, range] = halves(option, text, rule);
  const auto parts = parts_of(range, ':', 3);
  if (parts.size() < 2 || std::ranges::any_of(parts, [](const auto& p) { return p.empty(); }))
    throw UserError(fmt::format("{} '{}' is not {}", option, text, rule));
  return {name, parts[0], parts[1], parts.size() == 3 ? density_of(parts[2], name) : "1"};
}

std::pair<std::string, std::vector<std::string>> parse_given(const std::string& option,
                                                             const std::string& text) {
  const auto [name, list] = halves(option, text, "NAME=LIST");
  std::vector<std::string> values;
  for (const std::string& part : parts_of(list, ',', list.size() + 1)) {
    if (part.empty()) throw UserError(fmt::format("{} '{}' has an empty value", option, text));
    if (part.find(':') == std::string::npos) {
      values.push_back(part);
      continue;
    }
    try {
      for (const double value : parse_sweep(part)) values.push_back(to_text(value));
    } catch (const std::exception& error) {
      throw UserError(fmt::format("{} '{}': {}", option, text, error.what()));
    }
  }
  return {name, values};
}

StudyDefinition parse_let(const std::string& option, const std::string& text) {
  constexpr const char* rule = "NAME = FORMULA or NAME(A, B) = FORMULA";
  const auto [head, formula] = halves(option, text, rule);
  const auto open = head.find('(');
  if (open == std::string::npos) return {head, {}, formula};
  if (head.back() != ')') throw UserError(fmt::format("{} '{}' is not {}", option, text, rule));
  const std::string list = head.substr(open + 1, head.size() - open - 2);
  return {std::string(trimmed(head.substr(0, open))), parts_of(list, ',', list.size() + 1), formula};
}

ParameterBounds parse_bounds(const std::string& option, const std::string& text) {
  constexpr const char* rule = "NAME=A:B, NAME=A: or NAME=:B";
  const auto [name, range] = halves(option, text, rule);
  const auto parts = parts_of(range, ':', 3);
  if (parts.size() != 2) throw UserError(fmt::format("{} '{}' is not {}", option, text, rule));
  if (parts[0].empty() && parts[1].empty())
    throw UserError(
        fmt::format("{0} '{1}' has no end: say {0} {2}=0: for values from 0 on", option, text, name));
  const auto end = [&](const std::string& formula, double open) {
    if (formula.empty()) return open;
    const std::optional<double> value = value_of_numbers(formula);
    if (!value) throw UserError(fmt::format("{} '{}': '{}' is not a finite number", option, text, formula));
    return *value;
  };
  const ParameterBounds bounds{name, end(parts[0], -HUGE_VAL), end(parts[1], HUGE_VAL)};
  if (bounds.lower == bounds.upper)
    throw UserError(fmt::format("{} '{}' leaves one value: say --fix {}={}", option, text, name, parts[0]));
  if (bounds.lower > bounds.upper)
    throw UserError(fmt::format("{0} '{1}' is empty: it must rise, say {0} {2}={4}:{3}", option, text, name,
                                parts[0], parts[1]));
  return bounds;
}

std::vector<std::string> parse_names(const std::string& option, const std::string& text) {
  const std::vector<std::string> names = parts_of(text, ',', text.size() + 1);
  if (std::ranges::any_of(names, [](const std::string& name) { return name.empty(); }))
    throw UserError(fmt::format("{} '{}' is not a list of names separated by commas", option, text));
  return names;
}

}  // namespace shadefit
