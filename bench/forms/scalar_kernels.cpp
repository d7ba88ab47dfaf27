#include "bench/forms/compiled.hpp"

/// One number at a time, with the functions of the C library.
namespace shadefit::forms {
namespace {

constexpr auto table = table_of<float, double>(AllForms());

}  // namespace

constinit const std::span<const CompiledForm> Tables::scalar(table);

}  // namespace shadefit::forms
