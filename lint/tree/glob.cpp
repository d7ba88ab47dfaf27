#include "lint/tree/glob.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

using StepKind = GlobStep::Kind;

constexpr std::size_t byte_index(char c) {
  return static_cast<unsigned char>(c);
}

bool is_byte_within(char c, char first, char last) {
  return byte_index(first) <= byte_index(c) && byte_index(c) <= byte_index(last);
}

/// A class of bytes, as [:alpha:].
struct ByteClass {
  std::string_view name;
  bool (*has)(char c);
};

/// The classes of ASCII, in every locale. git's spaces are these four.
constexpr std::array<ByteClass, 12> classes{{
    {"alnum", [](char c) { return is_letter(c) || is_digit(c); }},
    {"alpha", is_letter},
    {"blank", is_blank_in_line},
    {"cntrl", [](char c) { return byte_index(c) < ' ' || c == '\x7F'; }},
    {"digit", is_digit},
    {"graph", [](char c) { return is_byte_within(c, '!', '~'); }},
    {"lower", [](char c) { return is_byte_within(c, 'a', 'z'); }},
    {"print", [](char c) { return is_byte_within(c, ' ', '~'); }},
    {"punct", [](char c) { return is_byte_within(c, '!', '~') && !is_letter(c) && !is_digit(c); }},
    {"space", is_blank},
    {"upper", [](char c) { return is_byte_within(c, 'A', 'Z'); }},
    {"xdigit",
     [](char c) { return is_digit(c) || is_byte_within(c, 'a', 'f') || is_byte_within(c, 'A', 'F'); }},
}};

/// The set of a class; empty for an unknown one.
std::optional<std::bitset<256>> set_of_class(std::string_view name) {
  const auto found = std::ranges::find(classes, name, &ByteClass::name);
  if (found == classes.end()) return std::nullopt;
  std::bitset<256> set;
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = found->has(static_cast<char>(i));
  return set;
}

/// Takes the set after a '[', with its ']', from the text. Empty if it is malformed.
std::optional<std::bitset<256>> take_set(std::string_view& text) {
  std::bitset<256> set;
  const auto take = [&]() -> std::optional<char> {
    if (text.empty()) return std::nullopt;
    const char c = text.front();
    text.remove_prefix(1);
    return c;
  };
  const bool is_negative = text.starts_with('!') || text.starts_with('^');
  if (is_negative) text.remove_prefix(1);
  std::size_t before = 0;  // the byte that a range may begin with; 0: none
  for (bool is_first = true;; is_first = false) {
    std::optional<char> c = take();
    if (!c) return std::nullopt;
    if (*c == ']' && !is_first) break;
    const std::size_t close = text.find(']');
    if (*c == '-' && before > 0 && !text.empty() && text.front() != ']') {
      c = take();
      if (*c == '\\') c = take();
      if (!c) return std::nullopt;
      for (std::size_t i = before; i <= byte_index(*c); ++i) set.set(i);
      before = 0;
      continue;
    }
    if (*c == '[' && text.starts_with(':') && close == std::string_view::npos) return std::nullopt;
    // "[:]" has no room for the second colon.
    if (*c == '[' && text.starts_with(':') && close >= 2 && text[close - 1] == ':') {
      const auto named = set_of_class(text.substr(1, close - 2));
      if (!named) return std::nullopt;
      set |= *named;
      text.remove_prefix(close + 1);
      before = 0;
      continue;
    }
    if (*c == '\\') c = take();
    if (!c) return std::nullopt;
    set.set(byte_index(*c));
    before = byte_index(*c);
  }
  return is_negative ? ~set : set;
}

GlobStep byte_step(char c) {
  return {StepKind::byte, std::bitset<256>().set(byte_index(c))};
}

