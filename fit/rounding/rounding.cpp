#include "fit/rounding/rounding.hpp"

#include <array>
#include <cmath>

#include "approx/encoding.hpp"
#include "fit/families/admissible.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/proof/running_error.hpp"
#include "fit/rounding/rounding_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The cosines at which the error is defined.
template <class F>
Domain domain_of(const F& family, const Domain& domain, Error kind) {
  if (kind == Error::absolute) return domain;
  const auto end = family.relative_end();
  if (!end || end->cos_theta >= domain.upper)
    throw UserError("a relative error has no meaning on this domain: the target vanishes there");
  return {std::max(domain.lower, end->cos_theta), domain.upper};
}

/// Each parameter rounded to the lattice separately.
template <std::size_t N, class Lattice>
LatticePoint<N> rounded_point(const Lattice& lattice, const FittableFamily& family,
                              const NumberFormat& format, const std::vector<double>& parameters) {
  LatticePoint<N> point;
  for (std::size_t i = 0; i < N; ++i) {
    point[i] = lattice.nearest(parameters[i]);
    if (std::abs(point[i]) > lattice.last())
      throw UserError(std::string(family.info.id) + ": " + std::string(family.parameters[i]) + " = " +
                      decimal(parameters[i], 6) + " overflows " + to_text(format) + ": the largest is " +
                      largest_text(lattice));
  }
  return point;
}

/// Refuses a weight and constraints: the search supports only the plain largest error.
void require_no_more(const Metric& metric, const NumberFormat& format) {
  const auto refuse = [&](bool is_there, const char* option) {
    if (is_there) throw UserError("--round '" + to_text(format) + "' does not apply with " + option);
  };
  refuse(!metric.weight.empty(), "--weight: the largest error is searched without one");
  refuse(!metric.constraints.exact_at.empty(), "--exact-at: rounding would break it");
  refuse(metric.constraints.one_sided.has_value(), "--one-sided: rounding would break it");
  refuse(metric.constraints.at_most.has_value(), "--at-most: rounding would break it");
  refuse(metric.constraints.at_least.has_value(), "--at-least: rounding would break it");
}

/// The exponent is a constant of the form and must be a number of the format.
template <class Format>
void require_exponent(const FittableFamily& family, double exponent, const NumberFormat& format) {
  if (!family.has_exponent()) return;
  const double rounded = static_cast<double>(NarrowResult<Format>::rounded(exponent));
  if (rounded == exponent) return;
  throw UserError("exponent " + to_text(exponent) + " is not a number of " + to_text(format) +
                  (std::isfinite(rounded) ? ": the nearest is " + to_text(rounded)
                                          : ": the largest is " + to_text(largest_of<Format>)));
}

template <std::size_t N, class Lattice>
RoundedConstants constants_at(const Lattice& lattice, const LatticePoint<N>& point) {
  RoundedConstants constants;
  for (const std::int64_t index : point) {
    constants.parameters.push_back(lattice.value(index));
    constants.texts.push_back(shortest(lattice, index));
  }
  return constants;
}

/// The displayed value of a weight: with a surface, its reflectance.
template <class F>
double shown(const F& family, double weight) {
  if constexpr (requires { family.surface; }) {
    if (family.surface.is_named())
      return schlick_reflectance(normal_reflectance<double>(family.surface), weight);
  }
  return weight;
}

/// The errors of constants of a narrow format.
template <class F, class Format>
RoundedConstants assessed(const NarrowProblem<F, Format>& problem, const F& family,
                          const LatticePoint<F::parameters.size()>& point) {
  RoundedConstants constants = constants_at(problem.lattice(), point);
  const auto p = parameter_array<F>(constants.parameters);
  const auto worst = problem.worst_of(p);
  constants.max_error = worst.error;
  constants.at = worst.input.cos_theta;
  double codes = 0;
  for (const auto& input : problem.inputs()) {
    const double form = shown(family, problem.form_at(input.cos_theta, p));
    codes = std::max(codes, std::abs(srgb_code(form) - srgb_code(shown(family, input.target))));
  }
  constants.srgb_codes = codes;
  constants.gpu_bound = problem.gpu_bound(p);
  return constants;
}

/// A bound of scale * |computed - real| of a form over a domain.
template <class F>
double rounding_bound(const F& family, Error kind, const Domain& domain,
                      const std::array<double, F::parameters.size()>& parameters, const Rounding& rounding) {
  const auto error = [&](const Cosine<Interval>& c) {
    std::array<RunningError, F::parameters.size()> p;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = RunningError{Interval(parameters[i]), 0, &rounding};
    const RunningError exponent{Interval(exponent_of(family)), 0, &rounding};
    const auto form = F::form_of(RunningError::operand(c.cos_theta, rounding), exponent, p);
    const Interval scale = measured_at(family, kind, c).scale;
    return largest_magnitude_in(Interval(form.error) * scale);
  };
  return bound_of_rounding(error, domain);
}

