#include "reports/sections/sections.hpp"

#include <gtest/gtest.h>

#include "fit/better/results.hpp"
#include "reports/io/csv.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

std::vector<ReflectanceCurve> curves_of(std::string_view wanted) {
  return reflectance_curves([&](std::string_view id) { return id == wanted; });
}

TEST(ReflectanceTable, HasTheColumnsThatOthersRelyOn) {
  EXPECT_EQ(write_csv(reflectance_table({}), Precision::report),
            "constant,exponent,view_angle,reflectance,estimated_error,with_cosine\n");
  const auto csv =
      parse_csv(write_csv(reflectance_table(curves_of("norm-phong")), Precision::report), "reflectance");
  ASSERT_EQ(csv.rows.size(), 44U);
  EXPECT_EQ(csv.rows[0], (std::vector<std::string>{"norm-phong", "1", "0", "1", "1e-10", "0.6666666667"}));
  EXPECT_EQ(csv.rows[4],
            (std::vector<std::string>{"norm-phong", "1", "60", "0.75", "1e-10", "0.4059985207"}));
}

TEST(ReflectanceTable, ShowsAnErrorThatBreaksThePromise) {
  Results results;
  results.reflectances = curves_of("norm-phong-brdf");
  EXPECT_TRUE(all_checks_passed(results));
  results.reflectances[1].points[2].estimated_error = 2.34e-10;
  EXPECT_FALSE(all_checks_passed(results));
  const auto csv =
      parse_csv(write_csv(reflectance_table(results.reflectances), Precision::report), "reflectance");
  EXPECT_EQ(csv.rows[11 + 2][4], "2.3e-10");
  EXPECT_EQ(csv.rows[11 + 3][4], "1e-10");
}

TEST(ReflectanceSection, SaysWhoCreatesEnergyAndWhere) {
  const auto cheap = reflectance_section(curves_of("norm-blinn-phong-cheap"));
  EXPECT_NE(cheap.find("- `norm-blinn-phong-cheap` creates energy: below 21.71 degrees for a = 1, below 18.1 "
                       "degrees for a = 8, below 9.437 degrees for a = 64, below 1.786 degrees for a = 2048. "
                       "Its reflectance is largest, 1.075 at 0 degrees for a = 8.\n"),
            std::string::npos)
      << cheap;
  const auto exact = reflectance_section(curves_of("norm-blinn-phong-brdf"));
  EXPECT_NE(
      exact.find(
          "- `norm-blinn-phong-brdf` creates no energy for a = 1, 8, 64, 2048: its reflectance with n.l is at most 1 at 0 "
          "degrees for a = 1, 8, 64, 2048.\n"),
      std::string::npos)
      << "equal peaks are named together, not picked by rounding\n"
      << exact;
  EXPECT_EQ(exact.find("times n.l, `"), std::string::npos) << "its lobe has n.l already";
  EXPECT_NE(reflectance_section(curves_of("norm-phong")).find("times n.l, `"), std::string::npos);
}

}  // namespace
}  // namespace shadefit
