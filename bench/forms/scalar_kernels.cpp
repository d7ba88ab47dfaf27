#include "bench/forms/compiled.hpp"

/// One number at a time, with the functions of the C library.
namespace shadefit::forms {

constinit const std::span<const CompiledForm> Tables::scalar(table<float, double>);

}  // namespace shadefit::forms
