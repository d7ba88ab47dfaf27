#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fit/ledger/topics.hpp"
#include "fit/ledger/transfer_function.hpp"

namespace shadefit {

double TransferFunction::linear(double code) const {
  const double encoded = code / codes;
  return gamma == 0 ? srgb_decode(encoded) : gamma_decode(encoded, gamma);
}

double TransferFunction::code(double linear) const {
  return codes * (gamma == 0 ? srgb_encode(linear) : gamma_encode(linear, gamma));
}

TransferFunction transfer_function(std::string_view name) {
  constexpr std::string_view exponent = "gamma ", divisor = " of code/";
  TransferFunction result;
  result.name = name;
  std::string_view function = name;
  if (const auto at = name.find(divisor); at != std::string_view::npos) {
    result.codes = number_of(name.substr(at + divisor.size()));
    function = name.substr(0, at);
  }
  if (function.starts_with(exponent)) {
    result.gamma = number_of(function.substr(exponent.size()));
  } else if (function != "sRGB") {
    throw std::invalid_argument(fmt::format("not a transfer function: '{}'", result.name));
  }
  return result;
}

namespace {

/// The record's conventions; the convention of stored codes comes first.
std::vector<TransferFunction> conventions_of(const Claim& claim) {
  std::vector<TransferFunction> conventions{transfer_function(claim.inputs.at("convention"))};
  for (const std::string& other : items_of(claim.inputs.at("other conventions")))
    conventions.push_back(transfer_function(other));
  return conventions;
}

/// The conversion of a code or of a linear value under each convention.
std::vector<Alternative> under_each(const std::vector<TransferFunction>& conventions,
                                    double (TransferFunction::*conversion)(double) const, double value) {
  std::vector<Alternative> all;
  for (const TransferFunction& convention : conventions)
    all.push_back({convention.name, (convention.*conversion)(value)});
  return all;
}

/// "0.0212 under sRGB, 0.017 under gamma 2.2".
std::string in_words(const std::vector<Alternative>& values) {
  std::vector<std::string> parts;
  for (const auto& [convention, value] : values)
    parts.push_back(fmt::format("{} under {}", decimal(value, 4), convention));
  return enumerated(parts);
}

std::string linear_under_each(const std::vector<TransferFunction>& conventions, double code) {
  return in_words(under_each(conventions, &TransferFunction::linear, code));
}

/// The effect of replacing one linear value by another, at a code.
std::string effect_of_linear(double used, double right, double code) {
  return effect_of_value(right, used, {{"code ", code}}, "a linear value",
                         fmt::format("{:.4g} instead of {:.4g}", used, right));
}

/// The exponents for which (code/255)^exponent rounds to `printed`: those of the interval that rounds to it.
/// Empty (from > to) if code/255 is 1 and printed is not.
Range exponents_that_give(std::string_view printed, double code) {
  constexpr double any = std::numeric_limits<double>::infinity();
  const double log_encoded = std::log(code / 255);
  if (log_encoded == 0) return units_off(printed, 1) == 0 ? Range{0, any} : Range{any, 0};
  const double value = number_of(printed), half = last_unit(printed) / 2;
  return {std::log(value + half) / log_encoded, std::log(value - half) / log_encoded};
}

/// Two printed linear values against the codes "from code" and "to code".
Finding chart_range(const Claim& claim) {
  const auto conventions = conventions_of(claim);
  const std::string_view low = claim.printed[0].value, high = claim.printed[1].value;
  const double from = given(claim, "from code"), to = given(claim, "to code");
  // The conventions under which all digits of both numbers are right.
  std::vector<TransferFunction> right;
  std::vector<std::string> names;
  for (const TransferFunction& t : conventions) {
    if (units_off(low, t.linear(from)) != 0 || units_off(high, t.linear(to)) != 0) continue;
    right.push_back(t);
    names.push_back(t.name);
  }
  const TransferFunction &stored = conventions.front(), &convention = right.empty() ? stored : right.front();
  const std::array verdicts{judge(low, {"", convention.linear(from)}, {}).verdict,
                            judge(high, {"", convention.linear(to)}, {}).verdict};
  const Range of_low = exponents_that_give(low, from), of_high = exponents_that_give(high, to);
  return told(
      claim, convention.name == stored.name ? worst(verdicts) : Verdict::other_objective,
      sentences({effect_of_linear(number_of(low), stored.linear(from), from),
                 effect_of_linear(number_of(high), stored.linear(to), to)}),
      Told{"low", convention.linear(from)}, Told{"high", convention.linear(to)},
      Told{"convention_used", convention.name}, Told{"low_values", linear_under_each(conventions, from)},
      Told{"high_values", linear_under_each(conventions, to)},
      Told{"right", names.empty() ? "no convention of these" : enumerated(names)},
      Told{"least", std::max(of_low.from, of_high.from)}, Told{"most", std::min(of_low.to, of_high.to)});
}

/// Two printed linear values that should both be the decoded "code".
Finding chart_range_given_twice(const Claim& claim) {
  const auto conventions = conventions_of(claim);
  const std::string_view printed_first = claim.printed[0].value, printed_second = claim.printed[1].value;
  const double first = number_of(printed_first), second = number_of(printed_second);
  const double code = given(claim, "code");
  const auto closer_to_first = std::ranges::count_if(conventions, [&](const TransferFunction& t) {
    return std::abs(t.linear(code) - first) < std::abs(t.linear(code) - second);
  });
  const auto code_of = [&](double linear) {
    return in_words(under_each(conventions, &TransferFunction::code, linear));
  };
  return told(claim, judge(printed_second, {"", first}, {}).verdict, effect_of_linear(second, first, code),
              Told{"decoded", conventions.front().linear(code)},
              Told{"units", counted(units_off(printed_second, first), "unit")},
              Told{"codes", linear_under_each(conventions, code)}, Told{"closer", closer_to_first},
              Told{"conventions", conventions.size()}, Told{"first_code", code_of(first)},
              Told{"second_code", code_of(second)});
}

/// Whether the common values are within the decoded codes: under the first convention, under another, or in
/// part.
Finding holds_common(const std::vector<TransferFunction>& conventions, std::string_view material,
                     const std::vector<double>& codes, const std::vector<double>& common) {
  const double least = common.at(0), most = common.at(1);
  const auto chart = [&](const TransferFunction& t) {
    return Range{t.linear(codes.at(0)), t.linear(codes.at(1))};
  };
  const auto holds = [&](const TransferFunction& t) { return chart(t).from <= least && most <= chart(t).to; };
  const auto overlaps = [&](const TransferFunction& t) {
    return chart(t).from <= most && least <= chart(t).to;
  };
  std::vector<std::string> ranges;
  for (const TransferFunction& t : conventions) {
    ranges.push_back(fmt::format("{:.4g} to {:.4g} under {}{}", chart(t).from, chart(t).to, t.name,
                                 holds(t) ? " (holds them)" : " (leaves some out)"));
  }
  const TransferFunction& stored = conventions.front();
  const Range own = chart(stored);
  const Verdict verdict = holds(stored)                             ? Verdict::confirmed
                          : std::ranges::any_of(conventions, holds) ? Verdict::other_objective
                          : overlaps(stored)                        ? Verdict::conditional
                                                                    : Verdict::refuted;
  Effect effect;  // of clamping a common value to the chart
  for (const double value : common)
    effect.show(value, std::clamp(value, own.from, own.to), {{"linear ", value}});
  return {
      verdict, fmt::format("{:.7g} .. {:.7g}", own.from, own.to),
      fmt::format(
          "common {} have {:.4g} to {:.4g}, which is codes {:.4g} to {:.4g} under {}. The chart's codes "
          "{:.6g} to {:.6g} are {}. They overlap under {} of {} conventions",
          material, least, most, stored.code(least), stored.code(most), stored.name, codes.at(0), codes.at(1),
          enumerated(ranges), std::ranges::count_if(conventions, overlaps), conventions.size()),
      sentence(effect, "a linear value", fmt::format("keeping {} within the chart", material))};
}

/// Whether the ranges of common dielectrics and of common metals are within the range of the chart's codes.
Finding chart_holds_common_materials(const Claim& claim) {
  const auto part = [&](std::string_view material, std::string_view codes, std::string_view common) {
    return holds_common(conventions_of(claim), material, numbers_of(claim.inputs.at(codes)),
                        numbers_of(claim.inputs.at(common)));
  };
  const Finding dielectrics = part("dielectrics", "dielectric codes", "common dielectrics");
  const Finding metals = part("metals", "metal codes", "common metals");
  return {worst(std::array{dielectrics.verdict, metals.verdict}),
          fmt::format("dielectrics {}, metals {}", dielectrics.computed, metals.computed),
          sentences({dielectrics.evidence, metals.evidence}), sentences({dielectrics.effect, metals.effect})};
}

/// A printed code against the encoding of "linear".
Finding middle_grey(const Claim& claim) {
  const auto conventions = conventions_of(claim);
  const double linear = given(claim, "linear");
  const std::string_view printed = claim.printed[0].value;
  const TransferFunction& stored = conventions.front();
  const auto codes = under_each(conventions, &TransferFunction::code, linear);
  const Judgement judged = judge(printed, codes.front(), std::span(codes).subspan(1));
  const double exact = stored.code(linear), of_code = stored.linear(number_of(printed));
  return told(claim, judged.verdict, effect_of_linear(of_code, linear, number_of(printed)),
              Told{"judged", judged.value}, Told{"codes", in_words(codes)},
              Told{"rounded", std::round(exact)}, Told{"truncated", std::floor(exact)},
              Told{"of_code", of_code}, Told{"of_not", stored.linear(given(claim, "not"))},
              Told{"photographic_code", stored.code(given(claim, "photographic grey"))});
}

}  // namespace

/// Codes of a colour chart and the linear values that are printed for them. Every record has a "convention"
/// for decoding codes, and "other conventions" (fit/ledger/transfer_function.hpp).
std::vector<Evaluator> colour_chart_evaluators() {
  return {{"chart-dielectric", chart_range},
          {"chart-metal", chart_range},
          {"chart-range-typo", chart_range_given_twice},
          {"chart-overlap", chart_holds_common_materials},
          {"middle-grey", middle_grey}};
}

}  // namespace shadefit
