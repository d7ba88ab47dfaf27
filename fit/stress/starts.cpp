#include "fit/stress/starts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

#include "fit/family_visit.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/newton.hpp"
#include "fit/solve/solve.hpp"
#include "fit/stress/newton_in_50_digits.hpp"
#include "fit/stress/numbers.hpp"

namespace shadefit {
namespace {

/// Exponents from blunt to extremely sharp lobes. Exponent 15 and all other forms are also fitted on a
/// thousandth of the domain.
constexpr std::array lobe_exponents{1e-3, 0.1, 1.0, 3.7, 15.0, 1e3, 1e6, 1e9};
/// Relative: a hundred times the error of 14 digits, and far below the distance of two optima.
constexpr double same_answer = 1e-12;
constexpr std::array narrow{Domain{0.999, 1}, Domain{0.4995, 0.5005}, Domain{0, 1e-3}};

struct Case {
  Setting setting;
  Domain domain;
};

template <class F>
std::vector<Case> cases() {
  std::vector<Case> all;
  if constexpr (requires(F f) { f.exponent; }) {
    for (const double k : lobe_exponents) all.push_back({Setting(k), {}});
    for (const Domain& domain : narrow) all.push_back({Setting(15), domain});
  } else {
    all.push_back({Setting(0), {}});
    for (const Domain& domain : narrow) all.push_back({Setting(0), domain});
  }
  return all;
}

/// Three places in a box around the family's own starts, four times as wide as theirs.
Starts starts_in_box(const Starts& own, Sequence& sequence) {
  Starts starts;
  for (auto& start : starts) {
    start.resize(own[0].size());
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      const auto [low, high] = std::minmax({own[0][i], own[1][i], own[2][i]});
      const double middle = (low + high) / 2, reach = 2 * (high - low);
      start[i] = sequence.between(middle - reach, middle + reach);
    }
  }
  return starts;
}

/// The largest relative distance of two answers, measured in the second.
double distance(const std::vector<double>& one, const std::vector<double>& other) {
  return relative_size<double>(vector_of(one) - vector_of(other), vector_of(other));
}

/// The digits of an answer, by a Newton step with gradient and Hessian in 50 digits. The Hessian is made of
/// central differences of the gradient.
template <class F>
int digits_of(const F& family, const Metric& metric, const std::vector<double>& answer) {
  constexpr std::size_t n = F::parameters.size();
  std::array<Decimal50, n> p;
  std::ranges::copy(answer, p.begin());
  const auto gradient = gradient_in_50_digits(family, metric.domain, p);
  ParameterMatrix<double> hessian(n, n);
  ParameterVector<double> g(n);
  for (std::size_t i = 0; i < n; ++i) {
    // This leaves 20 of the gradient's 30 digits.
    const Decimal50 step = Decimal50("1e-10") * p[i];
    auto above = p, below = p;
    above[i] += step;
    below[i] -= step;
    const auto up = gradient_in_50_digits(family, metric.domain, above);
    const auto down = gradient_in_50_digits(family, metric.domain, below);
    g[static_cast<Eigen::Index>(i)] = gradient[i].template convert_to<double>();
    for (std::size_t j = 0; j < n; ++j)
      hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          Decimal50((up[j] - down[j]) / (2 * step)).template convert_to<double>();
  }
  const ParameterVector<double> step = newton_step(g, hessian);
  return step.allFinite() ? correct_digits(relative_size(step, vector_of(answer))) : 0;
}

template <class F>
StartsTrial try_case(const Case& at, std::size_t fits, std::uint64_t seed, const Checkpoint& checkpoint) {
  const F family = make_family<F>(at.setting);
  const Metric metric{.domain = at.domain};
  const Solution own = solve_by_squares(family, metric);
  StartsTrial trial{.family = F::info.id, .domain = at.domain, .status = own.status};
  if constexpr (requires { family.exponent; }) trial.exponent = family.exponent;
  // If the family's own starts do not lead to one optimum, the first fit that converges defines it.
  Solution reference = own;
  const auto measure = [&] {
    trial.claimed = reference.digits;
    trial.digits = digits_of(family, metric, reference.parameters);
  };
  if (own.status == Status::converged) measure();
  Sequence sequence(seed);
  for (std::size_t i = 0; i < fits; ++i) {
    if (i % 64 == 0) checkpoint();
    const auto starts = starts_in_box(starts_of_family(family), sequence);
    const Solution found = solve_by_squares(family, metric, starts);
    trial.starts += std::ssize(starts);
    ++trial.fits;
    if (found.status != Status::converged) {
      ++trial.failed;
      continue;
    }
    if (reference.status != Status::converged) {
      reference = found;
      measure();
    }
    if (std::ranges::find(starts, vector_of(found.parameters)) != starts.end()) ++trial.returned;
    const bool is_there = distance(found.parameters, reference.parameters) <= same_answer;
    ++(is_there ? trial.reached : trial.elsewhere);
  }
  return trial;
}

template <class F>
void try_family(std::vector<StartsTrial>& trials, std::size_t starts, const Checkpoint& checkpoint) {
  const auto all = cases<F>();
  for (const Case& at : all)
    trials.push_back(
        try_case<F>(at, (starts + 3 * all.size() - 1) / (3 * all.size()), trials.size(), checkpoint));
}

}  // namespace

std::vector<StartsTrial> try_starts(std::size_t starts, const Checkpoint& checkpoint,
                                    const std::function<void(double share)>& progress) {
  std::vector<StartsTrial> trials;
  double done = 0;
  [&]<class... F>(std::type_identity<std::tuple<F...>>) {
    ((progress(done++ / sizeof...(F)), try_family<F>(trials, starts, checkpoint)), ...);
  }(std::type_identity<Families>{});
  return trials;
}

}  // namespace shadefit
