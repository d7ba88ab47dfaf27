#include "bench/forms/kernel.hpp"
namespace shadefit::forms {
std::string_view name(Width w) {
  constexpr std::array n{"scalar", "sse2", "avx2", "avx512"};
  return n[static_cast<std::size_t>(w)];
}
}  // namespace shadefit::forms
