#include "fit/ledger/computation.hpp"

#include "fit/ledger/read_claims.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

/// A claim with these definitions; its evidence is a text with holes.
Finding computed(const std::string& definitions, std::string_view text,
                 std::string_view verdict = "confirmed", const std::string& effect = "") {
  ReadClaims claims;
  read_sources("[lagarde]\nof = \"sg-offset-k5\"\n", "sources", claims);
  read_topic(
      "title = \"Mine\"\n[[claim]]\nid = \"mine\"\nstatement = \"\"\nderivation = \"why\"\nsource = \"lagarde\"\n"
      "printed = [[\"least\", \"2\"], [\"\", \"0.50\"]]\n"
      "inputs = [[\"powers\", \"1:3:1\"], [\"maps\", \"albedo 3, gloss\"], [\"form\", \"x^2 + 1\"],\n"
      "[\"rows\", \"0.5 least / 4\"]]\n"
      "define = [" +
          definitions + "]\nverdict = [\"" + std::string(verdict) + "\"]\neffect = [" + effect +
          "]\nevidence = '" + std::string(text) + "'\n",
      "mine", claims);
  return computed_by_its_record(claims.topics[0].claims[0]);
}

std::string evidence(const std::string& definitions, std::string_view text) {
  return computed(definitions, text).evidence;
}

TEST(Computation, FormulasAndSearches) {
  EXPECT_EQ(evidence("", "{2 least + printed_1:.3g} {printed_1} {powers_last:.3g}"), "4.5 0.50 3");
  EXPECT_EQ(evidence("['f(x)', '=form'], ['twice', '2 f(least)']", "{twice}, {f(3):.3g}"), "10, 10");
  EXPECT_EQ(
      evidence("['s', 'sum', 'k in powers, i in 1 .. 2', 'k i'], ['n', 'count', 'k in powers', 'k > 1']",
               "{s} {n}"),
      "18 2");
  EXPECT_EQ(
      evidence(
          "['m', 'most', 'k in powers', '1 - (k - 2)^2'], ['at', 'place', 'k in powers', '1 - (k - 2)^2', '10 k']",
          "{m} {at}"),
      "1 20");
  EXPECT_EQ(evidence("['first', 'place', 'k in powers', '1', 'k']", "{first}"), "1")
      << "of equal values the first";
  EXPECT_EQ(evidence("['s', 'sum', 'v in words of rows', 'v (v_place + 1)']", "{s}"), "16.5");
  EXPECT_EQ(evidence("['r', 'root', 'x', '0', '4', 'x^2 < 2']", "{r:.10g}"), "1.414213562");
  EXPECT_EQ(evidence("['i', 'integral', 'x', '0', '3', 'x^2', '0', '9', 'sqrt(x)/2'], ['d', 'doubt', 'i'], "
                     "['ok', 'if', 'd < 1e-11', 'sure', 'unsure']",
                     "{i:.10g} {ok}"),
            "9 sure");
  EXPECT_EQ(evidence("['d', 'doubt', 'i'], ['i', 'integral', 'x', '0', '1', '1', '0', '1', '2']", "{d:.3g}"),
            "1")
      << "the rules differ";
  EXPECT_EQ(
      evidence(
          "['l', 'largest', 'c (1 - c)'], ['at', 'largest-at', 'c y'], ['s', 'sampled', 'x', 'x (2 - 2 x)']",
          "{l:.6g} {at:.6g} {s:.6g}"),
      "0.25 0.5 0.5");
  EXPECT_EQ(
      evidence(
          "['h', 'in', 'half', '1 + 1e-4'], ['l', 'last', 'half', 'x', '1', '4', 'x <= 2.5003 ? 0 : -1'], "
          "['n', 'least', 'float'], ['g', 'greatest', 'half']",
          "{h} {l} {log2(n):.6g} {g}"),
      "1 2.5 -126 65504");
  EXPECT_EQ(evidence("['off', 'units', 'printed_1', '0.527'], ['unit', 'unit', 'printed_1']", "{off} {unit}"),
            "3 0.01");
}

