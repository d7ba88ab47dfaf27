#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "fit/least_squares/first_parameters.hpp"
#include "fit/minimax/minimax.hpp"
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

/// A family (fit/solve/under.hpp) under a norm of minimax, sampled at the search places. It must not move
/// while its `problem()` is in use.
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
      : family_(family), metric_(metric) {
    metric_.domain = {bottom.cos_theta, top.cos_theta};
    const Shape shape = family.shape().with_square_roots();
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
    for (const SearchPlace& place : places_) samples_.push_back(family_.sample(cosine(place.panel, place.s)));
  }

  /// From least squares under the same error: Ceres from one start, polished on few nodes.
  MinimaxOptimum solve() const {
    const auto basin = sampled_for_basin(family_, metric_, family_.shape());
    const auto start = descend_first<static_cast<int>(N)>(descent_problem(basin, family_, metric_.domain),
                                                          family_.starts(), family_.free_count());
    MinimaxParameters p{};
    // At the border of the admissible parameters the error has a pole, and no step leads back from there.
    const auto from = start.status == Status::at_border ? family_.starts()[0] : start.parameters;
    std::copy(from.begin(), from.end(), p.begin());
    MinimaxOptimum optimum = solve_minimax(problem(), p);
    optimum.iterations += start.iterations;
    return optimum;
  }

  MinimaxProblem problem() const {
    const auto error = [](const F& f, const auto& sample, const auto& p) { return f.error(sample, p); };
    const auto bounded = [](const F& f, const auto& sample, const auto& p) {
      if constexpr (is_exponential) {
        return f.log_form(sample, p);
      } else {
        return f.form(sample, p);
      }
    };
    const auto deviation = [](const F& f, const auto& sample, const auto& p) {
      if constexpr (is_exponential) {
        return f.log_ratio(sample, p);
      } else {
        return f.error(sample, p);
      }
    };
    MinimaxProblem result{.size = family_.free_count(),
                          .places = places_,
                          .cosine_at = [this](const SearchPlace& at) { return cosine(at.panel, at.s); },
                          .error = curve(error),
                          .bounded = curve(bounded),
                          .deviation = curve(deviation),
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
  template <class T>
  Cosine<T> cosine(std::size_t panel, const T& s) const {
    return panels_[panel].at(s).cosine;
  }

  template <class P, class Values>
  static std::array<P, N> lifted(const Values& values) {
    std::array<P, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = lift<P>(values[i]);
    return p;
  }

  template <class Function>
  MinimaxCurve curve(Function f) const {
    return {[this, f](const MinimaxParameters& p, std::span<double> values) {
              const auto q = lifted<double>(p);
              for (std::size_t i = 0; i < samples_.size(); ++i) values[i] = f(family_, samples_[i], q);
            },
            [this, f](const SearchPlace& place, const MinimaxParameters& p) {
              using First = ceres::Jet<double, 1>;
              using Second = ceres::Jet<First, 1>;
              Second s(First(place.s, 0));
              s.v[0] = First(1.0);
              const Second value = f(family_, family_.sample(cosine(place.panel, s)), lifted<Second>(p));
              return Along{value.a.a, value.a.v[0], value.v[0].v[0]};
            },
            [this, f](const SearchPlace& place, const MinimaxParameters& p, Unknowns& gradient) {
              using Jet = ceres::Jet<double, static_cast<int>(N)>;
              std::array<Jet, N> q;
              for (std::size_t i = 0; i < N; ++i) q[i] = Jet(p[i], static_cast<int>(i));
              const Jet value = f(family_, family_.sample(cosine(place.panel, place.s)), q);
              for (std::size_t i = 0; i < N; ++i) gradient[i] = value.v[static_cast<int>(i)];
              return value.a;
            },
            [this, f](const SearchPlace& place, const WideParameters& p) {
              const auto s = static_cast<long double>(place.s);
              return f(family_, family_.sample(cosine(place.panel, s)), lifted<long double>(p));
            },
            [this, f](const SearchPlace& place, const MinimaxParameters& p, Unknowns& gradient) {
              using Inner = ceres::Jet<double, static_cast<int>(N)>;
              std::array<Inner, N> q;
              for (std::size_t i = 0; i < N; ++i) q[i] = Inner(p[i], static_cast<int>(i));
              const Inner slope = slope_inward<Inner>(f, place, q);
              for (std::size_t i = 0; i < N; ++i) gradient[i] = slope.v[static_cast<int>(i)];
              return slope.a;
            },
            [this, f](const SearchPlace& place, const WideParameters& p) {
              return slope_inward<long double>(f, place, lifted<long double>(p));
            }};
  }

  /// The derivative by the distance from the end of a panel.
  template <class T, class Function>
  T slope_inward(Function f, const SearchPlace& place, const std::array<T, N>& p) const {
    using Jet = ceres::Jet<T, 1>;
    Jet s(lift<T>(place.s));
    s.v[0] = T(place.s == 0 ? 1.0 : -1.0);
    std::array<Jet, N> q;
    for (std::size_t i = 0; i < N; ++i) q[i] = Jet(p[i]);
    return f(family_, family_.sample(cosine(place.panel, s)), q).v[0];
  }

  F family_;
  Metric metric_;
  std::vector<Substitution> panels_;
  std::vector<SearchPlace> places_;
  std::vector<typename F::template Sample<double>> samples_;
};

}  // namespace shadefit
