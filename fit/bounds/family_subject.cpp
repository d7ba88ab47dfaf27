#include "fit/bounds/family_subject.hpp"

#include <algorithm>

#include "fit/bounds/prove_shape.hpp"
#include "fit/catalogue/catalogue_study.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A form that falls with the angle rises with its cosine.
Course course_of(Trend trend) {
  return trend == Trend::falls ? Course::rises : Course::falls;
}

}  // namespace

std::string target_text(const Family& family, const Setting& setting) {
  if (!family.is_fresnel || !setting.surface.is_exact()) return to_text(family.target);
  return setting.surface.extinction == 0 ? "(F - f0)/(1 - f0), F the exact reflectance of a dielectric"
                                         : "(F - f0)/(1 - f0), F the exact reflectance of a conductor";
}

FamilySubject subject_of(const Fit& fit, Error error) {
  FamilySubject subject{.family = std::string(fit.family->id),
                        .setting = setting_of(fit),
                        .error = error,
                        .domain = fit.metric.domain};
  const Family& family = *fit.family;
  for (std::size_t i = 0; i < family.parameters.size(); ++i)
    subject.parameters.emplace_back(std::string(family.parameters[i]), hex_text(fit.parameters[i]));
  return subject;
}

Study plain_study_of(const Family& family, const Setting& setting, Error error, const Domain& domain) {
  Domain counted = domain;
  if (error == Error::relative) {
    const auto defined = family.relative_domain(setting, domain);
    if (!defined)
      throw UserError("a relative error of " + std::string(family.id) + " has no meaning on the domain " +
                      to_text(domain));
    counted = *defined;
  }
  Study study;
  if (family.is_fresnel) {
    study = fresnel_study(setting.surface, error);
  } else {
    study.target = to_text(family.target);
    study.given["k"] = to_text(setting.exponent);
    study.error = error;
  }
  study.over = {{"c", to_text(counted.lower), to_text(counted.upper)}};
  study.form = to_text(family.form);
  return study;
}

StudySubject in_words(const FamilySubject& subject) {
  const Family& family = *find_family(subject.family);
  const std::vector<std::string> known(family.parameters.begin(), family.parameters.end());
  if (const std::string fault = fault_of_constants(subject.parameters, known, subject.family); !fault.empty())
    throw UserError(fault);
  return {plain_study_of(family, subject.setting, subject.error, subject.domain), subject.parameters};
}

std::vector<std::pair<std::string, Proof>> prove_curve(const FamilySubject& subject,
                                                       const Checkpoint& checkpoint) {
  const CurveShape& stated = find_family(subject.family)->curve;
  const StudySubject study = in_words(subject);
  std::vector<std::pair<std::string, Proof>> properties;
  const auto prove = [&](bool is_stated, const std::string& words, const Constraints& constraint) {
    constexpr double size = 1;  // of a lobe and of a weight
    if (is_stated) properties.emplace_back(words, prove_shape(study, constraint, size, 0, checkpoint).proof);
  };
  prove(stated.trend != Trend::none,
        std::string(stated.trend == Trend::falls ? "falls" : "rises") + " with the angle",
        {.monotone = course_of(stated.trend)});
  prove(stated.is_non_negative, "non-negative", {.at_least = 0});
  prove(stated.is_at_most_one, "at most 1", {.at_most = 1});
  return properties;
}

}  // namespace shadefit
