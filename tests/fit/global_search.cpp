#include "tests/fit/global_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace shadefit::search {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
constexpr double golden = std::numbers::phi - 1;

/// Numbers that are the same with every library: the distributions of <random> are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double from, double to) {
    return from + (to - from) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  double powers(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  bool chance(double share) { return uniform(0, 1) < share; }
  double normal() {
    return std::sqrt(-2 * std::log(uniform(1e-300, 1))) * std::cos(2 * std::numbers::pi * uniform(0, 1));
  }

 private:
  std::mt19937_64 engine_;
};

struct Form {
  std::string_view family;
  std::size_t parameters;
  bool is_lobe;
  double (*value)(const std::vector<double>& p, double c, double y, double k);
};

constexpr std::array forms{
    Form{"sg-offset", 1, true,
         [](const std::vector<double>& p, double, double y, double k) { return std::exp(-(k + p[0]) * y); }},
    Form{"sg-scaled", 2, true,
         [](const std::vector<double>& p, double, double y, double k) {
           return p[0] * std::exp(-(k + p[1]) * y);
         }},
    Form{"phong-blinn", 1, true,
         [](const std::vector<double>& p, double, double y, double k) {
           return std::exp(p[0] * k / 2 * std::log1p(-y / 2));
         }},
    Form{"fresnel-one-term", 1, false,
         [](const std::vector<double>& p, double c, double, double) { return std::exp2(-p[0] * c); }},
    Form{"fresnel-quadratic", 2, false,
         [](const std::vector<double>& p, double c, double, double) {
           return std::exp2((p[0] * c + p[1]) * c);
         }},
    Form{"fresnel-cubic", 3, false,
         [](const std::vector<double>& p, double c, double, double) {
           return std::exp2(((p[0] * c + p[1]) * c + p[2]) * c);
         }},
    Form{"fresnel-quartic", 4, false,
         [](const std::vector<double>& p, double c, double, double) {
           return std::exp2((((p[0] * c + p[1]) * c + p[2]) * c + p[3]) * c);
         }},
    Form{"fresnel-fourth", 1, false,
         [](const std::vector<double>& p, double, double y, double) { return p[0] * y * y * y * y; }},
    Form{"fresnel-square", 2, false,
         [](const std::vector<double>& p, double c, double y, double) {
           return y * y * (1 + (p[0] * c + p[1]) * c);
         }},
    Form{"fresnel-rational", 1, false,
         [](const std::vector<double>& p, double c, double y, double) {
           return y * y * y * y / (1 + p[0] * c);
         }},
};

const Form& form_of(std::string_view family) {
  const auto* found =
      std::find_if(forms.begin(), forms.end(), [&](const Form& f) { return f.family == family; });
  if (found == forms.end()) throw std::logic_error("the search has no form " + std::string(family));
  return *found;
}

/// Fresnel's equations with a complex index.
double reflectance(double c, std::complex<double> index) {
  const std::complex<double> cosine = std::sqrt(1.0 - (1 - c) * (1 + c) / (index * index));
  const auto rs = (c - index * cosine) / (c + index * cosine),
             rp = (index * c - cosine) / (index * c + cosine);
  return (std::norm(rs) + std::norm(rp)) / 2;
}

/// Gauss's six places on [-1, 1] and their weights: Abramowitz, Stegun 1964, table 25.4.
constexpr std::array<std::pair<double, double>, 6> gauss{{{-0.932469514203152, 0.171324492379170},
                                                          {-0.661209386466265, 0.360761573048139},
                                                          {-0.238619186083197, 0.467913934572691},
                                                          {0.238619186083197, 0.467913934572691},
                                                          {0.661209386466265, 0.360761573048139},
                                                          {0.932469514203152, 0.171324492379170}}};

