#include "fit/ledger/read_claims.hpp"

#include <gtest/gtest.h>

#include "fit/ledger/told.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const std::string head =
    "title = \"Lobes\"\n[[claim]]\nid = \"mine\"\nstatement = \"`x`\"\nderivation = \"why\"\n";

TEST(ReadClaims, TakeWhatTheirConstantsHave) {
  ReadClaims claims;
  read_sources("[lagarde]\nof = \"sg-offset-k5\"\n", "sources", claims);
  read_topic(
      head +
          "source = \"lagarde\"\nconstants = [\"sg-offset-k5\"]\ninputs = [[\"x\", \"=sg-offset-mean\"]]\n",
      "lobes", claims);
  ASSERT_EQ(claims.topics.size(), 1U);
  const Claim& claim = claims.topics[0].claims[0];
  EXPECT_EQ(claim.source.author, "Lagarde");
  EXPECT_EQ(claim.printed.at("x"), claim.constants[0].printed);
  EXPECT_EQ(claim.inputs.at("exponents"), "5");
  EXPECT_EQ(claim.inputs.at("x"), "0.775");
}

TEST(ReadClaims, AFaultIsOneLineWithItsPlace) {
  const std::string whole = head + "source = \"lagarde\"\n";
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"title = 1",
            "claims 'lobes', line 1: 'title' must be a text in quotes, so that every digit is kept"},
           {"title =", "claims 'lobes', line 1: "},
           {head + "source = \"nobody\"\n", "claims 'lobes', line 6: no source has that name"},
           {head, "claims 'lobes', line 2: the key 'source' is missing"},
           {whole + "statment = \"\"\n",
            "claims 'lobes', line 7: unknown key 'statment': did you mean 'statement'?"},
           {whole + "inputs = [[\"x\"]]\n",
            "claims 'lobes', line 7: 'inputs' must be a list of pairs: a name and a value"},
           {whole + "inputs = [[\"x\", \"=sg\"]]\n", "claims 'lobes', line 7: no constant has the id 'sg'"},
           {whole + "define = [\"x\"]\n",
            "claims 'lobes', line 7: 'define' must be a list of lists of texts"},
           {whole + "effect = [[\"none\"]]\n",
            "claims 'lobes', line 7: a list in 'effect' has at least two texts"},
           {whole + "constants = [\"sg\"]\n", "claims 'lobes', line 7: no published constant has that id"}}) {
    ReadClaims claims;
    read_sources("[lagarde]\nof = \"sg-offset-k5\"\n", "sources", claims);
    try {
      read_topic(text, "lobes", claims);
      ADD_FAILURE() << text;
    } catch (const UserError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, message.size()), message);
    }
  }
}

TEST(Told, NumbersFormulasAndWordsStandInTheHoles) {
  Claim claim{.id = "mine",
              .statement = "",
              .printed = {{"", "0.50"}},
              .inputs = {{"all powers", "2,32"}, {"tolerance", "1e-10"}},
              .derivation = "",
              .computed = "{identity}, {found:.2g}",
              .evidence =
                  "{agree} within {tolerance} at {all_powers#power} up to {all_powers_last:.3g}; "
                  "{2 found + printed_0:.2f}, not {printed_0}; {found}",
              .source = {}};
  const Finding finding = told(claim, Verdict::confirmed, "none", Told{"found", 3}, Told{"agree", "same"});
  EXPECT_EQ(finding.computed, "identity, 3");
  EXPECT_EQ(finding.evidence, "same within 1e-10 at 2 powers up to 32; 6.50, not 0.50; 3");
  EXPECT_EQ(finding.effect, "none");
  claim.computed = "{identity}";
  claim.evidence = "";
  EXPECT_EQ(told(claim, Verdict::refuted, "none").computed, "no identity");
  claim.evidence = "{lost}";
  EXPECT_THROW(told(claim, Verdict::confirmed, "none"), std::logic_error);
}

}  // namespace
}  // namespace shadefit
