#include "fit/better/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "approx/records/optical_constants.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/input/known.hpp"
#include "fit/support/parallel.hpp"
#include "fit/support/sweep.hpp"
#include "fit/verdicts/family_file.hpp"

namespace shadefit {
namespace {

bool is_wanted(const std::vector<std::string>& ids, std::string_view id) {
  return ids.empty() || std::ranges::find(ids, id) != ids.end();
}

/// A family that is named is refitted at all its exponents. For published numbers it is refitted only at the
/// exponents that they need. "Everything" does not include the forms that only compare.
struct WantedFits {
  std::vector<double> exponents;
  std::vector<const Published*> numbers;
};

std::optional<WantedFits> wanted_fits(const std::vector<std::string>& ids, const Family& family) {
  if (ids.empty() && family.is_comparison) return std::nullopt;
  const std::vector<const Published*> all = numbers_of(family);
  if (is_wanted(ids, family.id))
    return WantedFits{family.sweep.empty() ? std::vector<double>{} : parse_sweep(family.sweep), all};
  WantedFits wanted;
  for (const Published* number : all) {
    if (!is_wanted(ids, number->id)) continue;
    wanted.numbers.push_back(number);
    const auto needed = exponents_needed_by(*number, family);
    wanted.exponents.insert(wanted.exponents.end(), needed.begin(), needed.end());
  }
  return wanted.numbers.empty() ? std::nullopt : std::optional(wanted);
}

/// The name of a family includes the claims that begin with it: sg-offset includes sg-offset-mean.
bool is_claim_wanted(const std::vector<std::string>& ids, std::string_view id) {
  return is_wanted(ids, id) || std::ranges::any_of(ids, [&](const std::string& wanted) {
           return find_family(wanted) != nullptr && id.starts_with(wanted + "-");
         });
}

TargetComparison comparison_of(const std::string& title, const Family& family, const Surface& surface,
                               const std::string& exponent, const Checkpoint& checkpoint) {
  StudyFile file = family_file(family, nullptr, surface);
  take_rivals(file, family, nullptr, surface);
  if (family.has_exponent()) file.given.front().second = {exponent};
  const Study study = combinations(file.study, file.given).front();
  StudyComparison comparison = compare_study(file, study, checkpoint, keep_going, Judged::no);
  prove_contenders(comparison, checkpoint);
  return {title, std::move(file), std::move(comparison)};
}

/// The comparisons of the report: Schlick's weight, the exact reflectance of glass, and the lobe of exponent
/// 5, which mirrors Schlick's weight and for which an offset was published.
std::vector<TargetComparison> comparisons(const std::vector<std::string>& ids, const Checkpoint& checkpoint) {
  const Family& fresnel = *find_family("fresnel-quadratic");
  const Family& lobe = *find_family("sg-offset");
  const auto is_compared = [&](const Family& family) {
    return ids.empty() || std::ranges::any_of(ids, [&](const std::string& id) {
             const Family* named = find_family(id);
             return named != nullptr && have_same_target(*named, family);
           });
  };
  std::vector<TargetComparison> found;
  if (is_compared(fresnel)) {
    found.push_back(comparison_of("Schlick's formula", fresnel, {}, "", checkpoint));
    const Surface exact = exact_surface(constant<double>(glass.ior));
    found.push_back(
        comparison_of(fmt::format("An exact dielectric, n = {}", glass.ior), fresnel, exact, "", checkpoint));
  }
  if (is_compared(lobe)) found.push_back(comparison_of("A lobe at k = 5", lobe, {}, "5", checkpoint));
  return found;
}

}  // namespace

std::vector<std::string> fitted_ids() {
  std::vector<std::string> ids;
  for (const auto& family : families()) {
    ids.push_back(family.id);
    for (const Published* number : numbers_of(family)) ids.push_back(number->id);
  }
  return ids;
}

std::vector<std::string> known_ids() {
  std::vector<std::string> ids = fitted_ids();
  const auto add = [&](std::string_view id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.emplace_back(id);
  };
  for (const Normalisation& record : normalisations) add(record.id);
  for (const std::string& id : claim_ids()) add(id);
  return ids;
}

bool is_known_id(std::string_view id) {
  const auto has_id = [&](const auto& record) { return record.id == id; };
  return find_family(id) != nullptr || has_claim(id) || find_published(id) != nullptr ||
         std::ranges::any_of(normalisations, has_id);
}

std::vector<std::string> claim_ids() {
  std::vector<std::string> ids;
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) ids.emplace_back(claim.id);
  }
  return ids;
}