/// Angles between which the integrand is smooth: even ones; the widths of a lobe; powers of two towards both
/// ends and towards the critical angle.
std::vector<double> panels_of(const Drawn& drawn) {
  const double first = std::acos(drawn.upper), last = std::acos(drawn.lower), length = last - first;
  std::vector<double> ends{first, last};
  for (int i = 1; i < 16; ++i) ends.push_back(first + length * i / 16);
  for (int j = 5; j <= 12; ++j) {
    ends.push_back(first + std::ldexp(length, -j));
    ends.push_back(last - std::ldexp(length, -j));
  }
  // A relative error of a blunt lobe is steep towards the horizon.
  for (int j = 13; drawn.exponent > 0 && drawn.is_relative && j <= 20; ++j)
    ends.push_back(last - std::ldexp(length, -j));
  if (drawn.exponent > 0) {
    for (const double width : {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0})
      ends.push_back(width / std::sqrt(drawn.exponent));
  }
  if (drawn.is_exact && drawn.extinction == 0 && drawn.ior < 1) {
    const double kink = std::asin(drawn.ior);
    ends.push_back(kink);
    for (int j = 3; j <= 20; ++j) ends.push_back(kink - std::ldexp(1.0, -j));
    for (int j = 3; j <= 6; ++j) ends.push_back(kink + std::ldexp(1.0, -j));
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  ends.erase(std::remove_if(ends.begin(), ends.end(), [&](double e) { return e < first || e > last; }),
             ends.end());
  return ends;
}

/// Nelder and Mead 1965, "A simplex method for function minimization", from a simplex with steps of that
/// share of the start.
template <class Function>
Best descend(const Function& f, const std::vector<double>& start, double share, int evaluations) {
  std::vector<Best> simplex{{start, f(start)}};
  for (std::size_t i = 0; i < start.size(); ++i) {
    auto p = start;
    p[i] += p[i] == 0 ? share : share * p[i];
    simplex.push_back({p, f(p)});
  }
  const std::size_t n = start.size();
  const auto by_objective = [](const Best& a, const Best& b) { return a.objective < b.objective; };
  for (int used = static_cast<int>(n); used < evaluations; ++used) {
    std::sort(simplex.begin(), simplex.end(), by_objective);
    if (simplex.back().objective - simplex.front().objective <= 1e-12 * simplex.front().objective) break;
    std::vector<double> centre(n);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) centre[j] += simplex[i].parameters[j] / static_cast<double>(n);
    }
    const auto moved = [&](double by) {
      std::vector<double> p(n);
      for (std::size_t j = 0; j < n; ++j) p[j] = centre[j] + by * (simplex.back().parameters[j] - centre[j]);
      return Best{p, f(p)};
    };
    const Best reflected = moved(-1);
    if (reflected.objective < simplex.front().objective) {
      const Best expanded = moved(-2);
      ++used;
      simplex.back() = expanded.objective < reflected.objective ? expanded : reflected;
    } else if (reflected.objective < simplex[n - 1].objective) {
      simplex.back() = reflected;
    } else {
      const Best contracted = moved(reflected.objective < simplex.back().objective ? -0.5 : 0.5);
      ++used;
      if (contracted.objective < std::min(reflected.objective, simplex.back().objective)) {
        simplex.back() = contracted;
        continue;
      }
      for (std::size_t i = 1; i <= n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
          simplex[i].parameters[j] = (simplex[i].parameters[j] + simplex[0].parameters[j]) / 2;
        simplex[i].objective = f(simplex[i].parameters);
      }
      used += static_cast<int>(n);
    }
  }
  return *std::min_element(simplex.begin(), simplex.end(), by_objective);
}

/// All scales of a single parameter, rising.
std::vector<double> scan_of(const Problem& problem) {
  const Drawn& drawn = problem.drawn();
  std::vector<double> values;
  if (drawn.family == "fresnel-rational") {
    for (double margin = std::ldexp(1.0, -40); margin < 1e9; margin *= 1.2)
      values.push_back((margin - 1) / drawn.upper);
    return values;
  }
  const double scale = drawn.exponent > 0 ? 1 : 1 / problem.half();
  for (double value = scale * 1e-5; value < scale * 1e4; value *= 1.15) {
    values.push_back(value);
    values.push_back(-value);
  }
  values.push_back(0);
  std::sort(values.begin(), values.end());
  return values;
}

