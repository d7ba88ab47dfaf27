#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/better/study_properties.hpp"
#include "fit/catalogue/study_file.hpp"
#include "fit/errors/effect.hpp"
#include "fit/proof/constants.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/study_claims.hpp"
#include "fit/verdicts/study_verdict.hpp"

/// The published constants of a study against the best ones of each of its forms.
namespace shadefit {

/// Bounds of the largest error, proven in interval arithmetic.
struct ProvenError {
  double lower = 0, upper = 0;
  std::size_t boxes = 0;  ///< of which the proof consists
};

/// A form in a format: its constants are rounded, and so is every operation and function.
struct ContenderInFormat {
  /// How `bound` is known: by proof, or because the form was evaluated at every number or row.
  enum class Evidence { none, proven, every_number, every_row };

  std::string_view format;   ///< "float" or "half"
  Constants constants = {};  ///< the shortest decimals that read back; none if one overflows
  bool is_moved = false;     ///< constants that were searched for, not only rounded
  double bound = 0;          ///< of the error of the study
  Evidence evidence = Evidence::none;
  std::string reason = {};  ///< why there is no bound
};

/// A form with its constants.
struct StudyContender {
  const PublishedSet* published = nullptr;  ///< null for a fit
  std::string form, formula;                ///< the id and the formula
  OthersText origin;                        ///< the source, or the objective of a fit
  std::vector<std::string> names;
  std::vector<std::string> printed = {};  ///< of a published set
  std::vector<double> values;
  int digits = 0;                                ///< of a fit: how many its constants have
  Symbolic code;                                 ///< the form with these constants, as `emit` writes it
  Operations operations;                         ///< of that
  StudyExtremum max_error;                       ///< in the error of the study; sampled and refined
  double rms_error = 0;                          ///< weighted, by the density
  std::vector<StudyProperty> properties = {};    ///< that it shares with its target; proven or sampled
  Effect effect = {};                            ///< of the form in place of its target, sampled
  bool is_shown = false;                         ///< whether the target lies in [0, 1], as a colour does
  std::optional<StudyJudgement> judgement = {};  ///< of a published set whose form can be fitted
  std::vector<JudgedError> claims = {};          ///< what the source says of its errors
  std::optional<ProvenError> proof = {};         ///< only by `prove_contenders`
  std::string unproven = {};                     ///< why there is no proof, set by `prove_contenders`
  std::optional<double> bound = {};              ///< proven too, but maybe far above the largest error
  std::vector<ContenderInFormat> formats = {};   ///< only by `round_contenders`
  /// The published contenders, by their places in the list, that have a larger error at no fewer
  /// instructions.
  std::vector<std::size_t> beats = {};
};

/// All contenders for the target of one combination of given constants: the published ones first, both by
/// rising error.
struct StudyComparison {
  Study study;  ///< its form is empty
  /// Of all contenders: "max_abs_error", "max_rel_error", or "max_weighted_error" where the study has a
  /// weight. Of measured rows it is the largest residual.
  std::string_view error;
  std::vector<std::string> variables = {};
  bool is_encoded = false;  ///< as in `StudyFile`
  std::vector<StudyContender> contenders = {};
  std::vector<StudyProperty> properties = {};  ///< of the target
  std::vector<std::string> left_out = {};      ///< fits that did not converge: form, objective and reason
};

/// The formulas of a comparison, with the form of a contender.
ReadStudy formulas_of(const StudyComparison& comparison, const StudyContender& contender);

/// The largest change of the target in codes of 8 bits: of an encoded target 255 times the change, of a
/// linear one the change of its sRGB code.
double codes_of(const StudyComparison& comparison, const StudyContender& contender);

/// The published contender that the file of the study has first; null without any.
const StudyContender* first_published(const StudyComparison& comparison);

/// The error of an exact form is only rounding.
inline constexpr double rounding_alone = 1e-14;

/// The fit of any form with the smallest error that needs no more instructions than a published contender.
/// Its error is smaller by 1 % at least, and its rms error at most twice as large. Null if there is none.
const StudyContender* least_error_at_the_same_cost(const StudyComparison& comparison,
                                                   const StudyContender& published);

/// The same among the fits that have all properties of the published contender: what is meant by the *best*
/// set, or the better one, in every table, picture, page and code.
const StudyContender* better_at_the_same_cost(const StudyComparison& comparison,
                                              const StudyContender& published);

/// The same among the fits that have all properties of the target, also those that the published contender
/// lacks.
const StudyContender* better_with_all_properties(const StudyComparison& comparison,
                                                 const StudyContender& published);

/// Whether published sets and the claims about them are judged, which takes some hundred fits.
enum class Judged { yes, no };

/// Compares the published sets of a study with the fits of each of its forms: least squares, minimax, and
/// what the file asks for. Where the best of these loses a property of a published
/// set, its form is fitted under constraints that keep them. Calls `next` before each of its
/// `steps_to_compare`. Throws UserError for a study that cannot be read.
StudyComparison compare_study(const StudyFile& file, const Study& study,
                              const Checkpoint& checkpoint = keep_going, const Checkpoint& next = keep_going,
                              Judged judged = Judged::yes);

/// The number of published sets and of fits that `compare_study` computes. All fits that are to keep
/// properties are one step, because their number is known only then.
std::size_t steps_to_compare(const StudyFile& file, const Study& study);

}  // namespace shadefit
