#pragma once

#include <optional>
#include <string_view>

#include "app/options/options.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/study_file.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// The study that the options state or name: --target, --form and --over of the command line, the file or the
/// id of a study, or a built-in family, changed by the options that are present. Throws UserError for an
/// unknown id and for options that do not apply. Calls the checkpoint while it waits for a table on standard
/// input.
StudyFile chosen_study(const FitOptions& options, const Checkpoint& checkpoint);

/// The same with all that competes for its target: for a built-in family all forms and published curves of
/// the catalogue. Without exponents it has the lowest and the highest of its usual ones.
StudyFile compared_study(const FitOptions& options, const Checkpoint& checkpoint);

/// The constants of a study that `certify` and `emit` use.
struct ChosenStudySubject {
  StudySubject subject;   ///< of the first form
  std::string_view from;  ///< the origin of its values: given, published or fitted
  OthersText origin;      ///< in more words: the source, or how they were fitted
};

/// The given `parameters`; without them the first set that was published for the form, unless an option of a
/// fit is present; else those of a fit. `study` is one of the file's combinations. Throws UserError for
/// constants that are not those of the form, for an option of a fit next to given constants, and if the fit
/// did not converge.
ChosenStudySubject chosen_study_subject(const StudyFile& file, const Study& study,
                                        const std::optional<Constants>& parameters, const FitOptions& options,
                                        const Checkpoint& checkpoint);

}  // namespace shadefit
