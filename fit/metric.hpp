#pragma once

#include <array>
#include <charconv>
#include <compare>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

/// The metric is the result: a constant is only right under a measure, a norm, an error and a domain. One
/// object of this file is shared by solver, report and test.
namespace shadefit {

/// How the domain is weighted. All are given for c = cos(theta).
enum class Measure {
  cosine,           ///< dc: uniform in the cosine, that is in solid angle
  angle,            ///< d theta = dc / sqrt(1 - c^2): uniform in the angle
  cosine_weighted,  ///< c dc: uniform in projected solid angle
};

enum class Norm { least_squares };

enum class Error { absolute };

/// The range of c that counts, 0 <= lower < upper <= 1.
struct Domain {
  double lower = 0;
  double upper = 1;
  auto operator<=>(const Domain&) const = default;
};

/// "0.25:1", each end to its shortest round trip.
inline std::string to_text(const Domain& domain) {
  char text[64];
  const auto lower = std::to_chars(std::begin(text), std::end(text), domain.lower);
  *lower.ptr = ':';
  const auto upper = std::to_chars(lower.ptr + 1, std::end(text), domain.upper);
  return {text, upper.ptr};
}

struct Metric {
  Measure measure = Measure::cosine;
  Norm norm = Norm::least_squares;
  Error error = Error::absolute;
  Domain domain = {};
  auto operator<=>(const Metric&) const = default;
};

/// The measures in the order in which a published value is tried under them.
inline constexpr std::array measures{Measure::cosine, Measure::angle, Measure::cosine_weighted};

/// A measure near the peak: y^(p-1) (1 + w y + ..) dy for y = 1 - c.
struct PeakExpansion {
  double p;
  double w;
};

/// dc = dy; d theta = dy / sqrt(2y - y^2) = (2y)^(-1/2) (1 + y/4 + ..) dy, up to a factor; c dc = (1 - y) dy.
constexpr PeakExpansion peak_expansion(Measure measure) {
  switch (measure) {
    case Measure::cosine:
      return {1, 0};
    case Measure::angle:
      return {0.5, 0.25};
    case Measure::cosine_weighted:
      return {1, -1};
  }
  throw std::logic_error("a measure without an expansion");
}

constexpr std::string_view name(Measure measure) {
  switch (measure) {
    case Measure::cosine:
      return "cosine";
    case Measure::angle:
      return "angle";
    case Measure::cosine_weighted:
      return "cosine-weighted";
  }
  throw std::logic_error("a measure without a name");
}

constexpr std::string_view name(Norm norm) {
  switch (norm) {
    case Norm::least_squares:
      return "least-squares";
  }
  throw std::logic_error("a norm without a name");
}

constexpr std::string_view name(Error error) {
  switch (error) {
    case Error::absolute:
      return "absolute";
  }
  throw std::logic_error("an error without a name");
}

/// A metric as a reader names it: its measure, and the domain where that is not all of [0, 1].
inline std::string describe(const Metric& metric) {
  const std::string measure(name(metric.measure));
  return metric.domain == Domain{} ? measure : measure + " on " + to_text(metric.domain);
}

}  // namespace shadefit