/// Bounds of the errors of constants of a wide format; infinite where the form has a pole with them.
template <class F, class Lattice>
RoundedConstants assessed(const RealProblem<F, Lattice>& problem, const F& family,
                          const LatticePoint<F::parameters.size()>& point, const Setting& setting,
                          const Domain& domain, Error kind, bool is_float, const Checkpoint& checkpoint) {
  RoundedConstants constants = constants_at(problem.lattice(), point);
  const auto p = parameter_array<F>(constants.parameters);
  if constexpr (HasDenominator<F>) {
    if (!is_admissible(family, domain, p)) {
      constants.max_error = HUGE_VAL;
      constants.at = pole_in(family, domain, p).cos_theta;
      return constants;
    }
  }
  Subject subject{.family = std::string(F::info.id), .setting = setting, .error = kind, .domain = domain};
  for (std::size_t i = 0; i < p.size(); ++i)
    subject.parameters.emplace_back(std::string(F::parameters[i]), hex_text(p[i]));
  const Certificate certificate = certify(subject, usual_width, checkpoint).certificate;
  constants.real_error = certificate.upper;
  constants.at = cosine_at(certificate.attained.side, certificate.attained.distance).cos_theta;
  const auto with = [&](const Rounding& rounding) {
    return rounding_bound(family, kind, domain, p, rounding);
  };
  constants.rounding_error = with(is_float ? float_rounding : double_rounding);
  const auto sum = [&](double rounding) {
    return std::nextafter(certificate.upper + rounding, std::numeric_limits<double>::infinity());
  };
  constants.max_error = sum(*constants.rounding_error);
  if (is_float) constants.gpu_bound = sum(with(gpu_float_rounding));
  return constants;
}

/// The parts of the answer that all kinds of problems compute in the same way.
template <class F, class Problem, class Assess>
void round_with(const Fit& fit, Problem& problem, const std::vector<double>& published, long limit,
                const Checkpoint& checkpoint, const Assess& assess, Rounded& rounded) {
  constexpr std::size_t N = F::parameters.size();
  const FittableFamily& family = *find_family(F::info.id);
  const auto point = [&](const std::vector<double>& p) {
    return rounded_point<N>(problem.lattice(), family, rounded.format, p);
  };
  std::vector<LatticePoint<N>> starts{point(fit.parameters)};
  GivenPlaces<N> given{};
  for (const Held& held : fit.metric.constraints.held) given[parameter_index(family, held.parameter)] = true;
  const bool is_free = std::ranges::find(given, true) == given.end();
  if (!published.empty() && is_free) starts.push_back(point(published));
  const auto [best, is_proven, searched, boxes, evaluated] =
      search_format(lattice_problem<N>(problem), problem.lattice().last(), starts, given, rounded.format,
                    limit, checkpoint);
  rounded.is_proven = is_proven;
  rounded.searched = searched;
  rounded.boxes = boxes;
  rounded.evaluated = evaluated;
  if (!is_free) rounded.searched += ", for the parameters that are not given";
  rounded.naive = assess(starts.front());
  if (!published.empty()) rounded.published = assess(point(published));
  rounded.best = assess(best);
}

}  // namespace

Rounded round_fit(const Fit& fit, const NumberFormat& format, const std::vector<double>& published,
                  const Checkpoint& checkpoint, long limit) {
  require_no_more(fit.metric, format);
  const Error error = fit.metric.error;
  return visit_family(fit.family->id, [&]<class F>(std::type_identity<F>) {
    const Setting setting = setting_of(fit);
    const F family = make_family<F>(setting);
    const FittableFamily& info = *find_family(F::info.id);
    const Domain domain = domain_of(family, fit.metric.domain, error);
    Rounded rounded{.format = format, .error = error};
    const auto narrow = [&]<class Format>(std::type_identity<Format>) {
      require_exponent<Format>(info, setting.exponent, format);
      NarrowProblem<F, Format> problem(family, error, domain);
      if (problem.inputs().empty())
        throw UserError("--domain '" + to_text(domain) + "' holds no number of " + to_text(format));
      round_with<F>(
          fit, problem, published, limit, checkpoint,
          [&](const auto& point) { return assessed(problem, family, point); }, rounded);
    };
    const auto wide = [&](const auto& lattice) {
      const bool is_float = format.kind == NumberFormat::Kind::single;
      RealProblem problem(family, setting, error, domain, lattice);
      round_with<F>(
          fit, problem, published, limit, checkpoint,
          [&](const auto& point) {
            return assessed(problem, family, point, setting, domain, error, is_float, checkpoint);
          },
          rounded);
    };
    switch (format.kind) {
      case NumberFormat::Kind::half:
        narrow(std::type_identity<HalfFormat>{});
        break;
      case NumberFormat::Kind::bfloat16:
        narrow(std::type_identity<Bfloat16Format>{});
        break;
      case NumberFormat::Kind::single:
        require_exponent<FloatFormat>(info, setting.exponent, format);
        wide(BinaryLattice<FloatFormat>{});
        break;
      case NumberFormat::Kind::decimal:
        wide(DecimalLattice{format.digits});
        break;
    }
    return rounded;
  });
}

}  // namespace shadefit