/// By golden sections between the neighbours of each local minimum of a scan.
Best least_of_scan(const Problem& problem) {
  const auto values = scan_of(problem);
  std::vector<double> found;
  for (const double value : values) found.push_back(problem.objective({value}));
  Best best{{values.front()}, found.front()};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(found[i] < 2 * best.objective)) continue;
    const bool is_least =
        (i == 0 || found[i] <= found[i - 1]) && (i + 1 == values.size() || found[i] <= found[i + 1]);
    if (!is_least) continue;
    if (found[i] < best.objective) best = {{values[i]}, found[i]};
    double low = values[i == 0 ? 0 : i - 1], high = values[std::min(i + 1, values.size() - 1)];
    for (int step = 0; step < 60; ++step) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      const double at_left = problem.objective({left}), at_right = problem.objective({right});
      const Best better = at_left < at_right ? Best{{left}, at_left} : Best{{right}, at_right};
      if (better.objective < best.objective) best = better;
      (at_left < at_right ? high : low) = at_left < at_right ? right : left;
    }
  }
  return best;
}

/// A start at a random scale of the family.
std::vector<double> random_start(const Problem& problem, Random& random) {
  const Drawn& drawn = problem.drawn();
  if (drawn.family == "sg-scaled") return {random.powers(0.5, 2), random.normal() * random.powers(0.1, 10)};
  if (drawn.family == "fresnel-square") return {5 * random.normal(), 5 * random.normal()};
  const double scale = random.powers(1, 4 / problem.half()), growth = random.uniform(0, 1);
  const std::size_t n = form_of(drawn.family).parameters;
  std::vector<double> p(n);
  // the first is the coefficient of the highest power
  for (std::size_t i = 0; i < n; ++i)
    p[i] = random.normal() * std::pow(scale, 1 + growth * static_cast<double>(n - 1 - i));
  return p;
}

}  // namespace

Drawn draw(std::string_view family, int number) {
  Drawn drawn{.family = form_of(family).family};
  Random random(0x5eed0000U + static_cast<unsigned>(number) * 16 +
                static_cast<unsigned>(&form_of(family) - forms.data()));
  if (form_of(family).is_lobe) {
    drawn.exponent = random.powers(0.5, 3000);
  } else if (random.chance(0.85)) {
    drawn.is_exact = random.chance(0.8);
    drawn.ior = random.chance(0.4) ? random.uniform(0.3, 0.98) : random.powers(1.02, 5);
    if (drawn.is_exact && random.chance(0.4)) {
      drawn.ior = random.powers(0.05, 5);
      drawn.extinction = random.powers(0.1, 10);
    }
  }
  if (random.chance(0.4)) {
    drawn.lower = random.chance(0.5) ? 0 : random.uniform(0, 0.5);
    drawn.upper = random.chance(0.3) ? 1 : random.uniform(0.6, 1);
  }
  drawn.measure = static_cast<std::size_t>(random.uniform(0, 3));
  drawn.is_minimax = random.chance(0.5);
  drawn.is_relative = random.chance(0.3);
  return drawn;
}

std::string command_of(const Drawn& drawn) {
  std::ostringstream text;
  text.precision(17);
  text << "shadefit fit " << drawn.family;
  if (drawn.exponent > 0) text << " --exponent " << drawn.exponent;
  if (drawn.ior > 0) text << " --target " << (drawn.is_exact ? "exact" : "schlick") << " --ior " << drawn.ior;
  if (drawn.extinction > 0) text << " --extinction " << drawn.extinction;
  if (drawn.lower > 0 || drawn.upper < 1) text << " --domain " << drawn.lower << ":" << drawn.upper;
  if (drawn.is_minimax) text << " --norm minimax";
  if (drawn.is_relative) text << " --error relative";
  if (drawn.measure > 0) text << " --measure " << (drawn.measure == 1 ? "angle" : "cosine-weighted");
  return text.str();
}

Problem::Problem(const Drawn& drawn) : drawn_(drawn) {
  const Form& form = form_of(drawn.family);
  form_ = [&form, k = drawn.exponent](const std::vector<double>& p, double c, double y) {
    return form.value(p, c, y, k);
  };
  if (form.is_lobe) {
    target_ = [k = drawn.exponent](double c, double y) {
      return y < 0.5 ? std::exp(k * std::log1p(-y)) : std::pow(c, k);
    };
    // where a relative error has a meaning
    if (drawn_.is_relative)
      drawn_.lower = std::max(drawn_.lower, std::exp(-std::log(255.0) / drawn.exponent));
  } else {
    const std::complex<double> index(drawn.ior, drawn.extinction);
    f0_ = drawn.ior > 0 ? std::norm((index - 1.0) / (index + 1.0)) : 0.04;
    if (drawn.is_exact) {
      target_ = [index, f0 = f0_](double c, double) { return (reflectance(c, index) - f0) / (1 - f0); };
    } else {
      target_ = [](double, double y) { return std::pow(y, 5); };
    }
    half_ = 1e-6;
    while (half_ < 1 && target_(half_, 1 - half_) > 0.5) half_ *= 1.2;
  }
  const auto ends = panels_of(drawn_);
  if (ends.empty()) return;  // the target is nowhere at least 1/255: a relative error has no meaning
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    nodes_.push_back(node_at(ends[i], 0));
    const double centre = (ends[i] + ends[i + 1]) / 2, radius = (ends[i + 1] - ends[i]) / 2;
    for (const auto& [place, weight] : gauss)
      nodes_.push_back(node_at(centre + radius * place, radius * weight));
  }
  nodes_.push_back(node_at(ends.back(), 0));
}

