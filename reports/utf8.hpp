#pragma once

#include <cstddef>
#include <string_view>

/// UTF-8 as RFC 3629 has it.
namespace shadefit {

/// The length in bytes of the code point that `text` begins with; 0 where it is empty or begins with none: a
/// byte out of place, a sequence cut off, longer than needed, a surrogate, or beyond U+10FFFF.
inline std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0) == 0x80; };
  const unsigned first = byte(0), second = byte(1);
  if (text.empty()) return 0;
  if (first < 0x80) return 1;
  // Of two bytes: U+0080 to U+07FF, so not C0 and C1.
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  // Of three: U+0800 (E0 A0 80) to U+FFFF, without the surrogates (ED A0 80 to ED BF BF).
  const bool is_three = first >= 0xE0 && first <= 0xEF && !(first == 0xE0 && second < 0xA0) &&
                        !(first == 0xED && second >= 0xA0);
  if (is_three) return follows(1) && follows(2) ? 3 : 0;
  // Of four: U+10000 (F0 90 80 80) to U+10FFFF (F4 8F BF BF).
  const bool is_four = first >= 0xF0 && first <= 0xF4 && !(first == 0xF0 && second < 0x90) &&
                       !(first == 0xF4 && second >= 0x90);
  return is_four && follows(1) && follows(2) && follows(3) ? 4 : 0;
}

}  // namespace shadefit
