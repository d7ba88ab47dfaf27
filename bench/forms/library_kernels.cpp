#include "bench/forms/library_kernels.hpp"

#include <array>
#include <cmath>
#include <concepts>
#include <string_view>

#include "approx/scalar.hpp"
#include "bench/forms/lanes.hpp"
#include "bench/forms/loops.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit::forms {

/// float and double with accurate functions that give the same results on every machine.
///
/// A number whose operations are those of R and whose functions are evaluated in long double and rounded
/// once.
///
/// The table must not depend on the machine's library. The GNU C library uses fused instructions where
/// available, and then differs in the last bit at a few places. Its own float functions are within 0.51 ulp
/// of the truth, those of double within one; these within 0.50.
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

template <std::floating_point R>
struct Lanes<Library<R>> : Lanes<R> {
  using S = Library<R>;
  using Inner = S;
  static S load(const R* at) { return {*at}; }
  static S codes(const std::uint8_t* at) { return {static_cast<R>(*at)}; }
  static void store(const S& value, R* at) { *at = value.value; }
  static S of(R value) { return {value}; }
  static S wrap(const S& value) { return value; }
  static R first(const S& value) { return value.value; }
};

template <>
struct Lanes<Eigen::half> : OneNumber<Eigen::half> {};

namespace {

template <class... Forms>
consteval std::array<LibraryForm, sizeof...(Forms)> table_of(FormList<Forms...>) {
  return {LibraryForm{Forms::id, kernel_of<Forms, Library<float>>, kernel_of<Forms, Library<double>>,
                      kernel_of<Forms, Eigen::half>, kernel_of<Forms, long double>}...};
}

}  // namespace

std::span<const LibraryForm> library_forms() {
  static constexpr auto all = table_of(AllForms());
  return all;
}

}  // namespace shadefit::forms
