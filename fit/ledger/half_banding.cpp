#include <algorithm>
#include <array>
#include <cmath>

#include "approx/arithmetic.hpp"
#include "approx/lobe.hpp"
#include "fit/errors/banding.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/narrow_result.hpp"

namespace shadefit {
namespace {

/// A form of c^k with each operation rounded to half.
struct RoundedForm {
  std::string_view name;
  HalfResult (*curve)(const HalfResult& cos_theta, const HalfResult& exponent);
  bool is_published;  ///< one of the two forms of the claim
  /// The roundings of the exponent of its exp2 with a float cosine, each relative to the exponent; 0: one of
  /// them is relative to something larger.
  int relative_roundings;
};

constexpr std::array rounded_forms{
    RoundedForm{"pow", power_by_exp2<HalfResult>, true, 2},  // of log2(c) and of the product
    RoundedForm{
        "exp2(A c - A)",
        [](const HalfResult& c, const HalfResult& k) { return gaussian_lobe_base_two(c, base_two_power(k)); },
        true, 0},  // A c is rounded relative to A
    RoundedForm{"exp2(A (c - 1))",
                [](const HalfResult& c, const HalfResult& k) {
                  return gaussian_lobe_base_two_of_difference(c, base_two_power(k));
                },
                false, 2}};  // of c - 1 and of the product; rounding A only gives another smooth lobe

/// A curve of a float or half cosine at one power, sampled by the inputs.
struct Highlight {
  double exponent;
  bool half_cosine;
  int samples;       ///< of a float cosine
  double least = 0;  ///< jumps up to this, in codes, are not examined
};

template <class Curve>
Banding banding_of(const Curve& curve, const Highlight& highlight) {
  if (highlight.half_cosine)
    return banding(
        halves_near_the_peak(), curve, [](double) { return 1.0; }, highlight.least);
  return banding(
      floats_over_the_highlight(highlight.exponent, highlight.samples), curve,
      [&](double c) { return power_lobe(c, highlight.exponent); }, highlight.least);
}

Banding banding_of(const RoundedForm& form, const Highlight& highlight) {
  const HalfResult k = HalfResult::rounded(highlight.exponent);
  return banding_of([&](double c) { return static_cast<double>(form.curve(HalfResult(c), k)); }, highlight);
}

/// The largest step, in 8-bit sRGB codes, that roundings can cause in a smooth highlight of peak 1 and of any
/// power up to `last`, if roundings of the exponent t of 2^-t are relative to t. With u = 2^-11 each value is
/// within 2^-t e^(+-r), r = ((1+u)^n - 1) t ln 2 + u, of the exact one, and a step is at most one such
/// interval. Subnormal halves add 2^-25 to the result, and `last` times that to t. Searched over the value.
double largest_step_of_roundings(int roundings, double last) {
  constexpr double unit = 0x1p-11, subnormal = 0x1p-25;
  const double relative = std::pow(1 + unit, roundings) - 1;
  return largest_sampled([&](double value) {
    if (value == 0) return 0.0;
    const double r = -std::log(value) * relative + unit + ln2<double>() * last * subnormal;
    return srgb_code(value * std::exp(r) + subnormal) - srgb_code(value * std::exp(-r) - subnormal);
  });
}

/// The first whole power up to `last` that bands, found by trying each from 1 on. Empty if none does.
std::optional<int> first_banding_power(const RoundedForm& form, Highlight highlight, double visible,
                                       double last) {
  highlight.least = visible;
  for (int k = 1; k <= last; ++k) {
    highlight.exponent = k;
    if (banding_of(form, highlight).step > visible) return k;
  }
  return std::nullopt;
}

/// The effect of rounding on c^k at that power. A half cosine represents all cosines that round to it: half a
/// step of the halves in [0.5, 1] on both sides.
Effect effect_of_rounding(const RoundedForm& form, const Highlight& highlight) {
  const HalfResult k = HalfResult::rounded(highlight.exponent);
  Effect effect;
  const auto show = [&](double cosine, double stored) {
    effect.show(power_lobe(cosine, highlight.exponent),
                static_cast<double>(form.curve(HalfResult(stored), k)), at_cosine({cosine, 1 - cosine}));
  };
  if (!highlight.half_cosine) {
    for (const double c : floats_over_the_highlight(highlight.exponent, highlight.samples)) show(c, c);
    return effect;
  }
  for (const double c : halves_near_the_peak()) {
    show(c - 0x1p-12, c);
    show(std::min(1.0, c + 0x1p-12), c);
  }
  return effect;
}

/// A case of the claim: the number of published forms that band at the power, and at the low power.
struct BandingCase {
  std::size_t bands = 0, low_bands = 0, forms = 0;
  Effect effect;                      ///< of the published forms at the power
  std::vector<std::string> steps;     ///< the largest of each form at the power
  std::vector<std::string> evidence;  ///< a sentence for each form
};

/// Its evidence: "With the cosine in half pow first bands at power 18: its largest step is 0.47 codes at
/// power 8 and 51 at power 1024, where 18 of 256 codes are left".
BandingCase banding_case(const Claim& claim, bool half_cosine) {
  const double low = given(claim, "low power"), last = given(claim, "powers up to");
  const double visible = given(claim, "visible step in 8-bit sRGB codes");
  const Highlight highlight{number_of(claim.printed[0].value), half_cosine,
                            static_cast<int>(given(claim, "samples of a float cosine"))};
  BandingCase found;
  for (const RoundedForm& form : rounded_forms) {
    const Banding at_power = banding_of(form, highlight),
                  at_low = banding_of(form, {low, half_cosine, highlight.samples});
    // with a float cosine the roundings may prove that no power bands
    const double most = half_cosine || form.relative_roundings == 0
                            ? HUGE_VAL
                            : largest_step_of_roundings(form.relative_roundings, last);
    const auto first = most <= visible ? std::nullopt : first_banding_power(form, highlight, visible, last);
    const std::string more =
        first             ? fmt::format(", where {} of 256 codes are left", at_power.codes)
        : most <= visible ? fmt::format(". Rounding changes it by at most {:.2g} codes at each power", most)
                          : "";
    found.steps.push_back(decimal(at_power.step, 2));
    found.evidence.push_back(fmt::format(
        "With the cosine in {} {} {}: its largest step is {} codes at power {:.4g} and {} at power {:.6g}{}",
        half_cosine ? "half" : "float", form.name,
        first ? fmt::format("first bands at power {}", *first) : "never bands", decimal(at_low.step, 2), low,
        found.steps.back(), highlight.exponent, more));
    if (!form.is_published) continue;
    ++found.forms;
    found.bands += at_power.step > visible ? 1 : 0;
    found.low_bands += at_low.step > visible ? 1 : 0;
    found.effect.include(effect_of_rounding(form, highlight));
  }
  return found;
}

/// The remedy of the post's comments: cosine and arithmetic in float, sharpness and result in half.
double step_of_remedy(double power, int samples) {
  const auto sharpness = static_cast<float>(base_two_power(round_to_half(power)));
  return banding_of(
             [&](double c) {
               return widened(round_to_half(
                   static_cast<double>(gaussian_lobe_base_two(static_cast<float>(c), sharpness))));
             },
             {power, false, samples})
      .step;
}

/// Judges the claim that in half a highlight of the printed power bands and one of the low power does not, by
/// pow and by the spherical Gaussian, with the cosine in half and in float.
Finding half_banding(const Claim& claim) {
  const BandingCase half = banding_case(claim, true), wide = banding_case(claim, false);
  const std::size_t forms = half.forms + wide.forms;
  const std::array parts{verdict_of_cases(half.bands + wide.bands, forms),
                         verdict_of_cases(forms - half.low_bands - wide.low_bands, forms)};
  const std::string_view exponent = claim.printed[0].value;
  const int samples = static_cast<int>(given(claim, "samples of a float cosine"));
  return told(claim, worst(parts),
              sentences({sentence(half.effect, "a smooth highlight of peak 1",
                                  fmt::format("at power {} rounding with the cosine in half", exponent)),
                         sentence(wide.effect, "it", "rounding with the cosine in float")}),
              Told{"half_steps", enumerated(half.steps)}, Told{"float_steps", enumerated(wide.steps)},
              Told{"half_forms", sentences(half.evidence)}, Told{"float_forms", sentences(wide.evidence)},
              Told{"remedy", step_of_remedy(number_of(exponent), samples)});
}

}  // namespace

std::vector<Evaluator> half_banding_evaluators() {
  return {{"half-banding", half_banding}};
}

}  // namespace shadefit
