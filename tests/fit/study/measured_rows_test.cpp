#include "fit/study/measured_rows.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/refusal.hpp"

namespace shadefit {
namespace {

MeasuredRows read_rows(const std::string& text) {
  return read_measured_rows(text, "m.csv", {"x"});
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

TEST(MeasuredRows, AnswersBadInputWithOneLine) {
  EXPECT_EQ(refusal_of_rows(""), "'m.csv' is empty: its first line must name the columns");
  EXPECT_EQ(refusal_of_rows(std::string("x,value\n1,\0\n", 12)), "'m.csv' is not a text: it has a byte 0");
  EXPECT_EQ(refusal_of_rows("x,value\n"), "'m.csv' has no rows below its header");
  EXPECT_EQ(refusal_of_rows("0,1\n1,2\n"),
            "'m.csv', line 1: column 1 is a number: the first line must name the columns");
  EXPECT_EQ(refusal_of_rows("x,\n1,2\n"), "'m.csv', line 1: column 2 has no name");
  EXPECT_EQ(refusal_of_rows("x,value,x\n1,2,3\n"), "'m.csv', line 1: 'x' is there twice");
  EXPECT_EQ(refusal_of_rows("t,value\n1,2\n"), "'m.csv' has no column 'x'; it has 't', 'value'");
  EXPECT_EQ(refusal_of_rows("x,y\n1,2\n"),
            "'m.csv' has no column 'value'; it has 'x', 'y': --value names the measured one");
  EXPECT_EQ(refusal_of_rows("x,value\n1,2\n3\n"), "'m.csv', line 3: has 1 cell, the header has 2");
  EXPECT_EQ(refusal_of_rows("x,value\n1,2,3\n"), "'m.csv', line 2: has 3 cells, the header has 2");
  EXPECT_EQ(refusal_of_rows("x,value\n1,2\n\n"), "'m.csv', line 3: has 1 cell, the header has 2");
  EXPECT_EQ(refusal_of_rows("x,value\n1,two\n"), "'m.csv', line 2: value 'two' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\n1,\n"), "'m.csv', line 2: value '' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\nnan,1\n"), "'m.csv', line 2: x 'nan' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\n1e999,1\n"), "'m.csv', line 2: x '1e999' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\n+-1,1\n"), "'m.csv', line 2: x '+-1' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\n1;5,1\n"), "'m.csv', line 2: x '1;5' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value\n\"1\",2\n"),
            "'m.csv', line 2: a quote: write numbers and names without quotes");
  EXPECT_EQ(refusal_of_rows("x,value,sigma\n1,2,0\n"), "'m.csv', line 2: sigma '0' must be greater than 0");
  EXPECT_EQ(refusal_of_rows("x,value,sigma\n1,2,-1\n"), "'m.csv', line 2: sigma '-1' must be greater than 0");
  EXPECT_EQ(refusal_of_rows("x,value\n1," + std::string(1000, 'z') + "\n"),
            "'m.csv', line 2: value '" + std::string(40, 'z') + " ..' is not a finite number");
  EXPECT_EQ(refusal_of_rows("x,value" + std::string(1000, ',') + "\n"),
            "'m.csv', line 1: more than 1000 cells");
}

TEST(MeasuredRows, NamesTheMeasuredColumnAndTheLines) {
  const MeasuredRows rows = read_measured_rows("# a test\n# x light\n1 2\n", "m.csv", {"x"}, "light");
  EXPECT_EQ(rows.value, Numbers{2});
  EXPECT_EQ(line_of_row(rows, 1), 3u);
  EXPECT_EQ(refusal_of_rows("#\nx,value\n1,two\n"), "'m.csv', line 3: value 'two' is not a finite number");
  EXPECT_EQ(refusal_of_rows("# 1 2\n3 4\n"),
            "'m.csv', line 1: column 1 is a number: the first line must name the columns");
  EXPECT_EQ(refusal_of_rows("#\n"), "'m.csv', line 1: column 1 has no name");
}

TEST(MeasuredRows, HasALimit) {
  std::string text = "x,value\n";
  for (std::size_t row = 0; row < most_rows; ++row) text += "1,2\n";
  EXPECT_EQ(read_rows(text).value.size(), most_rows);
  EXPECT_EQ(refusal_of_rows(text + "1,2\n"), "'m.csv' has more than 100000 rows");
}

}  // namespace
}  // namespace shadefit
