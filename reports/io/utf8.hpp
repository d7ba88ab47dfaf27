#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// UTF-8 by RFC 3629, and text that is safe to show on a terminal.
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

/// The code point that a text of `length` bytes, as `utf8_length` says, begins with.
inline char32_t code_point(std::string_view text, std::size_t length) {
  // The first byte of a longer sequence spends one bit more on its length than there are bytes.
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  char32_t point = length == 1 ? byte(0) : byte(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) point = point << 6 | (byte(i) & 0x3FU);
  return point;
}

/// Whether a code point could forge a line on a terminal: control characters (C0, DEL, C1), what ends a line
/// (U+2028, U+2029), Unicode's Bidi_Control (PropList.txt), and what has no width or no shape (the format
/// characters of DerivedCoreProperties.txt's Default_Ignorable_Code_Point, and U+FFF9 to U+FFFB).
inline bool is_unshown(char32_t point) {
  constexpr std::pair<char32_t, char32_t> ranges[] = {
      {0x00, 0x1F},     {0x7F, 0x9F},       {0xAD, 0xAD},       {0x034F, 0x034F},  {0x061C, 0x061C},
      {0x115F, 0x1160}, {0x17B4, 0x17B5},   {0x180B, 0x180F},   {0x200B, 0x200F},  {0x2028, 0x202E},
      {0x2060, 0x206F}, {0x3164, 0x3164},   {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},  {0xFFA0, 0xFFA0},
      {0xFFF0, 0xFFFB}, {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}};
  return std::any_of(std::begin(ranges), std::end(ranges),
                     [&](const auto& range) { return point >= range.first && point <= range.second; });
}

/// The pieces of a text that a terminal can show: code points, and as \xNN each byte of a code point that
/// `is_unshown`, or of what is not UTF-8.
inline std::vector<std::string> printable_pieces(std::string_view text) {
  std::vector<std::string> pieces;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const bool is_shown = length > 0 && !is_unshown(code_point(text, length));
    const std::string_view point = text.substr(0, std::max<std::size_t>(length, 1));
    if (is_shown) pieces.emplace_back(point);
    for (std::size_t i = 0; i < point.size() && !is_shown; ++i)
      pieces.push_back(fmt::format("\\x{:02x}", static_cast<unsigned char>(point[i])));
    text.remove_prefix(point.size());
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
