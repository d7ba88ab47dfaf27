#include "tests/fit/ledger/mutations.hpp"

#include <set>
#include <vector>

#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/fit/ledger/find_claim.hpp"

// Nothing in a finding is typed: the printed numbers and the inputs decide it. Each row of mutations.csv
// changes a claim: "printed 0 = 3; tolerance = 1e-30".
namespace shadefit {
namespace {

struct Mutation {
  std::string change;   ///< empty: none; "every digit": each of each printed number in turn
  std::string verdict;  ///< after it; "refused": the record cannot be read; empty: see the test
  std::string why;
};

std::vector<Mutation> mutations_of(std::string_view claim) {
  static const CsvTable table =
      parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/fit/ledger/mutations.csv"), "mutations.csv");
  std::vector<Mutation> found;
  for (const auto& row : table.rows) {
    if (row.at(0) == claim) found.push_back({row.at(1), row.at(2), row.at(3)});
  }
  return found;
}

constexpr std::string_view printed_number = "printed ";

struct Change {
  std::string what, value;
};

/// The last " = " is that of the change.
std::vector<Change> changes_of(const std::string& text) {
  std::vector<Change> changes;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find("; ", at), text.size());
    const std::string one = text.substr(at, end - at);
    const std::size_t equal = one.rfind(" = ");
    changes.push_back({one.substr(0, equal), one.substr(equal + 3)});
    at = end + 2;
  }
  return changes;
}

Claim changed(Claim claim, const std::vector<Change>& changes) {
  for (const auto& [what, value] : changes) {
    claim = what.starts_with(printed_number)
                ? with_printed(claim, std::stoul(what.substr(printed_number.size())), value)
                : with_input(claim, what, value);
  }
  return claim;
}

/// Each digit of each printed decimal number of a confirmed claim, changed by five, takes the confirmation
/// away.
void check_every_digit(const Claim& claim) {
  ASSERT_EQ(verdict_of(claim), "confirmed") << claim.id;
  for (std::size_t i = 0; i < claim.printed.size(); ++i) {
    const std::string printed(claim.printed[i].value);
    for (std::size_t place = 0; place < printed.size(); ++place) {
      if (printed[place] < '0' || printed[place] > '9') continue;
      std::string other = printed;
      other[place] = static_cast<char>('0' + (printed[place] - '0' + 5) % 10);
      EXPECT_NE(verdict_of(with_printed(claim, i, other)), "confirmed") << claim.id << ": " << other;
    }
  }
}

/// A change without a verdict: of a printed number it changes the verdict, of an input the evidence or what
/// is computed.
void expect_to_matter(const Finding& before, const Finding& after, const std::string& what,
                      const std::string& row) {
  if (what.starts_with(printed_number)) {
    EXPECT_TRUE(before.verdict != after.verdict) << row << " keeps the verdict: " << after.evidence;
  } else {
    EXPECT_TRUE(before.evidence != after.evidence || before.computed != after.computed)
        << row << " leaves the evidence as it was: " << after.evidence;
  }
}

class OfTopic : public ::testing::TestWithParam<std::size_t> {};

TEST_P(OfTopic, ClaimsRestOnWhatIsPrintedAndGiven) {
  for (const Claim& claim : ledger()[GetParam()].claims) {
    EXPECT_FALSE(claim.printed.empty() && claim.inputs.empty())
        << claim.id << " rests on nothing that can be changed";
    const Finding before = evaluate(claim);
    std::set<std::string> matter;
    for (const auto& [change, verdict, why] : mutations_of(claim.id)) {
      const std::string row = std::string(claim.id) + ": " + change + ": " + why;
      if (change == "every digit") {
        check_every_digit(claim);
        for (std::size_t i = 0; i < claim.printed.size(); ++i) matter.insert("printed " + std::to_string(i));
        continue;
      }
      const std::vector<Change> changes = changes_of(change);
      const Claim after = changed(claim, changes);
      if (verdict == "refused") {
        EXPECT_THROW(evaluate(after), std::exception) << row;
      } else if (!verdict.empty()) {
        EXPECT_EQ(verdict_of(after), verdict) << row;
        if (changes.size() == 1 && verdict != name_of(before.verdict)) matter.insert(changes[0].what);
      } else {
        ASSERT_EQ(changes.size(), 1U) << row;
        matter.insert(changes[0].what);
        expect_to_matter(before, evaluate(after), changes[0].what, row);
      }
    }
    for (std::size_t i = 0; i < claim.printed.size(); ++i)
      EXPECT_TRUE(matter.contains("printed " + std::to_string(i)))
          << claim.id << ": no change of printed " << i;
    for (const Quantity& input : claim.inputs)
      EXPECT_TRUE(matter.contains(std::string(input.name))) << claim.id << ": no change of " << input.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Ledger, OfTopic, ::testing::Range(std::size_t{0}, ledger().size()));

TEST(Mutations, NameClaimsOfTheLedger) {
  for (const auto& row :
       parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/fit/ledger/mutations.csv"), "mutations.csv").rows)
    EXPECT_NE(find_claim(row.at(0)), nullptr) << row.at(0);
}

}  // namespace
}  // namespace shadefit
