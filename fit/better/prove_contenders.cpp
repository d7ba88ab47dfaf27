#include "fit/better/prove_contenders.hpp"

#include <fmt/format.h>

#include <set>

#include "fit/bounds/prove_shape.hpp"
#include "fit/bounds/study_integral.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

void prove(StudyContender& contender, const StudySubject& subject, const KnownIntegrals& known,
           const Checkpoint& checkpoint) {
  constexpr double width = 1e-4;  // the pages show four digits
  const std::size_t most = integral_depth(read_formulas(subject.study).target) > 0 ? 1'500 : 20'000;
  try {
    const auto [certificate, is_reached] = certify_study(subject, width, checkpoint, most, &known);
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
    wanted.insert({&contender, better_at_the_same_cost(comparison, contender),
                   better_with_all_properties(comparison, contender)});
  }
  return wanted;
}

/// " near x = 0.333, y = 0.2"; empty without a place.
std::string near_text(const Study& study, const std::vector<double>& place) {
  std::string text;
  for (std::size_t i = 0; i < place.size(); ++i)
    text += fmt::format("{} {} = {:.3g}", i == 0 ? " near" : ",", study.over[i].variable, place[i]);
  return text;
}

}  // namespace

StudySubject subject_of(const Study& study, const StudyContender& contender) {
  Study of_form = study;
  of_form.form = contender.formula;
  Constants constants;
  for (std::size_t i = 0; i < contender.names.size(); ++i)
    constants.emplace_back(contender.names[i],
                           contender.printed.empty() ? hex_text(contender.values[i]) : contender.printed[i]);
  for (const Held& held : study.held) constants.emplace_back(held.parameter, hex_text(held.value));
  return subject_of(std::move(of_form), constants);
}

void prove_properties(const Study& study, double size, StudyContender& contender,
                      const Checkpoint& checkpoint) {
  if (contender.properties.empty()) return;
  const StudySubject subject = subject_of(study, contender);
  std::erase_if(contender.properties, [&](StudyProperty& property) {
    const Constraints& constraints = property.constraints;
    const ShapeProof found = property.digits > 0
                                 ? prove_exact(subject, property.variable, constraints.exact_at.front(),
                                               property.digits, checkpoint)
                                 : prove_shape(subject, constraints, size, property.variable, checkpoint);
    property.is_proven = found.proof == Proof::proven;
    if (found.proof == Proof::open) property.unproven = found.reason + near_text(study, found.place);
    return found.proof == Proof::refuted;
  });
}

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
