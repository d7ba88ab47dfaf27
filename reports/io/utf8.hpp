#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

/// UTF-8 by RFC 3629, and text that is safe to show on a terminal.
namespace shadefit {

struct CodePoint {
  std::size_t length = 0;  ///< in bytes
  char32_t value = 0;
};

/// The first code point of `text`. Its length is 0 if `text` is empty or does not begin with a code point: a
/// byte out of place, a sequence that is cut off or longer than needed, a surrogate, a value above U+10FFFF.
inline CodePoint first_code_point(std::string_view text) {
  namespace utf = boost::locale::utf;
  const char* behind = text.data();
  const utf::code_point value = utf::utf_traits<char>::decode(behind, text.data() + text.size());
  if (value == utf::illegal || value == utf::incomplete) return {};
  return {static_cast<std::size_t>(behind - text.data()), value};
}

/// Whether a code point could forge a line on a terminal: control characters (C0, DEL, C1), ends of lines
/// (U+2028, U+2029), Unicode's Bidi_Control (PropList.txt), and characters without width or shape (the format
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

/// All of a text, such as a path, as a terminal can show it: \xNN for each byte of a code point that
/// `is_unshown`, and for each byte that is not UTF-8.
inline std::string printable(std::string_view text) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
  std::string shown;
  while (true) {
    // Most text is plain: it is copied at once.
    const auto plain = static_cast<std::size_t>(std::ranges::find_if_not(text, is_plain) - text.begin());
    shown += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) return shown;
    const auto [length, value] = first_code_point(text);
    const std::string_view point = text.substr(0, std::max<std::size_t>(length, 1));
    if (length > 0 && !is_unshown(value)) {
      shown += point;
    } else {
      for (const char c : point) shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
    text.remove_prefix(point.size());
  }
}

/// One line that a terminal can show, the middle of a text of more than 600 bytes left out.
inline std::string one_line(std::string_view text) {
  constexpr std::size_t longest = 600, half = longest / 2;
  if (text.size() <= longest) return printable(text);
  const auto is_inside_a_code_point = [&](std::size_t i) { return (text[i] & 0xC0) == 0x80; };
  std::size_t head = half, tail = text.size() - half;
  while (head > 0 && is_inside_a_code_point(head)) --head;
  while (tail < text.size() && is_inside_a_code_point(tail)) ++tail;
  return printable(text.substr(0, head)) + " .. " + printable(text.substr(tail));
}

}  // namespace shadefit
