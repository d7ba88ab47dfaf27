#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/forms/kernel.hpp"

/// The arrays of timed kernels, the same in every run.
namespace shadefit::bench {

/// The bytes of all arrays of a target in the first cache: half of 32 KiB, the smallest cache of x86-64
/// processors of the last decade, so that other data fit too.
inline constexpr std::size_t first_cache_bytes = 16 * 1024;

/// The elements of one call in memory: few, so that a slow form does not take seconds. Each call of a visit
/// starts at the end of the one before.
inline constexpr std::size_t memory_slice = 8192;

/// The bytes of an array of cosines in memory: the size of the last cache, at least 32 MiB and at most 256
/// MiB. At least twice as much is read and written before a place is visited again. For normals, half of it
/// per axis.
std::size_t memory_bytes(std::size_t last_cache);

/// The elements of a target's arrays that fit into the first cache together, a multiple of 64.
std::size_t first_cache_elements(forms::Arguments arguments, std::size_t bytes_of_number);

/// Memory, not yet written, that begins at a cache line, `offset` bytes after the begin of a page: arrays
/// that are read and written together should have different offsets in their pages, otherwise loads wait for
/// stores.
template <class Real>
class Array {
 public:
  Array(std::size_t size, std::size_t offset);
  Real* data() { return data_; }
  const Real* data() const { return data_; }
  std::size_t size() const { return size_; }

 private:
  std::unique_ptr<void, void (*)(void*)> memory_;
  Real* data_;
  std::size_t size_;
};

/// Arrays of `size` elements for the inputs of a target, spread evenly over its cosines, its codes, or the
/// directions of a hemisphere.
template <class Real>
class Workload {
 public:
  Workload(const forms::Target& target, std::size_t size);

  std::size_t size() const { return out_.size(); }
  /// The elements from `first` on.
  forms::Arrays<Real> slice(std::size_t first, std::size_t count);

 private:
  std::vector<Array<Real>> in_;
  std::vector<std::uint8_t> codes_;
  Array<Real> out_;
};

extern template class Workload<float>;
extern template class Workload<double>;

}  // namespace shadefit::bench
