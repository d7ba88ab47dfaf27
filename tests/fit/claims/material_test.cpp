#include <cmath>
#include <stdexcept>

#include "fit/ledger/finding.hpp"
#include "fit/ledger/transfer_function.hpp"
#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

/// The sum of a Lambertian term under a factor and of a mirror-like reflection.
struct DiffuseSum {
  double at_normal, at_grazing, under_sky, from_cosine;

  DiffuseSum(std::string_view factor, double albedo, double f0) {
    const std::string a = std::to_string(albedo), f = std::to_string(f0);
    Claim claim = with_input(with_input(*find_claim("diffuse-fresnel"), "albedo", a), "f0", f);
    claim = with_input(claim, "factor", factor);
    at_normal = computed_number(claim, "stated_normal");
    at_grazing = computed_number(claim, "stated_grazing");
    under_sky = computed_number(claim, "factor_sky");
    from_cosine = computed_number(claim, "of_factor");
  }
};

TEST(Diffuse, HasTheClosedFormsOfSchlick) {
  // The mean of (1-F) over the hemisphere: 1 - f0 - (1-f0)/21.
  for (const double f0 : {0.02, 0.04, 0.5}) {
    for (const double a : {0.25, 0.8, 1.0}) {
      const double rest = (1 - f0) * 20 / 21;
      const DiffuseSum both("(1-F_i)(1-F_o)", a, f0);
      EXPECT_NEAR(both.at_normal, f0 + a * (1 - f0) * rest, 1e-12);
      EXPECT_NEAR(both.at_grazing, 1, 1e-12);
      EXPECT_NEAR(both.under_sky, 1 - rest + a * rest * rest, 1e-12);
      EXPECT_EQ(both.from_cosine, 0);
      const DiffuseSum stand_in("1-F0", a, f0);
      EXPECT_NEAR(stand_in.at_normal, f0 + a * (1 - f0), 1e-12);
      EXPECT_NEAR(stand_in.at_grazing, 1 + a * (1 - f0), 1e-12);
      EXPECT_NEAR(stand_in.under_sky, 1 - rest + a * (1 - f0), 1e-12);
      // f0 + (1-f0) w + a (1-f0) <= 1 where w = (1-c)^5 <= 1 - a
      EXPECT_NEAR(stand_in.from_cosine, 1 - std::pow(1 - a, 0.2), 1e-9) << a << " " << f0;
    }
    const DiffuseSum in("1-F_i", 1, f0);
    EXPECT_NEAR(in.at_normal, 1, 1e-12) << "towards the light it is exactly what gets in";
    EXPECT_NEAR(in.under_sky, 1, 1e-12);
    EXPECT_GT(in.at_grazing, 1) << "and not reciprocal: too much towards a grazing view";
    EXPECT_GT(DiffuseSum("1", 1, f0).from_cosine, 1) << "nowhere";
  }
  EXPECT_THROW(DiffuseSum("1-F", 1, 0.04), std::exception);
}

TEST(TransferFunction, ReadsNames) {
  EXPECT_EQ(transfer_function("sRGB").gamma, 0);
  EXPECT_EQ(transfer_function("gamma 1.8").gamma, 1.8);
  EXPECT_EQ(transfer_function("gamma 1.8").codes, 255);
  EXPECT_EQ(transfer_function("gamma 2.2 of code/256").codes, 256);
  for (const char* bad : {"", "srgb", "gamma", "gamma x", "sRGB of code/"})
    EXPECT_THROW(transfer_function(bad), std::invalid_argument) << bad;
}

// mpmath, 20 digits: ((40/255 + 0.055)/1.055)**2.4, (40/255)**2.2, (40/256)**2.2; and back from codes
TEST(TransferFunction, DecodesAndEncodes) {
  const auto computed = [](std::string_view convention) {
    return evaluate(with_input(*find_claim("chart-overlap"), "convention", convention)).computed;
  };
  EXPECT_TRUE(computed("sRGB").starts_with("dielectrics 0.02121901 .. ")) << computed("sRGB");
  EXPECT_TRUE(computed("gamma 2.2").starts_with("dielectrics 0.01698805 .. "));
  EXPECT_TRUE(computed("gamma 2.2 of code/256").starts_with("dielectrics 0.0168424 .. "));
  for (const char* convention : {"sRGB", "gamma 2.2", "gamma 2.2 of code/256"}) {
    Claim claim = with_input(*find_claim("middle-grey"), "convention", convention);
    claim = with_input(claim, "other conventions", convention);
    const std::string code = evaluate(claim).computed;
    const std::string evidence = evaluate(with_input(claim, "not", code)).evidence;
    EXPECT_NE(evidence.find("code " + code + " is 0.5,"), std::string::npos) << evidence;
  }
}

TEST(List, IsReadByItsSeparator) {
  EXPECT_EQ(items_of("a b,  c"), (std::vector<std::string>{"a b", "c"}));
  EXPECT_EQ(items_of("one"), std::vector<std::string>{"one"});
  EXPECT_EQ(numbers_of("0.5, -1"), (std::vector<double>{0.5, -1}));
  EXPECT_EQ(numbers_of("5 10", ' '), (std::vector<double>{5, 10}));
  EXPECT_THROW(numbers_of("1,, 2"), std::invalid_argument);
}

}  // namespace
}  // namespace shadefit
