#pragma once

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit {

// The functions of 50 digits take long to compile: one copy.
extern template void TapeProgram<Decimal50>::run(std::span<const Decimal50>);

}  // namespace shadefit
