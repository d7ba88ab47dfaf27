#include "bench/forms/catalogue.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "approx/exp2_polynomial.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/support/decimal.hpp"
#include "fit/verdicts/refit.hpp"
#include "fit/verdicts/study_objectives.hpp"

namespace shadefit::forms {
namespace {

NamedNumber printed_number(std::string_view name, std::string_view decimal) {
  return {std::string(name), std::string(decimal), constant<double>(decimal)};
}

/// A fitted number rounded to the ten digits that are the same on every machine, so that results are too.
NamedNumber computed_number(std::string_view name, double value) {
  return printed_number(name, decimal(value, 10));
}

/// The published constants of a family, each set of numbers once.
std::vector<Constants> published_of(const Family& family) {
  std::vector<Constants> all;
  for (const Published* number : numbers_of(family)) {
    if (number->parameter != family.parameters.front()) continue;  // a set is named by its first
    Constants found{.id = "published-" + std::string(number->id), .numbers = {}};
    for (const auto& [parameter, printed] : *number->curve)
      found.numbers.push_back(printed_number(parameter, printed));
    all.push_back(std::move(found));
  }
  return all;
}

/// The metrics of "best", as ids.
std::vector<std::pair<std::string, Metric>> objectives() {
  std::vector<std::pair<std::string, Metric>> all;
  for (const Measure measure : measures)
    all.emplace_back("least-squares-" + std::string(name(measure)), Metric{.measure = measure});
  for (const Error error : {Error::absolute, Error::relative})
    all.emplace_back("minimax-" + std::string(name(error)), Metric{.norm = Norm::minimax, .error = error});
  return all;
}

/// The published constants of a family and the best ones. A fit without an answer is left out, for example if
/// the minimax relative error of a lobe's form is not attained.
std::vector<Constants> constants_of(std::string_view id) {
  const Family& family = *find_family(id);
  std::vector<Constants> all = published_of(family);
  for (const auto& [objective, metric] : objectives()) {
    const Fit fit = family.fit(Setting(fixed_exponent), metric);
    if (fit.status != Status::converged) continue;
    Constants found{.id = objective, .numbers = {}};
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
      found.numbers.push_back(computed_number(family.parameters[i], fit.parameters[i]));
    all.push_back(std::move(found));
  }
  return all;
}

// The error jumps where the exponent x = (a c + b) c passes the middle between two whole numbers. In c, these
// places depend on the pair. With x as the variable instead of c, they do not: the polynomial is 2^n p(x - n)
// for every pair, and the pair moves only the cosine at which (1-c)^5 is evaluated, the root of
// (a c + b) c = x that is 0 at x = 0. So the polynomial is the target here, and (1-c)^5 the form.

constexpr const char* cosine_of_exponent = "2 x/(b - sqrt(b b + 4 a x))";

/// From the first whole numbers, from 0 down. Without the others the level can only be lower. But errors
/// there are below the level: the polynomial is at most 2^-8.5 = 0.0028 and (1-c)^5 less, while the level is
/// at least 0.0034. So the level is that of the whole domain. Its test samples all of it.
constexpr const char* lowest_exponent = "-8.5";

std::string polynomial(int degree) {
  const Exp2Coefficients& coefficients = exp2_of_degree(exp2_for_float, degree);
  std::string text = "0";
  for (int i = degree; i > 0; --i)
    text = "r (" + std::string(coefficients.printed[static_cast<std::size_t>(i - 1)]) + " + " + text + ")";
  return "exp2(n) (1 + " + text + ")";
}

/// The constants of a form that another form of the same curve uses too.
std::vector<Constants> telling(std::vector<Constants> all) {
  std::erase_if(all, [](const Constants& constants) {
    return constants.id != "published-sg-offset-mean" && constants.id != "minimax-absolute";
  });
  return all;
}

std::vector<Constants> nothing() {
  return {{"none", {}}};
}

FormEntry of_family(std::string_view id) {
  return {id, constants_of(id)};
}

static_assert(fixed_exponent == 16, "the texts of the targets say so");

NamedNumber exponent() {
  return printed_number("k", std::to_string(fixed_exponent));
}

Target lobe(const std::vector<Constants>& offsets) {
  return {"lobe",
          "c^k, k = 16",
          Arguments::cosine,
          0,
          1,
          {exponent()},
          {{"lobe-pow", nothing()},
           {"lobe-exp2-log2", nothing()},
           {"lobe-squarings", nothing()},
           {"sg", offsets},
           {"sg-difference", telling(offsets)},
           of_family("sg-scaled"),
           of_family("phong-blinn")}};
}

Target gloss() {
  // Lagarde 2012.
  const auto with_offset = [](const char* name, std::string_view x) -> Constants {
    return {name, {printed_number("m", "1.528766"), printed_number("x", x)}};
  };
  return {"lobe-gloss",
          "c^(2^(d g + f)), g an 8-bit code/255",
          Arguments::cosine_and_code,
          0,
          1,
          {printed_number("d", "10"), printed_number("f", "1")},
          {{"gloss-pow", nothing()},
           {"gloss-sg",
            {with_offset("plain", "0"),
             with_offset("published-sg-offset-mean", find_published("sg-offset-mean")->printed),
             with_offset("published-sg-offset-limit", find_published("sg-offset-limit")->printed)}}}};
}

Target schlick() {
  Target target{"schlick",
                "(1 - c)^5",
                Arguments::cosine,
                0,
                1,
                {},
                {{"schlick-pow", nothing()}, {"schlick", nothing()}}};
  for (const char* id : {"fresnel-one-term", "fresnel-quadratic", "fresnel-cubic", "fresnel-quartic",
                         "fresnel-fourth", "fresnel-square", "fresnel-rational"}) {
    target.forms.push_back(of_family(id));
    if (target.forms.back().id != "fresnel-quadratic") continue;
    // The best pair for the cheapest polynomial instead of exp2.
    const StudyFit pair = fit_pair_for_exp2(least_exp2_degree);
    if (pair.status != Status::converged) continue;
    target.forms.back().constants.push_back(
        {"minimax-exp2-" + std::to_string(least_exp2_degree),
         {computed_number("a", pair.parameters[1]), computed_number("b", pair.parameters[0])}});
  }
  return target;
}

Target phases() {
  // Pharr, Humphreys 2010.
  const Constants published{"published", {printed_number("a", "1.55"), printed_number("b", "0.55")}};
  return {"henyey-greenstein",
          "(1 - g^2)/(4 pi (1 + g^2 - 2 g c)^1.5)",
          Arguments::cosine,
          -1,
          1,
          {printed_number("g", "0.76")},
          {{"hg-pow", nothing()}, {"hg-sqrt", nothing()}, {"schlick-phase", {published}}}};
}

Target lights(std::string_view id, std::size_t count, const std::vector<Constants>& offsets) {
  Target target{id,
                "sum of max(n.l, 0)^k over the lights, k = 16",
                Arguments::normal_to_lights,
                0,
                1,
                {exponent()},
                {{"phong-pow", nothing()}, {"phong-squarings", nothing()}, {"phong-sg", telling(offsets)}}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<double, 3> direction = spread_direction(i);
    for (std::size_t axis = 0; axis < 3; ++axis)
      target.parameters.push_back(computed_number(std::array{"x", "y", "z"}[axis], direction[axis]));
  }
  return target;
}

}  // namespace

StudyFit fit_pair_for_exp2(int degree) {
  const Study study{.target = polynomial(degree),
                    .form = std::string("schlick_weight(") + cosine_of_exponent + ")",
                    .over = {{"x", lowest_exponent, "0"}},
                    .definitions = {{"n", {}, "floor(x + 1/2)"}, {"r", {}, "x - n"}},
                    .starts = {{"a", -5}, {"b", -7}}};
  return fit_study({.study = study, .norm = Norm::minimax});
}

std::array<double, 3> spread_direction(std::size_t i) {
  // The first two coordinates of the sequence with the plastic number, whose cube is itself and 1: points
  // that are spread evenly over a square.
  constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
  const auto fraction = [](double x) { return x - static_cast<double>(static_cast<long>(x)); };
  const auto n = static_cast<double>(i + 1);
  const double u = 2 * fraction(n * first) - 1, v = 2 * fraction(n * second) - 1;
  // The square of (u, v), shrunk to lie within the unit disc, then projected onto the hemisphere.
  constexpr double within = 0.7;
  const double p = within * u, q = within * v, square = p * p + q * q;
  return {2 * p / (1 + square), 2 * q / (1 + square), (1 - square) / (1 + square)};
}

std::vector<Target> catalogue() {
  std::vector<Constants> offsets = constants_of("sg-offset");
  // Conventions, not fits: the offsets of the plain form, and of a von Mises-Fisher density.
  offsets.push_back({"plain", {printed_number("x", "0")}});
  offsets.push_back({"one", {printed_number("x", "1")}});
  return {lobe(offsets),
          gloss(),
          schlick(),
          phases(),
          lights("phong-1", 1, offsets),
          lights("phong-4", 4, offsets),
          lights("phong-16", 16, offsets),
          lights("phong-64", 64, offsets)};
}

std::vector<double> parameters_of(const Target& target, const Constants& constants) {
  std::vector<double> all;
  for (const NamedNumber& number : target.parameters) all.push_back(number.value);
  for (const NamedNumber& number : constants.numbers) all.push_back(number.value);
  return all;
}

}  // namespace shadefit::forms
