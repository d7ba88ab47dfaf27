#include "approx/arithmetic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "approx/lobe.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit {
namespace {

/// The values of exp(-k) in a format.
struct Underflow {
  bool power_is_zero;     ///< 0^k == 0
  bool gaussian_is_zero;  ///< exp(k 0 - k) == 0
  double last;            ///< the largest power of the format with exp(-k) > 0
  double last_normal;     ///< the same with exp(-k) normal, for machines that flush subnormals to zero
};

Underflow underflow_in(std::string_view format, double power) {
  return in_format(format, [&]<class T>() {
    const auto gaussian = [](T k) { return gaussian_lobe(integer<T>(0), k, integer<T>(0)); };
    const T k = rounded_to<T>(power);
    const double least_normal = widened(std::numeric_limits<T>::min());
    // exp(-1) is normal in all of them, exp(-1024) below the least double
    return Underflow{widened(power_lobe(integer<T>(0), k)) == 0, widened(gaussian(k)) == 0,
                     last_that_holds<T>(1, 1024, [&](T x) { return widened(gaussian(x)) > 0; }),
                     last_that_holds<T>(1, 1024, [&](T x) { return widened(gaussian(x)) >= least_normal; })};
  });
}

Finding gaussian_at_zero(const Claim& claim) {
  const double power = given(claim, "power");
  const auto formats = items_of(claim.inputs.at("formats"));
  std::vector<std::string> zero, last, last_normal;
  bool power_is_zero = true;
  for (const std::string& format : formats) {
    const Underflow found = underflow_in(format, power);
    power_is_zero = power_is_zero && found.power_is_zero;
    if (found.gaussian_is_zero) zero.push_back(format);
    last.push_back(decimal(found.last, 6));
    last_normal.push_back(decimal(found.last_normal, 4));
  }
  const Decimal50 exact = gaussian_lobe(Decimal50(0), Decimal50(power), Decimal50(0));
  // In exact arithmetic it holds for every power: the formats decide between `confirmed` and `conditional`.
  const Verdict verdict = power_is_zero && exact > 0
                              ? verdict_of_cases(1 + formats.size() - zero.size(), 1 + formats.size())
                              : Verdict::refuted;
  // The power up to which exp(-k), at the edge of a lobe of peak 1, is at least one 8-bit sRGB code: there
  // the encoding is straight, 12.92 x.
  const double visible = std::log(srgb_code(0x1p-20) / 0x1p-20);
  return told(claim, verdict, fmt::format("none: exp(-{:.6g}) is below the least positive double", power),
              Told{"magnitude", static_cast<double>(log10(exact))}, Told{"zero", enumerated(zero)},
              Told{"last", enumerated(last)}, Told{"all_formats", enumerated(formats)},
              Told{"last_normal", enumerated(last_normal)}, Told{"visible", visible});
}

/// The results of exp2(log2(0) b) in a format.
double power_of_zero(std::string_view format, std::string_view exponent) {
  return in_format(format,
                   [&]<class T>() { return widened(power_by_exp2(integer<T>(0), constant<T>(exponent))); });
}

/// "b = 0 and 1e-09 (in half alone)", the exponents for which `is_so` is true in some format; `cases` gets
/// their number.
std::string exponents_that(const std::vector<std::string>& exponents, const std::vector<std::string>& formats,
                           bool (*is_so)(double), std::size_t& cases) {
  std::vector<std::string> found;
  for (const std::string& b : exponents) {
    std::vector<std::string> where;
    std::ranges::copy_if(formats, std::back_inserter(where),
                         [&](const std::string& format) { return is_so(power_of_zero(format, b)); });
    cases += where.size();
    if (where.empty()) continue;
    found.push_back(b +
                    (where.size() == formats.size() ? "" : fmt::format(" (in {} alone)", enumerated(where))));
  }
  return enumerated(found);
}

/// The stored value in a fixed-point render target: NaN becomes 0. Source: Microsoft, Direct3D 11.3
/// Functional Specification, 3.2.3.6, "FLOAT -> UNORM".
double as_stored(double value) {
  return std::isnan(value) ? 0 : value;
}

/// The effect of exp2(log2(0) b) instead of 0^b on stored values, over all exponents and formats.
Effect effect_of_power_of_zero(const std::vector<std::string>& exponents,
                               const std::vector<std::string>& formats) {
  Effect effect;
  for (const std::string& format : formats) {
    for (const std::string& b : exponents) {
      const double exponent = number_of(b);
      effect.show(exponent == 0 ? 1 : power_lobe(0.0, exponent), as_stored(power_of_zero(format, b)),
                  {{"c = ", 0}, {"b = ", exponent}});
    }
  }
  return effect;
}

/// The overflow of the sharpness A = k/ln 2 in a format, and the Gaussian beyond it.
struct Overflow {
  double last_power;           ///< the largest power of the format whose sharpness is finite
  Effect effect = {};          ///< of what is beyond on the lobe, at the last power of the format
  bool is_nan_as_told = true;  ///< exp2(A c - A) at c = 0, 0.5 and 1, and exp2(A (c - 1)) at 1 alone
};

Overflow overflow_in(std::string_view format) {
  return in_format(format, [&]<class T>() {
    const double largest = widened(std::numeric_limits<T>::max());
    Overflow found{
        last_that_holds<T>(1, largest, [](T k) { return std::isfinite(widened(base_two_power(k))); })};
    const T infinite = base_two_power(rounded_to<T>(largest));
    for (const char* c : {"0", "0.5", "1"}) {
      const T cosine = constant<T>(c);
      const double value = widened(gaussian_lobe_base_two(cosine, infinite));
      const bool difference = std::isnan(widened(gaussian_lobe_base_two_of_difference(cosine, infinite)));
      found.is_nan_as_told &= std::isnan(value) && difference == (widened(cosine) == 1);
      found.effect.show(power_lobe(widened(cosine), largest), as_stored(value),
                        {{"c = ", widened(cosine)}, {"k = ", largest}});
    }
    return found;
  });
}

Finding nan_at_zero(const Claim& claim) {
  const auto formats = items_of(claim.inputs.at("formats"));
  const auto exponents = items_of(claim.inputs.at("exponents"));
  const double largest = given(claim, "powers up to");
  std::size_t nan = 0, zero = 0;
  const std::string of_nan = exponents_that(
      exponents, formats, [](double y) { return std::isnan(y); }, nan);
  const std::string of_zero = exponents_that(
      exponents, formats, [](double y) { return y == 0; }, zero);
  double least = largest;  // the power up to which no format overflows
  Effect lost;             // where one does
  std::vector<std::string> last, safe;
  for (const std::string& format : formats) {
    const Overflow found = overflow_in(format);
    last.push_back(fmt::format("{:.5g} in {}", found.last_power, format));
    least = std::min(least, found.last_power);
    if (largest > found.last_power) lost.include(found.effect);
    if (largest <= found.last_power) safe.push_back(format);
    if (!found.is_nan_as_told) throw std::logic_error("another overflow than the one of the sentence");
  }
  const std::array parts{verdict_of_cases(nan, formats.size() * exponents.size()),
                         verdict_of_cases(safe.size(), formats.size())};
  return told(claim, worst(parts),
              sentences({sentence(effect_of_power_of_zero(exponents, formats), "the curve",
                                  "NaN stored as 0, exp2(log2(0) b)"),
                         sentence(lost, "the curve", "exp2(A c - A)")}),
              Told{"of_nan", of_nan}, Told{"of_zero", of_zero}, Told{"all_formats", enumerated(formats)},
              Told{"last", enumerated(last)}, Told{"safe", safe.empty() ? "none of them" : enumerated(safe)},
              Told{"least", least});
}

}  // namespace

std::vector<Evaluator> arithmetic_evaluators() {
  return {{"sg-nonzero-at-zero", gaussian_at_zero}, {"pow-nan-at-zero", nan_at_zero}};
}

}  // namespace shadefit
