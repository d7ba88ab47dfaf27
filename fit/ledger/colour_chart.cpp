#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/finding.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/ledger/transfer_function.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

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
    if (!(result.gamma > 0))
      throw std::invalid_argument(fmt::format("not an exponent above 0: {}", result.name));
  } else if (function != "sRGB") {
    throw std::invalid_argument(fmt::format("not a transfer function: '{}'", result.name));
  }
  if (!(result.codes > 0)) throw std::invalid_argument(fmt::format("not a divisor above 0: {}", result.name));
  return result;
}

std::vector<TransferFunction> transfer_functions(std::string_view names) {
  std::vector<TransferFunction> result;
  for (const std::string_view name : items_of(names)) result.push_back(transfer_function(name));
  return result;
}

namespace {

/// The record's conventions; the convention of stored codes comes first.
std::vector<TransferFunction> conventions_of(const Claim& claim) {
  std::vector<TransferFunction> conventions{transfer_function(claim.inputs.at("convention"))};
  for (TransferFunction& other : transfer_functions(claim.inputs.at("other conventions")))
    conventions.push_back(std::move(other));
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

std::string code_under_each(const std::vector<TransferFunction>& conventions, double linear) {
  return in_words(under_each(conventions, &TransferFunction::code, linear));
}

/// The effect of replacing one linear value by another, at a code.
std::string effect_of_linear(double used, double right, double code) {
  Effect effect;
  effect.show(right, used, {{"code ", code}});
  return sentence(effect, "a linear value", fmt::format("{:.4g} instead of {:.4g}", used, right));
}

struct Range {
  double from, to;
};

/// The exponents for which (code/255)^exponent rounds to `printed`: those of the interval that rounds to it.
/// Empty (from > to) if code/255 is 1 and printed is not.
Range exponents_that_give(std::string_view printed, double code) {
  constexpr double any = std::numeric_limits<double>::infinity();
  const double log_encoded = std::log(code / 255);
  if (log_encoded == 0) return units_off(printed, 1) == 0 ? Range{0, any} : Range{any, 0};
  const double value = number_of(printed), half = last_unit(printed) / 2;
  return {std::log(value + half) / log_encoded, std::log(value - half) / log_encoded};
}

std::string exponents_sentence(const Range& range) {
  if (!(range.from <= range.to)) return "(code/255)^p gives both numbers for no p";
  return fmt::format("(code/255)^p gives both numbers for p from {:.4g} to {:.4g}", range.from, range.to);
}

/// Two printed linear values against the codes "from code" and "to code".
Finding chart_range(const Claim& claim) {
  const auto conventions = conventions_of(claim);
  const std::vector<double> codes{given(claim, "from code"), given(claim, "to code")};
  // The conventions under which all digits of both numbers are right.
  std::vector<TransferFunction> right;
  std::vector<std::string> names;
  for (const TransferFunction& t : conventions) {
    if (units_off(claim.printed[0].value, t.linear(codes[0])) != 0) continue;
    if (units_off(claim.printed[1].value, t.linear(codes[1])) != 0) continue;
    right.push_back(t);
    names.push_back(t.name);
  }
  const TransferFunction& convention = right.empty() ? conventions.front() : right.front();
  std::vector<Verdict> verdicts;
  std::vector<std::string> values, computed, effects;
  Range exponents{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto& [name, printed] = claim.printed[i];
    verdicts.push_back(judge(printed, {"", convention.linear(codes[i])}, {}).verdict);
    computed.push_back(fmt::format("{} = {:.7g}", name, convention.linear(codes[i])));
    values.push_back(fmt::format("code {:.6g} is {}", codes[i], linear_under_each(conventions, codes[i])));
    const Range own = exponents_that_give(printed, codes[i]);
    exponents = {std::max(exponents.from, own.from), std::min(exponents.to, own.to)};
    effects.push_back(effect_of_linear(number_of(printed), conventions.front().linear(codes[i]), codes[i]));
  }
  const bool is_other = convention.name != conventions.front().name;
  return {is_other ? Verdict::other_objective : worst(verdicts),
          fmt::format("{}, {} under {}", computed[0], computed[1], convention.name),
          sentences({values[0], values[1],
                     fmt::format("both printed numbers are right in all digits under {}",
                                 names.empty() ? "no convention of these" : enumerated(names)),
                     exponents_sentence(exponents)}),
          sentences(effects)};
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
  return {
      judge(printed_second, {std::string(printed_first), first}, {}).verdict,
      fmt::format("{}; code {:.6g} is {:.7g} under {}", printed_first, code, conventions.front().linear(code),
                  conventions.front().name),
      told(claim, Told{"units", counted(units_off(printed_second, first), "unit")},
           Told{"codes", linear_under_each(conventions, code)}, Told{"closer", closer_to_first},
           Told{"conventions", conventions.size()}, Told{"first_code", code_under_each(conventions, first)},
           Told{"second_code", code_under_each(conventions, second)}),
      effect_of_linear(second, first, code)};
}

/// Whether the common values are within the decoded codes: under the first convention, under another, or in
/// part.
Finding holds_common(const std::vector<TransferFunction>& conventions, std::string_view material,
                     const std::vector<double>& codes, const std::vector<double>& common) {
  const auto chart = [&](const TransferFunction& t) {
    return Range{t.linear(codes.at(0)), t.linear(codes.at(1))};
  };
  const auto holds = [&](const TransferFunction& t) {
    return chart(t).from <= common.at(0) && common.at(1) <= chart(t).to;
  };
  const auto overlaps = [&](const TransferFunction& t) {
    return chart(t).from <= common.at(1) && common.at(0) <= chart(t).to;
  };
  std::vector<std::string> ranges;
  for (const TransferFunction& t : conventions) {
    ranges.push_back(fmt::format("{:.4g} to {:.4g} under {}{}", chart(t).from, chart(t).to, t.name,
                                 holds(t) ? " (holds them)" : " (leaves some out)"));
  }
  const TransferFunction& stored = conventions.front();
  const Range own = chart(stored);
  const bool holds_elsewhere = std::any_of(conventions.begin() + 1, conventions.end(), holds);
  const Verdict verdict = holds(stored)      ? Verdict::confirmed
                          : holds_elsewhere  ? Verdict::other_objective
                          : overlaps(stored) ? Verdict::conditional
                                             : Verdict::refuted;
  Effect effect;  // of clamping a common value to the chart
  for (const double value : common)
    effect.show(value, std::clamp(value, own.from, std::max(own.from, own.to)), {{"linear ", value}});
  return {verdict, fmt::format("{:.7g} .. {:.7g}", own.from, own.to),
          fmt::format(
              "common {} have {:.4g} to {:.4g}, which is codes {:.4g} to {:.4g} under {}. The chart's codes "
              "{:.6g} to {:.6g} are {}. They overlap under {} of {} conventions",
              material, common.at(0), common.at(1), stored.code(common.at(0)), stored.code(common.at(1)),
              stored.name, codes.at(0), codes.at(1), enumerated(ranges),
              std::ranges::count_if(conventions, overlaps), conventions.size()),
          sentence(effect, "a linear value", fmt::format("keeping {} within the chart", material))};
}

/// Whether the ranges of common dielectrics and of common metals are within the range of the chart's codes.
Finding chart_holds_common_materials(const Claim& claim) {
  const auto conventions = conventions_of(claim);
  const auto part = [&](std::string_view material, std::string_view codes, std::string_view common) {
    return holds_common(conventions, material, numbers_of(claim.inputs.at(codes)),
                        numbers_of(claim.inputs.at(common)));
  };
  const Finding dielectrics = part("dielectrics", "dielectric codes", "common dielectrics");
  const Finding metals = part("metals", "metal codes", "common metals");
  const std::array verdicts{*dielectrics.verdict, *metals.verdict};
  return {worst(verdicts), fmt::format("dielectrics {}, metals {}", dielectrics.computed, metals.computed),
          sentences({dielectrics.evidence, metals.evidence}), sentences({dielectrics.effect, metals.effect})};
}

/// A printed code against the encoding of "linear".
Finding middle_grey(const Claim& claim) {
  const auto conventions = conventions_of(claim);
  const double linear = given(claim, "linear");
  const double naive = given(claim, "not");
  const double photographic = given(claim, "photographic grey");
  const std::string_view printed = claim.printed[0].value;
  const TransferFunction& stored = conventions.front();
  const auto codes = under_each(conventions, &TransferFunction::code, linear);
  const Judgement judged = judge(printed, codes.front(), std::span(codes).subspan(1));
  const double exact = stored.code(linear);
  return {judged.verdict, decimal(judged.value, 6),
          told(claim, Told{"codes", in_words(codes)}, Told{"rounded", std::round(exact)},
               Told{"truncated", std::floor(exact)}, Told{"of_code", stored.linear(number_of(printed))},
               Told{"of_not", stored.linear(naive)}, Told{"convention", stored.name},
               Told{"photographic_code", stored.code(photographic)}),
          effect_of_linear(stored.linear(number_of(printed)), linear, number_of(printed))};
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
