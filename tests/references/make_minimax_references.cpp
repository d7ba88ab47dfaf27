// The reference values of minimax fits, by a method that shares nothing with the toolkit.
//
// shadefit searches for extrema, solves linear programmes and polishes with the places held. Here the places
// are unknowns too: Newton on the whole stationary system
//   weight * error = +- level at every point of the alternation (0 or a bound at those of a constraint),
//   its derivative by c = 0 at those inside the domain,
// in 60 digits, with derivatives by truncated Taylor arithmetic of second order. Each problem starts from a
// few digits, and its answer is printed to 40 only if the alternation has the signs it was started with and
// no error at 4000 places exceeds the level.
//
//   make_minimax_references            prints minimax.csv
//   make_minimax_references --check F  compares F with what it computes; exit 1 where a digit differs
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "print_or_check.hpp"

namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

// A value with its first and second derivatives by up to five variables: the parameters, then c.
constexpr std::size_t most = 5;
struct Taylor {
  Real v = 0;
  std::array<Real, most> d{};
  std::array<std::array<Real, most>, most> dd{};
  Taylor(const Real& value = 0) : v(value) {}
};

// f(x) from f, f', f'' at x.v
Taylor chain(const Taylor& x, const Real& f, const Real& f1, const Real& f2) {
  Taylor r(f);
  for (std::size_t i = 0; i < most; ++i) {
    r.d[i] = f1 * x.d[i];
    for (std::size_t j = 0; j < most; ++j) r.dd[i][j] = f1 * x.dd[i][j] + f2 * x.d[i] * x.d[j];
  }
  return r;
}
Taylor operator+(const Taylor& x, const Taylor& y) {
  Taylor r(x.v + y.v);
  for (std::size_t i = 0; i < most; ++i) {
    r.d[i] = x.d[i] + y.d[i];
    for (std::size_t j = 0; j < most; ++j) r.dd[i][j] = x.dd[i][j] + y.dd[i][j];
  }
  return r;
}
Taylor operator*(const Taylor& x, const Taylor& y) {
  Taylor r(x.v * y.v);
  for (std::size_t i = 0; i < most; ++i) {
    r.d[i] = x.v * y.d[i] + y.v * x.d[i];
    for (std::size_t j = 0; j < most; ++j)
      r.dd[i][j] = x.v * y.dd[i][j] + y.v * x.dd[i][j] + x.d[i] * y.d[j] + x.d[j] * y.d[i];
  }
  return r;
}
Taylor operator-(const Taylor& x, const Taylor& y) {
  return x + Taylor(-1) * y;
}
Taylor inverse(const Taylor& x) {
  const Real f = 1 / x.v;
  return chain(x, f, -f * f, 2 * f * f * f);
}
Taylor exponential(const Taylor& x) {
  const Real f = exp(x.v);
  return chain(x, f, f, f);
}
// c^k; at c = 0, where only the value is asked for, 0
Taylor real_power(const Taylor& c, const Real& k) {
  if (c.v == 0) return Taylor(0);
  return chain(c, pow(c.v, k), k * pow(c.v, k - 1), k * (k - 1) * pow(c.v, k - 2));
}
Taylor whole_power(const Taylor& x, int n) {
  Taylor r(1);
  for (int i = 0; i < n; ++i) r = r * x;
  return r;
}

using Parameters = std::vector<Taylor>;
using Function = std::function<Taylor(const Taylor& c, const Parameters& p)>;

// At the end of which condition a point stands, and whether it is looked for: an end of the domain is not.
struct Point {
  const char* c;
  int sign;  // of the error; 0: at the constraint
  bool is_end = false;
};

struct Problem {
  std::string constant, exponent, error, extra;
  std::vector<std::string> names;
  std::vector<const char*> start;  // parameters, then the level
  Function weighted_error;
  std::vector<Point> points;
  Function constraint;  // zero at the points of sign 0
  Real from = 0, to = 1;
};

// Solves matrix * x = right by elimination with partial pivoting.
std::vector<Real> solve(std::vector<std::vector<Real>> matrix, std::vector<Real> right) {
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(matrix[i][k]) > abs(matrix[pivot][k])) pivot = i;
    }
    std::swap(matrix[k], matrix[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < n; ++j) matrix[i][j] -= factor * matrix[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right[k] -= matrix[k][j] * right[j];
    right[k] /= matrix[k][k];
  }
  return right;
}

