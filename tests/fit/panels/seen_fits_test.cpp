#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "fit/scalars/multiprecision.hpp"
#include "fit/verdicts/study_objectives.hpp"

/// Fits of targets that do more than their samples show: narrow features, and places where they are 0/0.
namespace shadefit {
namespace {

StudyFit fit_of(const std::string& target, const std::string& form, const std::string& lower,
                const std::string& upper, Norm norm, Error error = Error::absolute) {
  Study study{target, form, {{"x", lower, upper}}};
  study.error = error;
  return fit_study(objective_of(study, norm, {}));
}

struct Case {
  std::string target, form, lower, upper;
  Norm norm;
  Error error;
  double first, second;  ///< of the right answer: its first parameter; its second, or its level
};

/// The answers are those of tests/references/make_seen_fits.py.
TEST(SeenFit, HasTheRightConstants) {
  constexpr auto squares = Norm::least_squares, minimax = Norm::minimax;
  constexpr auto absolute = Error::absolute, relative = Error::relative;
  const std::vector<Case> cases{
      {"acos(x) + 0.1*exp(-((x - 0.3432)/0.003)^2)", "a + b*x", "0", "1", squares, absolute,
       1.6448375033378063, -1.2886115343650693},
      {"exp(-x) + 0.2*exp(-((x - 1.2345)/0.01)^2)", "a*exp(-b*x)", "0", "4", squares, absolute,
       0.99898758576108718, 0.99384365043021964},
      {"max(0, 1 - abs(x - 0.3432)/0.0001)", "a + b*x", "0", "1", squares, absolute, 0.00019408, -0.00018816},
      {"x^-0.3", "a + b*x", "0", "1", squares, absolute, 2.1848739495798319, -1.5126050420168067},
      {"1/(1 + x) + 0.5*exp(-((x - 0.2232)/0.0005)^2)", "a + b*x", "0", "1", minimax, absolute,
       1.2167053719665907, 0.24999889948275166},
      {"log(1 + x)/x", "a + b*x", "0", "1", minimax, absolute, 0.98187246925289001, 0.018127530747109995},
      {"(1 - cos(x))/x^2", "a + b*x", "0", "1", squares, absolute, 0.50667105293790257, -0.04057135340515968},
      {"sin(x)", "x*(a + b*x^2)", "0", "0.125", minimax, relative, 0.99999974549746021,
       2.5450253979441107e-7},
      {"x*log(x)", "x*(a + b*x + d*x^2)", "0", "1", minimax, absolute, -2.5253649045036895,
       0.035236560446716616},
      {"sin(x)/x", "1 + a*x^2 + b*x^4", "0", "pi", minimax, absolute, -0.15997021212684671,
       0.0056279110107072674},
  };
  for (const Case& of : cases) {
    SCOPED_TRACE(of.target);
    const StudyFit fit = fit_of(of.target, of.form, of.lower, of.upper, of.norm, of.error);
    ASSERT_EQ(fit.status, Status::converged) << fit.why;
    // A fit has 14 digits. The level of sin is the difference of numbers near 1.
    const double second = of.norm == minimax ? *fit.level : fit.parameters[1];
    EXPECT_NEAR(fit.parameters[0], of.first, 1e-13 * std::abs(of.first));
    EXPECT_NEAR(second, of.second, 1e-13 * std::max(std::abs(of.second), of.norm == minimax ? 1e-3 : 0.0));
    if (of.norm == minimax && of.error == absolute) {
      EXPECT_NEAR(fit.max_abs_error.magnitude, *fit.level, 1e-9);
    }
  }
}

TEST(SeenFit, SaysWhatItCannotExplain) {
  const StudyFit fit = fit_of("sin(1/x)", "a + b*x", "0", "1", Norm::least_squares);
  EXPECT_EQ(fit.status, Status::unresolved);
  EXPECT_NE(fit.why.find("more happens near x = "), std::string::npos) << fit.why;
}

int random_cases() {
  const char* wanted = std::getenv("SHADEFIT_RANDOM_FITS");
  return wanted == nullptr ? 50 : std::atoi(wanted);
}

using Target = std::function<Decimal50(const Decimal50&)>;

/// Whether polynomial constants are the best ones for a target, told by its values at many places alone.
std::string what_is_wrong(const StudyFit& fit, const Target& target, Norm norm,
                          const std::vector<double>& places) {
  const auto error_at = [&](double x) {
    Decimal50 sum = -target(x), power = 1;
    for (const double parameter : fit.parameters) {
      sum += parameter * power;
      power *= x;
    }
    return static_cast<double>(sum);
  };
  if (norm == Norm::minimax) {
    // De la Vallee Poussin: errors of changing signs at one place more than there are parameters bound the
    // least level from below. Other places bound this one's from above.
    double least = HUGE_VAL, most = 0;
    std::vector<double> alternating;
    for (const AlternationPoint& point : fit.alternation) alternating.push_back(error_at(point.at.cos_theta));
    for (std::size_t i = 0; i < alternating.size(); ++i) {
      if (i > 0 && alternating[i] * alternating[i - 1] > 0) return "the signs do not change";
      least = std::min(least, std::abs(alternating[i]));
    }
    for (const double x : places) most = std::max(most, std::abs(error_at(x)));
    if (alternating.size() <= fit.parameters.size()) return "too few places";
    return most <= least * (1 + 1e-5) + 1e-15 ? "" : "the error is larger: " + std::to_string(most / least);
  }
  // The error is orthogonal to each power: Simpson's rule between neighbouring places.
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    double sum = 0, size = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double left = places[i - 1], right = places[i], middle = (left + right) / 2;
      const auto term = [&](double x) { return error_at(x) * std::pow(x, k); };
      const double part = (right - left) / 6 * (term(left) + 4 * term(middle) + term(right));
      sum += part;
      size += std::abs(part);
    }
    // Simpson's rule on these places is right to 1e-7 of the sum of the magnitudes.
    if (std::abs(sum) > 1e-6 * size + 1e-15)
      return "the error is not orthogonal: " + std::to_string(sum / size);
  }
  return "";
}

