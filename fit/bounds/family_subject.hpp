#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/proof/constants.hpp"
#include "fit/proof/proof.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// A form of a family as the subject of a proof.
namespace shadefit {

/// One form with its constants, and the domain.
struct FamilySubject {
  std::string family;
  Constants parameters = {};  ///< in the order of the family's names
  Setting setting = {};
  Error error = Error::absolute;
  Domain domain = {};
};

/// The target of a form in a setting, as a reader reads it.
std::string target_text(const Family& family, const Setting& setting);

/// The subject of a fit, its parameters exact.
FamilySubject subject_of(const Fit& fit, Error error = Error::absolute);

/// The study of a family in its plain formulas of c, whose errors are those of the family: of the lobe, or of
/// the reflectance F if a Fresnel form has a surface. A relative error is narrowed to where it is defined.
/// Throws UserError where that is nowhere.
Study plain_study_of(const Family& family, const Setting& setting, Error error, const Domain& domain);

/// The same with the constants. Throws UserError for constants that are not those of the family.
StudySubject in_words(const FamilySubject& subject);

/// What the record of a family states of its curve, with the results of the proofs: "falls with the angle",
/// "non-negative", "at most 1".
std::vector<std::pair<std::string, Proof>> prove_curve(const FamilySubject& subject,
                                                       const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
