#include "fit/formula/shader_calls.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "approx/scalar.hpp"
#include "fit/scalars/functions.hpp"

namespace shadefit {
namespace {

using Arguments = std::span<const Symbolic>;

Symbolic whole(int n) {
  return integer<Symbolic>(n);
}

Symbolic clamped(const Symbolic& x, const Symbolic& low, const Symbolic& high) {
  return min(max(x, low), high);
}

/// A magnitude with the sign of x. `sign` would do, but C and CUDA have none.
Symbolic with_sign_of(const Symbolic& x, const Symbolic& magnitude) {
  return select(less(x, whole(0)), -magnitude, magnitude);
}

Symbolic truncated(const Symbolic& x) {
  return with_sign_of(x, floor(abs(x)));
}

/// log(x + sqrt(x^2 + 1)), with 1 taken from the argument of the logarithm, which is near 1 for a small x.
Symbolic area_sine(const Symbolic& x) {
  const Symbolic a = abs(x), square = a * a;
  return with_sign_of(x, log1p(a + square / (whole(1) + sqrt(square + whole(1)))));
}

struct Composed {
  std::string_view name;
  std::size_t arguments;
  Symbolic (*expression)(Arguments);
};

constexpr std::array composed_functions{
    Composed{"log10", 1, [](Arguments x) { return log(x[0]) / log(whole(10)); }},
    Composed{"radians", 1, [](Arguments x) { return x[0] * pi<Symbolic>() / whole(180); }},
    Composed{"degrees", 1, [](Arguments x) { return x[0] * whole(180) / pi<Symbolic>(); }},
    Composed{"asinh", 1, [](Arguments x) { return area_sine(x[0]); }},
    Composed{"acosh", 1, [](Arguments x) { return log(x[0] + sqrt((x[0] - whole(1)) * (x[0] + whole(1)))); }},
    Composed{"atanh", 1, [](Arguments x) { return log1p(whole(2) * x[0] / (whole(1) - x[0])) / whole(2); }},
    Composed{"cbrt", 1,
             [](Arguments x) { return with_sign_of(x[0], power(abs(x[0]), whole(1) / whole(3))); }},
    Composed{"hypot", 2, [](Arguments x) { return sqrt(x[0] * x[0] + x[1] * x[1]); }},
    Composed{"rsqrt", 1, [](Arguments x) { return whole(1) / sqrt(x[0]); }},
    Composed{"inversesqrt", 1, [](Arguments x) { return whole(1) / sqrt(x[0]); }},
    Composed{"rcp", 1, [](Arguments x) { return whole(1) / x[0]; }},
    Composed{"ceil", 1, [](Arguments x) { return -floor(-x[0]); }},
    Composed{"trunc", 1, [](Arguments x) { return truncated(x[0]); }},
    Composed{"round", 1,
             [](Arguments x) { return with_sign_of(x[0], floor(abs(x[0]) + constant<Symbolic>("0.5"))); }},
    Composed{"fract", 1, [](Arguments x) { return x[0] - floor(x[0]); }},
    Composed{"frac", 1, [](Arguments x) { return x[0] - floor(x[0]); }},
    Composed{"saturate", 1, [](Arguments x) { return clamped(x[0], whole(0), whole(1)); }},
    Composed{"fabs", 1, [](Arguments x) { return abs(x[0]); }},
    Composed{"float", 1, [](Arguments x) { return x[0]; }},
    Composed{"half", 1, [](Arguments x) { return x[0]; }},
    Composed{"double", 1, [](Arguments x) { return x[0]; }},
    Composed{"pow", 2, [](Arguments x) { return raised(x[0], x[1]); }},
    Composed{"atan", 2, [](Arguments x) { return atan2(x[0], x[1]); }},
    Composed{"fmin", 2, [](Arguments x) { return min(x[0], x[1]); }},
    Composed{"fmax", 2, [](Arguments x) { return max(x[0], x[1]); }},
    Composed{"step", 2, [](Arguments x) { return select(less(x[1], x[0]), whole(0), whole(1)); }},
    Composed{"mod", 2, [](Arguments x) { return x[0] - x[1] * floor(x[0] / x[1]); }},
    Composed{"fmod", 2, [](Arguments x) { return x[0] - x[1] * truncated(x[0] / x[1]); }},
    Composed{"clamp", 3, [](Arguments x) { return clamped(x[0], x[1], x[2]); }},
    Composed{"mix", 3, [](Arguments x) { return x[0] * (whole(1) - x[2]) + x[1] * x[2]; }},
    Composed{"lerp", 3, [](Arguments x) { return x[0] + x[2] * (x[1] - x[0]); }},
    Composed{"fma", 3, [](Arguments x) { return x[0] * x[1] + x[2]; }},
    Composed{"mad", 3, [](Arguments x) { return x[0] * x[1] + x[2]; }},
    Composed{"smoothstep", 3,
             [](Arguments x) {
               const Symbolic t = clamped((x[2] - x[0]) / (x[1] - x[0]), whole(0), whole(1));
               return t * t * (whole(3) - whole(2) * t);
             }},
};

struct NamedConstant {
  std::string_view name;
  Symbolic (*value)();
};

constexpr std::array named_constants{
    NamedConstant{"pi", [] { return pi<Symbolic>(); }},
    NamedConstant{"ln2", [] { return ln2<Symbolic>(); }},
    NamedConstant{"PI", [] { return pi<Symbolic>(); }},
    NamedConstant{"M_PI", [] { return pi<Symbolic>(); }},
    NamedConstant{"M_PI_2", [] { return pi<Symbolic>() / whole(2); }},
    NamedConstant{"M_PI_4", [] { return pi<Symbolic>() / whole(4); }},
    NamedConstant{"M_1_PI", [] { return whole(1) / pi<Symbolic>(); }},
    NamedConstant{"M_2_PI", [] { return whole(2) / pi<Symbolic>(); }},
    NamedConstant{"M_2_SQRTPI", [] { return whole(2) / sqrt(pi<Symbolic>()); }},
    NamedConstant{"M_SQRT2", [] { return sqrt(whole(2)); }},
    NamedConstant{"M_SQRT1_2", [] { return sqrt(constant<Symbolic>("0.5")); }},
    NamedConstant{"M_E", [] { return exp(whole(1)); }},
    NamedConstant{"M_LN2", [] { return ln2<Symbolic>(); }},
    NamedConstant{"M_LN10", [] { return log(whole(10)); }},
    NamedConstant{"M_LOG2E", [] { return whole(1) / ln2<Symbolic>(); }},
    NamedConstant{"M_LOG10E", [] { return whole(1) / log(whole(10)); }},
};

bool is_size(char c) {
  return '2' <= c && c <= '4';
}

std::vector<std::size_t> counts_of_exact(std::string_view name) {
  std::vector<std::size_t> counts;
  if (find_function(functions_of_one<double>, name) != nullptr) counts.push_back(1);
  if (find_function(functions_of_two<double>, name) != nullptr) counts.push_back(2);
  for (const Composed& f : composed_functions) {
    if (f.name == name) counts.push_back(f.arguments);
  }
  return counts;
}

using OtherName = std::pair<std::string_view, std::string_view>;

constexpr std::array other_names{OtherName{"arccos", "acos"},   OtherName{"arcsin", "asin"},
                                 OtherName{"arctan", "atan"},   OtherName{"arctan2", "atan2"},
                                 OtherName{"arccosh", "acosh"}, OtherName{"arcsinh", "asinh"},
                                 OtherName{"arctanh", "atanh"}};

/// Names that alone might be parameters.
constexpr std::array names_of_numpy{
    OtherName{"power", "pow"},       OtherName{"absolute", "abs"},   OtherName{"maximum", "max"},
    OtherName{"minimum", "min"},     OtherName{"clip", "clamp"},     OtherName{"deg2rad", "radians"},
    OtherName{"rad2deg", "degrees"}, OtherName{"reciprocal", "rcp"}, OtherName{"e", "M_E"}};

std::string_view named_otherwise(std::span<const OtherName> names, std::string_view name) {
  const auto found = std::ranges::find(names, name, &OtherName::first);
  return found == names.end() ? name : found->second;
}

/// The name without the f of C's functions on floats: `cosf` is `cos`; and `arccos` is `acos`.
std::string_view without_suffix(std::string_view given) {
  const std::string_view name = named_otherwise(other_names, given);
  const bool has_suffix = name.size() > 1 && name.back() == 'f' && counts_of_exact(name).empty();
  return has_suffix ? name.substr(0, name.size() - 1) : name;
}

/// The whole number that an exponent is written as.
std::optional<int> whole_exponent(const Symbolic& exponent) {
  if (exponent.kind() == Symbolic::Kind::negate) {
    const auto n = whole_exponent(exponent.part(0));
    return n ? std::optional(-*n) : std::nullopt;
  }
  if (exponent.kind() != Symbolic::Kind::number) return std::nullopt;
  std::string_view digits = exponent.name();
  if (const std::size_t point = digits.find('.'); point != std::string_view::npos) {
    if (digits.find_first_not_of('0', point + 1) != std::string_view::npos) return std::nullopt;
    digits = digits.substr(0, point);
  }
  int n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return n;
}

}  // namespace

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const auto& f : functions_of_one<double>) names.emplace_back(f.name);
  for (const auto& f : functions_of_two<double>) names.emplace_back(f.name);
  for (const Composed& f : composed_functions) names.emplace_back(f.name);
  return names;
}

