#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// UTF-8 as RFC 3629 has it, and what of a text a terminal can show.
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

/// Whether a code point of three bytes ends a line (U+2028, U+2029) or turns the direction of what follows
/// (U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069).
inline bool is_invisible(std::string_view point) {
  if (!point.starts_with('\xE2') || point.size() != 3) return false;
  const unsigned second = static_cast<unsigned char>(point[1]), third = static_cast<unsigned char>(point[2]);
  const unsigned code = 0x2000 | (second & 0x3F) << 6 | (third & 0x3F);
  return code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// The pieces of a text that a terminal can show: code points, and as \xNN each byte of a control character
/// (C0 and C1), of what ends or turns a line unseen, or of what is no UTF-8.
inline std::vector<std::string> printable_pieces(std::string_view text) {
  std::vector<std::string> pieces;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_c1 = byte == 0xC2 && length == 2 && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (length == 0 || byte < 0x20 || byte == 0x7F || is_c1 || is_invisible(text.substr(i, length))) {
      pieces.push_back(fmt::format("\\x{:02x}", byte));
      ++i;
    } else {
      pieces.emplace_back(text.substr(i, length));
      i += length;
    }
  }
  return pieces;
}

/// All of a text, such as a path, as a terminal can show it.
inline std::string printable(std::string_view text) {
  return fmt::format("{}", fmt::join(printable_pieces(text), ""));
}

/// One line that a terminal can show, the middle of a very long text left out. It is left out before anything
/// is escaped: a text of a user's file may be of any size.
inline std::string one_line(std::string_view text) {
  constexpr std::size_t longest = 600, half = longest / 2;
  constexpr std::size_t most_bytes = 4;  // of a piece, so that as many hold at least half of the pieces
  const bool is_long = text.size() > longest * most_bytes;
  const auto head = printable_pieces(is_long ? text.substr(0, half * most_bytes) : text);
  if (!is_long && head.size() <= longest) return fmt::format("{}", fmt::join(head, ""));
  std::string_view end = text.substr(is_long ? text.size() - half * most_bytes : 0);
  // Not from the middle of a code point on, which has at most three bytes more.
  for (int i = 0; i < 3 && is_long && utf8_length(end) == 0; ++i) end.remove_prefix(1);
  const auto tail = printable_pieces(end);
  const auto first = head.begin(), last = tail.end();
  const auto count = static_cast<std::ptrdiff_t>(half);
  return fmt::format("{} .. {}", fmt::join(first, first + count, ""),
                     fmt::join(last - std::min(count, last - tail.begin()), last, ""));
}

}  // namespace shadefit
