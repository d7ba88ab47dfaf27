#include "fit/scalars/likely_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "fit/scalars/integral.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

/// The size of an expression: a constant, and a share for the size of each parameter.
using Size = Eigen::VectorXd;

/// Collects the equations of a form. An expression without a size is 0 for every value.
class Equations {
 public:
  Equations(const std::vector<std::string>& parameters, const std::map<std::string, double>& sizes)
      : parameters_(parameters), sizes_(sizes) {}

  /// The recursion is as deep as the formula, which is limited.
  std::optional<Size> size_of(const Symbolic& e) {
    switch (e.kind()) {
      case Kind::variable:
        return of_name(e.name());
      case Kind::number:
      case Kind::constant:
        return of_number(e);
      case Kind::add:
      case Kind::subtract:
        return alike(size_of(e.part(0)), size_of(e.part(1)));
      case Kind::multiply:
        return combined(size_of(e.part(0)), size_of(e.part(1)), 1);
      case Kind::divide:
        return combined(size_of(e.part(0)), size_of(e.part(1)), -1);
      case Kind::negate:
        return size_of(e.part(0));
      case Kind::integer_power:
        return scaled(size_of(e.part(0)), e.exponent());
      case Kind::real_power:
        return of_power(e);
      case Kind::choice:
        alike(size_of(e.part(0)), size_of(e.part(1)));
        return alike(size_of(e.part(2)), size_of(e.part(3)));
      case Kind::integral:
        return of_integral(e);
      case Kind::function:
        break;
    }
    return of_function(e);
  }

  /// Adds the equation that two sizes are equal.
  void equate(const std::optional<Size>& a, const std::optional<Size>& b) {
    if (a && b && (*a - *b).tail(count()).any()) rows_.push_back(*a - *b);
  }

  Size constant(double size) const {
    Size result = Size::Zero(1 + count());
    result[0] = size;
    return result;
  }

  /// The sizes of the parameters: of all answers the one nearest to 0.
  std::vector<double> solved() const {
    if (rows_.empty()) return std::vector<double>(parameters_.size());
    Eigen::MatrixXd matrix(rows_.size(), count());
    Eigen::VectorXd right(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      matrix.row(static_cast<Eigen::Index>(i)) = rows_[i].tail(count());
      right[static_cast<Eigen::Index>(i)] = -rows_[i][0];
    }
    const Eigen::VectorXd answer = shortest_solution(matrix, right);
    return {answer.begin(), answer.end()};
  }

 private:
  Eigen::Index count() const { return static_cast<Eigen::Index>(parameters_.size()); }

  std::optional<Size> of_name(const std::string& name) const {
    if (const auto inner = bound_.find(name); inner != bound_.end()) return inner->second;
    const auto found = std::find(parameters_.begin(), parameters_.end(), name);
    Size result = constant(0);
    if (found != parameters_.end()) {
      result[1 + (found - parameters_.begin())] = 1;
    } else if (const auto known = sizes_.find(name); known != sizes_.end()) {
      result[0] = known->second;
    }
    return result;
  }

  std::optional<Size> of_number(const Symbolic& e) const {
    const double value = std::abs(evaluate<double>(e, [](const std::string&) { return 0.0; }));
    if (value == 0 || !std::isfinite(value)) return std::nullopt;
    return constant(std::log2(value));
  }

  static std::optional<Size> scaled(const std::optional<Size>& a, double factor) {
    return a ? std::optional<Size>(*a * factor) : std::nullopt;
  }

  static std::optional<Size> combined(const std::optional<Size>& a, const std::optional<Size>& b,
                                      double sign) {
    return a && b ? std::optional<Size>(*a + sign * *b) : std::nullopt;
  }

  /// The size of two expressions that have the same one. Of two known sizes the larger one counts.
  std::optional<Size> alike(const std::optional<Size>& a, const std::optional<Size>& b) {
    if (!a || !b) return a ? a : b;
    const bool are_known = !a->tail(count()).any() && !b->tail(count()).any();
    if (are_known) return constant(std::max((*a)[0], (*b)[0]));
    equate(a, b);
    return (*a + *b) / 2;
  }

  std::optional<Size> of_power(const Symbolic& e) {
    const std::optional<Size> base = size_of(e.part(0));
    if (free_variables(e.part(1)).empty())
      return scaled(base, evaluate<double>(e.part(1), [](const std::string&) { return 0.0; }));
    equate(size_of(e.part(1)), constant(0));
    // Whatever the exponent is, the power of a base of the size of 1 has that size too.
    equate(base, constant(0));
    return constant(0);
  }

  std::optional<Size> of_integral(const Symbolic& e) {
    const std::optional<Size> length = alike(size_of(e.part(1)), size_of(e.part(2)));
    bound_[e.name()] = length;
    return combined(size_of(e.part(0)), length, 1);
  }

  std::optional<Size> of_function(const Symbolic& e) {
    const std::string& name = e.name();
    if (name == "min" || name == "max") return alike(size_of(e.part(0)), size_of(e.part(1)));
    if (name == "abs" || name == "floor") return size_of(e.part(0));
    if (name == "sqrt") return scaled(size_of(e.part(0)), 0.5);
    if (name == "sign" || name == "atan2") {
      std::optional<Size> first = size_of(e.part(0));
      if (e.parts().size() > 1) alike(first, size_of(e.part(1)));
      return constant(0);
    }
    for (const Symbolic& part : e.parts()) equate(size_of(part), constant(0));
    return constant(0);
  }

  const std::vector<std::string>& parameters_;
  const std::map<std::string, double>& sizes_;
  std::map<std::string, std::optional<Size>> bound_ = {};  ///< of the variables of integrals
  std::vector<Size> rows_ = {};
};

}  // namespace

std::vector<double> likely_sizes(const Symbolic& form, const std::vector<std::string>& parameters,
                                 const std::map<std::string, double>& sizes, double result) {
  Equations equations(parameters, sizes);
  equations.equate(equations.size_of(form), equations.constant(result));
  return equations.solved();
}

}  // namespace shadefit
