#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fit/families/admissible.hpp"
#include "fit/family_visit.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/rounding/lattice_search.hpp"
#include "fit/rounding/rounding.hpp"
#include "fit/scalars/rounded_interval.hpp"

/// The problems that `search_lattice` solves: the constants of a lattice with the smallest largest error of a
/// form.
namespace shadefit {

/// An error is scale |form - target|.
template <class T>
struct Measured {
  T target;
  T scale;
};

/// The error of a family at a cosine: see its `error` and `relative_error`.
template <class F, class T>
Measured<T> measured_at(const F& family, Error kind, const Cosine<T>& c) {
  const T one = integer<T>(1);
  if constexpr (requires { family.exponent; }) {
    const T target = F::target_of(c.cos_theta, lift<T>(family.exponent));
    return {target, kind == Error::relative ? T(one / target) : one};
  } else {
    const T target = family.sample(c).target;
    const T f0 = normal_reflectance<T>(family.surface);
    if (kind == Error::relative) return {target, T((one - f0) / schlick_reflectance(f0, target))};
    return {target, family.surface.is_named() ? T(one - f0) : one};
  }
}

/// The exponent of a lobe; for other families an arbitrary number that no formula uses.
template <class F>
double exponent_of(const F& family) {
  if constexpr (requires { family.exponent; }) {
    return family.exponent;
  } else {
    return 0;
  }
}

/// A form evaluated in another arithmetic; the given doubles are numbers of that arithmetic.
template <class T, class F, std::size_t N>
T form_in(const F& family, double cos_theta, const std::array<T, N>& p) {
  return F::form_of(T(cos_theta), T(exponent_of(family)), p);
}

/// A place at which constants are compared with the target.
struct Trial {
  double cos_theta;
  double target_lower, target_upper;
  double scale;
};

/// The trials that rule out constants, the recently successful ones first.
class Trials {
 public:
  bool has(double cos_theta) const {
    return std::ranges::any_of(trials_, [&](const Trial& t) { return t.cos_theta == cos_theta; });
  }
  void add(const Trial& trial) {
    if (!has(trial.cos_theta)) trials_.insert(trials_.begin(), trial);
  }
  /// The largest of the least errors of forms that lie in `enclosure(cos_theta)`; stops from `best` up.
  template <class Enclosure>
  double least_error(const Enclosure& enclosure, double best) {
    double least = 0;
    for (std::size_t i = 0; i < trials_.size(); ++i) {
      const auto form = enclosure(trials_[i].cos_theta);
      const double off =
          std::max({0.0, form.lower() - trials_[i].target_upper, trials_[i].target_lower - form.upper()});
      least = std::max(least, trials_[i].scale * off);
      if (least >= best) {
        std::swap(trials_[i], trials_[i / 2]);
        break;
      }
    }
    return least;
  }

 private:
  std::vector<Trial> trials_;
};

/// The first trials of a search: this many places, evenly spaced in the cosine, and the ends.
inline constexpr int first_trials = 16;

/// The parameters of a box of a lattice as intervals.
template <class Arithmetic, class Lattice, std::size_t N>
std::array<RoundedInterval<Arithmetic>, N> intervals_of(const Lattice& lattice, const LatticeBox<N>& box) {
  std::array<RoundedInterval<Arithmetic>, N> p;
  for (std::size_t i = 0; i < N; ++i)
    p[i] = RoundedInterval<Arithmetic>(lattice.value(box.lower[i]), lattice.value(box.upper[i]));
  return p;
}

/// A narrow format: the error is the largest over every number of the format in the domain, each operation
/// rounded.
template <class F, class Format>
class NarrowProblem {
 public:
  static constexpr std::size_t N = F::parameters.size();

  /// A number of the format in the domain.
  struct Input {
    double cos_theta, target, scale;
  };
  struct Worst {
    double error = 0;
    Input input{};
  };

  NarrowProblem(const F& family, Error kind, const Domain& domain) : family_(family) {
    auto index = lattice_.nearest(domain.lower);
    if (lattice_.value(index) < domain.lower) ++index;
    for (; lattice_.value(index) <= domain.upper; ++index) {
      const double c = lattice_.value(index);
      const auto [target, scale] = measured_at(family, kind, Cosine<double>{c, 1 - c});
      inputs_.push_back({c, target, scale});
    }
    for (int i = 0; i <= first_trials && !inputs_.empty(); ++i) {
      const double c = domain.lower + (domain.upper - domain.lower) * i / first_trials;
      const auto near = std::lower_bound(inputs_.begin(), inputs_.end(), c,
                                         [](const Input& input, double x) { return input.cos_theta < x; });
      add_trial(near == inputs_.end() ? inputs_.back() : *near);
    }
  }

