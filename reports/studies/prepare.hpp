#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fit/catalogue/fit_study.hpp"
#include "fit/proof/constants.hpp"
#include "fit/squares/prepared_study.hpp"
#include "fit/study/study_fit.hpp"
#include "reports/code/shader_code.hpp"

/// A study from its text, for programs: fitted, proven and as code.
namespace shadefit {

struct StudySubject;  // fit/bounds/study_certificate.hpp

/// Proven bounds of the largest error.
struct CertifiedError {
  double lower, upper;
  bool is_reached;          ///< whether the bounds have the usual width; else they are wider
  std::string certificate;  ///< the text of a file that `shadefit verify` reads
};

/// The first form of a study. Whoever calls it has no constants to give: where none are given, they are those
/// of `fit`. What a user can mend throws UserError. One thread uses it at a time; a copy shares nothing.
class Prepared {
 public:
  /// A file in TOML (docs/studies.md). Throws UserError for what `shadefit fit` refuses, for a table, as the
  /// text has no folder, and for a given constant with several values.
  explicit Prepared(const std::string& text);
  Prepared(const Prepared& other);
  Prepared(Prepared&&) = default;
  Prepared& operator=(const Prepared& other) { return *this = Prepared(other); }
  Prepared& operator=(Prepared&&) = default;

  /// The fit that `shadefit fit` finds, without a start. It is computed once.
  const StudyFit& fit();

  /// The bottom of the basin of these starts, in the order of the parameters of the form; `ambiguous` if they
  /// lead to different curves. Nothing else is looked for, neither other basins nor the largest error. For
  /// least squares alone.
  StudyFit fit(const std::vector<std::vector<double>>& starts);

  /// Bounds of the largest error. Throws CheckFailed if there is no finite one.
  CertifiedError certify(const Constants& constants = {});

  /// The code that `shadefit emit` writes, without the line that names the command.
  std::string emit(Language language, const Constants& constants = {},
                   ShaderPrecision precision = ShaderPrecision::float32);

 private:
  StudySubject subject(const Constants& constants);

  std::string id_;
  StudyObjective objective_;
  std::optional<ReadStudy> read_;
  std::optional<StudyFit> fit_;
  std::unique_ptr<PreparedStudy> squares_;  ///< from the first fit with starts on
};

/// A study from its text.
inline Prepared prepare(const std::string& text) {
  return Prepared(text);
}

}  // namespace shadefit
