#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/study/study.hpp"
#include "fit/support/others_text.hpp"

/// A study with a name: a target, the forms that compete for it, and the constants that were published.
namespace shadefit {

/// Constants as printed: names and decimal texts, because the number of digits matters.
using PrintedValues = std::vector<std::pair<std::string, std::string>>;

struct StudyForm {
  std::string id, formula;
  std::string error = {};      ///< form - target by a formula that does not cancel; empty: their difference
  std::string near_peak = {};  ///< as in `Study`
  /// As the known starts of a study: formulas of numbers and of its given constants.
  std::vector<PrintedValues> starts = {};
};

/// The study with this form. Its given constants are known.
void take_form(Study& study, const StudyForm& form);

/// An error that a source states.
enum class StatedError {
  max_abs_error,
  max_rel_error,
  mean_abs_error,
  mean_rel_error,
  rms_error,
  mean_square_error
};

inline constexpr std::array stated_errors{StatedError::max_abs_error,  StatedError::max_rel_error,
                                          StatedError::mean_abs_error, StatedError::mean_rel_error,
                                          StatedError::rms_error,      StatedError::mean_square_error};

/// Its key in the file of a study: "max_abs_error" ..
std::string_view name(StatedError error);

/// What a source says about an error of its constants.
struct ErrorClaim {
  StatedError error = StatedError::max_abs_error;
  std::string printed;
  OthersText says = {};               ///< the words of the source
  std::vector<StudyRange> over = {};  ///< other ranges than those of the study
};

/// A copy with another digit, or with a value that its source has replaced.
struct MistypedCopy {
  PrintedValues values;      ///< only those that differ
  OthersText seen;           ///< where
  OthersText replaced = {};  ///< why its source replaced it; empty: it is mistyped
};

/// A work as a bibliography has it. An unknown part is empty.
struct CitedWork {
  std::vector<OthersText> authors = {};  ///< "Surname", "Surname, Given", or the name of a group
  OthersText title = {}, year = {}, howpublished = {}, note = {};
  std::string url = {};  ///< http or https, of the letters that an address may have
};

/// One published set of constants of a form.
struct PublishedSet {
  std::string form;                         ///< the id of a form
  PrintedValues given = {};                 ///< the given constants that it was published for; empty: any
  PrintedValues values;                     ///< one for each parameter
  OthersText source;                        ///< author, year, title
  std::optional<CitedWork> cite = {};       ///< the same in parts; empty: only the text is known
  std::vector<OthersText> where = {};       ///< repositories and files that use it
  std::vector<ErrorClaim> claims = {};      ///< about its errors
  std::vector<MistypedCopy> variants = {};  ///< copies that differ
  bool is_stated_fit = false;               ///< the source says that it is the fit that the study asks for
};

struct StudyFile {
  std::string id;
  OthersText title = {}, about = {};
  Study study;            ///< its form is empty: it is one of `forms`
  OthersText table = {};  ///< the file of measured rows, in the folder of the study; empty: a formula
  bool is_encoded =
      false;  ///< whether the target is a signal for a display, as sRGB is, and not linear light
  std::optional<std::string> recompute = {};  ///< the formula that gave the values of the table
  std::vector<std::pair<std::string, std::vector<std::string>>> given = {};  ///< each with its values
  std::vector<StudyForm> forms;                                              ///< the first is the usual one
  Norm norm = Norm::least_squares;
  bool has_weight = false;  ///< whether a weight is asked for; else measured rows with sigma get 1/sigma
  Constraints constraints = {};
  std::vector<PublishedSet> published = {};
  /// Where its formulas and ranges stand, by their keys: "target", "over x", "let f"; "form" and the id.
  std::map<std::string, long> lines = {};
};

/// Reads a study in TOML (docs/studies.md has its keys). Numbers are texts or formulas, so that no digit is
/// lost. Throws UserError with one line that names the file, the line and the rule: for a text that is not
/// TOML, an unknown key, a missing one, a value of another type, another schema, and a published set of a
/// form that is not there. The name is that of messages, and may be shown.
StudyFile read_study_file(const std::string& text, const std::string& name);

/// A fault of a formula in a file: its line and key instead of an option, ", line 6: target: formula
/// .."; the key alone, if the line is not known. `form` is the id of the form that was read.
std::string fault_in(const StudyFile& file, const StudyFault& fault, const std::string& form);

/// Whether a set was published for the given constants of a study.
bool is_for(const PublishedSet& set, const Study& study);

/// "k = 3, g = 0.5": the given constants of a study; empty without any.
std::string given_text(const Study& study);

inline constexpr std::size_t most_combinations = 10000;

/// Every combination of given constants: the values of the last change fastest. Throws UserError for a
/// constant that is given twice, and for more than `most_combinations`, or fewer of a study of many
/// definitions.
std::vector<Study> combinations(const Study& study,
                                const std::vector<std::pair<std::string, std::vector<std::string>>>& given);

}  // namespace shadefit