Problem::Node Problem::node_at(double angle, double share) const {
  const double half_sine = std::sin(angle / 2);
  Node node{
      angle, angle > 1 ? std::sin(right_angle - angle) : std::cos(angle), 2 * half_sine * half_sine, share, 0,
      1};
  if (drawn_.measure != 1) node.share *= std::sin(angle);
  if (drawn_.measure == 2) node.share *= node.cosine;
  node.target = target_(node.cosine, node.distance);
  if (drawn_.exponent > 0) {
    if (drawn_.is_relative) node.scale = 1 / node.target;
  } else {
    if (drawn_.ior > 0 || drawn_.is_relative) node.scale = 1 - f0_;
    if (drawn_.is_relative) node.scale /= f0_ + (1 - f0_) * node.target;
  }
  return node;
}

double Problem::error_at(const Node& node, const std::vector<double>& p) const {
  return node.scale * (form_(p, node.cosine, node.distance) - node.target);
}

double Problem::distance_to_pole(const std::vector<double>& p) const {
  if (drawn_.family != "fresnel-rational") return 1;
  const double low = 1 + p[0] * drawn_.lower, high = 1 + p[0] * drawn_.upper;
  return low * high > 0 ? std::min(std::abs(low), std::abs(high)) : -1;
}

double Problem::objective(const std::vector<double>& p) const {
  if (!(distance_to_pole(p) > 0)) return std::numeric_limits<double>::infinity();
  double square = 0, total = 0, largest = 0;
  for (const Node& node : nodes_) {
    const double error = error_at(node, p);
    square += node.share * error * error;
    total += node.share;
    largest = std::max(largest, std::abs(error));
  }
  const double result = drawn_.is_minimax ? largest : std::sqrt(square / total);
  return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

double Problem::refined_objective(const std::vector<double>& p) const {
  double largest = objective(p);
  if (!drawn_.is_minimax || !std::isfinite(largest)) return largest;
  const auto magnitude = [&](double angle) { return std::abs(error_at(node_at(angle, 0), p)); };
  const double seen = largest;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (std::abs(error_at(nodes_[i], p)) < 0.95 * seen) continue;
    double low = nodes_[i == 0 ? 0 : i - 1].angle, high = nodes_[std::min(i + 1, nodes_.size() - 1)].angle;
    for (int step = 0; step < 50; ++step) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      const double at_left = magnitude(left), at_right = magnitude(right);
      largest = std::max({largest, at_left, at_right});
      (at_left > at_right ? high : low) = at_left > at_right ? right : left;
    }
  }
  return largest;
}

Best least(const Problem& problem, const std::vector<double>& known, int seed) {
  const auto objective = [&](const std::vector<double>& p) { return problem.objective(p); };
  const std::size_t n = form_of(problem.drawn().family).parameters;
  if (n == 1) return least_of_scan(problem);
  const int evaluations = 150 * static_cast<int>(n);
  Random random(static_cast<std::uint64_t>(seed));
  Best best{{}, std::numeric_limits<double>::infinity()};
  const auto consider = [&](const Best& found) {
    if (found.objective < best.objective) best = found;
  };
  if (!known.empty()) consider(descend(objective, known, 0.01, evaluations));
  for (int i = 0; i < 6; ++i) consider(descend(objective, random_start(problem, random), 0.3, evaluations));
  // a simplex that has collapsed begins anew
  if (!best.parameters.empty()) consider(descend(objective, best.parameters, 0.05, evaluations));
  return best;
}

}  // namespace shadefit::search
