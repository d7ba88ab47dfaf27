#pragma once

#include <immintrin.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "bench/forms/batch.hpp"
#include "bench/forms/lanes.hpp"

/// The registers of a kernel.
namespace shadefit::forms {

/// Codes as the numbers of a register. Four codes, for SSE2, need two steps that put zeros between them.
template <class B>
B four_codes(const std::uint8_t* at) {
  std::uint32_t packed;
  std::memcpy(&packed, at, sizeof packed);
  const __m128i zero = _mm_setzero_si128();
  const __m128i bytes = _mm_cvtsi32_si128(static_cast<int>(packed));
  return B(_mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(bytes, zero), zero)));
}
template <class B>
B two_codes(const std::uint8_t* at) {
  return B(_mm_cvtepi32_pd(_mm_set_epi32(0, 0, at[1], at[0])));
}

template <class R, class A>
struct Lanes<xsimd::batch<R, A>> {
  using Real = R;
  using B = xsimd::batch<R, A>;
  using Inner = B;
  static constexpr std::size_t size = B::size;
  /// AVX-512 has 32 registers, the others 16.
  static constexpr std::size_t unrolled = size * sizeof(R) == 64 ? 4 : 2;

  static B load(const R* at) { return B::load_unaligned(at); }
  static void store(const B& value, R* at) { value.store_unaligned(at); }
  static B of(R value) { return B::broadcast(value); }
  static B wrap(const B& value) { return value; }
  static R first(const B& value) {
    alignas(64) R all[size];
    value.store_aligned(all);
    return all[0];
  }

  static B codes(const std::uint8_t* at) {
    constexpr bool is_float = std::is_same_v<R, float>;
    if constexpr (size * sizeof(R) == 16) {
      if constexpr (is_float) return four_codes<B>(at);
      if constexpr (!is_float) return two_codes<B>(at);
    }
#ifdef __AVX2__
    if constexpr (size * sizeof(R) == 32) {
      if constexpr (is_float) return B(_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadu_si64(at))));
      if constexpr (!is_float) return B(_mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_loadu_si32(at))));
    }
#endif
#ifdef __AVX512F__
    if constexpr (size * sizeof(R) == 64) {
      if constexpr (is_float)
        return B(
            _mm512_cvtepi32_ps(_mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)))));
      if constexpr (!is_float) return B(_mm512_cvtepi32_pd(_mm256_cvtepu8_epi32(_mm_loadu_si64(at))));
    }
#endif
  }
};

}  // namespace shadefit::forms
