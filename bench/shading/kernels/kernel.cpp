#include "bench/shading/kernels/kernel.hpp"

namespace shadefit::shade {

std::vector<Kernels> kernels_here() {
  std::vector<Kernels> kernels;
  for (const forms::Width width : forms::widths_here()) {
    if (width == forms::Width::sse2) kernels.push_back(KernelUnits::sse2);
    if (width == forms::Width::avx2) kernels.push_back(KernelUnits::avx2);
    if (width == forms::Width::avx512) kernels.push_back(KernelUnits::avx512);
  }
  return kernels;
}

}  // namespace shadefit::shade
