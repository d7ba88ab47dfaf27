#include <utility>

#include "fit/bounds/study_certificate.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {

StudySubject subject_of(Study study, const Constants& constants) {
  study.held.clear();
  study.starts.clear();
  study.known_starts.clear();
  study.near_peak = {};
  study.residual.clear();  // a proof is of the form and its target
  study.cuts.reset();
  for (StudyRange& range : study.over) range.density = "1";
  const std::vector<std::string> names = read_formulas(study).parameters;
  return {std::move(study), in_order(constants, names)};
}

Constants constants_of(const Study& study, const StudyFit& fit) {
  Constants constants;
  for (std::size_t i = 0; i < fit.names.size(); ++i)
    constants.emplace_back(fit.names[i], hex_text(fit.parameters[i]));
  for (const Held& held : study.held) constants.emplace_back(held.parameter, to_text(held.value));
  return constants;
}

}  // namespace shadefit