Taylor at(const Function& f, const std::vector<Real>& p, const Real& c) {
  Parameters q;
  for (std::size_t i = 0; i < p.size(); ++i) {
    q.emplace_back(p[i]);
    q.back().d[i] = 1;
  }
  Taylor place(c);
  place.d[p.size()] = 1;
  return f(place, q);
}

// The parameters and the level.
std::vector<Real> stationary(const Problem& problem) {
  const std::size_t n = problem.names.size();
  std::vector<Real> p, places;
  for (std::size_t i = 0; i < n; ++i) p.emplace_back(problem.start[i]);
  Real level(problem.start[n]);
  for (const Point& point : problem.points)
    places.push_back(!point.is_end                    ? Real(point.c)
                     : std::string(point.c) == "from" ? problem.from
                                                      : problem.to);
  Real size = 1;
  for (int step = 0; step < 60 && size > Real("1e-50"); ++step) {
    std::vector<std::vector<Real>> matrix;
    std::vector<Real> right;
    std::vector<std::size_t> column(problem.points.size());
    std::size_t unknowns = n + 1;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!problem.points[i].is_end) column[i] = unknowns++;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Point& point = problem.points[i];
      const Taylor e = at(point.sign == 0 ? problem.constraint : problem.weighted_error, p, places[i]);
      std::vector<Real> row(unknowns), slope_row(unknowns);
      for (std::size_t j = 0; j < n; ++j) {
        row[j] = e.d[j];
        slope_row[j] = e.dd[n][j];
      }
      row[n] = -point.sign;
      if (!point.is_end) {
        row[column[i]] = e.d[n];
        slope_row[column[i]] = e.dd[n][n];
      }
      matrix.push_back(row);
      right.push_back(point.sign * level - e.v);
      if (point.is_end) continue;
      matrix.push_back(slope_row);
      right.push_back(-e.d[n]);
    }
    const auto x = solve(matrix, right);
    size = 0;
    for (const Real& change : x) size = std::max(size, Real(abs(change)));
    for (std::size_t j = 0; j < n; ++j) p[j] += x[j];
    level += x[n];
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!problem.points[i].is_end) places[i] += x[column[i]];
    }
  }
  const auto fail = [&](const char* what) {
    throw std::logic_error(problem.constant + " " + problem.exponent + " " + problem.error + " " +
                           problem.extra + ": " + what);
  };
  if (!(size <= Real("1e-50"))) fail("Newton did not settle");
  if (!(level > 0)) fail("the level is not positive");
  for (int i = 0; i <= 4000; ++i) {
    const Real c = problem.from + (problem.to - problem.from) * i / 4000;
    if (abs(at(problem.weighted_error, p, c).v) > level * (1 + Real("1e-12"))) fail("the level is exceeded");
  }
  p.push_back(level);
  return p;
}

// The forms, written out once more.
Function exp2_of_polynomial() {
  return [](const Taylor& c, const Parameters& p) {
    Taylor exponent(0);
    for (const Taylor& coefficient : p) exponent = (exponent + coefficient) * c;
    return exponential(exponent * Taylor(boost::math::constants::ln_two<Real>()));
  };
}
Taylor schlick(const Taylor& c) {
  return whole_power(Taylor(1) - c, 5);
}
Function minus_schlick(const Function& form) {
  return [form](const Taylor& c, const Parameters& p) { return form(c, p) - schlick(c); };
}
// (Fhat - F)/F, F = 0.04 + 0.96 (1-c)^5
Function relative_to_reflectance(const Function& form) {
  return [form](const Taylor& c, const Parameters& p) {
    const Taylor rest(Real("0.96"));
    return rest * (form(c, p) - schlick(c)) * inverse(Taylor(Real("0.04")) + rest * schlick(c));
  };
}
Function scaled_gaussian(const char* exponent, bool has_scale) {
  return [k = Real(exponent), has_scale](const Taylor& c, const Parameters& p) {
    const Taylor lobe = exponential((Taylor(k) + p.back()) * (c - Taylor(1)));
    return has_scale ? p.front() * lobe : lobe;
  };
}
// cos^(x k)(theta/2) = ((1 + c)/2)^(x k/2)
Function half_angle(const char* exponent) {
  return [k = Real(exponent)](const Taylor& c, const Parameters& p) {
    const Taylor half = (Taylor(1) + c) * Taylor(Real(1) / 2);
    const Taylor logarithm = chain(half, log(half.v), 1 / half.v, -1 / (half.v * half.v));
    return exponential(p.front() * Taylor(k / 2) * logarithm);
  };
}
Function minus_lobe(const Function& form, const char* exponent) {
  return [form, k = Real(exponent)](const Taylor& c, const Parameters& p) {
    return form(c, p) - real_power(c, k);
  };
}
Function relative_to_lobe(const Function& form, const char* exponent) {
  return [form, k = Real(exponent)](const Taylor& c, const Parameters& p) {
    return form(c, p) * inverse(real_power(c, k)) - Taylor(1);
  };
}

