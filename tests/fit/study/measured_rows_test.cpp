#include "fit/study/measured_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/refusal.hpp"

namespace shadefit {
namespace {

/// A text in parts of a length; the last part may be shorter.
TextParts parts_of(const std::string& text, std::size_t length = std::string::npos) {
  return [text, length, from = std::size_t{0}]() mutable {
    const std::string part = text.substr(from, length);
    from += part.size();
    return part;
  };
}

MeasuredRows read_rows(const std::string& text) {
  return read_measured_rows(parts_of(text), "m.csv", {"x"});
}

using Numbers = std::vector<double>;

TEST(MeasuredRows, ReadsColumnsByName) {
  const MeasuredRows rows = read_rows("value,x,sigma\n1,2,0.5\n-3e2,+4,.25\n");
  EXPECT_EQ(rows.file, "m.csv");
  ASSERT_EQ(rows.places.size(), 1u);
  EXPECT_EQ(rows.places[0], (Numbers{2, 4}));
  EXPECT_EQ(rows.value, (Numbers{1, -300}));
  EXPECT_EQ(rows.sigma, (Numbers{0.5, 0.25}));
}

// Windows, an old Macintosh, a last line without an end, a byte order mark, blanks, columns of text: as other
// tools write them.
TEST(MeasuredRows, ReadsWhatOtherToolsWrite) {
  const Numbers one{1}, two{2};
  for (const char* text : {"x,value\n1,2\n", "x,value\r\n1,2\r\n", "x,value\r1,2\r", "x,value\n1,2",
                           "\xEF\xBB\xBFx,value\n1,2\n", " x ,\tvalue \n 1 ,\t2 \n",
                           "name,x,value\nsteel,1,2\n", "x,value,name\n1,2,\n", "x value\n1 2\n",
                           "x\tvalue\n1\t2\n", "  x \t value\n   1.0  \t2 \n", "# x value\n1.0e+00 2.0e+00\n",
                           "#x,value\n1,2\n", "# x, value\n1 2\n", "# of 2020\n# by hand\n#x value\n1 2\n",
                           "# of 2020\nx,value\n1,2\n", "# name,x,value\nsteel,1,2\n"}) {
    const MeasuredRows rows = read_rows(text);
    EXPECT_EQ(rows.places[0], one) << text;
    EXPECT_EQ(rows.value, two) << text;
    EXPECT_TRUE(rows.sigma.empty()) << text;
  }
}

std::string refusal_of_rows(const std::string& text) {
  return testing::refusal([&] { read_rows(text); });
}

void expect_fault(const std::string& text, int line, const std::string& fault) {
  EXPECT_EQ(refusal_of_rows(text), "'m.csv', line " + std::to_string(line) + ": " + fault);
}

TEST(MeasuredRows, AnswersBadInputWithOneLine) {
  EXPECT_EQ(refusal_of_rows(""), "'m.csv' is empty: its first line must name the columns");
  EXPECT_EQ(refusal_of_rows(std::string("x,value\n1,\0\n", 12)), "'m.csv' is not a text: it has a byte 0");
  EXPECT_EQ(refusal_of_rows("x,value\n"), "'m.csv' has no rows below its header");
  expect_fault("0,1\n1,2\n", 1, "column 1 is a number: the first line must name the columns");
  expect_fault("x,\n1,2\n", 1, "column 2 has no name");
  expect_fault("x,value,x\n1,2,3\n", 1, "'x' is there twice");
  EXPECT_EQ(refusal_of_rows("t,value\n1,2\n"), "'m.csv' has no column 'x'; it has 't', 'value'");
  EXPECT_EQ(refusal_of_rows("x,y\n1,2\n"),
            "'m.csv' has no column 'value'; it has 'x', 'y': --value names the measured one");
  expect_fault("x,value\n1,2\n3\n", 3, "has 1 cell, the header has 2");
  expect_fault("x,value\n1,2,3\n", 2, "has 3 cells, the header has 2");
  expect_fault("x,value\n1,2\n\n", 3, "has 1 cell, the header has 2");
  expect_fault("x,value\n1,two\n", 2, "value 'two' is not a finite number");
  expect_fault("x,value\n1,\n", 2, "value '' is not a finite number");
  expect_fault("x,value\nnan,1\n", 2, "x 'nan' is not a finite number");
  expect_fault("x,value\n1e999,1\n", 2, "x '1e999' is not a finite number");
  expect_fault("x,value\n+-1,1\n", 2, "x '+-1' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\n1;5,1\n"), "'m.csv', line 2: x '1;5' is not a finite number");
  expect_fault("x,value\n\"1\",2\n", 2, "a quote: write numbers and names without quotes");
  expect_fault("x,value,sigma\n1,2,0\n", 2, "sigma '0' must be greater than 0");
  expect_fault("x,value,sigma\n1,2,-1\n", 2, "sigma '-1' must be greater than 0");
  expect_fault("x,value\n1," + std::string(1000, 'z') + "\n", 2,
               "value '" + std::string(40, 'z') + " ..' is not a finite number");
  expect_fault("x,value" + std::string(1000, ',') + "\n", 1, "more than 1000 cells");
}

TEST(MeasuredRows, NamesTheMeasuredColumnAndTheLines) {
  const MeasuredRows rows =
      read_measured_rows(parts_of("# a test\n# x light\n1 2\n"), "m.csv", {"x"}, "light");
  EXPECT_EQ(rows.value, Numbers{2});
  EXPECT_EQ(line_of_row(rows, 1), 3u);
  expect_fault("#\nx,value\n1,two\n", 3, "value 'two' is not a finite number");
  expect_fault("# 1 2\n3 4\n", 1, "column 1 is a number: the first line must name the columns");
  expect_fault("#\n", 1, "column 1 has no name");
}

TEST(MeasuredRows, ReadsPartsThatEndAnywhere) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text =
        "# by hand" + end + "# x value sigma" + end + "1.25 2 3" + end + "4 5 0.75" + end;
    for (std::size_t length = 1; length <= text.size(); ++length) {
      const MeasuredRows rows = read_measured_rows(parts_of(text, length), "m.csv", {"x"});
      EXPECT_EQ(rows.places[0], (Numbers{1.25, 4})) << length;
      EXPECT_EQ(rows.value, (Numbers{2, 5})) << length;
      EXPECT_EQ(rows.sigma, (Numbers{3, 0.75})) << length;
      EXPECT_EQ(line_of_row(rows, 1), 3u);
    }
  }
  const std::string long_line = "x,value\n1," + std::string(3 << 20, ' ') + "2\n";
  EXPECT_EQ(testing::refusal([&] { read_measured_rows(parts_of(long_line, 1 << 20), "m.csv", {"x"}); }),
            "'m.csv', line 2: more than 1048576 bytes");
}

/// The text of so many rows, a part at a time.
TextParts text_of_rows(std::size_t count) {
  return [count, part = std::string("x,value\n")]() mutable {
    constexpr std::size_t most = 100'000;
    std::string next;
    for (std::size_t i = 0; i < std::min(count, most); ++i) next += "1,2\n";
    count -= std::min(count, most);
    return std::exchange(part, next);
  };
}

// Of the text nothing remains: a row takes 8 bytes a column.
TEST(MeasuredRows, HasALimit) {
  const MeasuredRows rows = read_measured_rows(text_of_rows(most_rows), "m.csv", {"x"});
  for (const auto* column : columns_of(rows)) {
    EXPECT_EQ(column->size(), 10'000'000u);
    EXPECT_EQ(column->capacity(), column->size());
  }
  EXPECT_EQ(testing::refusal([] { read_measured_rows(text_of_rows(most_rows + 1), "m.csv", {"x"}); }),
            "'m.csv' has more than 10000000 rows");
}

}  // namespace
}  // namespace shadefit