  const BinaryLattice<Format>& lattice() const { return lattice_; }
  const std::vector<Input>& inputs() const { return inputs_; }

  double bound(const LatticeBox<N>& box, double best) {
    using T = RoundedInterval<CorrectArithmetic<Format>>;
    const auto p = intervals_of<CorrectArithmetic<Format>>(lattice_, box);
    const T k(exponent_of(family_));
    return trials_.least_error([&](double c) { return F::form_of(T(c), k, p); }, best);
  }

  double error(const LatticePoint<N>& point, double) {
    std::array<double, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = lattice_.value(point[i]);
    const Worst worst = worst_of(p);
    add_trial(worst.input);
    return worst.error;
  }

  /// The largest error of constants of the format; infinite if a result is NaN.
  Worst worst_of(const std::array<double, N>& parameters) const {
    Worst worst{-1, {}};
    for (const Input& input : inputs_) {
      const double off = std::abs(form_at(input.cos_theta, parameters) - input.target) * input.scale;
      const double error = std::isnan(off) ? unbounded : off;
      if (error > worst.error) worst = {error, input};
    }
    return worst;
  }

  double form_at(double cos_theta, const std::array<double, N>& parameters) const {
    using T = NarrowResult<Format>;
    std::array<T, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = T(parameters[i]);
    return static_cast<double>(form_in(family_, cos_theta, p));
  }

  /// A bound of the error on a GPU: see `usual_gpu`.
  double gpu_bound(const std::array<double, N>& parameters) const {
    using T = RoundedInterval<GpuArithmetic<Format>>;
    std::array<T, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = T(parameters[i]);
    double bound = 0;
    for (const Input& input : inputs_) {
      const T form = form_in(family_, input.cos_theta, p);
      const double off =
          std::max(std::abs(form.lower() - input.target), std::abs(form.upper() - input.target));
      bound = std::max(bound, input.scale * off);
    }
    return bound;
  }

 private:
  void add_trial(const Input& input) {
    trials_.add({input.cos_theta, input.target, input.target, input.scale});
  }

  F family_;
  BinaryLattice<Format> lattice_;
  std::vector<Input> inputs_;
  Trials trials_;
};

/// A wide format: the error is that of the real form, whose maximum is sampled and refined. Ruling out
/// constants is rigorous nevertheless: it uses enclosures of the real form at places where the form is too
/// far from the target.
template <class F, class Lattice>
class RealProblem {
 public:
  static constexpr std::size_t N = F::parameters.size();

  RealProblem(const F& family, const Setting& setting, Error kind, const Domain& domain, Lattice lattice)
      : family_(family), setting_(setting), kind_(kind), domain_(domain), lattice_(lattice) {
    for (int i = 0; i <= first_trials; ++i)
      add_trial(domain.lower + (domain.upper - domain.lower) * i / first_trials);
  }

  const Lattice& lattice() const { return lattice_; }

  double bound(const LatticeBox<N>& box, double best) {
    using T = RoundedInterval<OutwardArithmetic>;
    const auto p = intervals_of<OutwardArithmetic>(lattice_, box);
    if constexpr (HasDenominator<F>) {
      // Each inadmissible set of constants has its pole at a different place, so a trial could not rule out
      // many.
      for (const double end : {domain_.lower, domain_.upper}) {
        if (family_.denominator(T(end), p).upper() <= 0) return unbounded;
      }
    }
    const T k(exponent_of(family_));
    return trials_.least_error([&](double c) { return F::form_of(T(c), k, p); }, best);
  }

  double error(const LatticePoint<N>& point, double) {
    std::array<double, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = lattice_.value(point[i]);
    const FittableFamily& family = *find_family(F::info.id);
    const Extremum worst = kind_ == Error::relative
                               ? family.max_rel_error(setting_, domain_, p).value_or(Extremum{})
                               : family.max_abs_error(setting_, domain_, p);
    if (std::isnan(worst.magnitude)) return unbounded;
    add_trial(worst.at.cos_theta);
    return worst.magnitude;
  }

 private:
  void add_trial(double c) {
    if (trials_.has(c)) return;
    const Interval cosine(c);
    const auto [target, scale] = measured_at(family_, kind_, Cosine<Interval>{cosine, Interval(1) - cosine});
    const double lower = lower_end(target), upper = upper_end(target), least = lower_end(scale);
    if (!std::isfinite(lower) || !std::isfinite(upper) || !std::isfinite(least)) return;
    trials_.add({c, lower, upper, least});
  }

  F family_;
  Setting setting_;
  Error kind_;
  Domain domain_;
  Lattice lattice_;
  Trials trials_;
};

}  // namespace shadefit
