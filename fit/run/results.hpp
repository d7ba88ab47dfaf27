#pragma once

#include <string>
#include <vector>

#include "fit/better/better.hpp"
#include "fit/integrals/normalisation_check.hpp"
#include "fit/integrals/reflectance.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/fresnel_chain.hpp"
#include "fit/verdicts/refit.hpp"

/// Everything that a run computes, before it becomes rows.
namespace shadefit {

struct Results {
  std::vector<Refit> refits;
  std::vector<FresnelLink> fresnel_chain;  ///< of the Fresnel families among the refits
  std::vector<NormalisationCheck> normalisations;
  std::vector<ReflectanceCurve> reflectances;
  std::vector<JudgedClaim> claims;
  std::vector<Comparison> comparisons;  ///< what would be better, of the targets that are wanted
};

/// How a run compares: published curves against the least largest error of each form, to more digits than the
/// report shows.
inline constexpr Contest report_contest{.width = 1e-6, .only_minimax = true};

/// The ids that name something: families, published constants, normalisations, claims, in the order of the
/// report.
std::vector<std::string> known_ids();

/// Those of the ledger alone.
std::vector<std::string> claim_ids();

/// Computes what `ids` name, or everything where it is empty; of a published constant the fits that it needs.
/// Throws UserError for an id that names nothing. The checkpoint is called between fits and between
/// normalisations.
Results compute_results(const std::vector<std::string>& ids, const Checkpoint& checkpoint = keep_going);

/// Whether every fit converged, those against exact surfaces too, and every normalisation was confirmed, and
/// every reflectance is as exact as promised, every claim could be judged and every comparison proven.
bool all_checks_passed(const Results& results);

/// "sg-offset at exponent 5".
std::string which_fit(const Fit& fit);

/// One line for each fit that did not converge, with the reason.
std::string not_converged_lines(const Refit& refit);

}  // namespace shadefit
