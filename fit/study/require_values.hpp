#pragma once

#include <string>
#include <vector>

#include "fit/study/study_nodes.hpp"

namespace shadefit {

/// The values of the target at the nodes. Throws UserError with the place where the target has no finite
/// value, where the weight is not finite or negative (with rows also 0), or where a relative error divides by
/// a zero of the target that the form does not share. With one variable such zeros are found in all of its
/// range, with several only at nodes.
std::vector<double> require_values(const ReadStudy& study, const StudyNodes& nodes);

/// Throws UserError with a place at the border of the range, or at a pole inside it, where a formula of the
/// variables is not finite: for least squares if the integral of its square does not converge there, for
/// minimax always. `option` names the formula; `edges` are those of the study.
void require_finite(const ReadStudy& study, const Symbolic& formula, const std::string& option, Norm norm,
                    const std::vector<std::vector<StudyEdge>>& edges);

/// The same of the form at nearly all parameters, as for a/x + b at x = 0: to say why a fit failed.
void require_finite_form(const ReadStudy& study, Norm norm);

/// Throws UserError if the form does not depend on a parameter, or if the parameter only moves a jump, so
/// that no derivative tells its way. `is_open` marks the parameters whose derivative is 0 everywhere.
void require_dependence(const ReadStudy& study, const std::vector<bool>& is_open);

}  // namespace shadefit
