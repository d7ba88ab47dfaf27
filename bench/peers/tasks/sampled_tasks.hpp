#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "task_program.hpp"

/// The least-squares tasks as fits to samples, which any library for them can do.
namespace peer_tasks {

inline constexpr int samples = 1001;

/// A fit of a form to weighted samples of its target, from 0 to `end`.
struct SampledFit {
  double end, exponent;
  std::vector<double> start;
  std::function<double(double)> target;
  std::function<double(double)> weight = [](double) { return 1.0; };

  double place(int sample) const { return end * sample / (samples - 1); }
};

/// The forms. T is double or the library's own scalar; `at` is c or the angle.
struct Pair {
  static constexpr int size = 2;
  template <class T>
  static T value(double c, const T* p, double) {
    using std::exp;
    return exp((p[0] * c + p[1]) * c * M_LN2);
  }
};

struct Gaussian {
  static constexpr int size = 1;
  template <class T>
  static T value(double c, const T* p, double k) {
    using std::exp;
    return exp((p[0] + k) * (c - 1));
  }
};

struct Blinn {
  static constexpr int size = 1;
  template <class T>
  static T value(double angle, const T* p, double rho) {
    using std::exp;
    return exp(p[0] * (rho * std::log(std::cos(angle / 2))));
  }
};

inline const std::vector<double> gaussian_exponents{3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
    large_exponents{100, 1e3, 1e4, 1e6}, blinn_exponents{2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048};

/// The offset or factor of one number at each exponent.
inline Answer at_each(const std::vector<double>& exponents, const std::function<double(double)>& fit) {
  Answer answer;
  for (const double exponent : exponents) answer.push_back({"x", fit(exponent), exponent});
  return answer;
}

/// The tasks with a library, whose `fit(form, SampledFit)` returns the parameters.
template <class Fit>
std::vector<Task> sampled_tasks(const std::string& way, const Fit& fit) {
  const auto gaussian = [=](double k) {
    return fit(Gaussian(), SampledFit{1, k, {0.5}, [=](double c) { return std::pow(c, k); }})[0];
  };
  const auto blinn = [=](double rho) {
    const auto target = [=](double angle) { return std::pow(std::max(std::cos(angle), 0.0), rho); };
    return fit(Blinn(),
               SampledFit{M_PI_2, rho, {3}, target, [](double angle) { return std::sin(angle); }})[0];
  };
  const auto pair = [=]() -> Answer {
    const auto p = fit(Pair(), SampledFit{1, 0, {-5, -5}, [](double c) { return std::pow(1 - c, 5); }});
    return {{"a", p[0]}, {"b", p[1]}};
  };
  return {{"T1", way, pair},
          {"T2", way, [=] { return at_each(gaussian_exponents, gaussian); }},
          {"T2-large", way, [=] { return at_each(large_exponents, gaussian); }},
          {"T3", way, [=] { return at_each(blinn_exponents, blinn); }}};
}

}  // namespace peer_tasks
