#include "fit/better/prove_properties.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "fit/proof/constants.hpp"
#include "fit/study_proof/prove_shape.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// " near x = 0.333, y = 0.2"; empty without a place.
std::string near_text(const Study& study, const std::vector<double>& place) {
  std::string text;
  for (std::size_t i = 0; i < place.size(); ++i)
    text += fmt::format("{} {} = {:.3g}", i == 0 ? " near" : ",", study.over[i].variable, place[i]);
  return text;
}

}  // namespace

StudySubject subject_of(const Study& study, const StudyContender& contender) {
  StudySubject subject{study, {}};
  subject.study.form = contender.formula;
  subject.study.held.clear();
  subject.study.starts.clear();
  for (StudyRange& range : subject.study.over) range.density = "1";  // only a fit has a density
  Constants constants;
  for (std::size_t i = 0; i < contender.names.size(); ++i)
    constants.emplace_back(contender.names[i],
                           contender.printed.empty() ? hex_text(contender.values[i]) : contender.printed[i]);
  for (const Held& held : study.held) constants.emplace_back(held.parameter, hex_text(held.value));
  subject.parameters = in_order(std::move(constants), read_formulas(subject.study).parameters);
  return subject;
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

}  // namespace shadefit