std::optional<Symbolic> named_constant(std::string_view name) {
  for (const NamedConstant& constant : named_constants) {
    if (constant.name == name) return constant.value();
  }
  return std::nullopt;
}

bool is_of_vectors(std::string_view name) {
  constexpr std::array<std::string_view, 5> functions{"dot", "cross", "normalize", "reflect", "refract"};
  if (std::find(functions.begin(), functions.end(), name) != functions.end()) return true;
  if (name.empty() || !is_size(name.back())) return false;
  name.remove_suffix(1);
  if (name.size() > 2 && name.back() == 'x' && is_size(name[name.size() - 2])) name.remove_suffix(2);
  constexpr std::array<std::string_view, 14> types{"vec",    "dvec", "ivec", "uvec",  "bvec",
                                                   "mat",    "dmat", "half", "float", "int",
                                                   "double", "uint", "bool", "fixed"};
  return std::find(types.begin(), types.end(), name) != types.end();
}

bool is_python_module(std::string_view name) {
  return name == "np" || name == "numpy" || name == "math";
}

std::string_view name_for_numpy(std::string_view name) {
  return named_otherwise(names_of_numpy, name);
}

bool is_real_type(std::string_view name) {
  return name == "float" || name == "half" || name == "double";
}

std::vector<std::size_t> argument_counts(std::string_view function) {
  return counts_of_exact(without_suffix(function));
}

Symbolic call(std::string_view function, std::span<const Symbolic> arguments) {
  const std::string_view name = without_suffix(function);
  for (const Composed& f : composed_functions) {
    if (f.name == name && f.arguments == arguments.size()) return f.expression(arguments);
  }
  return Symbolic::function(name, {arguments.begin(), arguments.end()});
}

Symbolic raised(const Symbolic& base, const Symbolic& exponent) {
  if (const auto n = whole_exponent(exponent)) return power(base, *n);
  return power(base, exponent);
}

}  // namespace shadefit