Function one_term() {
  return [](const Taylor& c, const Parameters& p) {
    return exponential(Taylor(-boost::math::constants::ln_two<Real>()) * p.front() * c);
  };
}
Function quadratic_with_b(const char* b) {
  return [b = Real(b)](const Taylor& c, const Parameters& p) {
    return exponential((p.front() * c + Taylor(b)) * c * Taylor(boost::math::constants::ln_two<Real>()));
  };
}
Function fourth() {
  return [](const Taylor& c, const Parameters& p) { return p.front() * whole_power(Taylor(1) - c, 4); };
}
Function square() {
  return [](const Taylor& c, const Parameters& p) {
    return whole_power(Taylor(1) - c, 2) * (Taylor(1) + p[1] * c + p[0] * c * c);
  };
}
Function rational() {
  return [](const Taylor& c, const Parameters& p) {
    return whole_power(Taylor(1) - c, 4) * inverse(Taylor(1) + p.front() * c);
  };
}
Function minus(const Function& form, const char* bound) {
  return [=](const Taylor& c, const Parameters& p) { return form(c, p) - Taylor(Real(bound)); };
}
// (1 + 4 c) times the error
Function weighted(const Function& error) {
  return [=](const Taylor& c, const Parameters& p) { return (Taylor(1) + Taylor(4) * c) * error(c, p); };
}
// c^k = 1/255
Real visible_end(const char* k) {
  return exp(-log(Real(255)) / Real(k));
}

// A lobe by the form of a family; a relative error counts where the lobe is visible.
Problem lobe_problem(const std::string& family, const char* exponent, const std::string& error,
                     const std::vector<const char*>& start, const std::vector<Point>& points) {
  const bool has_scale = family == "sg-scaled";
  const Function form = family == "phong-blinn" ? half_angle(exponent) : scaled_gaussian(exponent, has_scale);
  const auto parameters = has_scale ? std::vector<std::string>{"A", "x"} : std::vector<std::string>{"x"};
  if (error == "absolute")
    return {family, exponent, error, "", parameters, start, minus_lobe(form, exponent), points, {}};
  return {family,
          exponent,
          error,
          "",
          parameters,
          start,
          relative_to_lobe(form, exponent),
          points,
          {},
          visible_end(exponent)};
}

// Schlick's weight by a form; a relative error is of the reflectance.
Problem fresnel_problem(const std::string& family, const std::string& error,
                        const std::vector<std::string>& parameters, const std::vector<const char*>& start,
                        const Function& form, const std::vector<Point>& points) {
  return {family,
          "",
          error,
          "",
          parameters,
          start,
          error == "absolute" ? minus_schlick(form) : relative_to_reflectance(form),
          points,
          {}};
}

