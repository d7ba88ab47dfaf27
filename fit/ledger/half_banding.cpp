#include "fit/ledger/half_banding.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "approx/arithmetic.hpp"
#include "approx/lobe.hpp"
#include "fit/banding.hpp"
#include "fit/decimal.hpp"
#include "fit/half_result.hpp"
#include "fit/ledger/formats.hpp"

namespace shadefit {
namespace {

/// What rounding each operation to half makes of a form of c^k.
using Rounded = HalfResult (*)(const HalfResult& cos_theta, const HalfResult& exponent);

struct RoundedForm {
  std::string_view name;
  Rounded curve;
  bool is_published;  ///< one of the two that the claim speaks of
};

constexpr std::array rounded_forms{
    RoundedForm{"pow", power_by_exp2<HalfResult>, true},
    RoundedForm{
        "exp2(A c - A)",
        [](const HalfResult& c, const HalfResult& k) { return gaussian_lobe_base_two(c, base_two_power(k)); },
        true},
    RoundedForm{"exp2(A (c - 1))",
                [](const HalfResult& c, const HalfResult& k) {
                  return gaussian_lobe_base_two_of_difference(c, base_two_power(k));
                },
                false}};

/// A curve of a float or half cosine at one power, sampled as the inputs say.
struct Highlight {
  double exponent;
  bool half_cosine;
  int samples;       ///< of a float cosine
  double least = 0;  ///< jumps up to this, in codes, are not looked into
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

/// The first whole power that bands: looked for at 1, 2, 4 .. `last`, then between the last of these that
/// does not and the first that does. Empty where none of these does.
std::optional<int> first_banding_power(const RoundedForm& form, Highlight highlight, double visible,
                                       double last) {
  const auto bands = [&](int k) {
    highlight.exponent = k;
    highlight.least = visible;
    return banding_of(form, highlight).step > visible;
  };
  for (int k = 1; k <= last; k *= 2) {
    if (!bands(k)) continue;
    int first = k / 2 + 1;
    while (!bands(first)) ++first;
    return first;
  }
  return std::nullopt;
}

/// A case of the claim: how many of the published forms band at the power, how many at the low one.
struct BandingCase {
  std::size_t bands = 0, low_bands = 0, forms = 0;
  double step = 0;  ///< the largest of the published forms at the power
  std::string computed, evidence;
};

BandingCase banding_case(const Claim& claim, bool half_cosine) {
  const double power = number_of(claim.printed[0].value), low = number_of(claim.inputs.at("low power"));
  const double visible = number_of(claim.inputs.at("visible step in 8-bit sRGB codes"));
  const double last = number_of(claim.inputs.at("powers up to"));
  const int samples = static_cast<int>(number_of(claim.inputs.at("samples of a float cosine")));
  BandingCase found;
  std::vector<std::string> steps, codes, low_steps, first;
  for (const RoundedForm& form : rounded_forms) {
    const Banding at_power = banding_of(form, {power, half_cosine, samples});
    const Banding at_low = banding_of(form, {low, half_cosine, samples});
    if (form.is_published) {
      ++found.forms;
      found.bands += at_power.step > visible ? 1 : 0;
      found.low_bands += at_low.step > visible ? 1 : 0;
      found.step = std::max(found.step, at_power.step);
    }
    const auto from = first_banding_power(form, {power, half_cosine, samples}, visible, last);
    steps.push_back(decimal(at_power.step, 2));
    codes.push_back(std::to_string(at_power.codes));
    low_steps.push_back(decimal(at_low.step, 2));
    first.push_back(from ? std::to_string(*from) : "none");
  }
  found.computed = "steps of " + enumerated(steps);
  found.evidence = enumerated(steps) + " codes, showing " + enumerated(codes) + " of the 256, and at power " +
                   decimal(low, 4) + " " + enumerated(low_steps) +
                   " codes, the first power (of powers of two, then between them) up to " + decimal(last, 6) +
                   " that bands being " + enumerated(first);
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

}  // namespace

Finding evaluate_half_banding(const Claim& claim) {
  const BandingCase half = banding_case(claim, true), wide = banding_case(claim, false);
  const std::size_t forms = half.forms + wide.forms;
  const std::array parts{verdict_of_cases(half.bands + wide.bands, forms),
                         verdict_of_cases(forms - half.low_bands - wide.low_bands, forms)};
  const std::string exponent(claim.printed[0].value);
  std::vector<std::string> names;
  for (const RoundedForm& form : rounded_forms) names.emplace_back(form.name);
  const int samples = static_cast<int>(number_of(claim.inputs.at("samples of a float cosine")));
  return {worst(parts), half.computed + " codes with a half cosine, " + wide.computed + " with a float one",
          "largest steps of " + enumerated(names) + " at power " + exponent + ": with the cosine in half " +
              half.evidence + "; with the cosine in float and half arithmetic " + wide.evidence,
          "at power " + exponent + " neighbouring values of a smooth highlight of peak 1 lie up to " +
              decimal(std::max(half.step, wide.step), 2) +
              " 8-bit sRGB codes apart; with cosine and arithmetic in float and only the result in half, the "
              "remedy of the comments, " +
              decimal(step_of_remedy(number_of(exponent), samples), 2)};
}

}  // namespace shadefit
