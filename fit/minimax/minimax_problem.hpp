#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "fit/least_squares/descent.hpp"
#include "fit/least_squares/error_scale.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/minimax/minimax.hpp"
#include "fit/minimax/minimax_curve.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"

/// A family's minimax problem, sampled where the exchange looks.
namespace shadefit {

/// The search places of a panel: the 41 extrema of Chebyshev's polynomial of degree 40, ends included. They
/// are enough: the error of a form with four parameters has five to seven extrema.
inline const std::array<double, 41>& chebyshev_places() {
  static const std::array<double, 41> places = [] {
    std::array<double, 41> s{};
    for (std::size_t i = 0; i < s.size(); ++i) {
      const double sine = std::sin(std::numbers::pi * static_cast<double>(i) / 80);
      s[i] = sine * sine;
    }
    return s;
  }();
  return places;
}

/// A family under a norm of minimax, sampled at the search places. It must not move while its `problem()` is
/// in use.
template <class F>
class Minimax {
 public:
  static constexpr std::size_t N = F::parameters.size();
  static_assert(N <= most_parameters);
  static constexpr bool is_exponential =
      requires(const F& f, const typename F::template Sample<double>& s, const std::array<double, N>& p) {
    f.log_form(s, p);
    f.log_ratio(s, p);
  };
  static constexpr bool is_linear = [] {
    if constexpr (requires { F::is_linear; }) return F::is_linear;
    return false;
  }();

  /// `top` and `bottom` are the ends of the places that count.
  Minimax(const F& family, const Metric& metric, const Cosine<double>& top, const Cosine<double>& bottom)
      : family_(family), metric_(metric), given_(given_parameters(F::parameters, metric.constraints)) {
    metric_.domain = {bottom.cos_theta, top.cos_theta};
    scale_ = ErrorScale(metric_);
    const Shape shape = shape_under(scale_, family.shape()).with_square_roots();
    panels_ = shape.concentration > 0 || shape.end_power > 0
                  ? Substitution::panels({.domain = metric_.domain}, shape)
                  : Substitution::between(top, bottom, shape);
    for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
      for (const double s : chebyshev_places()) places_.push_back({panel, s});
    }
    // A lobe that was cut off because it is nearly zero counts to the end of the domain.
    if (panels_.back().at(1.0).cosine.cos_theta > bottom.cos_theta + 1e-15) {
      panels_.push_back(Substitution::between(bottom, bottom).front());
      places_.push_back({panels_.size() - 1, 1.0});
    }
    samples_.reserve(places_.size());
    for (const SearchPlace& place : places_) samples_.push_back(sample(place.panel, place.s));
  }

  /// From the free parameters of a start; those of the result are all of the family.
  MinimaxOptimum solve(const Candidate& start) const {
    MinimaxParameters p{};
    std::ranges::copy(start.parameters, p.begin());
    MinimaxOptimum optimum = solve_minimax(problem(), p);
    optimum.iterations += start.iterations;
    const auto all = lifted<double>(optimum.parameters);
    std::ranges::copy(all, optimum.parameters.begin());
    return optimum;
  }

  MinimaxProblem problem() const {
    MinimaxProblem result{.size = free_count(given_),
                          .places = places_,
                          .cosine_at = [this](const SearchPlace& at) { return cosine(at.panel, at.s); },
                          .error = curve(Kind::error),
                          .bounded = curve(Kind::bounded),
                          .deviation = curve(Kind::deviation),
                          .is_exponential = is_exponential,
                          .is_linear = is_linear,
                          .one_sided = metric_.constraints.one_sided,
                          .at_most = metric_.constraints.at_most,
                          .at_least = metric_.constraints.at_least,
                          .is_admissible =
                              [this](const MinimaxParameters& p) {
                                return shadefit::is_admissible(family_, metric_.domain, lifted<double>(p));
                              }};
    if (is_exponential && result.at_least && *result.at_least <= 0)
      result.at_least.reset();  // always satisfied
    for (const double c : metric_.constraints.exact_at)
      result.exact_at.push_back(c == metric_.domain.upper ? places_.front() : places_.back());
    return result;
  }

 private:
  /// The curves of a `MinimaxProblem`.
  enum class Kind { error, bounded, deviation };

  template <class T>
  Cosine<T> cosine(std::size_t panel, const T& s) const {
    return panels_[panel].at(s).cosine;
  }

  template <class T>
  ScaledSample<F, T> sample(std::size_t panel, const T& s) const {
    return sample_under(scale_, family_, cosine(panel, s));
  }

  /// All parameters of the family, from the free ones.
  template <class P, class Values>
  std::array<P, N> lifted(const Values& free) const {
    std::array<P, N> p;
    std::size_t next = 0;
    for (std::size_t i = 0; i < N; ++i) p[i] = given_[i] ? lift<P>(*given_[i]) : lift<P>(free[next++]);
    return p;
  }
  /// As Jets that carry the derivatives by the free ones.
  auto seeded(const MinimaxParameters& free) const {
    auto p = lifted<ceres::Jet<double, static_cast<int>(N)>>(free);
    int next = 0;
    for (std::size_t i = 0; i < N; ++i) {
      if (!given_[i]) p[i].v[next++] = 1;
    }
    return p;
  }

  template <class T, class P>
  P value(Kind kind, const ScaledSample<F, T>& s, const std::array<P, N>& p) const {
    if constexpr (is_exponential) {
      if (kind == Kind::bounded) return family_.log_form(s.inner, p);
      if (kind == Kind::deviation) return family_.log_ratio(s.inner, p);
    } else {
      if (kind == Kind::bounded) return family_.form(s.inner, p);
    }
    return error_under(scale_, family_, s, p);
  }

  MinimaxCurve curve(Kind kind) const {
    const auto at = [this, kind]<class T, class P>(std::size_t panel, const T& s,
                                                   const std::array<P, N>& free) {
      return this->value(kind, sample(panel, s), lifted<P>(free));
    };
    MinimaxCurve result = curve_of_error<N>(at, places_);
    result.everywhere = [this, kind](const MinimaxParameters& p, std::span<double> values) {
      const auto q = lifted<double>(p);
      for (std::size_t i = 0; i < samples_.size(); ++i) values[i] = value(kind, samples_[i], q);
    };
    result.slope_across = [this, kind](const SearchPlace& place, const MinimaxParameters& p,
                                       Unknowns& gradient) {
      const auto slope = slope_inward(kind, place, seeded(p));
      for (std::size_t i = 0; i < N; ++i) gradient[i] = slope.v[static_cast<int>(i)];
      return slope.a;
    };
    result.wide_slope = [this, kind](const SearchPlace& place, const WideParameters& p) {
      return slope_inward(kind, place, lifted<long double>(p));
    };
    return result;
  }

  /// The derivative by the distance from the end of a panel.
  template <class T>
  T slope_inward(Kind kind, const SearchPlace& place, const std::array<T, N>& p) const {
    using Jet = ceres::Jet<T, 1>;
    Jet s(lift<T>(place.s));
    s.v[0] = T(place.s == 0 ? 1.0 : -1.0);
    std::array<Jet, N> q;
    for (std::size_t i = 0; i < N; ++i) q[i] = Jet(p[i]);
    return value(kind, sample(place.panel, s), q).v[0];
  }

  F family_;
  Metric metric_;
  GivenParameters given_;
  ErrorScale scale_ = {};
  std::vector<Substitution> panels_;
  std::vector<SearchPlace> places_;
  std::vector<ScaledSample<F, double>> samples_;
};

}  // namespace shadefit