// The starts are a few digits of the answers, to say which optimum is meant; Newton does the rest.
std::vector<Problem> problems() {
  return {
      lobe_problem("sg-offset", "1", "absolute", {"0.94238", "0.1434"}, {{"0.6582", -1}, {"from", 1, true}}),
      lobe_problem("sg-offset", "1", "relative", {"3.9175", "0.9022"}, {{"0.20335", -1}, {"from", 1, true}}),
      lobe_problem("phong-blinn", "1", "absolute", {"6.3816", "0.1095"},
                   {{"0.61595", -1}, {"from", 1, true}}),
      lobe_problem("phong-blinn", "1", "relative", {"14.261", "0.8715"},
                   {{"0.16312", -1}, {"from", 1, true}}),
      lobe_problem("sg-scaled", "1", "absolute", {"1.1279", "1.1766", "0.1279"},
                   {{"to", 1, true}, {"0.58736", -1}, {"from", 1, true}}),
      lobe_problem("sg-offset", "5", "absolute", {"0.71724", "0.02628"}, {{"0.91246", -1}, {"0.5228", 1}}),
      lobe_problem("sg-offset", "5", "relative", {"2.742", "0.4264"}, {{"0.64583", -1}, {"from", 1, true}}),
      lobe_problem("phong-blinn", "5", "absolute", {"4.299", "0.01437"}, {{"0.90928", -1}, {"0.5304", 1}}),
      lobe_problem("phong-blinn", "5", "relative", {"5.1851", "0.2894"},
                   {{"0.62792", -1}, {"from", 1, true}}),
      lobe_problem("sg-scaled", "5", "absolute", {"1.0228", "0.88102", "0.02282"},
                   {{"to", 1, true}, {"0.88704", -1}, {"0.50824", 1}}),
      lobe_problem("sg-scaled", "5", "relative", {"1.3605", "3.2722", "0.3605"},
                   {{"to", 1, true}, {"0.60443", -1}, {"from", 1, true}}),
      lobe_problem("sg-offset", "37.5", "absolute", {"0.66965", "0.003371"},
                   {{"0.98774", -1}, {"0.92545", 1}}),
      lobe_problem("sg-offset", "37.5", "relative", {"2.356", "0.06858"},
                   {{"0.94089", -1}, {"from", 1, true}}),
      lobe_problem("phong-blinn", "37.5", "absolute", {"4.0359", "0.001706"},
                   {{"0.98768", -1}, {"0.92566", 1}}),
      lobe_problem("phong-blinn", "37.5", "relative", {"4.1269", "0.0359"},
                   {{"0.94036", -1}, {"from", 1, true}}),
      lobe_problem("sg-scaled", "37.5", "absolute", {"1.0029", "0.81905", "0.002912"},
                   {{"to", 1, true}, {"0.98389", -1}, {"0.92184", 1}}),
      lobe_problem("sg-offset", "1000", "absolute", {"0.663", "0.0001257"},
                   {{"0.99954", -1}, {"0.99714", 1}}),
      lobe_problem("sg-offset", "1000", "relative", {"2.2975", "0.002632"},
                   {{"0.99771", -1}, {"from", 1, true}}),
      lobe_problem("phong-blinn", "1000", "absolute", {"4.0013", "6.288e-05"},
                   {{"0.99954", -1}, {"0.99714", 1}}),
      lobe_problem("sg-scaled", "1000", "absolute", {"1.0001", "0.81036", "0.0001085"},
                   {{"to", 1, true}, {"0.99939", -1}, {"0.99699", 1}}),
      fresnel_problem("fresnel-one-term", "absolute", {"A"}, {"8.2482", "0.02628"}, one_term(),
                      {{"0.4772", 1}, {"0.087544", -1}}),
      fresnel_problem("fresnel-one-term", "relative", {"A"}, {"9.5842", "0.1721"}, one_term(),
                      {{"0.64862", 1}, {"0.22353", -1}}),
      fresnel_problem("fresnel-quadratic", "absolute", {"a", "b"}, {"-5.5513", "-6.9961", "0.003402"},
                      exp2_of_polynomial(), {{"0.59329", 1}, {"0.2547", -1}, {"0.052617", 1}}),
      fresnel_problem("fresnel-quadratic", "relative", {"a", "b"}, {"-7.2996", "-6.4501", "0.02807"},
                      exp2_of_polynomial(), {{"0.69333", 1}, {"0.41004", -1}, {"0.11586", 1}}),
      fresnel_problem("fresnel-cubic", "absolute", {"a", "b", "d"},
                      {"-5.6404", "-2.6626", "-7.2762", "0.0006815"}, exp2_of_polynomial(),
                      {{"0.68076", 1}, {"0.39277", -1}, {"0.17725", 1}, {"0.036654", -1}}),
      fresnel_problem("fresnel-cubic", "relative", {"a", "b", "d"},
                      {"-8.2424", "-0.93371", "-7.5154", "0.006521"}, exp2_of_polynomial(),
                      {{"0.74481", 1}, {"0.51671", -1}, {"0.29396", 1}, {"0.072625", -1}}),
      fresnel_problem("fresnel-quartic", "absolute", {"a", "b", "d", "g"},
                      {"-7.1014", "0.42581", "-4.0871", "-7.1916", "0.0001771"}, exp2_of_polynomial(),
                      {{"0.74416", 1}, {"0.50054", -1}, {"0.29596", 1}, {"0.1329", -1}, {"0.027343", 1}}),
      fresnel_problem("fresnel-quartic", "relative", {"a", "b", "d", "g"},
                      {"-11.263", "4.7819", "-5.4088", "-7.0825", "0.001899"}, exp2_of_polynomial(),
                      {{"0.78766", 1}, {"0.59228", -1}, {"0.41126", 1}, {"0.21659", -1}, {"0.049547", 1}}),
      fresnel_problem("fresnel-fourth", "absolute", {"s"}, {"0.93991", "0.06009"}, fourth(),
                      {{"0.24807", 1}, {"from", -1, true}}),
      fresnel_problem("fresnel-fourth", "relative", {"s"}, {"0.76414", "0.2264"}, fourth(),
                      {{"0.50155", 1}, {"from", -1, true}}),
      fresnel_problem("fresnel-square", "absolute", {"a", "b"}, {"2.214", "-2.8767", "0.004532"}, square(),
                      {{"0.76109", 1}, {"0.38316", -1}, {"0.084536", 1}}),
      fresnel_problem("fresnel-square", "relative", {"a", "b"}, {"1.9073", "-2.7206", "0.03541"}, square(),
                      {{"0.82037", 1}, {"0.55292", -1}, {"0.2221", 1}}),
      fresnel_problem("fresnel-rational", "absolute", {"a"}, {"1.2616", "0.008377"}, rational(),
                      {{"0.40431", 1}, {"0.076276", -1}}),
      fresnel_problem("fresnel-rational", "relative", {"a"}, {"1.6407", "0.05263"}, rational(),
                      {{"0.57282", 1}, {"0.18261", -1}}),
      {"fresnel-quadratic",
       "",
       "absolute",
       "weight 1 + 4 c",
       {"a", "b"},
       {"-6.1088", "-6.8551", "0.008512"},
       weighted(minus_schlick(exp2_of_polynomial())),
       {{"0.6465", 1}, {"0.30823", -1}, {"0.073717", 1}},
       {}},
      {"fresnel-quadratic",
       "",
       "absolute",
       "form >= target",
       {"a", "b"},
       {"-5.3132", "-6.9723", "0.004551"},
       minus_schlick(exp2_of_polynomial()),
       {{"0.55384", 1}, {"0.25481", 0}, {"0.066143", 1}},
       minus_schlick(exp2_of_polynomial())},
      {"fresnel-quartic",
       "",
       "absolute",
       "form >= target",
       {"a", "b", "d", "g"},
       {"-6.5414", "0.12895", "-4.0521", "-7.1884", "0.00025154"},
       minus_schlick(exp2_of_polynomial()),
       {{"0.7133", 1}, {"0.49075", 0}, {"0.29475", 1}, {"0.13745", 0}, {"0.03535", 1}},
       minus_schlick(exp2_of_polynomial())},
      {"fresnel-quadratic",
       "",
       "absolute",
       "form >= 0.001",
       {"a", "b"},
       {"-2.2111", "-7.7547", "0.01521"},
       minus_schlick(exp2_of_polynomial()),
       {{"to", 0, true}, {"0.48244", 1}, {"0.094883", -1}},
       minus(exp2_of_polynomial(), "0.001")},
      {"fresnel-quadratic",
       "",
       "absolute",
       "b = -7",
       {"a"},
       {"-5.5383", "0.003425"},
       minus_schlick(quadratic_with_b("-7")),
       {{"0.5927", 1}, {"0.25348", -1}},
       {}},
      {"sg-scaled",
       "5",
       "absolute",
       "form <= 1",
       {"A", "x"},
       {"1", "0.71724", "0.02628"},
       minus_lobe(scaled_gaussian("5", true), "5"),
       {{"to", 0, true}, {"0.91246", -1}, {"0.5228", 1}},
       minus(scaled_gaussian("5", true), "1")},
      {"fresnel-square",
       "",
       "absolute",
       "form >= target",
       {"a", "b"},
       {"2.2361", "-2.8541", "0.006452"},
       minus_schlick(square()),
       {{"0.72361", 1}, {"0.38197", 0}, {"0.10557", 1}},
       minus_schlick(square())},
  };
}

void write_references(std::ostream& out) {
  out.precision(40);
  out << "constant,parameter,exponent,error,extra,value\n";
  for (const Problem& problem : problems()) {
    const auto answer = stationary(problem);
    for (std::size_t i = 0; i < answer.size(); ++i) {
      out << problem.constant << ',' << (i < problem.names.size() ? problem.names[i] : "level") << ','
          << problem.exponent << ',' << problem.error << ',' << problem.extra << ',' << answer[i] << '\n';
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shadefit::references::print_or_check(argc, argv, write_references);
}
