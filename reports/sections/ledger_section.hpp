#pragma once

#include <string>
#include <vector>

#include "fit/ledger/ledger.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/table.hpp"
#include "reports/io/writers.hpp"

/// The ledger: every claim of the source documents with its verdict, as rows, as sections and one by one.
namespace shadefit {

/// "a = -5.55473, b = -6.98316"; "-" for a claim without a number.
std::string printed_text(const Claim& claim);

/// The verdict's name; "not-converged" if the evidence is weaker than the printed digits.
std::string verdict_text(const Finding& finding);

/// One row per claim: claims.csv.
Table claims_table(const std::vector<JudgedClaim>& claims);

/// The table for people: claim, printed, computed, verdict.
Table claims_overview(const std::vector<JudgedClaim>& claims);

/// Every record, with its verdict if claims are judged: `shadefit list`. Without statements, for a terminal,
/// each source is "author year".
Table claims_list(const std::vector<JudgedClaim>& claims, bool with_verdicts, bool with_statements);

/// Adds a row for each form that only compares, which has no source, to such a table without verdicts.
void add_forms_of_comparison(Table& list);

/// "82 claims: 61 confirmed, 4 rounding, ..": verdicts that occur, in their order.
std::string verdict_counts(const std::vector<JudgedClaim>& claims);

/// A section for each topic: a table of verdicts, and each claim's evidence and effect, with a link to its
/// figure if that is among the `figures`.
std::string ledger_section(const std::vector<JudgedClaim>& claims, const std::vector<Figure>& figures);

/// One claim in full: record, derivation, evidence, effect, plot. Lines have at most 106 letters, and fit the
/// terminal.
std::string explanation(const JudgedClaim& judged, const Terminal& terminal = {});

/// The same as JSON.
nlohmann::ordered_json explanation_json(const JudgedClaim& judged);

}  // namespace shadefit