namespace {

/// The refits and the claims: they share the fits.
void add_refits_and_claims(Results& results, const std::vector<std::string>& ids,
                           const Checkpoint& checkpoint) {
  Fits fits;
  for (const Family& family : families()) {
    if (const auto wanted = wanted_fits(ids, family))
      results.refits.push_back(
          refit(fits.of(family), wanted->exponents, wanted->numbers, whole_domain_metrics(), checkpoint));
  }
  results.claims =
      judge_claims([&](std::string_view id) { return is_claim_wanted(ids, id); }, fits, checkpoint);
}

/// The chain has published curves only.
void add_fresnel_chain(Results& results, const std::vector<std::string>& ids, const Checkpoint& checkpoint) {
  std::vector<const Family*> chained;
  for (const Family& family : families())
    if (family.is_fresnel && !family.is_comparison && wanted_fits(ids, family)) chained.push_back(&family);
  checkpoint();
  results.fresnel_chain = fresnel_chain(chained);
}

void add_normalisations(Results& results, const std::vector<std::string>& ids, const Checkpoint& checkpoint) {
  for (const Normalisation& record : normalisations) {
    if (!is_wanted(ids, record.id)) continue;
    checkpoint();
    for (const auto& check : check_normalisation(record)) results.normalisations.push_back(check);
  }
  results.reflectances = reflectance_curves([&](std::string_view id) { return is_wanted(ids, id); });
}

}  // namespace

Results compute_results(const std::vector<std::string>& ids, const Checkpoint& checkpoint) {
  for (const std::string& id : ids) require_known(id, known_ids(), "constant");
  Results results;
  // The longest first, so that two cores end together.
  constexpr std::array parts{&add_refits_and_claims,
                             +[](Results& all, const std::vector<std::string>& wanted,
                                 const Checkpoint& next) { all.comparisons = comparisons(wanted, next); },
                             &add_fresnel_chain, &add_normalisations};
  for_each_in_parallel(parts.size(),
                       [&](std::size_t part, const Checkpoint& next) { parts.at(part)(results, ids, next); },
                       {.checkpoint = checkpoint});
  return results;
}

bool all_checks_passed(const Results& results) {
  const auto& all_of = std::ranges::all_of;
  const auto is_converged = [](Status status) { return status == Status::converged; };
  const auto status_of = [](const FitReport& report) { return report.fit.status; };
  const auto is_exact = [](const Reflectance& point) {
    return point.estimated_error <= reflectance_tolerance;
  };
  const auto is_proven = [](const StudyContender& contender) {
    return contender.published == nullptr || contender.proof;
  };
  const bool converged =
      all_of(results.refits, [&](const Refit& refit) { return all_of(refit.fits, is_converged, status_of); });
  const bool confirmed =
      all_of(results.normalisations, [](const auto& check) { return check.verdict == Verdict::confirmed; });
  const bool exact = all_of(results.reflectances,
                            [&](const ReflectanceCurve& curve) { return all_of(curve.points, is_exact); });
  const bool linked = all_of(results.fresnel_chain, is_converged, &FresnelLink::status);
  const bool judged =
      all_of(results.claims, [](const JudgedClaim& claim) { return claim.finding.verdict.has_value(); });
  const bool proven = all_of(results.comparisons, [&](const TargetComparison& of) {
    return all_of(of.comparison.contenders, is_proven);
  });
  return converged && linked && confirmed && exact && judged && proven;
}

std::string not_converged_lines(const Refit& refit) {
  std::string lines;
  for (const auto& [fit, assessments] : refit.fits) {
    if (fit.status == Status::converged) continue;
    lines += fmt::format("shadefit: {}{} did not converge: {}{}\n", fit.family->id,
                         fit.exponent ? fmt::format(" at exponent {}", *fit.exponent) : "", name(fit.status),
                         fit.why.empty() ? "" : ": " + fit.why);
  }
  return lines;
}

}  // namespace shadefit
