#include "reports/io/utf8.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace shadefit {
namespace {

/// A code point in `length` bytes, by the layout of UTF-8 alone: too long, a surrogate or out of range, if
/// asked for.
std::string encoded(std::uint32_t code_point, int length) {
  if (length == 1) return {static_cast<char>(code_point)};
  std::string bytes(static_cast<std::size_t>(length), '\0');
  for (auto i = bytes.size(); i-- > 1; code_point >>= 6)
    bytes[i] = static_cast<char>(0x80 | (code_point & 0x3F));
  bytes[0] = static_cast<char>((0xF00 >> length & 0xFF) | code_point);
  return bytes;
}

int shortest(std::uint32_t code_point) {
  return code_point < 0x80 ? 1 : code_point < 0x800 ? 2 : code_point < 0x10000 ? 3 : 4;
}

TEST(Utf8, TakesEveryCodePointInItsShortestFormOnly) {
  for (std::uint32_t code_point = 0; code_point < 0x200000; ++code_point) {
    const bool exists = code_point <= 0x10FFFF && (code_point < 0xD800 || code_point > 0xDFFF);
    for (int length = shortest(code_point); length <= 4; ++length) {
      const std::size_t expected =
          exists && length == shortest(code_point) ? static_cast<std::size_t>(length) : 0;
      const CodePoint found = first_code_point(encoded(code_point, length) + "x");
      ASSERT_EQ(found.length, expected) << code_point << " in " << length;
      ASSERT_EQ(found.value, expected > 0 ? code_point : 0U) << code_point;
    }
  }
}

TEST(Utf8, TakesNothingThatIsCutOffOrOutOfPlace) {
  for (const char* whole : {"\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"}) {
    const std::string text(whole);
    EXPECT_EQ(first_code_point(text).length, text.size());
    for (std::size_t length = 1; length < text.size(); ++length) {
      EXPECT_EQ(first_code_point(text.substr(0, length)).length, 0U) << "cut off by the end";
      EXPECT_EQ(first_code_point(text.substr(0, length) + "abc").length, 0U)
          << "cut off by another character";
      EXPECT_EQ(first_code_point(text.substr(length)).length, 0U) << "a rest";
    }
  }
  EXPECT_EQ(first_code_point("").length, 0U);
  EXPECT_EQ(first_code_point("\xF8\x88\x80\x80\x80").length, 0U);
  EXPECT_EQ(first_code_point("\xFF").length, 0U);
}

// What can end or turn a line, or has no width, by Unicode's names for it; everything beside them is shown.
TEST(Utf8, WhatCouldForgeALineIsEscaped) {
  for (const std::uint32_t point :
       {0x00U,   0x1BU,   0x7FU,   0x85U,   0x9BU,   0xADU,   0x061CU, 0x180EU,  0x200BU, 0x200CU, 0x200DU,
        0x200EU, 0x200FU, 0x2028U, 0x2029U, 0x202AU, 0x202BU, 0x202CU, 0x202DU,  0x202EU, 0x2060U, 0x2066U,
        0x2067U, 0x2068U, 0x2069U, 0x3164U, 0xFEFFU, 0xFFF9U, 0xFFFBU, 0xE0001U, 0xE007FU}) {
    const std::string bytes = encoded(point, shortest(point));
    const std::string shown = printable("a" + bytes + "b");
    EXPECT_EQ(shown.size(), 2 + 4 * bytes.size()) << point;
    EXPECT_EQ(shown.find(bytes), std::string::npos) << point;
  }
  for (const std::uint32_t point :
       {0x20U, 0x7EU, 0xA0U, 0xACU, 0xAEU, 0xE9U, 0x061BU, 0x061DU, 0x200AU, 0x2010U, 0x2027U, 0x202FU,
        0x205FU, 0x2070U, 0x3042U, 0xFF21U, 0x1F600U}) {
    const std::string bytes = encoded(point, shortest(point));
    EXPECT_EQ(printable(bytes), bytes) << point;
  }
}

TEST(Utf8, OneLineShowsNoControlCharacterAndIsBounded) {
  EXPECT_EQ(one_line("a\x1B[2J\r\n\x7F\xC2\x9B\xFF \xC3\xA9"),
            "a\\x1b[2J\\x0d\\x0a\\x7f\\xc2\\x9b\\xff \xC3\xA9");
  EXPECT_EQ(one_line(std::string(600, 'x')), std::string(600, 'x'));
  EXPECT_EQ(one_line(std::string(301, 'x') + std::string(300, 'y')),
            std::string(300, 'x') + " .. " + std::string(300, 'y'));
  // Long texts are cut before they are escaped: code points of four bytes are whole all the same.
  const auto repeated = [](const std::string& what, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += what;
    return text;
  };
  const std::string smile = "\xF0\x9F\x98\x80";
  EXPECT_EQ(one_line(repeated(smile, 1000)), repeated(smile, 300) + " .. " + repeated(smile, 300));
  EXPECT_EQ(one_line("a" + repeated(smile, 1000) + "b"),
            "a" + repeated(smile, 299) + " .. " + repeated(smile, 299) + "b");
  EXPECT_EQ(one_line(repeated("x", 5000) + "\n"), repeated("x", 300) + " .. " + repeated("x", 299) + "\\x0a");
  EXPECT_EQ(printable(std::string(601, 'x') + "\n"), std::string(601, 'x') + "\\x0a") << "a path is whole";
}

}  // namespace
}  // namespace shadefit