struct Feature {
  const char* text;  ///< of (x - place)/width
  std::function<Decimal50(const Decimal50&)> value;
};

const std::vector<Feature>& features() {
  static const std::vector<Feature> result{
      {"exp(-({0})^2)", [](const Decimal50& u) { return Decimal50(exp(-u * u)); }},
      {"1/(1 + ({0})^2)", [](const Decimal50& u) { return Decimal50(1 / (1 + u * u)); }},
      {"max(0, 1 - abs({0}))", [](const Decimal50& u) { return Decimal50(abs(u) < 1 ? 1 - abs(u) : 0); }},
      {"tanh({0})", [](const Decimal50& u) { return Decimal50(tanh(u)); }},
      {"1/(1 + exp({0}))", [](const Decimal50& u) { return Decimal50(1 / (1 + exp(u))); }},
      {"1/cosh({0})", [](const Decimal50& u) { return Decimal50(1 / cosh(u)); }},
  };
  return result;
}

struct Asked {
  std::string text;
  Target target;
  std::vector<double> places;  ///< rising, dense where the target is narrow
};

/// exp(-x) on [0, 1] with a feature that is up to a millionth wide.
Asked with_feature(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const Feature& feature = features()[random() % features().size()];
  const std::string place = fmt::format("{:.6f}", uniform(0.01, 0.99)),
                    width = fmt::format("{:.3e}", std::pow(10, uniform(-6, -2))),
                    height = fmt::format("{:.3f}", uniform(0.02, 1));
  const std::string of = fmt::format("(x - {})/{}", place, width);
  Asked asked{fmt::format("exp(-x) + {}*{}", height, fmt::format(fmt::runtime(feature.text), of)),
              [=](const Decimal50& x) {
                const Decimal50 u = (x - Decimal50(place)) / Decimal50(width);
                return Decimal50(exp(-x) + Decimal50(height) * feature.value(u));
              },
              {0, 1}};
  const double at = std::stod(place), unit = std::stod(width);
  for (double distance = unit / 32, step = distance; distance < 1; distance += step) {
    for (const double x : {at - distance, at + distance})
      if (0 < x && x < 1) asked.places.push_back(x);
    if (distance > 8 * unit) step = distance / 64;
  }
  asked.places.push_back(at);
  std::ranges::sort(asked.places);
  return asked;
}

