#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "approx/normalisation.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/support/sweep.hpp"
#include "fit/verdicts/refit.hpp"
#include "fit/verdicts/verdict.hpp"

namespace shadefit {
namespace {

TEST(Records, HaveUniqueIdsAndSources) {
  std::set<std::string_view> ids;
  const auto check_source = [](std::string_view id, const Source& source) {
    EXPECT_FALSE(source.author.empty() || source.title.empty() || source.place.empty()) << id;
    EXPECT_GT(source.year, 1900) << id;
  };
  for (const Published& record : published_constants()) {
    EXPECT_TRUE(ids.insert(record.id).second) << record.id << " stands twice";
    check_source(record.id, record.source);
  }
  for (const Normalisation& record : normalisations) {
    EXPECT_TRUE(ids.insert(record.id).second) << record.id << " stands twice";
    EXPECT_FALSE(record.printed.empty() || record.lobe.empty()) << record.id;
    check_source(record.id, record.source);
  }
}

TEST(Records, PublishedConstantsBelongToFamilies) {
  for (const Published& record : published_constants()) {
    const Family* family = find_family(record.family);
    ASSERT_NE(family, nullptr) << record.id;
    EXPECT_EQ(std::count(family->parameters.begin(), family->parameters.end(), record.parameter), 1)
        << record.id;
    EXPECT_NO_THROW(constant<double>(record.printed)) << record.id;
    EXPECT_NO_THROW(exponents_of(record)) << record.id;
    const bool needs_exponents = family->has_exponent() && (record.statement == Statement::best_fit ||
                                                            record.statement == Statement::mean_of_fits);
    EXPECT_EQ(record.exponents.empty(), !needs_exponents) << record.id;
    if (record.statement == Statement::best_fit) {
      EXPECT_EQ(exponents_of(record).size(), 1U) << record.id << ": one fit has one exponent";
    }
  }
}

TEST(Records, VariantsAreWrongCopies) {
  int variants = 0;
  for (const Published& record : published_constants()) {
    for (const Variant& variant : record.variants) {
      ++variants;
      EXPECT_NE(constant<double>(variant.printed), constant<double>(record.printed)) << variant.printed;
      EXPECT_FALSE(variant.seen_in.empty()) << variant.printed;
    }
  }
  EXPECT_EQ(variants, 2);
}

TEST(Records, ConventionsGiveTheirPrintedDigits) {
  int conventions = 0;
  for (const Published& record : published_constants()) {
    if (!record.convention.value) continue;
    ++conventions;
    EXPECT_EQ(units_off(record.printed, *record.convention.value), 0) << record.id;
  }
  EXPECT_EQ(conventions, 1);
}

TEST(Records, FamilySweepsAreReadable) {
  for (const Family& family : families()) {
    if (family.has_exponent()) {
      EXPECT_FALSE(parse_sweep(family.sweep).empty()) << family.id;
    }
  }
  EXPECT_EQ(find_family("no-such-family"), nullptr);
}

}  // namespace
}  // namespace shadefit
