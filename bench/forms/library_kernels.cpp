#include "bench/forms/library_kernels.hpp"

#include <array>

#include "bench/forms/library.hpp"
#include "bench/forms/loops.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit::forms {

template <>
struct Lanes<Eigen::half> {
  using Real = Eigen::half;
  using Inner = Eigen::half;
  static constexpr std::size_t size = 1;
  static constexpr std::size_t unrolled = 1;
  static Real load(const Real* at) { return *at; }
  static Real codes(const std::uint8_t* at) { return integer<Real>(*at); }
  static void store(Real value, Real* at) { *at = value; }
  static Real of(Real value) { return value; }
  static Real wrap(Real value) { return value; }
  static Real first(Real value) { return value; }
};

namespace {

template <class... Forms>
consteval std::array<LibraryForm, sizeof...(Forms)> table_of(FormList<Forms...>) {
  return {LibraryForm{Forms::id, kernel_of<Forms, Library<float>>, kernel_of<Forms, Library<double>>,
                      kernel_of<Forms, Eigen::half>, kernel_of<Forms, long double>}...};
}

constexpr auto table = table_of(AllForms());

}  // namespace

std::span<const LibraryForm> library_forms() {
  return table;
}

}  // namespace shadefit::forms
