#include "bench/timing/workload.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <new>

namespace shadefit::bench {
namespace {

constexpr std::size_t line = 64, page = 4096, large_page = 2 * 1024 * 1024;

/// The number of inputs and outputs of a target per element.
std::size_t arrays_of(forms::Arguments arguments) {
  return arguments == forms::Arguments::normal_to_lights ? 4 : 2;
}

}  // namespace

std::size_t memory_bytes(std::size_t last_cache) {
  constexpr std::size_t mebibyte = 1024 * 1024;
  return std::clamp(std::bit_ceil(last_cache), 32 * mebibyte, 256 * mebibyte);
}

std::size_t first_cache_elements(forms::Arguments arguments, std::size_t bytes_of_number) {
  return first_cache_bytes / (arrays_of(arguments) * bytes_of_number) / line * line;
}

template <class Real>
Array<Real>::Array(std::size_t size, std::size_t offset) : memory_(nullptr, std::free), size_(size) {
  // Long arrays use large pages if the system has them: page-table walks would distort the times, and small
  // pages take seconds to allocate.
  const std::size_t needed = size * sizeof(Real) + page, unit = needed >= large_page ? large_page : page;
  const std::size_t bytes = (needed + unit - 1) / unit * unit;
  memory_.reset(std::aligned_alloc(unit, bytes));
  if (memory_ == nullptr) throw std::bad_alloc();
  if (unit == large_page) ::madvise(memory_.get(), bytes, MADV_HUGEPAGE);  // only advice
  data_ = reinterpret_cast<Real*>(static_cast<unsigned char*>(memory_.get()) + offset % page / line * line);
}

template <class Real>
Workload<Real>::Workload(const forms::Target& target, std::size_t size) : out_(size, 5 * page / 8) {
  const bool has_normals = target.arguments == forms::Arguments::normal_to_lights;
  for (std::size_t i = 0; i + 1 < arrays_of(target.arguments); ++i) in_.emplace_back(size, i * page / 8);
  // Steps of the golden ratio: every part of them is spread evenly, and none is sorted.
  constexpr double golden = 0.6180339887498949;
  double share = golden / 2;
  for (std::size_t i = 0; i < size; ++i) {
    if (has_normals) {
      const auto direction = forms::spread_direction(i);
      for (std::size_t axis = 0; axis < 3; ++axis) in_[axis].data()[i] = static_cast<Real>(direction[axis]);
    } else {
      in_[0].data()[i] = static_cast<Real>(target.from + share * (target.to - target.from));
    }
    share += golden;
    if (share >= 1) share -= 1;
  }
  if (target.arguments == forms::Arguments::cosine_and_code) {
    // 151 and 256 have no common divisor: all codes occur, unsorted.
    for (std::size_t i = 0; i < size; ++i) codes_.push_back(static_cast<std::uint8_t>(i * 151));
  }
  std::fill_n(out_.data(), size, Real{0});
}

template <class Real>
forms::Arrays<Real> Workload<Real>::slice(std::size_t first, std::size_t count) {
  forms::Arrays<Real> arrays;
  for (std::size_t i = 0; i < in_.size(); ++i) arrays.in[i] = in_[i].data() + first;
  arrays.codes = codes_.empty() ? nullptr : codes_.data() + first;
  arrays.out = out_.data() + first;
  arrays.size = count;
  return arrays;
}

template class Array<float>;
template class Array<double>;
template class Workload<float>;
template class Workload<double>;

}  // namespace shadefit::bench
