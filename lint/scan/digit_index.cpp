#include "lint/scan/digit_index.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <tuple>

namespace shadefit::lint {
namespace {

/// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits) of a text without the digit at `skipped`.
std::uint64_t key_of(std::string_view text, std::size_t skipped) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == skipped) continue;
    hash = (hash ^ static_cast<unsigned char>(text[i])) * 0x100000001b3;
  }
  return hash ^ (hash >> 29);
}

/// 0.TEXT to the first 15 digits, which a double has.
double mantissa_of(const Digits& digits) {
  constexpr std::size_t digits_of_a_double = 15;
  double first = 0, power = 1;
  for (const char digit : std::string_view(digits.text).substr(0, digits_of_a_double)) {
    first = 10 * first + (digit - '0');
    power *= 10;
  }
  return first / power;
}

constexpr std::size_t least_digits = 3;

/// The elements whose keys are in [low, high], of those that are sorted by the key.
template <class T, class Value, class KeyOf>
std::span<const T> between(const std::vector<T>& sorted, Value low, Value high, KeyOf key_of) {
  const auto first = std::ranges::lower_bound(sorted, low, {}, key_of);
  return {first, std::ranges::upper_bound(first, sorted.end(), high, {}, key_of)};
}

/// Adds a match, unless a closer one is there.
void append(const NumberMatch& match, std::vector<NumberMatch>& matches) {
  for (NumberMatch& other : matches) {
    if (other.place != match.place) continue;
    if (match.variant && !other.variant && other.match > DigitMatch::float32) other = match;
    return;
  }
  matches.push_back(match);
}

}  // namespace

DigitIndex::DigitIndex(const std::vector<KnownSet>& sets) {
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (std::size_t c = 0; c < sets[s].constants.size(); ++c) {
      const KnownConstant& constant = sets[s].constants[c];
      const Digits digits = digits_of(constant.printed);
      if (digits.text.size() >= least_digits)
        entries_.push_back({digits, mantissa_of(digits), {s, c}, constant.is_common});
    }
    for (std::size_t v = 0; v < sets[s].variants.size(); ++v) {
      const Digits digits = digits_of(sets[s].variants[v].printed);
      entries_.push_back({digits, mantissa_of(digits), {s, sets[s].variants[v].constant}, false, v});
    }
  }
  std::ranges::sort(entries_, {}, [](const Entry& entry) {
    return std::tuple(entry.mantissa, entry.place, entry.variant);
  });
  for (std::uint32_t e = 0; e < entries_.size(); ++e) {
    const std::string& text = entries_[e].digits.text;
    if (entries_[e].variant || entries_[e].is_common || text.size() < least_digits_to_vary) continue;
    for (std::size_t skipped = 0; skipped <= text.size(); ++skipped)
      keys_.emplace_back(key_of(text, skipped), e);
  }
  std::ranges::sort(keys_);
}

std::vector<NumberMatch> DigitIndex::find(const Digits& found) const {
  std::vector<NumberMatch> matches;
  if (found.text.size() < least_digits) return matches;
  look_near(found, matches);
  look_edited(found, matches);
  return matches;
}

void DigitIndex::look_near(const Digits& found, std::vector<NumberMatch>& matches) const {
  const double mantissa = mantissa_of(found);
  // Numbers that agree in three digits are closer than this; those that agree in four are
  // closer than a tenth of it.
  const double near = found.text.size() == least_digits ? 0.011 : 0.0011;
  for (const Entry& entry :
       between(entries_, mantissa * (1 - near), mantissa * (1 + near), &Entry::mantissa)) {
    if (entry.variant) {
      if (found == entry.digits) append({entry.place, DigitMatch::edited, entry.variant}, matches);
    } else if (const auto match = match_digits(found, entry.digits);
               match && !(entry.is_common && *match > DigitMatch::rounded)) {
      append({entry.place, *match}, matches);
    }
  }
}

void DigitIndex::look_edited(const Digits& found, std::vector<NumberMatch>& matches) const {
  for (std::size_t skipped = 0; skipped <= found.text.size(); ++skipped) {
    const std::uint64_t key = key_of(found.text, skipped);
    for (const auto& [same, place] : between(keys_, key, key, &Key::first)) {
      const Entry& entry = entries_[place];
      if (const auto match = match_digits(found, entry.digits)) append({entry.place, *match}, matches);
    }
  }
}

}  // namespace shadefit::lint
