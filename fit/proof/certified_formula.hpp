#pragma once

#include <array>
#include <string>

#include "fit/family_visit.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/proof/interval.hpp"

/// The formula that a certificate is about, in interval arithmetic. The search and the check share it.
namespace shadefit {

/// The target of a form in a setting, as text.
inline std::string target_text(const FittableFamily& family, const Setting& setting) {
  if (!family.is_fresnel() || !setting.surface.is_exact()) return to_text(family.target());
  return setting.surface.extinction == 0 ? "(F - f0)/(1 - f0), F the exact reflectance of a dielectric"
                                         : "(F - f0)/(1 - f0), F the exact reflectance of a conductor";
}

/// Calls visitor(error, form) with the error and the form of a subject as functions of the cosine,
/// for any scalar over intervals. The family must be known and each parameter's text a constant.
template <class Visitor>
auto visit_formula(const Subject& subject, const Visitor& visitor) {
  return visit_family(subject.family, [&]<class F>(std::type_identity<F>) {
    const F family = make_family<F>(subject.setting);
    std::array<Interval, F::parameters.size()> p;
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = enclosed_constant(subject.parameters.at(i).second).value();
    const auto with = [&](const auto& function) { return at_parameters(family, p, function); };
    const auto form = with([](const F& f, const auto& sample, const auto& q) { return f.form(sample, q); });
    if (subject.error == Error::absolute)
      return visitor(with([](const F& f, const auto& sample, const auto& q) { return f.error(sample, q); }),
                     form);
    return visitor(
        with([](const F& f, const auto& sample, const auto& q) { return f.relative_error(sample, q); }),
        form);
  });
}

/// The error and the form of a subject, type-erased: what uses them is compiled once, not for each family.
struct CertifiedFormula {
  EnclosedFunction error, form;
};

/// The same for these two scalars only.
CertifiedFormula certified_formula(const Subject& subject);

}  // namespace shadefit
