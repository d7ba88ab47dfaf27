#include "fit/better/prove_contenders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fit/better/prove_properties.hpp"
#include "fit/study_proof/study_certificate.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

bool has_integral(const Symbolic& formula) {
  return formula.kind() == Symbolic::Kind::integral ||
         std::any_of(formula.parts().begin(), formula.parts().end(), has_integral);
}

void prove(StudyContender& contender, const StudySubject& subject, const KnownIntegrals& known,
           const Checkpoint& checkpoint) {
  constexpr double width = 1e-4;  // the pages show four digits
  const std::size_t most = has_integral(read_formulas(subject.study).target) ? 1'500 : 20'000;
  try {
    const auto [certificate, is_reached] = certify_study(subject, width, checkpoint, most, known);
    contender.bound = certificate.upper;
    if (is_reached) {
      contender.proof = {certificate.lower, certificate.upper, count_boxes(certificate)};
    } else {
      contender.unproven = fmt::format("a proof needs more than {} boxes", most);
    }
  } catch (const CheckFailed&) {
    contender.unproven = "a proof finds no finite bound";
  }
}

void prove_error(const Study& study, StudyContender& contender, const KnownIntegrals& known,
                 const Checkpoint& checkpoint) {
  if (study.rows) {
    contender.unproven = "the error is known at the rows alone";
    return;
  }
  const StudySubject subject = subject_of(study, contender);
  contender.unproven = fault_of(subject);
  if (contender.unproven.empty()) prove(contender, subject, known, checkpoint);
}

/// The published contenders, and what is better than each.
std::set<const StudyContender*> contenders_to_prove(const StudyComparison& comparison) {
  std::set<const StudyContender*> wanted;
  for (const StudyContender& contender : comparison.contenders) {
    if (contender.published == nullptr) continue;
    wanted.insert(&contender);
    if (const StudyContender* best = better_at_the_same_cost(comparison, contender)) wanted.insert(best);
    if (const StudyContender* all = better_with_all_properties(comparison, contender)) wanted.insert(all);
  }
  return wanted;
}

}  // namespace

void prove_contenders(StudyComparison& comparison, const Checkpoint& checkpoint) {
  const std::set<const StudyContender*> wanted = contenders_to_prove(comparison);
  const KnownIntegrals known;  // contenders have one target
  for (StudyContender& contender : comparison.contenders) {
    if (wanted.count(&contender) == 0) continue;
    checkpoint();
    prove_error(comparison.study, contender, known, checkpoint);
  }
}

}  // namespace shadefit
