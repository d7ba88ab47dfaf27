#include "reports/io/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shadefit {
namespace {

std::string report(const Cell& cell) {
  return text(cell, Precision::report);
}
std::string full(const Cell& cell) {
  return text(cell, Precision::full);
}

TEST(Cell, Texts) {
  EXPECT_EQ(report({}), "");
  EXPECT_EQ(report(std::string("word")), "word");
  EXPECT_EQ(report(14L), "14");
  EXPECT_EQ(report(Number{-0.0, 10}), "0");
  EXPECT_EQ(full(Number{-0.0, 10}), "0");
  EXPECT_EQ(report(Number{1e6, 10}), "1000000");
}

TEST(Cell, AReportShowsNoRoundingNoise) {
  const double x = 0.78754461967478318;
  EXPECT_EQ(report(converged(x)), "0.7875446197");
  EXPECT_EQ(report(converged(x)), report(converged(std::nextafter(x, 1))));
  EXPECT_EQ(full(converged(x)), "0.7875446196747832");
  EXPECT_EQ(std::stod(full(converged(x))), x) << "the shortest text that reads back";
  EXPECT_EQ(report(place({0.055357004712345, 0.944642995287655})), "0.055357");
  EXPECT_EQ(report(place({0.99995002123, 0.4997877e-4})), "0.99995") << "three digits of 1 - c";
  EXPECT_EQ(report(place({0.99995012, 0.4988e-4})), "0.9999501");
  EXPECT_EQ(report(place({1 - 4.999998e-7, 4.999998e-7})), "0.9999995")
      << "and not 1, where there is no error";
  EXPECT_EQ(report(place({1, 0})), "1");
  EXPECT_EQ(report(place({0, 1})), "0");
}

TEST(Cell, ADifferenceStopsWhereItsMinuendDoes) {
  // -5.554727813 has nine decimals, so the difference to -5.55473 has nine too
  EXPECT_EQ(report(difference(2.18735e-06, -5.55472781264884)), "2.187e-06");
  EXPECT_EQ(report(difference(0.000364258522491, 0.775364258522491)), "0.0003642585");
  EXPECT_EQ(report(difference(3e-16, 0.75)), "0") << "what lies below the last digit is rounding";
  EXPECT_EQ(report(difference(0, 0.75)), "0");
  EXPECT_EQ(report(difference(12.5, 0.75)), "12.5") << "never more than ten digits";
}

TEST(Cell, BelowItsFloorADifferenceIsZero) {
  EXPECT_EQ(report(above_floor(0.99e-12, 1e-12)), "0");
  EXPECT_EQ(report(above_floor(1.24e-12, 1e-12)), "1.2e-12");
}

TEST(Table, TransposedHasItsFirstColumnAsTitles) {
  const Table table{{"parameter", "value", "error"},
                    {{"a", Number{1.5, 3}, 2L}, {"b", Number{2.5, 3}, Cell()}}};
  const Table other = transposed(table);
  EXPECT_EQ(other.columns, (std::vector<std::string>{"parameter", "a", "b"}));
  ASSERT_EQ(other.rows.size(), 2U);
  EXPECT_EQ(text(other.rows[0][0], Precision::report), "value");
  EXPECT_EQ(text(other.rows[0][2], Precision::report), "2.5");
  EXPECT_EQ(text(other.rows[1][1], Precision::report), "2");
}

}  // namespace
}  // namespace shadefit
