#pragma once

#include <string>
#include <vector>

#include "fit/better/better_study.hpp"
#include "fit/claims/normalisation_check.hpp"
#include "fit/claims/reflectance.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/fresnel_chain.hpp"
#include "fit/verdicts/refit.hpp"

/// All results of a run, before they become rows.
namespace shadefit {

/// What is published for a target of the catalogue, and what is better.
struct TargetComparison {
  std::string title;
  StudyFile file;  ///< the comparison points to its published sets
  StudyComparison comparison;
};

struct Results {
  std::vector<Refit> refits;
  std::vector<FresnelLink> fresnel_chain;  ///< of the Fresnel families among the refits
  std::vector<NormalisationCheck> normalisations;
  std::vector<ReflectanceCurve> reflectances;
  std::vector<JudgedClaim> claims;
  std::vector<TargetComparison> comparisons;  ///< for the wanted targets
};

/// The ids of families and published constants.
std::vector<std::string> fitted_ids();

/// All ids: families, published constants, normalisations, claims, in the order of the report.
std::vector<std::string> known_ids();

/// Whether an id is one of them.
bool is_known_id(std::string_view id);

/// The ids of the ledger only.
std::vector<std::string> claim_ids();

/// Computes the results for `ids`, or everything if there are none; for a published constant, the fits that
/// it needs. Throws UserError for an unknown id. The checkpoint is called between fits and between
/// normalisations.
Results compute_results(const std::vector<std::string>& ids, const Checkpoint& checkpoint = keep_going);

/// Whether everything is as promised: every fit converged, also against exact surfaces; every normalisation
/// was confirmed; every reflectance is exact enough; every claim was judged and the error of every published
/// curve proven.
bool all_checks_passed(const Results& results);

/// One line for each fit that did not converge, with the reason.
std::string not_converged_lines(const Refit& refit);

}  // namespace shadefit