/// Takes the stars that the rest of a pattern begins with.
void take_stars(std::string_view pattern, std::string_view& rest, std::vector<GlobStep>& steps) {
  const std::size_t begin = pattern.size() - rest.size();
  const std::size_t count = std::min(rest.find_first_not_of('*'), rest.size());
  rest.remove_prefix(count);
  const bool is_behind_slash = begin == 0 || pattern[begin - 1] == '/';
  const bool is_before_slash = rest.empty() || rest.starts_with('/') || rest.starts_with("\\/");
  if (count == 1 || !is_behind_slash || !is_before_slash) {
    steps.push_back({StepKind::star});
  } else if (rest.starts_with('/')) {
    steps.insert(steps.end(), {{StepKind::optional}, {StepKind::stars}, byte_step('/')});
    rest.remove_prefix(1);
  } else {
    steps.push_back({StepKind::stars});
  }
}

/// The steps of a pattern; empty if it is malformed.
std::optional<std::vector<GlobStep>> read_steps(std::string_view pattern) {
  std::vector<GlobStep> steps;
  for (std::string_view rest = pattern; !rest.empty();) {
    char c = rest.front();
    if (c == '*') {
      take_stars(pattern, rest, steps);
      continue;
    }
    rest.remove_prefix(1);
    if (c == '?' || c == '[') {
      auto set = c == '?' ? std::optional(~std::bitset<256>()) : take_set(rest);
      if (!set) return std::nullopt;
      steps.push_back({StepKind::byte, set->reset(byte_index('/'))});
      continue;
    }
    if (c == '\\') {
      if (rest.empty()) return std::nullopt;
      c = rest.front();
      rest.remove_prefix(1);
    }
    steps.push_back(byte_step(c));
  }
  return steps;
}

/// Moves the last single bytes from the steps to a text.
std::string take_end(std::vector<GlobStep>& steps) {
  std::string end;
  while (!steps.empty() && steps.back().kind == StepKind::byte && steps.back().bytes.count() == 1) {
    const bool is_optional = steps.size() >= 3 && steps[steps.size() - 3].kind == StepKind::optional;
    if (is_optional) break;
    std::size_t byte = 0;
    while (!steps.back().bytes[byte]) ++byte;
    end.insert(end.begin(), static_cast<char>(byte));
    steps.pop_back();
  }
  return end;
}

/// Marks also the next step if a step can match nothing.
void leave_out(std::vector<char>& at, const std::vector<GlobStep>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (at[i] == 0 || steps[i].kind == StepKind::byte) continue;
    at[i + 1] = 1;
    if (steps[i].kind == StepKind::optional) at[i + 3] = 1;
  }
}

}  // namespace

Glob parse_glob(std::string_view pattern) {
  const std::size_t wild = std::min(pattern.find_first_of("*?[\\"), pattern.size());
  auto steps = read_steps(pattern.substr(wild));
  if (!steps) return {{}, {}, {}, false};
  std::string end = take_end(*steps);
  return {std::string(pattern.substr(0, wild)), std::move(end), *std::move(steps)};
}

bool matches(const Glob& glob, std::string_view text) {
  if (!glob.is_valid || text.size() < glob.start.size() + glob.end.size()) return false;
  if (!text.starts_with(glob.start) || !text.ends_with(glob.end)) return false;
  text = text.substr(glob.start.size(), text.size() - glob.start.size() - glob.end.size());
  const std::vector<GlobStep>& steps = glob.steps;
  if (steps.empty()) return text.empty();
  if (steps.size() == 1 && steps[0].kind == StepKind::star) return text.find('/') == std::string_view::npos;
  // All ways in parallel, byte by byte, so that a hostile glob cannot make them branch.
  std::vector<char> at(steps.size() + 1), next(steps.size() + 1);
  at[0] = 1;
  leave_out(at, steps);
  for (const char c : text) {
    std::ranges::fill(next, '\0');
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (at[i] == 0) continue;
      const StepKind kind = steps[i].kind;
      if (kind == StepKind::byte && steps[i].bytes[byte_index(c)]) next[i + 1] = 1;
      if (kind == StepKind::stars || (kind == StepKind::star && c != '/')) next[i] = 1;
    }
    leave_out(next, steps);
    at.swap(next);
  }
  return at.back() != 0;
}

}  // namespace shadefit::lint
