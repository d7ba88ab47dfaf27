#include "bench/forms/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

#include "approx/scalar.hpp"
#include "bench/forms/loops.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit::forms {

/// A number whose operations are those of R and whose functions are evaluated in long double and rounded
/// once.
///
/// The table of errors must not depend on the machine's library. The GNU C library uses fused instructions
/// where available, and then differs in the last bit at a few places. Its own float functions are within
/// 0.51 ulp of the truth, those of double within one; these within 0.50.
template <std::floating_point R>
struct Library {
  R value;

  friend Library operator+(const Library& a, const Library& b) { return {a.value + b.value}; }
  friend Library operator-(const Library& a, const Library& b) { return {a.value - b.value}; }
  friend Library operator-(const Library& a) { return {-a.value}; }
  friend Library operator*(const Library& a, const Library& b) { return {a.value * b.value}; }
  friend Library operator/(const Library& a, const Library& b) { return {a.value / b.value}; }
};

}  // namespace shadefit::forms

namespace shadefit {

template <std::floating_point R>
struct Scalar<forms::Library<R>> {
  using T = forms::Library<R>;
  using Wide = Scalar<long double>;

  static T exp2(const T& x) { return {static_cast<R>(Wide::exp2(x.value))}; }
  static T log2(const T& x) { return {static_cast<R>(Wide::log2(x.value))}; }
  static T power(const T& x, const T& p) { return {static_cast<R>(Wide::power(x.value, p.value))}; }
  static T sqrt(const T& x) { return {std::sqrt(x.value)}; }
  static T max(const T& a, const T& b) { return {Scalar<R>::max(a.value, b.value)}; }
  static T integer(int n) { return {Scalar<R>::integer(n)}; }
  static T from_decimal(std::string_view decimal) { return {Scalar<R>::from_decimal(decimal)}; }
  static T pi() { return {Scalar<R>::pi()}; }
  static T ln2() { return {Scalar<R>::ln2()}; }
};

}  // namespace shadefit

namespace shadefit::forms {
namespace {

/// The degrees of exp2 with a double kernel: below 4 float is accurate enough, and 5 is hardly cheaper than
/// 6.
constexpr bool has_double_kernel(int degree) {
  return degree == 4 || degree == 6;
}

template <class Form, int degree>
FormKernels with_polynomial() {
  FormKernels kernels{.form = Form::id, .exp2_degree = degree};
  kernels.in_float = kernel_of<Form, WithExp2<float, Exp2Choice<degree, float>>>;
  if constexpr (has_double_kernel(degree))
    kernels.in_double = kernel_of<Form, WithExp2<double, Exp2Choice<degree, double>>>;
  return kernels;
}

template <class Form>
void append(std::vector<FormKernels>& all) {
  all.push_back({Form::id, 0, kernel_of<Form, float>, kernel_of<Form, double>,
                 kernel_of<Form, Library<float>>, kernel_of<Form, Library<double>>,
                 kernel_of<Form, Eigen::half>, kernel_of<Form, long double>, kernel_of<Form, Symbolic>});
  if constexpr (Form::has_exp2) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (all.push_back(with_polynomial<Form, least_exp2_degree + static_cast<int>(I)>()), ...);
    }
    (std::make_index_sequence<exp2_for_float.size()>());
  }
}

template <class... Forms>
std::vector<FormKernels> all_kernels(FormList<Forms...>) {
  std::vector<FormKernels> all;
  (append<Forms>(all), ...);
  return all;
}

}  // namespace

std::span<const FormKernels> kernels_of(std::string_view form) {
  static const std::vector<FormKernels> all = all_kernels(AllForms());
  const auto first = std::ranges::find(all, form, &FormKernels::form);
  const auto is_other = [&](const FormKernels& kernels) { return kernels.form != form; };
  return {first, std::find_if(first, all.end(), is_other)};
}

}  // namespace shadefit::forms
