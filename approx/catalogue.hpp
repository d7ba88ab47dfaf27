#pragma once

#include <array>
#include <cstddef>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/normalisation.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/records/record.hpp"

/// Every record in one list; the records are in one file per topic.
namespace shadefit {

namespace detail {

template <class T, std::size_t... N>
constexpr auto join(const std::array<T, N>&... parts) {
  std::array<T, (N + ...)> all{};
  std::size_t next = 0;
  const auto append = [&](const auto& part) {
    for (const T& record : part) all[next++] = record;
  };
  (append(parts), ...);
  return all;
}

}  // namespace detail

/// The published constants of fitted families, in the order of the ledger.
inline constexpr auto published_constants =
    detail::join(sg_offset_published, fresnel_published, phong_blinn_published);

}  // namespace shadefit
