#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "lint/scan/known_set.hpp"

/// The curves of an expression, compared with those of forms.
namespace shadefit::lint {

/// Published digits and their floats differ by 1e-7, and polynomials with large terms enlarge that.
inline constexpr double same_curve = 1e-5;

/// Whether two numbers differ by at most `slack`, relatively.
bool is_near(double a, double b, double slack);

/// A part of an expression with what it holds.
struct ExpressionPart {
  Symbolic formula;
  std::set<std::string> names;
  std::vector<double> numbers;
  std::size_t held = 0;  ///< how many of the wanted numbers
};

/// How many of the wanted numbers are among these, to the accuracy of a float.
std::size_t count_held(const std::vector<double>& numbers, const std::vector<double>& wanted);

/// The parts that hold as many of the wanted numbers as the whole does, inner ones first. Empty if it holds
/// none.
std::vector<ExpressionPart> full_parts(const Symbolic& formula, const std::vector<double>& wanted);

/// A form of the variables and constants of a set, with values of the constants.
struct Curve {
  Symbolic form;
  std::vector<double> constants;
};

/// The curves of the parts of an expression, for each order of their names.
class CurveComparison {
 public:
  CurveComparison(const KnownSet& set, const std::vector<ExpressionPart>& parts);

  bool is_empty() const { return curves_.empty(); }

  /// Whether a part has this curve inside the ranges. Their ends are left out, because programs have branches
  /// there.
  bool has(const Curve& curve) const;

  /// Whether a part has this curve, also at the ends, and the curve differs from all allowed ones by more
  /// than `hidden` of the largest value.
  bool has_other(const Curve& curve, const std::vector<Curve>& allowed, double hidden) const;

 private:
  using Values = std::vector<double>;
  using Places = std::vector<std::vector<double>>;

  bool is_there(const Values& values, std::size_t count) const;
  Values values_of(const Curve& curve) const;

  const KnownSet& set_;
  std::size_t inner_places_ = 0;
  Places places_;  ///< first those inside the ranges
  std::vector<Values> curves_;
};

}  // namespace shadefit::lint