TEST(Computation, Words) {
  EXPECT_EQ(
      evidence(
          "['all', 'list', 'k in powers', '{k}'], ['few', 'list', 'i in printed', '{i}: {printed_i}', '; ']",
          "{all}; {few}"),
      "1, 2 and 3; 0: 2; 1: 0.5");
  EXPECT_EQ(
      evidence("['if_odd', 'if', 'k == 2', '', '{k}'], ['odd', 'list', 'k in powers', '{if_odd}']", "{odd}"),
      "1 and 3");
  EXPECT_EQ(evidence("['names', 'list', 'm in maps', '{m_name} ({m})']", "{names}"),
            "albedo 3 (3) and gloss (1)");
  EXPECT_EQ(evidence("['f', 'fraction', '7/8'], ['g', 'fraction', 'pi']", "{f} {g}"), "7/8 3.14159");
  EXPECT_EQ(evidence("['r', 'runs', 'i in 0 .. 9', 'i != 3 && i < 6']", "{r}"), "0 to 2 and 4 to 5");
  EXPECT_EQ(evidence("['r', 'ranges', 'x', '(x - 0.25) (0.5 - x)']", "{r}"), "from c = 0.25 to 0.5");
  EXPECT_EQ(evidence("['j', 'judged', 'printed_1 = 0.51'], ['t', 'text', 'it is {j}']", "{t}"),
            "it is rounding");
}

TEST(Computation, VerdictsAndEffects) {
  EXPECT_EQ(computed("", "", "printed_1 = 0.5").verdict, Verdict::confirmed);
  EXPECT_EQ(computed("", "", "printed_1 = 0.509").verdict, Verdict::rounding);
  EXPECT_EQ(computed("", "", "other_objective").verdict, Verdict::other_objective);
  EXPECT_EQ(computed("", "", "least > 2 ? confirmed : undecided").verdict, std::nullopt);
  EXPECT_EQ(computed("", "", "conditional\", \"confirmed").verdict, Verdict::conditional)
      << "the worst counts";
  EXPECT_EQ(computed("", "{verdict_1} {identity}", "conditional\", \"confirmed").evidence,
            "confirmed no identity");
  EXPECT_EQ(computed("", "", "confirmed", "['none', 'it is {least}']").effect, "none: it is 2");
  EXPECT_EQ(computed("", "", "confirmed", "['power', '1', '2', '']").effect, effect_of_power(1, 2));
  EXPECT_EQ(computed("", "", "confirmed", "['factor', '0.99', '1', 'x']").effect,
            effect_of_factor(0.99, 1, "x"));
  const std::string value =
      computed("", "", "confirmed", "['value', '0.5', '0.25', 'it', 'at {least}', 'k = {}', 'least']").effect;
  EXPECT_TRUE(value.starts_with("at 2 moves it by up to ")) << value;
  EXPECT_NE(value.find("(absolute: 0.25 at k = 2;"), std::string::npos) << value;
  const std::string each =
      computed("", "", "confirmed", "['each', '0', 'k/4', 'it', '', 'k in powers', 'k = {}', 'k']").effect;
  EXPECT_NE(each.find("(absolute: 0.75 at k = 3;"), std::string::npos) << each;
  const std::string curve = computed("", "", "confirmed", "['curve', 'c', 'c^2', 'it', '', '0']").effect;
  EXPECT_NE(curve.find("(absolute: 0.25 at c = 0.5;"), std::string::npos) << curve;
}

TEST(Computation, WhatHasNoValueIsRefused) {
  EXPECT_THROW(evidence("", "{1/(least - 2):.3g}"), std::invalid_argument);
  EXPECT_THROW(evidence("", "{nothing:.3g}"), std::logic_error);
  EXPECT_THROW(evidence("['x', 'guess', '1']", "{x}"), std::logic_error);
  EXPECT_THROW(evidence("['x', 'sum', 'k in powers']", "{x}"), std::out_of_range);
  EXPECT_THROW(evidence("['x', '1 + x']", "{x:.3g}"), std::logic_error) << "it needs itself";
  EXPECT_THROW(evidence("['x', 'sum', 'k in powers', 'k y'], ['y', 'x']", "{x:.3g}"), std::logic_error);
  EXPECT_THROW(evidence("['x', 'text', 'as {x}']", "{x}"), std::logic_error);
}

}  // namespace
}  // namespace shadefit
