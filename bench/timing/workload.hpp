#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/forms/kernel.hpp"

/// The arrays that kernels are timed on: the same in every run.
namespace shadefit::bench {

/// Bytes that all arrays of a target take in the first cache together: half of the smallest that x86-64
/// processors of the last decade have, 32 KiB, so that nothing else has to leave it.
inline constexpr std::size_t first_cache_bytes = 16 * 1024;

/// Elements of one call in memory, from one place of long arrays to the next: few, so that a slow form does
/// not take seconds; the calls of a visit go on where the one before ended.
inline constexpr std::size_t memory_slice = 8192;

/// Bytes of an array of cosines in memory: as many as the last cache has, at least 32 MiB and at most 256
/// MiB. What is read and written before a place is met again is twice that at least. Of normals, half of it
/// an axis.
std::size_t memory_bytes(std::size_t last_cache);

/// The elements of a target's arrays that fit into the first cache together, a multiple of 64.
std::size_t first_cache_elements(forms::Arguments arguments, std::size_t bytes_of_number);

/// Memory, not yet written, that begins at a line of the cache, `offset` bytes after a page: arrays that are
/// read and written together should not begin at equal places of their pages, where loads wait for stores.
template <class Real>
class Array {
 public:
  Array(std::size_t size, std::size_t offset);
  Real* data() { return data_; }
  const Real* data() const { return data_; }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  std::unique_ptr<void, Free> memory_;
  Real* data_;
  std::size_t size_;
};

/// Arrays of `size` elements for whatever a target reads, spread evenly over its cosines, its codes, or the
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
