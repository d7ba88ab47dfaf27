#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/families/admissible.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/proof/certified_formula.hpp"
#include "fit/proof/curve_proof.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

std::string parameters_text(const Subject& subject) {
  std::string text;
  for (const auto& [name, value] : subject.parameters)
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
}

/// Requires that the form has no pole in the domain. The denominator is linear in c, so checking both ends is
/// enough.
void require_admissible(const Subject& subject) {
  visit_family(subject.family, [&]<class F>(std::type_identity<F>) {
    if constexpr (HasDenominator<F>) {
      const F family = make_family<F>(subject.setting);
      std::array<Interval, F::parameters.size()> p;
      for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = enclosed_constant(subject.parameters[i].second).value();
      for (const double end : {subject.domain.lower, subject.domain.upper}) {
        if (!(lower_end(family.denominator(Interval(end), p)) > 0))
          throw UserError(subject.family + " with " + parameters_text(subject) + " has a pole: it must be " +
                          rule_of_admission(family, subject.domain));
      }
    }
  });
}

/// The part of the domain where the error is defined. An end that is a double stays exact.
Domain narrowed(const Subject& subject) {
  if (subject.error == Error::absolute) return subject.domain;
  const auto end = visit_family(subject.family, [&]<class F>(std::type_identity<F>) {
    return make_family<F>(subject.setting).relative_end();
  });
  const double lower = end ? std::max(subject.domain.lower, end->cos_theta) : subject.domain.upper;
  if (!(lower < subject.domain.upper))
    throw UserError("a relative error of " + subject.family + " has no meaning on the domain " +
                    to_text(subject.domain));
  return {lower, subject.domain.upper};
}

/// The place of the largest error by a search in plain doubles. It only makes the proof faster.
std::optional<ExactPlace> probable_place(const FittableFamily& family, const Subject& subject) {
  std::vector<double> parameters;
  for (const auto& [name, text] : subject.parameters)
    parameters.push_back(upper_end(enclosed_constant(text).value()));
  if (subject.error == Error::absolute)
    return place_of(family.max_abs_error(subject.setting, subject.domain, parameters).at);
  const auto found = family.max_rel_error(subject.setting, subject.domain, parameters);
  return found ? std::optional(place_of(found->at)) : std::nullopt;
}

/// The ends of the boxes of one side, in rising order.
std::vector<double> ends_of(const std::vector<Box>& boxes, Origin side) {
  std::vector<double> ends;
  for (const Box& box : boxes) {
    if (box.side != side) continue;
    ends.push_back(box.lower);
    ends.push_back(box.upper);
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

Domain cosines_of(const Box& box) {
  if (box.side == Origin::horizon) return {box.lower, box.upper};
  const Interval one(1);
  return {lower_end(one - Interval(box.upper)), upper_end(one - Interval(box.lower))};
}

void require_width(double width) {
  if (!(width >= least_width && width < 1)) {
    throw UserError("width '" + decimal(width, 6) + "' cannot be reached: it must be at least " +
                    decimal(least_width, 6) + ", what an enclosure by doubles can say, and less than 1");
  }
}

CertifiedFormula certified_formula(const Subject& subject) {
  return visit_formula(subject, [](const auto& error, const auto& form) {
    return CertifiedFormula{error, form};
  });
}

Certified certify(const Subject& asked, double width, const Checkpoint& checkpoint) {
  require_width(width);
  if (const std::string fault = fault_of(asked); !fault.empty()) throw UserError(fault);
  const FittableFamily* family = find_family(asked.family);
  require_admissible(asked);
  const auto [error, form] = certified_formula(asked);
  Subject subject = asked;
  subject.domain = narrowed(asked);
  const Enclosure found =
      enclose_largest(error, subject.domain,
                      {.width = width, .hint = probable_place(*family, subject), .checkpoint = checkpoint});
  if (!std::isfinite(found.upper))
    throw CheckFailed(asked.family + " with " + parameters_text(asked) + " on " + to_text(subject.domain) +
                      ": no double was proven to bound the largest error");
  std::vector<Box> boxes = found.boxes;
  const CurveShape& stated = family->info.curve;
  const CurveProof curve = prove_curve(form, stated, boxes, checkpoint);
  const CurveShape proven{.trend = curve.trend == Proof::proven ? stated.trend : Trend::none,
                          .is_non_negative = curve.non_negative == Proof::proven,
                          .is_at_most_one = curve.at_most_one == Proof::proven};
  return {.certificate = {.subject = subject,
                          .target = target_text(*family, asked.setting),
                          .form = to_text(family->form()),
                          .lower = found.lower,
                          .upper = found.upper,
                          .attained = found.attained,
                          .places = found.places,
                          .horizon = ends_of(boxes, Origin::horizon),
                          .peak = ends_of(boxes, Origin::peak),
                          .curve = proven,
                          .precision = interval_precision()},
          .is_reached = found.is_reached,
          .curve = curve};
}

Subject subject_of(const Fit& fit, Error error) {
  Subject subject{.family = std::string(fit.family->id),
                  .setting = setting_of(fit),
                  .error = error,
                  .domain = fit.metric.domain};
  const FittableFamily& family = *find_family(fit.family->id);
  for (std::size_t i = 0; i < family.parameters.size(); ++i)
    subject.parameters.emplace_back(std::string(family.parameters[i]), hex_text(fit.parameters[i]));
  return subject;
}

}  // namespace shadefit