/// A quotient that is 0/0 at x = 0, over a range that has this place at its end or inside.
Asked with_limit(std::mt19937_64& random) {
  struct Zero {
    const char* text;
    Decimal50 (*value)(const Decimal50&);
    int order;
  };
  static const std::vector<Zero> zeros{
      {"sin(x)", [](const Decimal50& x) { return Decimal50(sin(x)); }, 1},
      {"log(1 + x)", [](const Decimal50& x) { return Decimal50(log(1 + x)); }, 1},
      {"(exp(x) - 1)", [](const Decimal50& x) { return Decimal50(exp(x) - 1); }, 1},
      {"tanh(x)", [](const Decimal50& x) { return Decimal50(tanh(x)); }, 1},
      {"(sqrt(1 + x) - 1)", [](const Decimal50& x) { return Decimal50(sqrt(1 + x) - 1); }, 1},
      {"(1 - cos(x))", [](const Decimal50& x) { return Decimal50(1 - cos(x)); }, 2},
      {"x^2", [](const Decimal50& x) { return Decimal50(x * x); }, 2},
      {"(x - sin(x))", [](const Decimal50& x) { return Decimal50(x - sin(x)); }, 3},
  };
  for (;;) {
    const Zero &above = zeros[random() % zeros.size()], &below = zeros[random() % zeros.size()];
    if (&above == &below || above.order < below.order) continue;
    Asked asked{fmt::format("{}/({})", above.text, below.text),
                [=](const Decimal50& x) {
                  // the limit, to 20 digits
                  const Decimal50 at = x == 0 ? Decimal50("1e-20") : x;
                  return Decimal50(above.value(at) / below.value(at));
                },
                {}};
    const double lower = random() % 2 == 0 ? 0 : -0.5;
    for (int i = 0; i <= 400; ++i) asked.places.push_back(lower + (0.75 - lower) * i / 400);
    return asked;
  }
}

/// Nothing wrong is called converged, and 97 of 100 are answered.
TEST(SeenFit, IsRightForRandomTargets) {
  for (const auto& kind : {with_feature, with_limit}) {
    std::mt19937_64 random(5);
    const int cases = random_cases();
    int answered = 0;
    for (int i = 0; i < cases; ++i) {
      const Asked asked = kind(random);
      const Norm norm = i % 2 == 0 ? Norm::least_squares : Norm::minimax;
      const StudyFit fit = fit_of(asked.text, "a + b*x", fmt::format("{}", asked.places.front()),
                                  fmt::format("{}", asked.places.back()), norm);
      if (fit.status != Status::converged) continue;
      ++answered;
      EXPECT_EQ(what_is_wrong(fit, asked.target, norm, asked.places), "") << asked.text << " " << name(norm);
    }
    EXPECT_GE(answered, cases * 97 / 100);
  }
}

// No place holds the level of a form that is its target. Beside it there is an alternation.
TEST(ExactMinimax, HasTheLevelZero) {
  const auto fit = [](const std::string& target, Error error) {
    Study study{.target = target, .form = "a x^2 + b x + d", .over = {{"x", "1", "2"}}};
    study.error = error;
    return fit_study({.study = study, .norm = Norm::minimax});
  };
  for (const Error error : {Error::absolute, Error::relative}) {
    const StudyFit exact = fit("x^2", error);
    ASSERT_EQ(name(exact.status), "converged") << exact.why;
    EXPECT_EQ(exact.level, 0);
    EXPECT_NEAR(exact.parameters[0], 1, 1e-14);
    const StudyFit near = fit("x^2 + 1e-9*x^3", error);
    ASSERT_EQ(name(near.status), "converged") << near.why;
    EXPECT_GT(*near.level, 1e-12);
    EXPECT_EQ(near.alternation.size(), 4U);
  }
}

}  // namespace
}  // namespace shadefit
